// SPDX-License-Identifier: Apache-2.0
//! Ratios of shared area, suppression by them, and arrays of boxes by centre, size and angle.
use crate::batch::{ended, in_step, nms_scratch, room};
use crate::error::{answer, filled};
use crate::{Aabb, Ellipse, Error, Rect, Scalar, Shape, Shapes};
use core::ptr;
use vesica_sys as sys;

/// What a shared area is compared with. The hull of two shapes is the smallest box along the axes about both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Ratio {
    /// The area of both together (IoU).
    OverUnion = sys::VESICA_RATIO_OVER_UNION,
    /// The area of a (IoF).
    OverFirst = sys::VESICA_RATIO_OVER_FIRST,
    /// The area of b (IoA).
    OverSecond = sys::VESICA_RATIO_OVER_SECOND,
    /// The smaller of the areas (IoS).
    OverSmaller = sys::VESICA_RATIO_OVER_SMALLER,
    /// IoU less the part of the hull that neither covers (GIoU).
    Generalized = sys::VESICA_RATIO_GENERALIZED,
    /// IoU less the square of the distance of the centres over the hull's diagonal (DIoU).
    Distance = sys::VESICA_RATIO_DISTANCE,
    /// DIoU less a term for unlike aspect ratios (CIoU).
    Complete = sys::VESICA_RATIO_COMPLETE,
}

/// A ratio of two shapes. It is an error if the shape whose area divides has none, or neither has.
pub fn ratio<A, B>(which: Ratio, a: &A, b: &B) -> Result<A::Scalar, Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b) = (a.kind() as i32, b.kind() as i32);
    let (a, b) = (a.address(), b.address());
    filled(A::Scalar::default(), |out| unsafe { A::Scalar::ratio(which as i32, kind_a, a, kind_b, b, out) })
}

/// A ratio of `a[i]` and `b[i]`. Returns how many are above 0.
///
/// Where there is none the result is NaN, all others are written, and the call is an error.
pub fn ratio_many<'a, 'b, T: Scalar>(
    which: Ratio,
    a: impl Into<Shapes<'a, T>>,
    b: impl Into<Shapes<'b, T>>,
    out: &mut [T],
) -> Result<usize, Error> {
    let (a, b) = (a.into(), b.into());
    room(out, in_step(&a, &b)?)?;
    answer(|| unsafe { T::ratio_many(which as i32, &a.view, &b.view, out.as_mut_ptr()) })
}

/// A ratio of each of a with each of b, rows one after the other. Else as [`ratio_many`].
pub fn ratio_matrix<'a, 'b, T: Scalar>(
    which: Ratio,
    a: impl Into<Shapes<'a, T>>,
    b: impl Into<Shapes<'b, T>>,
    out: &mut [T],
) -> Result<usize, Error> {
    let (a, b) = (a.into(), b.into());
    room(out, a.len().saturating_mul(b.len()))?;
    answer(|| unsafe { T::ratio_matrix(which as i32, &a.view, &b.view, out.as_mut_ptr(), b.len() as isize) })
}

/// How [`suppress`] chooses.
#[derive(Clone, Copy, Debug)]
pub struct Suppression<'a, T> {
    /// The ratio of a shape kept with every better one that was kept is at most this.
    pub threshold: T,
    /// Any but [`Ratio::OverFirst`] and [`Ratio::OverSecond`].
    pub ratio: Ratio,
    /// One for each shape: only shapes of the same label suppress one another. Empty if all are alike.
    pub labels: &'a [i32],
    /// Shapes below it are not looked at.
    pub least_score: Option<T>,
    /// How many are kept at most.
    pub most: usize,
}

impl<T> Suppression<'_, T> {
    /// By intersection over union, all labels alike, without a least score or a greatest number.
    pub fn by_iou(threshold: T) -> Self {
        Suppression { threshold, ratio: Ratio::OverUnion, labels: &[], least_score: None, most: usize::MAX }
    }
}

/// Greedy suppression: writes the indices of the shapes kept, best score first, and returns how many they are.
///
/// The scratch has [`nms_scratch`] bytes or more, and keep room for all shapes, or for as many as are kept at most. After
/// an error about an invalid shape or a score that is NaN, those kept of the others are written, and -1 ends them unless
/// they fill keep.
pub fn suppress<'a, T: Scalar + From<f32>>(
    shapes: impl Into<Shapes<'a, T>>,
    scores: &[T],
    how: Suppression<'_, T>,
    scratch: &mut [u8],
    keep: &mut [i64],
) -> Result<usize, Error> {
    let shapes = shapes.into();
    let n = shapes.len();
    if scores.len() != n {
        return Err(Error::Counts(n, scores.len()));
    }
    if !how.labels.is_empty() && how.labels.len() != n {
        return Err(Error::Counts(n, how.labels.len()));
    }
    let most = how.most.min(n);
    room(keep, most)?;
    room(scratch, nms_scratch(n)?)?;
    let labels = if how.labels.is_empty() { ptr::null() } else { how.labels.as_ptr() };
    let least = how.least_score.unwrap_or_else(|| f32::NEG_INFINITY.into());
    let (size, to, mut kept) = (scratch.len() as i64, keep.as_mut_ptr(), 0);
    let (scores, with) = (scores.as_ptr(), scratch.as_mut_ptr().cast());
    let (ratio, threshold, most) = (how.ratio as i32, how.threshold, most as i64);
    let result = answer(|| unsafe {
        T::suppress(&shapes.view, scores, labels, ratio, threshold, least, most, with, size, to, &mut kept)
    });
    ended(result, kept, keep)
}

/// How the angle of a box is told: in radians, degrees or quarter turns, from +x towards +y or the other way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Angle(i32);

impl Angle {
    /// From +x towards +y: counter-clockwise if y points up, clockwise on a screen.
    pub const RADIANS: Angle = Angle(sys::VESICA_ANGLE_RADIANS);
    /// Multiples of 90 turn exactly.
    pub const DEGREES: Angle = Angle(sys::VESICA_ANGLE_DEGREES);
    /// Whole ones turn exactly.
    pub const QUARTERS: Angle = Angle(sys::VESICA_ANGLE_QUARTERS);

    /// The same unit, from +x away from +y.
    pub const fn reversed(self) -> Angle {
        Angle(self.0 | sys::VESICA_ANGLE_REVERSED)
    }
}

macro_rules! from_boxes {
    ($($(#[$text:meta])* $name:ident -> $shape:ident;)*) => {$(
        $(#[$text])*
        ///
        /// A box is the first five numbers of a row: centre x, y, width along the angle, height across it, angle. Of
        /// an invalid box all numbers are NaN, all others are written, and the call is an error.
        pub fn $name<T: Scalar, const N: usize>(
            boxes: &[[T; N]],
            angle: Angle,
            out: &mut [$shape<T>],
        ) -> Result<(), Error> {
            if N < 5 {
                return Err(Error::Room { needed: 5, given: N });
            }
            room(out, boxes.len())?;
            let (from, count) = (boxes.as_ptr().cast(), boxes.len() as i64);
            let stride = core::mem::size_of::<[T; N]>() as isize;
            answer(|| unsafe { T::$name(from, count, stride, angle.0, out.as_mut_ptr()) }).map(drop)
        }
    )*};
}

from_boxes! {
    /// Rectangles from boxes.
    rects_from_boxes -> Rect;
    /// Ellipses from the boxes about them, whose sides they touch in the middle.
    ellipses_from_boxes -> Ellipse;
}

/// The way back: boxes of rectangles, or about ellipses.
pub fn boxes_from_shapes<'a, T: Scalar>(
    shapes: impl Into<Shapes<'a, T>>,
    angle: Angle,
    out: &mut [[T; 5]],
) -> Result<(), Error> {
    let shapes = shapes.into();
    room(out, shapes.len())?;
    answer(|| unsafe { T::boxes_from_shapes(&shapes.view, angle.0, out.as_mut_ptr().cast()) }).map(drop)
}

/// The corners x0 y0 ... x3 y3 of rectangles, or of the boxes about ellipses.
pub fn corners_of_shapes<'a, T: Scalar>(shapes: impl Into<Shapes<'a, T>>, out: &mut [[T; 8]]) -> Result<(), Error> {
    let shapes = shapes.into();
    room(out, shapes.len())?;
    answer(|| unsafe { T::corners_of_shapes(&shapes.view, out.as_mut_ptr().cast()) }).map(drop)
}

/// The smallest boxes of representable numbers that contain shapes.
pub fn bounds_many<'a, T: Scalar>(shapes: impl Into<Shapes<'a, T>>, out: &mut [Aabb<T>]) -> Result<(), Error> {
    let shapes = shapes.into();
    room(out, shapes.len())?;
    answer(|| unsafe { T::bounds_many(&shapes.view, out.as_mut_ptr()) }).map(drop)
}
