// SPDX-License-Identifier: Apache-2.0
//! Questions about arrays: in step, of every pair, and choices among many.
use crate::error::answer;
use crate::{Error, Relation, Scalar, Shape, Shapes};
use core::ptr;
use vesica_sys as sys;

/// Columns for [`nearest_many`] and [`boundary_distance_many`]; those of length 0 are not written, but one must be.
#[derive(Debug, Default)]
#[allow(missing_docs)]
pub struct ClosestPointsColumns<'a, T> {
    pub distance: &'a mut [T],
    pub ax: &'a mut [T],
    pub ay: &'a mut [T],
    pub bx: &'a mut [T],
    pub by: &'a mut [T],
}

/// Columns for [`depth_many`]; those of length 0 are not written, but one must be.
#[derive(Debug, Default)]
#[allow(missing_docs)]
pub struct PenetrationColumns<'a, T> {
    pub depth: &'a mut [T],
    pub x: &'a mut [T],
    pub y: &'a mut [T],
}

/// How many answers arrays in step have.
pub(crate) fn in_step<T: Scalar>(a: &Shapes<'_, T>, b: &Shapes<'_, T>) -> Result<usize, Error> {
    match (a.len(), b.len()) {
        (a, b) if a == b || b == 1 => Ok(a),
        (1, b) => Ok(b),
        (a, b) => Err(Error::Counts(a, b)),
    }
}

pub(crate) fn room<R>(out: &[R], needed: usize) -> Result<(), Error> {
    if out.len() < needed {
        return Err(Error::Room { needed, given: out.len() });
    }
    Ok(())
}

/// The address of a column, or NULL for one that is not wanted.
pub(crate) fn column<T>(out: &mut [T], needed: usize) -> Result<*mut T, Error> {
    if out.is_empty() {
        return Ok(ptr::null_mut());
    }
    room(out, needed)?;
    Ok(out.as_mut_ptr())
}

// bool and Relation are bytes, and the library writes none but theirs.
macro_rules! many {
    ($($(#[$text:meta])* $name:ident: $result:ty as $written:ty;)*) => {$(
        $(#[$text])*
        ///
        /// Two arrays in step, or one shape against an array. If a shape is invalid its own result is 0 or NaN, all
        /// others are written, and the call is an error.
        pub fn $name<'a, 'b, T: Scalar>(
            a: impl Into<Shapes<'a, T>>,
            b: impl Into<Shapes<'b, T>>,
            out: &mut [$result],
        ) -> Result<usize, Error> {
            let (a, b) = (a.into(), b.into());
            room(out, in_step(&a, &b)?)?;
            answer(|| unsafe { T::$name(&a.view, &b.view, out.as_mut_ptr().cast::<$written>()) })
        }
    )*};
}

many! {
    /// Do `a[i]` and `b[i]` share a point? Returns how many do.
    overlap_many: bool as u8;
    /// Do the insides of `a[i]` and `b[i]` share a point? Returns how many do.
    interiors_overlap_many: bool as u8;
    /// How does `a[i]` relate to `b[i]`? Returns how many are not disjoint.
    relation_many: Relation as u8;
    /// Does `a[i]` hold all of `b[i]`? Returns how many do.
    contains_many: bool as u8;
    /// The area that `a[i]` and `b[i]` share. Returns how many are above 0.
    area_many: T as T;
    /// The distance of `a[i]` and `b[i]` or, below 0, how deep they overlap. Returns how many overlap.
    signed_distance_many: T as T;
    /// Intersection over union of `a[i]` and `b[i]`. Returns how many are above 0.
    iou_many: T as T;
}

macro_rules! matrix {
    ($($(#[$text:meta])* $name:ident: $result:ty as $written:ty;)*) => {$(
        $(#[$text])*
        ///
        /// Rows one after the other: `out[i * b.len() + j]` is of `a[i]` and `b[j]`. If a shape is invalid its own
        /// results are 0 or NaN, all others are written, and the call is an error.
        pub fn $name<'a, 'b, T: Scalar>(
            a: impl Into<Shapes<'a, T>>,
            b: impl Into<Shapes<'b, T>>,
            out: &mut [$result],
        ) -> Result<usize, Error> {
            let (a, b) = (a.into(), b.into());
            room(out, a.len().saturating_mul(b.len()))?;
            let row = b.len() as isize;
            answer(|| unsafe { T::$name(&a.view, &b.view, out.as_mut_ptr().cast::<$written>(), row) })
        }
    )*};
}

matrix! {
    /// Does each of a overlap each of b? Returns how many pairs do.
    overlap_matrix: bool as u8;
    /// Do the insides of each of a and each of b share a point? Returns how many pairs do.
    interiors_overlap_matrix: bool as u8;
    /// How does each of a relate to each of b? Returns how many are not disjoint.
    relation_matrix: Relation as u8;
    /// Does each of a hold all of each of b? Returns how many do.
    contains_matrix: bool as u8;
    /// The area that each of a shares with each of b. Returns how many are above 0.
    area_matrix: T as T;
    /// Intersection over union of each of a with each of b. Returns how many are above 0.
    iou_matrix: T as T;
    /// The distance of each of a from each of b. Returns how many pairs overlap.
    nearest_matrix: T as T;
    /// The distance of the outline of each of a from that of each of b. Returns how many pairs of outlines meet.
    boundary_distance_matrix: T as T;
    /// How deep each of a and each of b overlap. Returns how many depths are above 0.
    depth_matrix: T as T;
    /// The signed distance of each of a and each of b. Returns how many pairs overlap.
    signed_distance_matrix: T as T;
}

macro_rules! closest {
    ($($(#[$text:meta])* $name:ident;)*) => {$(
        $(#[$text])*
        pub fn $name<'a, 'b, T: Scalar>(
            a: impl Into<Shapes<'a, T>>,
            b: impl Into<Shapes<'b, T>>,
            out: ClosestPointsColumns<'_, T>,
        ) -> Result<usize, Error> {
            let (a, b) = (a.into(), b.into());
            let n = in_step(&a, &b)?;
            let distance = column(out.distance, n)?;
            let (ax, ay) = (column(out.ax, n)?, column(out.ay, n)?);
            let (bx, by) = (column(out.bx, n)?, column(out.by, n)?);
            answer(|| unsafe { T::$name(&a.view, &b.view, distance, ax, ay, bx, by) })
        }
    )*};
}

closest! {
    /// How far are `a[i]` and `b[i]` apart, and where? Returns how many overlap.
    nearest_many;
    /// How far are the outlines of `a[i]` and `b[i]` apart, and where? Returns how many meet.
    boundary_distance_many;
}

/// How deep do `a[i]` and `b[i]` overlap? Returns how many depths are above 0.
pub fn depth_many<'a, 'b, T: Scalar>(
    a: impl Into<Shapes<'a, T>>,
    b: impl Into<Shapes<'b, T>>,
    out: PenetrationColumns<'_, T>,
) -> Result<usize, Error> {
    let (a, b) = (a.into(), b.into());
    let n = in_step(&a, &b)?;
    let (depth, x, y) = (column(out.depth, n)?, column(out.x, n)?, column(out.y, n)?);
    answer(|| unsafe { T::depth_many(&a.view, &b.view, depth, x, y) })
}

/// Which of many shapes overlap one? Their indices are written in ascending order, as many as there is room for.
///
/// Returns how many there are. After an error about an invalid shape the others are written, and -1 ends them.
pub fn overlap_select<'b, S: Shape + ?Sized>(
    one: &S,
    many: impl Into<Shapes<'b, S::Scalar>>,
    out: &mut [i64],
) -> Result<usize, Error> {
    let (one, many) = (Shapes::one(one), many.into());
    answer(|| unsafe { S::Scalar::overlap_select(&one.view, &many.view, out.as_mut_ptr(), out.len() as i64) })
}

/// Which of many shapes have insides that share a point with that of one? Otherwise as [`overlap_select`].
pub fn interiors_overlap_select<'b, S: Shape + ?Sized>(
    one: &S,
    many: impl Into<Shapes<'b, S::Scalar>>,
    out: &mut [i64],
) -> Result<usize, Error> {
    let (one, many) = (Shapes::one(one), many.into());
    let (out, room) = (out.as_mut_ptr(), out.len() as i64);
    answer(|| unsafe { S::Scalar::interiors_overlap_select(&one.view, &many.view, out, room) })
}

/// How many are kept. After an error about an invalid shape -1 ends them, for the error does not tell.
pub(crate) fn ended(result: Result<usize, Error>, kept: i64, keep: &mut [i64]) -> Result<usize, Error> {
    if let (Err(Error::Shape), Some(end)) = (result, keep.get_mut(kept as usize)) {
        *end = -1;
    }
    result.map(|_| kept as usize)
}

/// Bytes of scratch that [`nms`] needs for so many shapes.
pub fn nms_scratch(count: usize) -> Result<usize, Error> {
    answer(|| unsafe { sys::vesica_nms_scratch(count as i64) })
}

/// Greedy suppression: writes the indices of the shapes kept, best score first, and returns how many they are.
///
/// Each shape kept has an intersection over union of at most `threshold` with every better one that was kept. The
/// scratch has [`nms_scratch`] bytes or more. After an error about an invalid shape or a score that is NaN, those kept
/// of the others are written, and -1 ends them.
pub fn nms<'a, T: Scalar>(
    shapes: impl Into<Shapes<'a, T>>,
    scores: &[T],
    threshold: T,
    scratch: &mut [u8],
    keep: &mut [i64],
) -> Result<usize, Error> {
    let shapes = shapes.into();
    if scores.len() != shapes.len() {
        return Err(Error::Counts(shapes.len(), scores.len()));
    }
    room(keep, shapes.len())?;
    room(scratch, nms_scratch(shapes.len())?)?;
    let mut kept = 0;
    let (room, to) = (scratch.len() as i64, keep.as_mut_ptr());
    let scratch = scratch.as_mut_ptr().cast();
    let result = answer(|| unsafe { T::nms(&shapes.view, scores.as_ptr(), threshold, scratch, room, to, &mut kept) });
    ended(result, kept, keep)
}
