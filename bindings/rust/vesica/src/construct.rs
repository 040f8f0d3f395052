// SPDX-License-Identifier: Apache-2.0
//! Shapes from other descriptions. [`sys`](crate::sys) has the whole text of each.
use crate::error::filled;
use crate::{Aabb, Capsule, Ellipse, Error, Rect, RoundRect, Scalar};

macro_rules! constructors {
    ($($(#[$text:meta])* $name:ident($($number:ident),*) -> $shape:ident: $function:ident;)*) => {$(
        $(#[$text])*
        pub fn $name<T: Scalar>($($number: T),*) -> Result<$shape<T>, Error> {
            filled($shape::default(), |out| unsafe { T::$function($($number,)* out) })
        }
    )*};
}

constructors! {
    /// Box with two opposite corners, in any order.
    aabb(x0, y0, x1, y1) -> Aabb: aabb_from_corners;
    /// Rectangle from centre, angle in radians, and whole sizes: width along the angle, height across it.
    rect(cx, cy, angle, width, height) -> Rect: rect_from_angle;
    /// Rounded rectangle from centre, angle in radians, whole sizes with the round corners included, and their radius.
    /// A radius of more than half the width or height is [`Error::Argument`].
    round_rect(cx, cy, angle, width, height, radius) -> RoundRect: round_rect_from_angle;
    /// Capsule from centre, angle in radians, the length between the ends of its segment, and radius.
    capsule(cx, cy, angle, length, radius) -> Capsule: capsule_from_angle;
    /// Capsule from the ends of its segment and its whole width, twice the radius.
    capsule_from_width(x0, y0, x1, y1, width) -> Capsule: capsule_from_width;
    /// Ellipse from centre, angle in radians, and half lengths: a along the angle, b across it.
    ellipse(cx, cy, angle, a, b) -> Ellipse: ellipse_from_angle;
    /// Ellipse from a radius vector: one half axis is (wx, wy), the other ratio times its perpendicular.
    ellipse_from_radius_vector(cx, cy, wx, wy, ratio) -> Ellipse: ellipse_from_radius_vector;
    /// Ellipse of the points within k standard deviations of a mean.
    ellipse_from_covariance(mean_x, mean_y, cxx, cxy, cyy, k) -> Ellipse: ellipse_from_covariance;
    /// Ellipse of the points X with (X - C) . M (X - C) <= 1.
    ellipse_from_matrix(cx, cy, mxx, mxy, myy) -> Ellipse: ellipse_from_matrix;
}

/// Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline. Crossed corners are
/// [`Error::Argument`]; [`rect_corners_misfit`] says how far the corners are off.
pub fn rect_from_corners<T: Scalar>(corners: &[T; 8]) -> Result<Rect<T>, Error> {
    filled(Rect::default(), |out| unsafe { T::rect_from_corners(corners.as_ptr(), out) })
}

/// The largest distance from a given corner to the rectangle's corner that corresponds to it.
pub fn rect_corners_misfit<T: Scalar>(corners: &[T; 8], rect: &Rect<T>) -> Result<T, Error> {
    filled(T::default(), |out| unsafe { T::rect_corners_misfit(corners.as_ptr(), rect, out) })
}
