// SPDX-License-Identifier: Apache-2.0
//! Vesica: exact overlap queries between plain 2D shapes. Touching counts.
use std::ffi::CStr;
use std::fmt;

/// Every function and constant: rust/vesica-sys/src/declarations.rs, to be copied beside this file.
#[allow(non_camel_case_types, clippy::all)]
#[path = "declarations.rs"]
pub mod c;
pub mod index;
mod shapes;
pub use shapes::{Aabb, Circle, Ellipse, Point, Rect, Segment, Shape};

/// Of the declarations below.
pub const VERSION: i32 = c::VESICA_VERSION;

/// An array of shapes as the library sees it.
#[doc(hidden)]
pub type View<T> = c::Shapes<T>;
pub use c::ClosestPoints;
use c::{vesica_strerror, vesica_version};

pub use c::Scalar;

/// An error of the library, by its code; displayed as what it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Error(pub i32);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = unsafe { CStr::from_ptr(vesica_strerror(self.0).cast()) };
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
    let answer = unsafe { A::Scalar::overlap(A::KIND, a.cast(), B::KIND, b.cast()) };
    Ok(checked(answer.into())? == 1)
}

/// The same of flat numbers, whose kinds are known at run time only.
pub fn overlap_numbers<T: Scalar>(kind_a: i32, a: &[T; 6], kind_b: i32, b: &[T; 6]) -> Result<bool, Error> {
    let answer = unsafe { T::overlap(kind_a, a.as_ptr(), kind_b, b.as_ptr()) };
    Ok(checked(answer.into())? == 1)
}

/// How far apart are two shapes, and which of their points are closest?
pub fn nearest<A: Shape, B: Shape<Scalar = A::Scalar>>(a: &A, b: &B) -> Result<ClosestPoints<A::Scalar>, Error> {
    let ((a, b), mut out): ((*const A, *const B), _) = ((a, b), ClosestPoints::default());
    checked(unsafe { A::Scalar::nearest(A::KIND, a.cast(), B::KIND, b.cast(), &mut out) }.into())?;
    Ok(out)
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
    checked(unsafe { A::Scalar::overlap_many(&view(a), &view(b), out.as_mut_ptr().cast()) })
}

fn view<S: Shape>(shapes: &[S]) -> View<S::Scalar> {
    let first: *const S::Scalar = shapes.as_ptr().cast();
    let field = [0, 1, 2, 3, 4, 5].map(|i| first.wrapping_add(i));
    let stride = std::mem::size_of::<S>() as isize;
    View { kind: S::KIND, reserved: 0, count: shapes.len() as i64, stride, field }
}
