// SPDX-License-Identifier: Apache-2.0
//! The shapes, laid out as the library's structs.
use crate::Scalar;

/// What the library takes for a shape.
///
/// # Safety
/// The type is laid out as the numbers of a shape of that kind, in its order.
pub unsafe trait Shape {
    type Scalar: Scalar;
    const KIND: i32;
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<T> {
    pub x: T,
    pub y: T,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment<T> {
    pub x0: T,
    pub y0: T,
    pub x1: T,
    pub y1: T,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle<T> {
    pub cx: T,
    pub cy: T,
    pub r: T,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb<T> {
    pub min_x: T,
    pub min_y: T,
    pub max_x: T,
    pub max_y: T,
}

/// Centre, axis (cosine and sine of the angle), half extents.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect<T> {
    pub cx: T,
    pub cy: T,
    pub ux: T,
    pub uy: T,
    pub hx: T,
    pub hy: T,
}

/// Centre, axis, half lengths.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse<T> {
    pub cx: T,
    pub cy: T,
    pub ux: T,
    pub uy: T,
    pub a: T,
    pub b: T,
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
