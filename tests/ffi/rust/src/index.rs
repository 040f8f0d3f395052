// SPDX-License-Identifier: Apache-2.0
//! Index and join: all pairs that overlap among millions of shapes, of one kind or several.
use crate::{checked, view, Error, Scalar, Shape, View};
use std::marker::PhantomData;
use std::ptr;

const E_SHAPE: i64 = -2;

extern "C" {
    fn vesica_index_size(count: i64) -> i64;
    fn vesica_index_scratch(count: i64) -> i64;
    fn vesica_join_scratch() -> i64;
    fn vesica_index_check(index: *const Line, size: i64) -> i32;
    fn vesica_index_bytes(index: *const Line) -> i64;
    fn vesica_index_build_f64(s: *const View<f64>, n: i32, to: *mut Line, size: i64, with: *mut Line, room: i64)
        -> i64;
    fn vesica_index_build_f32(s: *const View<f32>, n: i32, to: *mut Line, size: i64, with: *mut Line, room: i64)
        -> i64;
    fn vesica_index_select_f64(
        index: *const Line,
        sets: *const View<f64>,
        set_count: i32,
        one: *const View<f64>,
        out: *mut i64,
        capacity: i64,
        state: *mut i64,
    ) -> i64;
    fn vesica_index_select_f32(
        index: *const Line,
        sets: *const View<f32>,
        set_count: i32,
        one: *const View<f32>,
        out: *mut i64,
        capacity: i64,
        state: *mut i64,
    ) -> i64;
    fn vesica_index_nearest_f64(
        index: *const Line,
        sets: *const View<f64>,
        set_count: i32,
        one: *const View<f64>,
        k: i64,
        within: f64,
        out: *mut i64,
        distance: *mut f64,
    ) -> i64;
    fn vesica_index_nearest_f32(
        index: *const Line,
        sets: *const View<f32>,
        set_count: i32,
        one: *const View<f32>,
        k: i64,
        within: f32,
        out: *mut i64,
        distance: *mut f32,
    ) -> i64;
    fn vesica_join_f64(
        query: i32,
        index_a: *const Line,
        sets_a: *const View<f64>,
        set_count_a: i32,
        index_b: *const Line,
        sets_b: *const View<f64>,
        set_count_b: i32,
        part: i64,
        parts: i64,
        scratch: *mut Line,
        scratch_size: i64,
        out_a: *mut i64,
        out_b: *mut i64,
        capacity: i64,
        state: *mut i64,
    ) -> i64;
    fn vesica_join_f32(
        query: i32,
        index_a: *const Line,
        sets_a: *const View<f32>,
        set_count_a: i32,
        index_b: *const Line,
        sets_b: *const View<f32>,
        set_count_b: i32,
        part: i64,
        parts: i64,
        scratch: *mut Line,
        scratch_size: i64,
        out_a: *mut i64,
        out_b: *mut i64,
        capacity: i64,
        state: *mut i64,
    ) -> i64;
}

/// What an index and its scratch are aligned to.
#[doc(hidden)]
#[repr(C, align(64))]
#[derive(Clone, Copy)]
pub struct Line([u8; 64]);

type Build<T> = unsafe extern "C" fn(*const View<T>, i32, *mut Line, i64, *mut Line, i64) -> i64;
type Select<T> = unsafe extern "C" fn(*const Line, *const View<T>, i32, *const View<T>, *mut i64, i64, *mut i64) -> i64;
type Nearest<T> =
    unsafe extern "C" fn(*const Line, *const View<T>, i32, *const View<T>, i64, T, *mut i64, *mut T) -> i64;
type Join<T> = unsafe extern "C" fn(
    i32,
    *const Line,
    *const View<T>,
    i32,
    *const Line,
    *const View<T>,
    i32,
    i64,
    i64,
    *mut Line,
    i64,
    *mut i64,
    *mut i64,
    i64,
    *mut i64,
) -> i64;

/// `f64` and `f32`, each with its functions of an index.
///
/// # Safety
/// Nothing else can be one.
pub unsafe trait IndexScalar: Scalar + Default {
    #[doc(hidden)]
    const BUILD: Build<Self>;
    #[doc(hidden)]
    const SELECT: Select<Self>;
    #[doc(hidden)]
    const NEAREST: Nearest<Self>;
    #[doc(hidden)]
    const JOIN: Join<Self>;
}
unsafe impl IndexScalar for f64 {
    const BUILD: Build<f64> = vesica_index_build_f64;
    const SELECT: Select<f64> = vesica_index_select_f64;
    const NEAREST: Nearest<f64> = vesica_index_nearest_f64;
    const JOIN: Join<f64> = vesica_join_f64;
}
unsafe impl IndexScalar for f32 {
    const BUILD: Build<f32> = vesica_index_build_f32;
    const SELECT: Select<f32> = vesica_index_select_f32;
    const NEAREST: Nearest<f32> = vesica_index_nearest_f32;
    const JOIN: Join<f32> = vesica_join_f32;
}

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

impl<'a, T: IndexScalar> Index<'a, T> {
    /// Invalid shapes are left out, and `has_invalid` tells.
    pub fn new(sets: Vec<Set<'a, T>>) -> Result<Self, Error> {
        let views: Vec<_> = sets.into_iter().map(|set| set.view).collect();
        let count = views.iter().map(|view| view.count).sum();
        let mut lines = memory(unsafe { vesica_index_size(count) })?;
        let mut scratch = memory(unsafe { vesica_index_scratch(count) })?;
        let (size, room) = (bytes_of(&lines), bytes_of(&scratch));
        let built = unsafe {
            T::BUILD(views.as_ptr(), views.len() as i32, lines.as_mut_ptr(), size, scratch.as_mut_ptr(), room)
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
        checked(unsafe { vesica_index_check(lines.as_ptr(), bytes.len() as i64) }.into())?;
        let views = sets.into_iter().map(|set| set.view).collect();
        Ok(Index { lines, views, has_invalid: false, shapes: PhantomData })
    }

    /// The bytes to save.
    pub fn as_bytes(&self) -> &[u8] {
        let size = unsafe { vesica_index_bytes(self.lines.as_ptr()) };
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
        let (index, (sets, count), one) = (self.lines.as_ptr(), self.sets(), view(std::slice::from_ref(one)));
        let found = checked(unsafe { T::SELECT(index, sets, count, &one, ptr::null_mut(), 0, ptr::null_mut()) })?;
        let (mut out, mut state) = (vec![0; found], [0; 4]);
        if found > 0 {
            let room = found as i64;
            checked(unsafe { T::SELECT(index, sets, count, &one, out.as_mut_ptr(), room, state.as_mut_ptr()) })?;
        }
        Ok(out)
    }

    /// The k items nearest to one shape, at most `within` away, each with its distance.
    pub fn nearest<S: Shape<Scalar = T>>(&self, one: &S, k: usize, within: T) -> Result<Vec<(i64, T)>, Error> {
        let (mut items, mut distance) = (vec![0; k], vec![T::default(); k]);
        let ((sets, count), one, room) = (self.sets(), view(std::slice::from_ref(one)), k as i64);
        let (out, far) = (items.as_mut_ptr(), distance.as_mut_ptr());
        let found = checked(unsafe { T::NEAREST(self.lines.as_ptr(), sets, count, &one, room, within, out, far) })?;
        Ok(items.into_iter().zip(distance).take(found.min(k)).collect())
    }
}

/// All pairs of an item of a and one of b. Of an index with itself: of two items of it, the lower one first.
pub fn join<T: IndexScalar>(query: Query, a: &Index<T>, b: &Index<T>) -> Result<Vec<(i64, i64)>, Error> {
    const ROOM: usize = 4096;
    let (mut first, mut second, mut state) = (vec![0; ROOM], vec![0; ROOM], [0; 4]);
    let mut scratch = memory(unsafe { vesica_join_scratch() })?;
    let ((sets_a, count_a), (sets_b, count_b)) = (a.sets(), b.sets());
    let mut pairs = Vec::new();
    while state[0] != -1 {
        let found = checked(unsafe {
            T::JOIN(
                query as i32,
                a.lines.as_ptr(),
                sets_a,
                count_a,
                b.lines.as_ptr(),
                sets_b,
                count_b,
                0,
                1,
                scratch.as_mut_ptr(),
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
