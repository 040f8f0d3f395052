// SPDX-License-Identifier: Apache-2.0
//! Index and join by this crate. The hashes are those of tests/index/same_bytes_test.cpp.
use vesica::index::{join, Index, Query, Set};
use vesica::{Circle, Error, Point, Rect};

struct Shapes {
    rects: Vec<Rect<f64>>,
    circles: Vec<Circle<f64>>,
    points: Vec<Point<f64>>,
}

/// Rectangles, circles and points over 20 scales, many of which touch.
fn touching(count: u64, mut seed: u64) -> Shapes {
    let mut draw = |below| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 33) % below
    };
    let mut shapes = Shapes { rects: vec![], circles: vec![], points: vec![] };
    for i in 0..count {
        let unit = if i % 7 == 0 { 0.5f64.powi(draw(20) as i32) } else { 1.0 };
        let (x, y) = (draw(60) as f64 * unit, draw(60) as f64 * unit);
        match i % 5 {
            0 => shapes.circles.push(Circle { cx: x, cy: y, r: unit / 2.0 }),
            1 => shapes.points.push(Point { x: x + unit / 2.0, y }),
            _ => {
                let (ux, uy) = ((i % 2) as f64, 1.0 - (i % 3) as f64 / 4.0);
                shapes.rects.push(Rect { cx: x, cy: y, ux, uy, hx: unit / 2.0, hy: unit / 4.0 })
            }
        }
    }
    shapes
}

fn sets(shapes: &Shapes) -> Vec<Set<'_, f64>> {
    vec![shapes.rects.as_slice().into(), shapes.circles.as_slice().into(), shapes.points.as_slice().into()]
}

fn fnv(numbers: impl Iterator<Item = u64>) -> u64 {
    numbers.fold(0xcbf29ce484222325, |state, number| (state ^ number).wrapping_mul(0x100000001b3))
}

fn hash_pairs(pairs: Vec<(i64, i64)>) -> u64 {
    fnv(pairs.into_iter().flat_map(|(a, b)| [a as u64, b as u64]))
}

fn hashes_as_in_c() -> Result<(), Error> {
    let (shapes_a, shapes_b) = (touching(9000, 1), touching(7000, 2));
    let (a, b) = (Index::new(sets(&shapes_a))?, Index::new(sets(&shapes_b))?);
    if cfg!(target_endian = "little") {
        assert_eq!(fnv(a.as_bytes().iter().map(|&byte| byte.into())), 14017431053294008823);
    }
    assert_eq!(hash_pairs(join(Query::Overlap, &a, &b)?), 9459960488521776375);
    assert_eq!(hash_pairs(join(Query::Overlap, &a, &a)?), 12175247251169411526);
    let again = Index::from_bytes(sets(&shapes_a), a.as_bytes())?;
    assert_eq!(hash_pairs(join(Query::Overlap, &again, &b)?), 9459960488521776375);
    let cut_off = &a.as_bytes()[..a.as_bytes().len() - 64];
    assert_eq!(Index::from_bytes(sets(&shapes_a), cut_off).err(), Some(Error(-10)));
    Ok(())
}

/// Squares of half size 1 in a row, 2 apart, so that neighbours touch.
fn known_answers() -> Result<(), Error> {
    let square = |i| Rect { cx: 2.0 * i as f32, cy: 0.0, ux: 1.0, uy: 0.0, hx: 1.0, hy: 1.0 };
    let mut row: Vec<_> = (0..10).map(square).collect();
    let squares = Index::new(vec![row.as_slice().into()])?;
    assert!(!squares.has_invalid());
    let mut pairs = join(Query::Overlap, &squares, &squares)?;
    pairs.sort_unstable();
    assert_eq!(pairs, (0..9).map(|i| (i, i + 1)).collect::<Vec<_>>());
    let mut hit = squares.select(&Point { x: 7.0, y: 0.0 })?;
    hit.sort_unstable();
    assert_eq!(hit, [3, 4]);
    assert_eq!(squares.select(&Circle { cx: 6.0, cy: 3.0, r: 2.0 })?, [3]);
    assert_eq!(squares.select(&Point { x: 7.0, y: 2.0 })?, []);
    let above = Point { x: 7.0, y: 3.0 };
    let far = 8f32.sqrt();
    assert_eq!(squares.nearest(&above, 4, f32::INFINITY)?, [(3, 2.0), (4, 2.0), (2, far), (5, far)]);
    assert_eq!(squares.nearest(&above, 4, 2.0)?.len(), 2);
    let dot = [Point { x: 4.0, y: 1.0 }];
    assert_eq!(join(Query::Contains, &squares, &Index::new(vec![dot.as_slice().into()])?)?, [(2, 0)]);
    row[5].hx = -1.0;
    let broken = Index::new(vec![row.as_slice().into()])?;
    assert!(broken.has_invalid());
    assert_eq!(join(Query::Overlap, &broken, &broken)?.len(), 7);
    Ok(())
}

fn main() -> Result<(), Error> {
    hashes_as_in_c()?;
    known_answers()?;
    println!("index: as in C");
    Ok(())
}
