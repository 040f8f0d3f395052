// SPDX-License-Identifier: Apache-2.0
//! Sparse ratios beside the matrix; assignment, fusion, matching and average precision by hand.
use vesica::*;

fn rects(mut state: u64, n: usize) -> Vec<Rect<f64>> {
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 40) as f64 / (1u64 << 24) as f64
    };
    (0..n).map(|_| Rect { cx: 20.0 * next(), cy: 20.0 * next(), ux: 1.0, uy: next(), hx: 0.5, hy: 0.3 }).collect()
}

#[test]
fn sparse_ratios() {
    let (a, b) = (rects(1, 400), rects(2, 300));
    let mut matrix = vec![0.0; 400 * 300];
    ratio_matrix(Ratio::OverSmaller, &a[..], &b[..], &mut matrix).unwrap();
    let (first, second) = (Index::new(&[a[..].into()]).unwrap(), Index::new(&[b[..].into()]).unwrap());
    let pairs = first.join_ratio(&second, Ratio::OverSmaller, 0.25).unwrap();
    assert!(pairs.len() > 30);
    assert_eq!(pairs.len(), matrix.iter().filter(|&&value| value >= 0.25).count());
    assert!(pairs.iter().all(|pair| matrix[pair.a as usize * 300 + pair.b as usize] == pair.value));
    assert_eq!(first.join_ratio(&second, Ratio::OverUnion, f64::NAN), Err(Error::Argument));
}

#[test]
fn assignment() {
    let pair = |a, b, value| RatioPair { a, b, value };
    let given = [pair(0, 0, 0.5f32), pair(5, 0, 0.75), pair(0, 1, 0.25), pair(5, 1, 0.625), pair(2, 2, f32::NAN)];
    assert_eq!(assign_greedy(&given), Ok(vec![1, 2]));
    assert_eq!(assign_greedy::<f64>(&[]), Ok(vec![]));
    assert_eq!(assign_greedy(&[pair(-1, 0, 1.0)]), Err(Error::Argument));
}

#[test]
fn fusion() {
    let aabb = |min_x, max_x| Aabb { min_x, min_y: 0.0, max_x, max_y: 4.0 };
    let (boxes, scores) = ([aabb(0.0, 4.0), aabb(0.5, 4.5), aabb(20.0, 24.0)], [0.75, 0.25, 0.5]);
    let plain = Fusion::by_iou(0.55);
    let fused = fuse(&boxes, &scores, plain).unwrap();
    assert_eq!(fused.boxes, [aabb(0.125, 4.125), aabb(20.0, 24.0)]);
    assert_eq!((fused.scores, fused.clusters), (vec![0.5, 0.5], vec![0, 0, 1]));
    let best = fuse(&boxes, &scores, Fusion { score: FusedScore::Max, ..plain }).unwrap();
    assert_eq!(best.scores, [0.75, 0.5]);
    let weighed = fuse(&boxes, &[0.5; 3], Fusion { weights: &[3.0, 1.0, 1.0], ..plain }).unwrap();
    assert_eq!(weighed.boxes[0], aabb(0.125, 4.125));
    let labelled = fuse(&boxes, &scores, Fusion { labels: &[1, 2, 1], ..plain }).unwrap();
    assert_eq!(labelled.clusters, [0, 2, 1]);
    assert_eq!(fuse(&boxes, &[0.75, -1.0, 0.5], plain).unwrap().clusters, [0, -1, 1]);
    assert_eq!(fuse(&boxes, &scores[..2], plain), Err(Error::Counts(3, 2)));
    assert_eq!(fuse(&[Circle::<f64>::default()], &[1.0], plain), Err(Error::Kind));
}

#[test]
fn precision() {
    // Detection 1 is better than 0 and takes truth 0; 2 takes a crowd.
    let pair = |a, b, value: f64| RatioPair { a, b, value };
    let pairs = [pair(0, 0, 0.875), pair(1, 0, 0.75), pair(2, 1, 0.875)];
    let flags = [Truth::Counts, Truth::Crowd];
    let (outcomes, taken) = match_truths(MatchRule::Coco, &pairs, &[0.5, 1.0, 0.25], &flags, &[0.5, 0.8]).unwrap();
    use Outcome::{Hit, Ignored, Miss};
    assert_eq!(outcomes, [Miss, Hit, Ignored, Hit, Miss, Ignored]);
    assert_eq!(taken, [-1, 0, 1, 0, -1, 1]);
    let wrong = match_truths(MatchRule::Voc, &pairs, &[0.5, 1.0], &flags, &[0.5]);
    assert_eq!(wrong, Err(Error::Argument));
    // One hit of two truths, after a miss: the best precision is 1/2 up to recall 1/2, then 0.
    assert_eq!(average_precision(PrecisionRule::Voc2010, &[0.5, 1.0, 2.0], &[Hit, Miss, Ignored], 2), Ok(0.25));
    assert!(average_precision::<f32>(PrecisionRule::Coco, &[], &[], 0).unwrap().is_nan());
    assert_eq!(average_precision(PrecisionRule::Coco, &[1.0], &[], 1), Err(Error::Counts(1, 0)));
}
