// SPDX-License-Identifier: Apache-2.0
//! Vesica: exact overlap queries between plain 2D shapes. Touching counts.
use std::ffi::CStr;
use std::fmt;
use std::os::raw::c_char;

pub mod index;
mod shapes;
pub use shapes::{Aabb, Circle, Ellipse, Point, Rect, Segment, Shape};

/// Of the declarations below.
pub const VERSION: i32 = 100;

/// An array of shapes as the library sees it (`vesica_shapes_f64`, `vesica_shapes_f32`).
#[doc(hidden)]
#[repr(C)]
pub struct View<T> {
    kind: i32,
    reserved: i32,
    count: i64,
    stride: isize,
    field: [*const T; 6],
}

extern "C" {
    fn vesica_version() -> i32;
    fn vesica_strerror(code: i32) -> *const c_char;
    fn vesica_overlap_f64(kind_a: i32, a: *const f64, kind_b: i32, b: *const f64) -> i32;
    fn vesica_overlap_f32(kind_a: i32, a: *const f32, kind_b: i32, b: *const f32) -> i32;
    fn vesica_overlap_many_f64(a: *const View<f64>, b: *const View<f64>, out: *mut bool) -> i64;
    fn vesica_overlap_many_f32(a: *const View<f32>, b: *const View<f32>, out: *mut bool) -> i64;
}

/// `f64` and `f32`, each with its functions.
///
/// # Safety
/// Nothing else can be one.
pub unsafe trait Scalar: Copy {
    #[doc(hidden)]
    const OVERLAP: unsafe extern "C" fn(i32, *const Self, i32, *const Self) -> i32;
    #[doc(hidden)]
    const OVERLAP_MANY: unsafe extern "C" fn(*const View<Self>, *const View<Self>, *mut bool) -> i64;
}
unsafe impl Scalar for f64 {
    const OVERLAP: unsafe extern "C" fn(i32, *const f64, i32, *const f64) -> i32 = vesica_overlap_f64;
    const OVERLAP_MANY: unsafe extern "C" fn(*const View<f64>, *const View<f64>, *mut bool) -> i64 =
        vesica_overlap_many_f64;
}
unsafe impl Scalar for f32 {
    const OVERLAP: unsafe extern "C" fn(i32, *const f32, i32, *const f32) -> i32 = vesica_overlap_f32;
    const OVERLAP_MANY: unsafe extern "C" fn(*const View<f32>, *const View<f32>, *mut bool) -> i64 =
        vesica_overlap_many_f32;
}

/// An error of the library, by its code; displayed as what it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Error(pub i32);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = unsafe { CStr::from_ptr(vesica_strerror(self.0)) };
        f.write_str(&text.to_string_lossy())
    }
}
impl std::error::Error for Error {}

fn checked(answer: i64) -> Result<usize, Error> {
    usize::try_from(answer).map_err(|_| Error(answer as i32))
}

/// Once, before the first call: why the library that was loaded will not do.
pub fn require_version() -> Result<(), String> {
    match unsafe { vesica_version() } {
        version if version < VERSION => Err(format!("vesica {version} is older than {VERSION}")),
        _ => Ok(()),
    }
}

/// Do two shapes share a point?
pub fn overlap<A: Shape, B: Shape<Scalar = A::Scalar>>(a: &A, b: &B) -> Result<bool, Error> {
    let (a, b): (*const A, *const B) = (a, b);
    let answer = unsafe { A::Scalar::OVERLAP(A::KIND, a.cast(), B::KIND, b.cast()) };
    Ok(checked(answer.into())? == 1)
}

/// The same of flat numbers, whose kinds are known at run time only.
pub fn overlap_numbers<T: Scalar>(kind_a: i32, a: &[T; 6], kind_b: i32, b: &[T; 6]) -> Result<bool, Error> {
    let answer = unsafe { T::OVERLAP(kind_a, a.as_ptr(), kind_b, b.as_ptr()) };
    Ok(checked(answer.into())? == 1)
}

/// Two slices in step, or one shape against a slice: `out[i]` says whether they overlap. Returns how many do.
/// Where a shape is invalid, `out` is false for it and right for every other, and the error is returned.
pub fn overlap_many<A, B>(a: &[A], b: &[B], out: &mut [bool]) -> Result<usize, Error>
where
    A: Shape,
    B: Shape<Scalar = A::Scalar>,
{
    let count = if a.is_empty() || b.is_empty() { 0 } else { a.len().max(b.len()) };
    assert!(out.len() >= count, "out has {} elements, {count} are needed", out.len());
    checked(unsafe { A::Scalar::OVERLAP_MANY(&view(a), &view(b), out.as_mut_ptr()) })
}

fn view<S: Shape>(shapes: &[S]) -> View<S::Scalar> {
    let first: *const S::Scalar = shapes.as_ptr().cast();
    let field = [0, 1, 2, 3, 4, 5].map(|i| first.wrapping_add(i));
    let stride = std::mem::size_of::<S>() as isize;
    View { kind: S::KIND, reserved: 0, count: shapes.len() as i64, stride, field }
}
