// SPDX-License-Identifier: Apache-2.0
//! Questions about one shape or two.
use crate::error::{answer, filled};
use crate::{Aabb, ClosestPoints, Error, Penetration, Scalar, Shape};
use core::ffi::c_void;
use vesica_sys as sys;

/// How a shape a relates to a shape b: the eight relations of RCC-8.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Relation {
    /// They have no common point.
    Disjoint = sys::VESICA_DISJOINT as u8,
    /// They have common points, but their insides have none.
    Touch = sys::VESICA_TOUCH as u8,
    /// Their insides meet, and neither contains the other.
    Cross = sys::VESICA_CROSS as u8,
    /// b contains a, and a has no point of b's outline.
    Inside = sys::VESICA_INSIDE as u8,
    /// b contains a, and a has points of b's outline.
    InsideTouch = sys::VESICA_INSIDE_TOUCH as u8,
    /// a contains b, and b has no point of a's outline.
    Contains = sys::VESICA_CONTAINS as u8,
    /// a contains b, and b has points of a's outline.
    ContainsTouch = sys::VESICA_CONTAINS_TOUCH as u8,
    /// They are the same set of points.
    Equal = sys::VESICA_EQUAL as u8,
}

impl Relation {
    const ALL: [Relation; 8] = [
        Relation::Disjoint,
        Relation::Touch,
        Relation::Cross,
        Relation::Inside,
        Relation::InsideTouch,
        Relation::Contains,
        Relation::ContainsTouch,
        Relation::Equal,
    ];
}

impl Default for Relation {
    fn default() -> Self {
        Relation::Disjoint
    }
}

/// Where two outlines meet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Crossings<T> {
    count: usize,
    places: [[T; 2]; 12],
    /// Whether the outlines share a stretch.
    pub shared: bool,
}

impl<T> Crossings<T> {
    /// The places, in order along the first shape's outline.
    pub fn places(&self) -> &[[T; 2]] {
        &self.places[..self.count]
    }
}

fn places<A, B>(a: &A, b: &B) -> Result<Crossings<A::Scalar>, Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b, mut found, mut shared) = (a.kind() as i32, b.kind() as i32, Crossings::default(), 0);
    let (a, b) = (a.address(), b.address());
    let (to, room) = (found.places.as_mut_ptr().cast(), found.places.len() as i64);
    found.count = answer(|| unsafe { A::Scalar::crossings(kind_a, a, kind_b, b, to, room, &mut shared) })?;
    if found.count > found.places.len() {
        return Err(Error::Room { needed: found.count, given: found.places.len() });
    }
    found.shared = shared == 1;
    Ok(found)
}

type Code = unsafe fn(i32, *const c_void, i32, *const c_void) -> i32;
type Measure<R> = unsafe fn(i32, *const c_void, i32, *const c_void, *mut R) -> i32;

#[inline]
fn code<A, B>(function: Code, a: &A, b: &B) -> Result<usize, Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b) = (a.kind() as i32, b.kind() as i32);
    answer(|| unsafe { function(kind_a, a.address(), kind_b, b.address()) })
}

#[inline]
fn measure<A, B, R: Default>(function: Measure<R>, a: &A, b: &B) -> Result<R, Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b) = (a.kind() as i32, b.kind() as i32);
    let (a, b) = (a.address(), b.address());
    filled(R::default(), |out| unsafe { function(kind_a, a, kind_b, b, out) })
}

macro_rules! of_two {
    ($($(#[$text:meta])* $name:ident -> $result:ty: $call:expr;)*) => {$(
        $(#[$text])*
        #[inline]
        pub fn $name<A, B>(a: &A, b: &B) -> Result<$result, Error>
        where
            A: Shape + ?Sized,
            B: Shape<Scalar = A::Scalar> + ?Sized,
        {
            $call(a, b)
        }
    )*};
}

of_two! {
    /// Do two shapes share a point? Touching counts. Exact.
    overlap -> bool: |a, b| Ok(code(A::Scalar::overlap, a, b)? == 1);
    /// Do the insides of two shapes share a point? Touching does not count. Exact.
    interiors_overlap -> bool: |a, b| Ok(code(A::Scalar::interiors_overlap, a, b)? == 1);
    /// How does a relate to b? Exact.
    relation -> Relation: |a, b| Ok(Relation::ALL[code(A::Scalar::relation, a, b)?]);
    /// Does a hold all of b? Equal shapes do. Exact.
    contains -> bool: |a, b| Ok(code(A::Scalar::contains, a, b)? == 1);
    /// The places where the outlines meet, in order along a's. Their number is exact.
    crossings -> Crossings<A::Scalar>: places;
    /// How far are the solid shapes apart, and which of their points are closest?
    nearest -> ClosestPoints<A::Scalar>: |a, b| measure(A::Scalar::nearest, a, b);
    /// How far are the outlines apart, that of a shape inside another too?
    boundary_distance -> ClosestPoints<A::Scalar>: |a, b| measure(A::Scalar::boundary_distance, a, b);
    /// How far and in which direction must b move until it only touches a?
    depth -> Penetration<A::Scalar>: |a, b| measure(A::Scalar::depth, a, b);
    /// The distance of two shapes or, below 0, how deep they overlap.
    signed_distance -> A::Scalar: |a, b| measure(A::Scalar::signed_distance, a, b);
    /// The area that a and b share.
    area -> A::Scalar: |a, b| measure(A::Scalar::area, a, b);
    /// Intersection over union, from 0 to 1.
    iou -> A::Scalar: |a, b| measure(A::Scalar::iou, a, b);
}

/// Is a shape valid? If not, the error is the first rule that it breaks.
pub fn check<S: Shape + ?Sized>(shape: &S) -> Result<(), Error> {
    answer(|| unsafe { S::Scalar::check(shape.kind() as i32, shape.address()) }).map(drop)
}

/// The area of one shape.
pub fn shape_area<S: Shape + ?Sized>(shape: &S) -> Result<S::Scalar, Error> {
    let (kind, address) = (shape.kind() as i32, shape.address());
    filled(S::Scalar::default(), |out| unsafe { S::Scalar::shape_area(kind, address, out) })
}

/// The smallest box of representable numbers that contains a shape.
pub fn bounds<S: Shape + ?Sized>(shape: &S) -> Result<Aabb<S::Scalar>, Error> {
    let (kind, address) = (shape.kind() as i32, shape.address());
    filled(Aabb::default(), |out| unsafe { S::Scalar::bounds(kind, address, out) })
}
