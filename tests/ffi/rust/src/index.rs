// SPDX-License-Identifier: Apache-2.0
//! Index and join: all pairs that overlap among millions of shapes, of one kind or several.
use crate::c::{
    self, vesica_index_bytes, vesica_index_check, vesica_index_scratch, vesica_index_size, vesica_join_scratch,
};
use crate::{checked, view, Error, Scalar, Shape, View};
use std::marker::PhantomData;
use std::ptr;

const E_SHAPE: i64 = c::VESICA_E_SHAPE as i64;

/// What an index and its scratch are aligned to.
#[doc(hidden)]
#[repr(C, align(64))]
#[derive(Clone, Copy)]
pub struct Line([u8; 64]);

/// A slice of shapes of one kind, as part of an index. It borrows the slice.
pub struct Set<'a, T> {
    view: View<T>,
    shapes: PhantomData<&'a T>,
}

impl<'a, S: Shape> From<&'a [S]> for Set<'a, S::Scalar> {
    fn from(shapes: &'a [S]) -> Self {
        Set { view: view(shapes), shapes: PhantomData }
    }
}

/// What makes a pair of a join.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Query {
    Overlap = 0,
    /// Their bounds meet: all pairs that overlap, and some that do not.
    Bounds = 1,
    Contains = 2,
    Inside = 3,
}

/// An index over sets of shapes laid end to end: item i is shape i of the first set, and so on.
pub struct Index<'a, T> {
    lines: Vec<Line>,
    views: Vec<View<T>>,
    has_invalid: bool,
    shapes: PhantomData<&'a T>,
}

fn memory(bytes: i64) -> Result<Vec<Line>, Error> {
    Ok(vec![Line([0; 64]); (checked(bytes)? + 63) / 64])
}

fn bytes_of(lines: &[Line]) -> i64 {
    (lines.len() * 64) as i64
}

impl<'a, T: Scalar> Index<'a, T> {
    /// Invalid shapes are left out, and `has_invalid` tells.
    pub fn new(sets: Vec<Set<'a, T>>) -> Result<Self, Error> {
        let views: Vec<_> = sets.into_iter().map(|set| set.view).collect();
        let count = views.iter().map(|view| view.count).sum();
        let mut lines = memory(unsafe { vesica_index_size(count) })?;
        let mut scratch = memory(unsafe { vesica_index_scratch(count) })?;
        let (size, room) = (bytes_of(&lines), bytes_of(&scratch));
        let built = unsafe {
            T::index_build(
                views.as_ptr(),
                views.len() as i32,
                lines.as_mut_ptr().cast(),
                size,
                scratch.as_mut_ptr().cast(),
                room,
            )
        };
        let has_invalid = built == E_SHAPE;
        if !has_invalid {
            checked(built)?;
        }
        Ok(Index { lines, views, has_invalid, shapes: PhantomData })
    }

    /// The index that `bytes` were saved from, of the same sets. They are checked.
    pub fn from_bytes(sets: Vec<Set<'a, T>>, bytes: &[u8]) -> Result<Self, Error> {
        let mut lines = memory(bytes.len() as i64)?;
        unsafe { ptr::copy_nonoverlapping(bytes.as_ptr(), lines.as_mut_ptr().cast(), bytes.len()) };
        checked(unsafe { vesica_index_check(lines.as_ptr().cast(), bytes.len() as i64) }.into())?;
        let views = sets.into_iter().map(|set| set.view).collect();
        Ok(Index { lines, views, has_invalid: false, shapes: PhantomData })
    }

    /// The bytes to save.
    pub fn as_bytes(&self) -> &[u8] {
        let size = unsafe { vesica_index_bytes(self.lines.as_ptr().cast()) };
        unsafe { std::slice::from_raw_parts(self.lines.as_ptr().cast(), size as usize) }
    }

    pub fn has_invalid(&self) -> bool {
        self.has_invalid
    }

    fn sets(&self) -> (*const View<T>, i32) {
        (self.views.as_ptr(), self.views.len() as i32)
    }

    /// The items that one shape overlaps.
    pub fn select<S: Shape<Scalar = T>>(&self, one: &S) -> Result<Vec<i64>, Error> {
        let (index, (sets, count), one) = (self.lines.as_ptr().cast(), self.sets(), view(std::slice::from_ref(one)));
        let found = checked(unsafe { T::index_select(index, sets, count, &one, ptr::null_mut(), 0, ptr::null_mut()) })?;
        let (mut out, mut state) = (vec![0; found], [0; 4]);
        if found > 0 {
            let room = found as i64;
            checked(unsafe { T::index_select(index, sets, count, &one, out.as_mut_ptr(), room, state.as_mut_ptr()) })?;
        }
        Ok(out)
    }

    /// The k items nearest to one shape, at most `within` away, each with its distance.
    pub fn nearest<S: Shape<Scalar = T>>(&self, one: &S, k: usize, within: T) -> Result<Vec<(i64, T)>, Error> {
        let (mut items, mut distance) = (vec![0; k], vec![T::default(); k]);
        let ((sets, count), one, room) = (self.sets(), view(std::slice::from_ref(one)), k as i64);
        let (out, far) = (items.as_mut_ptr(), distance.as_mut_ptr());
        let found = checked(unsafe {
            T::index_nearest(self.lines.as_ptr().cast(), sets, count, &one, room, within, out, far)
        })?;
        Ok(items.into_iter().zip(distance).take(found.min(k)).collect())
    }
}

/// All pairs of an item of a and one of b. Of an index with itself: of two items of it, the lower one first.
pub fn join<T: Scalar>(query: Query, a: &Index<T>, b: &Index<T>) -> Result<Vec<(i64, i64)>, Error> {
    const ROOM: usize = 4096;
    let (mut first, mut second, mut state) = (vec![0; ROOM], vec![0; ROOM], [0; 4]);
    let mut scratch = memory(unsafe { vesica_join_scratch() })?;
    let ((sets_a, count_a), (sets_b, count_b)) = (a.sets(), b.sets());
    let mut pairs = Vec::new();
    while state[0] != -1 {
        let found = checked(unsafe {
            T::join(
                query as i32,
                a.lines.as_ptr().cast(),
                sets_a,
                count_a,
                b.lines.as_ptr().cast(),
                sets_b,
                count_b,
                0,
                1,
                scratch.as_mut_ptr().cast(),
                bytes_of(&scratch),
                first.as_mut_ptr(),
                second.as_mut_ptr(),
                ROOM as i64,
                state.as_mut_ptr(),
            )
        })?;
        pairs.extend(first[..found].iter().copied().zip(second[..found].iter().copied()));
    }
    Ok(pairs)
}
