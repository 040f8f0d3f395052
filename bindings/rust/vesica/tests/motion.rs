// SPDX-License-Identifier: Apache-2.0
//! Casts, boxes, ratios and shapes with a radius by numbers that are known, and what is refused.
use vesica::*;

const DISC: Circle<f64> = Circle { cx: 0.0, cy: 0.0, r: 1.0 };
const WALL: Aabb<f64> = Aabb { min_x: 10.0, min_y: -5.0, max_x: 12.0, max_y: 5.0 };

fn motion(vx: f64, t_end: f64) -> Motion<f64> {
    Motion { vx, vy: 0.0, t_end }
}

#[test]
fn casts() {
    let met = Impact { t: 3.0, x: 10.0, y: 0.0, nx: -1.0, ny: 0.0 };
    assert_eq!(cast(&WALL, &DISC, motion(3.0, f64::INFINITY)), Ok((Cast::Hit, met)));
    assert_eq!(cast(&WALL, &DISC, motion(3.0, 2.5)).map(|(found, _)| found), Ok(Cast::Miss));
    assert_eq!(cast(&WALL, &WALL, motion(3.0, 2.5)).map(|(found, _)| found), Ok(Cast::Start));
    let walls = [Aabb { min_x: 20.0, max_x: 22.0, ..WALL }, WALL, WALL];
    assert_eq!(cast_first(&DISC, &walls, motion(3.0, 9.0)), Ok(Some((1, met))));
    assert_eq!(cast_first(&DISC, &walls, motion(-3.0, 9.0)), Ok(None));
    let index = Index::new(&[Shapes::from(&walls)]).unwrap();
    assert_eq!(index.cast(&DISC, motion(1.0, 10.0)).map(|items| items.len()), Ok(2));
    assert_eq!(index.cast_first(&DISC, motion(3.0, 9.0)), Ok(Some((1, met))));
    let mut t = [0.0; 3];
    let only = ImpactColumns { t: &mut t, ..Default::default() };
    assert_eq!(cast_many(&walls, &DISC, (&[2.0, -1.0, f64::NAN], &[0.0; 3]), 99.0, only), Err(Error::Argument));
    assert_eq!(t[..2], [9.5, f64::INFINITY]);
    assert!(t[2].is_nan());
    let swept = sweep_bounds(&DISC, motion(3.0, 2.0)).unwrap();
    assert_eq!(contains(&swept, &Aabb { min_x: -1.0, min_y: -1.0, max_x: 7.0, max_y: 1.0 }), Ok(true));
}

#[test]
fn shapes_that_turn() {
    let bar = Segment { x0: -1.0, y0: 0.0, x1: 1.0, y1: 0.0 };
    let (speck, still) = (Circle { cx: 0.0, cy: 0.5, r: 1e-8 }, Turn::default());
    let by = |angle| Turn { vx: 0.0, vy: 0.0, angle };
    let (found, impact, gap) = impact_time(&bar, by(core::f64::consts::PI), &speck, still, 1e-7).unwrap();
    assert_eq!(found, Cast::Hit);
    assert!(impact.t <= 0.5 && impact.t > 0.499999 && gap <= 1e-7);
    let (found, impact, gap) = impact_time(&bar, by(1.57), &speck, still, 1e-7).unwrap();
    assert!(found == Cast::Miss && impact.t == f64::INFINITY && gap.is_nan());
    // Without area contact is never proved.
    let near = impact_time(&bar, by(3.0), &Point { x: 0.0, y: 0.5 }, still, 1e-7);
    assert_eq!(near.map(|(found, ..)| found), Ok(Cast::Near));
    let start = impact_time(&WALL, by(1.0), &WALL, still, 1.0);
    assert_eq!(start.map(|(found, impact, gap)| (found, impact.t, gap)), Ok((Cast::Start, 0.0, 0.0)));
    assert_eq!(impact_time(&WALL, by(2e6), &DISC, still, 1.0).err(), Some(Error::Argument));
    assert_eq!(impact_time(&WALL, still, &DISC, still, 0.0).err(), Some(Error::Argument));
}

#[test]
fn boxes() {
    let rows = [[1.0, 2.0, 6.0, 4.0, 90.0, 77.0], [1.0, 2.0, -6.0, 4.0, 90.0, 77.0]];
    let mut rects = [Rect::<f64>::default(); 2];
    assert_eq!(rects_from_boxes(&rows, Angle::DEGREES, &mut rects), Err(Error::Shape));
    assert_eq!(rects[0], Rect { cx: 1.0, cy: 2.0, ux: 0.0, uy: 1.0, hx: 3.0, hy: 2.0 });
    assert!(rects[1].cx.is_nan());
    let mut back = [[0.0; 5]];
    assert_eq!(boxes_from_shapes(&rects[..1], Angle::QUARTERS.reversed(), &mut back), Ok(()));
    assert_eq!(back, [[1.0, 2.0, 6.0, 4.0, -1.0]]);
    assert_eq!(boxes_from_shapes(&DISC, Angle::RADIANS, &mut back), Err(Error::Kind));
    assert_eq!(boxes_from_shapes(&rects, Angle::RADIANS, &mut back), Err(Error::Room { needed: 2, given: 1 }));
    assert!(rects_from_boxes(&[[0.0; 4]], Angle::RADIANS, &mut rects).is_err());
}

#[test]
fn ratios_and_suppression() {
    let (small, large) = (Aabb { min_x: 0.0, min_y: 0.0, max_x: 2.0, max_y: 2.0 }, [0.0, 0.0, 4.0, 4.0]);
    let large = Aabb { max_x: large[2], max_y: large[3], ..small };
    assert_eq!(ratio(Ratio::OverFirst, &small, &large), Ok(1.0));
    assert_eq!(ratio(Ratio::OverSecond, &small, &large), Ok(0.25));
    assert_eq!(ratio(Ratio::OverFirst, &Point { x: 0.0, y: 0.0 }, &large), Err(Error::Argument));
    let both = [small, large];
    let (mut scratch, mut keep) = (vec![0; nms_scratch(2).unwrap()], [0; 2]);
    let mut kept = |how| suppress(&both, &[1.0, 2.0], how, &mut scratch, &mut keep);
    let by_smaller = Suppression { ratio: Ratio::OverSmaller, ..Suppression::by_iou(0.5) };
    assert_eq!(kept(Suppression::by_iou(0.5)), Ok(2));
    assert_eq!(kept(by_smaller), Ok(1));
    assert_eq!(kept(Suppression { labels: &[1, 2], ..by_smaller }), Ok(2));
    assert_eq!(kept(Suppression { most: 1, ..Suppression::by_iou(0.5) }), Ok(1));
    assert_eq!(kept(Suppression { least_score: Some(2.5), ..Suppression::by_iou(0.5) }), Ok(0));
    assert_eq!(kept(Suppression { ratio: Ratio::OverFirst, ..by_smaller }), Err(Error::Argument));
    assert_eq!(kept(Suppression { labels: &[1], ..by_smaller }), Err(Error::Counts(2, 1)));
}

#[test]
fn near_deep_and_how_they_meet() {
    let square = |x: f64, y: f64| Aabb { min_x: x, min_y: y, max_x: x + 2.0, max_y: y + 2.0 };
    let (a, b, disc) = (square(0.0, 0.0), square(1.0, 1.0), Circle { cx: 6.0, cy: 1.0, r: 1.0 });
    assert_eq!(within(&a, &disc, 3.0), Ok(Within::Yes));
    assert_eq!(within(&a, &disc, 2.999), Ok(Within::No));
    let ellipse = Ellipse { cx: 5.0, cy: 0.0, ux: 1.0, uy: 0.0, a: 2.0, b: 1.0 };
    let left = Ellipse { cx: -2.0, ..ellipse };
    assert_eq!(within(&Point { x: 0.0, y: 0.0 }, &ellipse, 3.0), Ok(Within::Yes));
    assert_eq!(within(&left, &ellipse, 3.0), Ok(Within::Nearly));
    assert_eq!(within(&a, &b, f64::NAN), Err(Error::Argument));
    assert_eq!((within(&a, &b, -1.0), within(&a, &b, -1.001)), (Ok(Within::Yes), Ok(Within::No)));
    let (boxes, mut found, mut signed) = ([a, b, square(5.0, 0.0)], [Within::No; 3], [0.0; 3]);
    assert_eq!(within_many(&boxes, &a, 2.0, &mut found), Ok(2));
    assert_eq!(found, [Within::Yes, Within::Yes, Within::No]);
    assert_eq!(signed_distance_many(&boxes, &a, &mut signed), Ok(2));
    assert_eq!(signed, [-2.0, -1.0, 3.0]);
    let index = Index::new(&[Shapes::from(&boxes)]).unwrap();
    assert_eq!(index.join_within(&index, 2.0).map(|pairs| pairs.len()), Ok(2));
    assert_eq!(de9im(&a, &square(2.0, 0.0)).as_ref(), Ok(b"FF2F11212"));
    assert_eq!(de9im_match(b"FF2F11212", b"FF*FT****"), Ok(true));
    assert_eq!(de9im_match(b"FF2F11212", b"FF*FT***"), Err(Error::Argument));
    let region = intersection(&a, &b).unwrap();
    assert_eq!(region.vertices(), [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]);
    assert_eq!(intersection(&a, &disc), Err(Error::Kind));
    let soft = [Aabb { max_x: 4.0, max_y: 4.0, ..a }, Aabb { max_x: 4.0, max_y: 3.0, ..a }, square(9.0, 9.0)];
    let (mut keep, mut left) = ([0; 3], [0.0; 3]);
    let mut scratch = vec![0; suppress_soft_scratch(3).unwrap()];
    let (decay, ratio) = (Decay::Linear(0.5), Ratio::OverUnion);
    let how = SoftSuppression { decay, ratio, labels: &[], least_score: 0.0, most: 3 };
    assert_eq!(suppress_soft(&soft, &[1.0, 0.75, 0.5], how, &mut scratch, &mut keep, &mut left), Ok(3));
    assert_eq!((keep, left), ([0, 2, 1], [1.0, 0.5, 0.1875]));
}

#[test]
fn capsules_and_rounded_rectangles() {
    let bars = [0.0, 5.0].map(|y| Capsule { x0: 0.0, y0: y, x1: 4.0, y1: y, r: 1.0 });
    let rounded = RoundRect { cx: 10.0, cy: 0.0, ux: 1.0, uy: 0.0, hx: 2.0, hy: 1.0, r: 0.5 };
    let end = Point { x: 5.0, y: 0.0 };
    assert_eq!(overlap(&bars[0], &end), Ok(true));
    assert_eq!(overlap(&bars[0], &Point { y: 5e-324, ..end }), Ok(false));
    assert_eq!(nearest(&bars[0], &rounded).map(|found| found.distance), Ok(2.5));
    assert_eq!(bounds(&rounded), Ok(Aabb { min_x: 7.5, min_y: -1.5, max_x: 12.5, max_y: 1.5 }));
    let any = AnyShape::new(Kind::RoundRect, &[10.0, 0.0, 1.0, 0.0, 2.0, 1.0, 0.5]).unwrap();
    let mut hits = [true; 2];
    assert_eq!(overlap_many(&bars, &end, &mut hits), Ok(1));
    assert_eq!(hits, [true, false]);
    let mut near = [Within::No; 2];
    assert_eq!(within_many(&bars, &any, 2.5, &mut near), Ok(1));
    let index = Index::new(&[Shapes::from(&bars)]).unwrap();
    assert_eq!(index.select(&end), Ok(vec![0]));
    assert_eq!(area(&bars[0], &rounded), Ok(0.0));
    let found = cast(&bars[0], &rounded, motion(-1.0, 9.0));
    assert_eq!(found.map(|(found, at)| (found, at.t)), Ok((Cast::Hit, 2.5)));
    let ellipse = Ellipse { cx: 10.0, cy: 0.0, ux: 1.0, uy: 0.0, a: 1.0, b: 1.0 };
    assert_eq!(contains(&rounded, &ellipse), Ok(true));
    assert_eq!(boundary_distance(&rounded, &ellipse).map(|found| found.distance), Ok(0.5));
}
