// SPDX-License-Identifier: Apache-2.0
//! Casts, boxes and ratios by numbers that are known, and what is refused.
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
