// SPDX-License-Identifier: Apache-2.0
//! What calls cost from Rust: as bench/hosts/overhead.c does, with the same rectangles.
use std::hint::black_box;
use std::time::Instant;
use vesica::*;

const COUNT: usize = 1_000_000;

fn rect(i: usize) -> Rect<f64> {
    let (ux, uy) = if i % 2 == 1 { (5.0 / 13.0, 12.0 / 13.0) } else { (0.8, 0.6) };
    Rect {
        cx: (i * 7919 % 4001) as f64 / 1000.0,
        cy: (i * 104729 % 4003) as f64 / 1000.0,
        ux,
        uy,
        hx: 0.5 + (i % 100) as f64 / 200.0,
        hy: 0.5 + (i % 70) as f64 / 140.0,
    }
}

fn least(repeats: usize, calls: usize, mut call: impl FnMut(usize)) -> f64 {
    let repeat = |_| {
        let start = Instant::now();
        (0..calls).for_each(&mut call);
        start.elapsed().as_secs_f64() / calls as f64 * 1e9
    };
    (0..repeats).map(repeat).fold(f64::INFINITY, f64::min)
}

fn row(question: &str, one: impl FnMut(usize), mut many: impl FnMut(usize)) {
    let one = least(100, 1000, one);
    let some = least(100, 1, |_| many(1000)) / 1e3;
    println!("Rust {question} {one:.4} {some:.4} {:.4}", least(7, 1, |_| many(COUNT)) / COUNT as f64);
}

fn main() {
    let a: Vec<_> = (0..COUNT).map(rect).collect();
    let b: Vec<_> = (0..COUNT).map(|i| rect(3 * i + 1)).collect();
    let (mut hits, mut out) = (vec![false; COUNT], vec![0.0; 5 * COUNT]);
    row(
        "overlap",
        |i| {
            let _ = black_box(overlap(&a[i % 1000], &b[i % 1000]));
        },
        |n| {
            let _ = overlap_many(&a[..n], &b[..n], &mut hits);
        },
    );
    row(
        "nearest",
        |i| {
            let _ = black_box(nearest(&a[i % 1000], &b[i % 1000]));
        },
        |n| {
            let mut column = out.chunks_mut(COUNT);
            let mut next = || column.next().unwrap();
            let columns = ClosestPointsColumns { distance: next(), ax: next(), ay: next(), bx: next(), by: next() };
            let _ = nearest_many(&a[..n], &b[..n], columns);
        },
    );
    row(
        "iou",
        |i| {
            let _ = black_box(iou(&a[i % 1000], &b[i % 1000]));
        },
        |n| {
            let _ = iou_many(&a[..n], &b[..n], &mut out);
        },
    );
}
