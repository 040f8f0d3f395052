// SPDX-License-Identifier: Apache-2.0
//! What is done around detectors: assignment, fusion of boxes, average precision.
use crate::error::{answer, filled};
use crate::index::RatioPair;
use crate::shape::KnownKind;
use crate::{Error, Scalar, Shapes};
use alloc::vec;
use alloc::vec::Vec;
use core::ptr;
use vesica_sys as sys;

macro_rules! constants {
    ($($(#[$text:meta])* $name:ident: $repr:ident { $($(#[$meaning:meta])* $member:ident = $value:ident,)* })*) => {$(
        $(#[$text])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[repr($repr)]
        pub enum $name {
            $($(#[$meaning])* $member = sys::$value as $repr,)*
        }
    )*};
}

constants! {
    /// The score of a cluster of boxes that were fused.
    FusedScore: i32 {
        /// The mean of its scores by their weights.
        Mean = VESICA_FUSED_MEAN,
        /// Its highest score.
        Max = VESICA_FUSED_MAX,
    }
    /// Which truth a detection takes, of those whose value is at least the threshold.
    MatchRule: i32 {
        /// The one of the highest value: if it is taken, the detection is a miss.
        Voc = VESICA_MATCH_VOC,
        /// The one of the highest value among those that are free.
        Coco = VESICA_MATCH_COCO,
    }
    /// The part of a truth in the result.
    Truth: u8 {
        /// It counts, and one detection may take it.
        Counts = VESICA_TRUTH_COUNTS,
        /// It does not count, any number may take it: "difficult" (VOC), "iscrowd" (COCO).
        Crowd = VESICA_TRUTH_CROWD,
        /// It does not count, and one may take it: COCO's truths outside a range of areas.
        Ignored = VESICA_TRUTH_IGNORED,
    }
    /// What a detection is.
    Outcome: u8 {
        /// It took no truth: a false positive.
        Miss = VESICA_OUTCOME_MISS,
        /// It took one that counts: a true positive.
        Hit = VESICA_OUTCOME_HIT,
        /// It took one that does not count, and is neither.
        Ignored = VESICA_OUTCOME_IGNORED,
    }
    /// How precision is averaged over recall.
    PrecisionRule: i32 {
        /// At 11 recalls, 0, 0.1 ... 1.
        Voc2007 = VESICA_PRECISION_VOC_2007,
        /// At every truth: the area under the curve, of VOC from 2010 on.
        Voc2010 = VESICA_PRECISION_VOC_2010,
        /// At 101 recalls, 0, 0.01 ... 1.
        Coco = VESICA_PRECISION_COCO,
    }
}

/// Scratch of so many bytes, aligned to 8.
fn scratch_of(size: impl FnOnce() -> i64) -> Result<Vec<u64>, Error> {
    Ok(vec![0; (answer(size)? + 7) / 8])
}

fn size(scratch: &[u64]) -> i64 {
    (scratch.len() * 8) as i64
}

/// Pairs in columns.
fn columns<T: Scalar>(pairs: &[RatioPair<T>]) -> (Vec<i64>, Vec<i64>, Vec<T>) {
    let (a, b) = pairs.iter().map(|pair| (pair.a, pair.b)).unzip();
    (a, b, pairs.iter().map(|pair| pair.value).collect())
}

fn end_of(items: &[i64]) -> i64 {
    items.iter().map(|item| item.saturating_add(1)).max().unwrap_or(0).max(0)
}

/// Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both free,
/// until there is none. Which of `pairs`, the best first; of equal values the pair with the lower `a`, then `b`.
pub fn assign_greedy<T: Scalar>(pairs: &[RatioPair<T>]) -> Result<Vec<i64>, Error> {
    let (a, b, values) = columns(pairs);
    let (count, count_a, count_b) = (pairs.len() as i64, end_of(&a), end_of(&b));
    let mut scratch = scratch_of(|| unsafe { sys::vesica_assign_greedy_scratch(count, count_a, count_b) })?;
    let mut chosen = vec![0; pairs.len()];
    let (bytes, with, to) = (size(&scratch), scratch.as_mut_ptr().cast(), chosen.as_mut_ptr());
    let (a, b, values) = (a.as_ptr(), b.as_ptr(), values.as_ptr());
    let taken = answer(|| unsafe { T::assign_greedy(a, b, values, count, count_a, count_b, with, bytes, to) })?;
    chosen.truncate(taken);
    Ok(chosen)
}

/// How [`fuse`] works.
#[derive(Clone, Copy, Debug)]
pub struct Fusion<'a, T> {
    /// A box joins the cluster whose mean it has the highest IoU with, if that exceeds this.
    pub threshold: T,
    /// One for each box, such as that of its model. Empty if all are 1.
    pub weights: &'a [T],
    /// One for each box: only boxes of the same label are fused. Empty if all are alike.
    pub labels: &'a [i32],
    /// The score of a cluster.
    pub score: FusedScore,
}

impl<T> Fusion<'_, T> {
    /// Without weights and labels, by the mean score.
    pub fn by_iou(threshold: T) -> Self {
        Fusion { threshold, weights: &[], labels: &[], score: FusedScore::Mean }
    }
}

/// What boxes became.
#[derive(Clone, Debug, PartialEq)]
pub struct Fused<S, T> {
    /// The mean of each cluster.
    pub boxes: Vec<S>,
    /// The score of each cluster.
    pub scores: Vec<T>,
    /// The cluster of each box that was given. It is -1 if the box, its score or its weight is invalid.
    pub clusters: Vec<i64>,
}

/// Weighted boxes fusion: boxes of one object, [`Aabb`](crate::Aabb) or [`Rect`](crate::Rect), become their mean by
/// score times weight.
pub fn fuse<S>(boxes: &[S], scores: &[S::Scalar], how: Fusion<'_, S::Scalar>) -> Result<Fused<S, S::Scalar>, Error>
where
    S: KnownKind + Default,
{
    let n = boxes.len();
    if scores.len() != n {
        return Err(Error::Counts(n, scores.len()));
    }
    for given in [how.weights.len(), how.labels.len()] {
        if given != 0 && given != n {
            return Err(Error::Counts(n, given));
        }
    }
    let mut scratch = scratch_of(|| unsafe { sys::vesica_fuse_scratch(n as i64) })?;
    let mut out = Fused { boxes: vec![S::default(); n], scores: vec![S::Scalar::default(); n], clusters: vec![0; n] };
    let weights = if how.weights.is_empty() { ptr::null() } else { how.weights.as_ptr() };
    let labels = if how.labels.is_empty() { ptr::null() } else { how.labels.as_ptr() };
    let (shapes, scores, mut count) = (Shapes::from(boxes), scores.as_ptr(), 0);
    let (bytes, with, score) = (size(&scratch), scratch.as_mut_ptr().cast(), how.score as i32);
    let (fused, to) = (out.boxes.as_mut_ptr().cast(), (out.scores.as_mut_ptr(), out.clusters.as_mut_ptr()));
    let view = &shapes.view;
    let result = answer(|| unsafe {
        S::Scalar::fuse(view, scores, weights, labels, how.threshold, score, with, bytes, fused, to.0, to.1, &mut count)
    });
    if result != Err(Error::Shape) {
        result?;
    }
    out.boxes.truncate(count as usize);
    out.scores.truncate(count as usize);
    Ok(out)
}

/// Which detections hit a truth, at each of some thresholds? Rows, one for each threshold, of the outcome of each
/// detection, and of the truth that it took, or -1.
///
/// In a pair, `a` is a detection and `b` a truth. `scores` has one for each detection, and `flags` one for each truth.
pub fn match_truths<T: Scalar>(
    rule: MatchRule,
    pairs: &[RatioPair<T>],
    scores: &[T],
    flags: &[Truth],
    thresholds: &[T],
) -> Result<(Vec<Outcome>, Vec<i64>), Error> {
    let (a, b, values) = columns(pairs);
    let (count, detections, truths) = (pairs.len() as i64, scores.len() as i64, flags.len() as i64);
    let mut scratch = scratch_of(|| unsafe { sys::vesica_match_truths_scratch(count, detections, truths) })?;
    let results = scores.len().saturating_mul(thresholds.len());
    let (mut outcomes, mut taken) = (vec![Outcome::Miss; results], vec![0; results]);
    let (a, b, values, scores) = (a.as_ptr(), b.as_ptr(), values.as_ptr(), scores.as_ptr());
    let (flags, rows, row_count) = (flags.as_ptr().cast(), thresholds.as_ptr(), thresholds.len() as i64);
    let (bytes, with, rule) = (size(&scratch), scratch.as_mut_ptr().cast(), rule as i32);
    let (to, took) = (outcomes.as_mut_ptr().cast(), taken.as_mut_ptr());
    answer(|| unsafe {
        T::match_truths(
            rule, a, b, values, count, scores, detections, flags, truths, rows, row_count, with, bytes, to, took,
        )
    })?;
    Ok((outcomes, taken))
}

/// The average precision of detections of one class, or NaN without truths. `truths`: how many of them count.
pub fn average_precision<T: Scalar>(
    rule: PrecisionRule,
    scores: &[T],
    outcomes: &[Outcome],
    truths: usize,
) -> Result<T, Error> {
    if scores.len() != outcomes.len() {
        return Err(Error::Counts(scores.len(), outcomes.len()));
    }
    let (count, truths, rule) = (scores.len() as i64, truths as i64, rule as i32);
    let mut scratch = scratch_of(|| unsafe { sys::vesica_average_precision_scratch(count) })?;
    let (bytes, with) = (size(&scratch), scratch.as_mut_ptr().cast());
    let (scores, outcomes) = (scores.as_ptr(), outcomes.as_ptr().cast());
    filled(T::default(), |out| unsafe { T::average_precision(rule, scores, outcomes, count, truths, with, bytes, out) })
}
