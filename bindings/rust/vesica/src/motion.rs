// SPDX-License-Identifier: Apache-2.0
//! Shapes that move: b by t times a velocity, t from 0 to an end that may be infinite. A ray is a point that moves. And
//! two that move and turn.
use crate::batch::{column, in_step};
use crate::error::{answer, filled};
use crate::{Aabb, Error, Impact, Scalar, Shape, Shapes, Turn};
use vesica_sys as sys;

/// What a cast finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Cast {
    /// No contact.
    Miss = sys::VESICA_CAST_MISS,
    /// Contact, the first after the start.
    Hit = sys::VESICA_CAST_HIT,
    /// The shapes overlap at the start.
    Start = sys::VESICA_CAST_START,
    /// Of [`impact_time`] alone: no contact before the time, and perhaps none later.
    Near = sys::VESICA_CAST_NEAR,
}

const CASTS: [Cast; 4] = [Cast::Miss, Cast::Hit, Cast::Start, Cast::Near];

/// How a shape moves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Motion<T> {
    pub vx: T,
    pub vy: T,
    /// 0 or more; infinity has no end.
    pub t_end: T,
}

/// Columns for [`cast_many`]; those of length 0 are not written, but one must be.
#[derive(Debug, Default)]
#[allow(missing_docs)]
pub struct ImpactColumns<'a, T> {
    pub t: &'a mut [T],
    pub x: &'a mut [T],
    pub y: &'a mut [T],
    pub nx: &'a mut [T],
    pub ny: &'a mut [T],
}

/// Does b touch a while it moves, when first, and where? Whether it does is exact, and the time is rounded down.
///
/// The normal is from a to b. After a miss the time is infinity and the rest NaN.
pub fn cast<A, B>(a: &A, b: &B, motion: Motion<A::Scalar>) -> Result<(Cast, Impact<A::Scalar>), Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b) = (a.kind() as i32, b.kind() as i32);
    let (a, b) = (a.address(), b.address());
    let (mut out, Motion { vx, vy, t_end }) = (Impact::default(), motion);
    let code = answer(|| unsafe { A::Scalar::cast(kind_a, a, kind_b, b, vx, vy, t_end, &mut out) })?;
    Ok((CASTS[code], out))
}

/// When, and where, does `b[i]` touch `a[i]`? Returns how many touch.
///
/// There are as many velocities as shapes in step, or one. Of an invalid shape or velocity the numbers are NaN, all
/// others are written, and the call is an error.
pub fn cast_many<'a, 'b, T: Scalar>(
    a: impl Into<Shapes<'a, T>>,
    b: impl Into<Shapes<'b, T>>,
    (vx, vy): (&[T], &[T]),
    t_end: T,
    out: ImpactColumns<'_, T>,
) -> Result<usize, Error> {
    let (a, b) = (a.into(), b.into());
    let n = in_step(&a, &b)?;
    if vx.len() != vy.len() || (vx.len() != n && vx.len() != 1) {
        return Err(Error::Counts(n, if vx.len() == n { vy.len() } else { vx.len() }));
    }
    let stride = if vx.len() == 1 { 0 } else { core::mem::size_of::<T>() as isize };
    let (vx, vy) = (vx.as_ptr(), vy.as_ptr());
    let t = column(out.t, n)?;
    let ((x, y), (nx, ny)) = ((column(out.x, n)?, column(out.y, n)?), (column(out.nx, n)?, column(out.ny, n)?));
    answer(|| unsafe { T::cast_many(&a.view, &b.view, vx, vy, stride, t_end, t, x, y, nx, ny) })
}

/// An item that was met first, if there is one.
pub(crate) fn first<T>(item: usize, count: usize, impact: Impact<T>) -> Option<(usize, Impact<T>)> {
    (item < count).then_some((item, impact))
}

/// Which of many shapes at rest does one moving shape touch first? The lowest of several. The normal points to `one`.
pub fn cast_first<'b, S: Shape + ?Sized>(
    one: &S,
    many: impl Into<Shapes<'b, S::Scalar>>,
    motion: Motion<S::Scalar>,
) -> Result<Option<(usize, Impact<S::Scalar>)>, Error> {
    let (one, many) = (Shapes::one(one), many.into());
    let (mut out, Motion { vx, vy, t_end }) = (Impact::default(), motion);
    let item = answer(|| unsafe { S::Scalar::cast_first(&one.view, &many.view, vx, vy, t_end, &mut out) })?;
    Ok(first(item, many.len(), out))
}

/// When do two shapes that move and turn touch first, t from 0 to 1? Proved: there is no contact before t, however thin
/// they are and however fast they turn.
///
/// At t a centre has moved by t (vx, vy), and a shape has turned about it by t times the angle, which is at most 2^20
/// radians. The impact is the place at t: the point of a nearest to b, and the normal that separates them. The last
/// number, the gap, is how far apart they are then at most: no more than the tolerance, a length above 0, but for
/// rounding and very long searches, as [`sys::vesica_impact_time_f64`] tells.
///
/// - [`Cast::Miss`]: proved, no contact from 0 to 1. The time is infinity, the rest NaN.
/// - [`Cast::Hit`]: proved, contact after t.
/// - [`Cast::Near`]: they come as near as the gap; there may be contact after t, or none. Of a point and a segment, or
///   two points, contact is never proved.
/// - [`Cast::Start`]: they overlap at t = 0, exactly. The gap is 0.
pub fn impact_time<A, B>(
    a: &A,
    turn_a: Turn<A::Scalar>,
    b: &B,
    turn_b: Turn<A::Scalar>,
    tolerance: A::Scalar,
) -> Result<(Cast, Impact<A::Scalar>, A::Scalar), Error>
where
    A: Shape + ?Sized,
    B: Shape<Scalar = A::Scalar> + ?Sized,
{
    let (kind_a, kind_b) = (a.kind() as i32, b.kind() as i32);
    let (a, b) = (a.address(), b.address());
    let (mut out, mut gap) = (Impact::default(), A::Scalar::default());
    let code = answer(|| unsafe {
        A::Scalar::impact_time(kind_a, a, &turn_a, kind_b, b, &turn_b, tolerance, &mut out, &mut gap)
    })?;
    Ok((CASTS[code], out, gap))
}

/// A box that holds a shape throughout its motion.
pub fn sweep_bounds<S: Shape + ?Sized>(shape: &S, motion: Motion<S::Scalar>) -> Result<Aabb<S::Scalar>, Error> {
    let (kind, address, Motion { vx, vy, t_end }) = (shape.kind() as i32, shape.address(), motion);
    filled(Aabb::default(), |out| unsafe { S::Scalar::sweep_bounds(kind, address, vx, vy, t_end, out) })
}
