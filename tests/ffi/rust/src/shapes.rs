// SPDX-License-Identifier: Apache-2.0
//! The shapes, laid out as the library's structs.
pub use crate::c::{Aabb, Circle, Ellipse, Point, Rect, Segment};
use crate::Scalar;

/// What the library takes for a shape.
///
/// # Safety
/// The type is laid out as the numbers of a shape of that kind, in its order.
pub unsafe trait Shape {
    type Scalar: Scalar;
    const KIND: i32;
}

unsafe impl<T: Scalar> Shape for Point<T> {
    type Scalar = T;
    const KIND: i32 = 0;
}
unsafe impl<T: Scalar> Shape for Segment<T> {
    type Scalar = T;
    const KIND: i32 = 1;
}
unsafe impl<T: Scalar> Shape for Circle<T> {
    type Scalar = T;
    const KIND: i32 = 2;
}
unsafe impl<T: Scalar> Shape for Aabb<T> {
    type Scalar = T;
    const KIND: i32 = 3;
}
unsafe impl<T: Scalar> Shape for Rect<T> {
    type Scalar = T;
    const KIND: i32 = 4;
}
unsafe impl<T: Scalar> Shape for Ellipse<T> {
    type Scalar = T;
    const KIND: i32 = 5;
}
