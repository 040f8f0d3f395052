// SPDX-License-Identifier: Apache-2.0
//! vectors FILE: the shared vectors (../vectors.txt) by this crate. Exit status 0 when all answers are right.
use std::error::Error;
use vesica::{nearest, overlap, overlap_many, overlap_numbers, Aabb, Circle, ClosestPoints, Ellipse, Point, Rect};

type Numbers = [f64; 6];

#[derive(Default)]
struct Batch {
    lines: Vec<usize>,
    expected: Vec<i32>,
    rects: Vec<Rect<f64>>,
    ellipses: Vec<Ellipse<f64>>,
}

fn right(line: usize, answer: i32, expected: i32) -> bool {
    if answer != expected {
        println!("line {line}: {answer}, not {expected}");
    }
    answer == expected
}

fn shape(words: &[&str]) -> Result<(i32, Numbers), Box<dyn Error>> {
    let mut numbers = Numbers::default();
    for (number, word) in numbers.iter_mut().zip(&words[1..]) {
        *number = f64::from_bits(u64::from_str_radix(word, 16)?);
    }
    Ok((words[0].parse()?, numbers))
}

fn check_batch(batch: &Batch) -> bool {
    let mut out = vec![false; batch.lines.len()];
    let valid = batch.expected.iter().take_while(|&&code| code >= 0).count();
    let hits = batch.expected[..valid].iter().filter(|&&code| code == 1).count();
    let count = overlap_many(&batch.rects[..valid], &batch.ellipses[..valid], &mut out);
    // With an invalid element, an error: and yet every valid one has its answer.
    let failure = overlap_many(&batch.rects, &batch.ellipses, &mut out);
    let mut all_right = count == Ok(hits) && failure == Err(vesica::Error(-2));
    for (i, &hit) in out.iter().enumerate() {
        all_right &= right(batch.lines[i], hit.into(), batch.expected[i].max(0));
    }
    all_right & floats_agree(batch, valid)
}

/// In float, as the scalar calls are.
fn floats_agree(batch: &Batch, valid: usize) -> bool {
    let narrow = |numbers: Numbers| numbers.map(|x| x as f32);
    let rects: Vec<_> =
        batch.rects[..valid].iter().map(|r| rect(narrow([r.cx, r.cy, r.ux, r.uy, r.hx, r.hy]))).collect();
    let ellipses: Vec<_> =
        batch.ellipses[..valid].iter().map(|e| ellipse(narrow([e.cx, e.cy, e.ux, e.uy, e.a, e.b]))).collect();
    let mut out = vec![false; valid];
    let count = overlap_many(&rects, &ellipses, &mut out);
    count.is_ok() && out.iter().zip(rects.iter().zip(&ellipses)).all(|(&hit, (a, b))| overlap(a, b) == Ok(hit))
}

fn rect<T: Copy>(n: [T; 6]) -> Rect<T> {
    Rect { cx: n[0], cy: n[1], ux: n[2], uy: n[3], hx: n[4], hy: n[5] }
}

fn ellipse<T: Copy>(n: [T; 6]) -> Ellipse<T> {
    Ellipse { cx: n[0], cy: n[1], ux: n[2], uy: n[3], a: n[4], b: n[5] }
}

fn main() -> Result<(), Box<dyn Error>> {
    vesica::require_version()?;
    let path = std::env::args().nth(1).ok_or("usage: vectors FILE")?;
    let (mut calls, mut all_right, mut batch) = (0, true, Batch::default());
    for (i, text) in std::fs::read_to_string(path)?.lines().enumerate() {
        if text.starts_with('#') {
            continue;
        }
        let words: Vec<&str> = text.split_whitespace().collect();
        let expected = words[1].parse()?;
        let ((kind_a, a), (kind_b, b)) = (shape(&words[2..9])?, shape(&words[9..16])?);
        if words[0] == "many" {
            batch.lines.push(i + 1);
            batch.expected.push(expected);
            batch.rects.push(rect(a));
            batch.ellipses.push(ellipse(b));
            continue;
        }
        let answer = match words[0] {
            "f64" => overlap_numbers(kind_a, &a, kind_b, &b),
            _ => overlap_numbers(kind_a, &a.map(|x| x as f32), kind_b, &b.map(|x| x as f32)),
        };
        all_right &= right(i + 1, answer.map_or_else(|error| error.0, i32::from), expected);
        calls += 1;
    }
    all_right &= check_batch(&batch);
    if let Err(error) = overlap(&Point { x: f64::NAN, y: 0.0 }, &Circle { cx: 0.0, cy: 0.0, r: 1.0 }) {
        println!("NaN: {error}");
    }
    let (square, disc) = (Aabb { min_x: 0.0, min_y: 0.0, max_x: 2.0, max_y: 2.0 }, Circle { cx: 6.0, cy: 1.0, r: 1.0 });
    if nearest(&square, &disc)? == (ClosestPoints { distance: 3.0, ax: 2.0, ay: 1.0, bx: 5.0, by: 1.0 }) {
        println!("nearest: as in C");
    }
    println!("{calls} calls, {} in a batch", batch.lines.len());
    if all_right {
        Ok(())
    } else {
        Err("wrong answers".into())
    }
}
