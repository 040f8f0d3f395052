// SPDX-License-Identifier: Apache-2.0
//! Within a distance, signed distances, nine-intersection matrices, shared regions, and soft suppression.
use crate::batch::{ended, in_step, room};
use crate::error::answer;
use crate::{Error, Ratio, Scalar, Shape, Shapes};
use core::ptr;
use vesica_sys as sys;

/// Whether two shapes are at most so far apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Within {
    /// They are farther apart.
    No = sys::VESICA_WITHIN_NO as u8,
    /// They are not.
    Yes = sys::VESICA_WITHIN_YES as u8,
    /// Only of two ellipses: their distance is too near the one asked for to decide.
    Nearly = sys::VESICA_WITHIN_NEARLY as u8,
}

impl Default for Within {
    fn default() -> Self {
        Within::No
    }
}

/// Are two shapes at most `distance` apart? Exactly so far counts, and exact, but for ellipses. With a negative distance:
/// do they overlap at least that deep?
pub fn within<A, B>(a: &A, b: &B, distance: A::Scalar) -> Result<Within, Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b) = (a.kind() as i32, b.kind() as i32);
    let (a, b) = (a.address(), b.address());
    let code = answer(|| unsafe { A::Scalar::within(kind_a, a, kind_b, b, distance) })?;
    Ok([Within::No, Within::Yes, Within::Nearly][code])
}

/// Are `a[i]` and `b[i]` at most `distance` apart? Returns how many are, or nearly.
///
/// If a shape is invalid its own answer is no, all others are written, and the call is an error.
pub fn within_many<'a, 'b, T: Scalar>(
    a: impl Into<Shapes<'a, T>>,
    b: impl Into<Shapes<'b, T>>,
    distance: T,
    out: &mut [Within],
) -> Result<usize, Error> {
    let (a, b) = (a.into(), b.into());
    room(out, in_step(&a, &b)?)?;
    answer(|| unsafe { T::within_many(&a.view, &b.view, distance, out.as_mut_ptr().cast()) })
}

/// Is each of a at most `distance` from each of b? Rows one after the other. Else as [`within_many`].
pub fn within_matrix<'a, 'b, T: Scalar>(
    a: impl Into<Shapes<'a, T>>,
    b: impl Into<Shapes<'b, T>>,
    distance: T,
    out: &mut [Within],
) -> Result<usize, Error> {
    let (a, b) = (a.into(), b.into());
    room(out, a.len().saturating_mul(b.len()))?;
    let row = b.len() as isize;
    answer(|| unsafe { T::within_matrix(&a.view, &b.view, distance, out.as_mut_ptr().cast(), row) })
}

/// The nine-intersection matrix of two shapes, as geographic systems have it: nine of the letters F, 0, 1 and 2. Exact.
pub fn de9im<A, B>(a: &A, b: &B) -> Result<[u8; 9], Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b, mut text) = (a.kind() as i32, b.kind() as i32, [0; 10]);
    let (a, b) = (a.address(), b.address());
    answer(|| unsafe { A::Scalar::de9im(kind_a, a, kind_b, b, text.as_mut_ptr()) })?;
    let mut matrix = [0; 9];
    matrix.copy_from_slice(&text[..9]);
    Ok(matrix)
}

/// Does such a matrix fit a pattern of F, 0, 1, 2, T (any of 0, 1 and 2) and * (anything), as `b"T*F**F***"`?
pub fn de9im_match(matrix: &[u8], pattern: &[u8]) -> Result<bool, Error> {
    let text = |letters: &[u8]| -> Result<[u8; 10], Error> {
        let mut text = [0; 10];
        if letters.len() != 9 || letters.contains(&0) {
            return Err(Error::Argument);
        }
        text[..9].copy_from_slice(letters);
        Ok(text)
    };
    let (matrix, pattern) = (text(matrix)?, text(pattern)?);
    Ok(answer(|| unsafe { sys::vesica_de9im_match(matrix.as_ptr(), pattern.as_ptr()) })? == 1)
}

/// The region that two shapes share: its vertices x y, of which the first `count` are so, counter-clockwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Region<T> {
    count: usize,
    vertices: [[T; 2]; 8],
}

impl<T> Region<T> {
    /// The vertices: none where nothing is shared, one for a point, two for the ends of a segment.
    pub fn vertices(&self) -> &[[T; 2]] {
        &self.vertices[..self.count]
    }
}

/// The region that two shapes share: of points, segments, boxes, rectangles and convex polygons; of a point or a segment
/// and anything. `Error::Room` if there are more than eight vertices: then take `intersection_into`.
pub fn intersection<A, B>(a: &A, b: &B) -> Result<Region<A::Scalar>, Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b, mut region) = (a.kind() as i32, b.kind() as i32, Region::default());
    let (a, b) = (a.address(), b.address());
    let to = region.vertices.as_mut_ptr().cast();
    region.count = answer(|| unsafe { A::Scalar::intersection(kind_a, a, kind_b, b, to, 8) })?;
    if region.count > region.vertices.len() {
        return Err(Error::Room { needed: region.count, given: region.vertices.len() });
    }
    Ok(region)
}

/// The same in an output of any length. Returns how many vertices there are, and `Error::Room` if that is more. Of a
/// segment and a polygon or a polyline, two for each piece, in order along the segment.
pub fn intersection_into<A, B>(a: &A, b: &B, out: &mut [[A::Scalar; 2]]) -> Result<usize, Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b, given) = (a.kind() as i32, b.kind() as i32, out.len());
    let (a, b, to) = (a.address(), b.address(), out.as_mut_ptr().cast());
    let needed = answer(|| unsafe { A::Scalar::intersection(kind_a, a, kind_b, b, to, given as i64) })?;
    if needed > given {
        return Err(Error::Room { needed, given });
    }
    Ok(needed)
}

/// How soft suppression lowers the score of what has a ratio r with a shape that is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Decay<T> {
    /// Times 1 - r, where r is above this threshold.
    Linear(T),
    /// Times exp(-r^2 / this).
    Gaussian(T),
}

/// How [`suppress_soft`] chooses.
#[derive(Clone, Copy, Debug)]
pub struct SoftSuppression<'a, T> {
    /// How scores are lowered.
    pub decay: Decay<T>,
    /// Any but [`Ratio::OverFirst`] and [`Ratio::OverSecond`].
    pub ratio: Ratio,
    /// One for each shape: only shapes of the same label lower one another. Empty if all are alike.
    pub labels: &'a [i32],
    /// Ends when no score is left that is at least this, from 0.
    pub least_score: T,
    /// How many are kept at most.
    pub most: usize,
}

/// Numbers of 8 bytes of scratch that [`suppress_soft`] needs for so many shapes.
pub fn suppress_soft_scratch(count: usize) -> Result<usize, Error> {
    Ok(answer(|| unsafe { sys::vesica_suppress_soft_scratch(count as i64) })? / 8)
}

/// Soft suppression: writes the indices as they are taken, and the scores that were left then. Returns how many.
///
/// After an error about an invalid shape or a score that is NaN, those taken of the others are written, and -1 ends them
/// unless they fill keep.
pub fn suppress_soft<'a, T: Scalar>(
    shapes: impl Into<Shapes<'a, T>>,
    scores: &[T],
    how: SoftSuppression<'_, T>,
    scratch: &mut [u64],
    keep: &mut [i64],
    decayed: &mut [T],
) -> Result<usize, Error> {
    let shapes = shapes.into();
    let n = shapes.len();
    for given in [scores.len(), if how.labels.is_empty() { n } else { how.labels.len() }] {
        if given != n {
            return Err(Error::Counts(n, given));
        }
    }
    let most = how.most.min(n);
    room(keep, most)?;
    room(decayed, most)?;
    room(scratch, suppress_soft_scratch(n)?)?;
    let labels = if how.labels.is_empty() { ptr::null() } else { how.labels.as_ptr() };
    let (decay, parameter) = match how.decay {
        Decay::Linear(threshold) => (sys::VESICA_DECAY_LINEAR, threshold),
        Decay::Gaussian(parameter) => (sys::VESICA_DECAY_GAUSSIAN, parameter),
    };
    let (with, size) = (scratch.as_mut_ptr().cast(), 8 * scratch.len() as i64);
    let (to, left, mut kept) = (keep.as_mut_ptr(), decayed.as_mut_ptr(), 0);
    let (ratio, least, most, scores) = (how.ratio as i32, how.least_score, most as i64, scores.as_ptr());
    let view = &shapes.view;
    let result = answer(|| unsafe {
        T::suppress_soft(view, scores, labels, ratio, decay, parameter, least, most, with, size, to, left, &mut kept)
    });
    ended(result, kept, keep)
}
