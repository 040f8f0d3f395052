// SPDX-License-Identifier: Apache-2.0
//! All pairs among millions: an index of shapes, joins, windows and nearest shapes.
use crate::error::answer;
use crate::motion::first;
use crate::{Aabb, Error, Impact, Motion, Ratio, Scalar, Shape, Shapes};
use alloc::vec;
use alloc::vec::Vec;
use core::{ptr, slice};
use vesica_sys as sys;

/// What makes a pair of a join.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum JoinQuery {
    /// a and b share a point.
    Overlap = sys::VESICA_JOIN_OVERLAP,
    /// Their bounds meet: all pairs that overlap, and some that do not.
    Bounds = sys::VESICA_JOIN_BOUNDS,
    /// a contains b.
    Contains = sys::VESICA_JOIN_CONTAINS,
    /// b contains a.
    Inside = sys::VESICA_JOIN_INSIDE,
    /// Their insides share a point.
    Interiors = sys::VESICA_JOIN_INTERIORS,
}

/// An item of one index and an item of another, with a ratio of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RatioPair<T> {
    /// The item of the first index.
    pub a: i64,
    /// The item of the other index.
    pub b: i64,
    /// Their ratio.
    pub value: T,
}

/// What an index and its scratch are aligned to.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
struct Line([u8; 64]);

fn lines(bytes: usize) -> Vec<Line> {
    vec![Line([0; 64]); (bytes + 63) / 64]
}

fn size(lines: &[Line]) -> i64 {
    (lines.len() * 64) as i64
}

/// An index over sets of shapes laid end to end: item i is shape i of the first set, and the next set's items follow.
///
/// The sets may be of any kinds. The index borrows them.
pub struct Index<'a, T> {
    sets: Vec<Shapes<'a, T>>,
    memory: Vec<Line>,
    incomplete: bool,
}

fn count_of<T: Scalar>(sets: &[Shapes<'_, T>]) -> usize {
    sets.iter().map(Shapes::len).sum()
}

/// Shapes is a transparent struct around the library's view.
fn views<T>(sets: &[Shapes<'_, T>]) -> (*const sys::Shapes<T>, i32) {
    (sets.as_ptr().cast(), sets.len() as i32)
}

/// All items of a question, which is put twice: how many, and which.
fn all_items(ask: impl Fn(*mut i64, i64, *mut i64) -> Result<usize, Error>) -> Result<Vec<i64>, Error> {
    let mut out = vec![0; ask(ptr::null_mut(), 0, ptr::null_mut())?];
    if !out.is_empty() {
        ask(out.as_mut_ptr(), out.len() as i64, [0; 4].as_mut_ptr())?;
    }
    Ok(out)
}

impl<'a, T: Scalar> Index<'a, T> {
    /// Invalid shapes are left out; [`incomplete`](Index::incomplete) tells.
    pub fn new(sets: &[Shapes<'a, T>]) -> Result<Self, Error> {
        Self::built(sets, |(view, count), memory, scratch| {
            let ((to, bytes), (with, room)) = (memory, scratch);
            unsafe { T::index_build(view, count, to.cast(), bytes, with.cast(), room) }
        })
    }

    /// [`new`](Index::new) by so many threads; 0 stands for all processors, as far as that pays. The bytes are the
    /// same.
    #[cfg(feature = "std")]
    pub fn new_parallel(sets: &[Shapes<'a, T>], threads: usize) -> Result<Self, Error>
    where
        T: Sync,
    {
        let threads = crate::threads::count_for(threads, count_of(sets));
        let own = sets.to_vec();
        Self::built(sets, |_, (to, bytes), (with, room)| {
            // Threads share numbers, not pointers.
            let (to, with) = (to as usize, with as usize);
            let ask = |step: i32, part: usize, parts: usize| {
                let ((view, count), part, parts) = (views(&own), part as i64, parts as i64);
                unsafe { T::index_step(step, part, parts, view, count, to as *mut _, bytes, with as *mut _, room) }
            };
            let mut code = 0;
            for step in 0..5 {
                let parts = if step == 0 || step == 4 { 1 } else { threads };
                let codes = crate::threads::each_part(threads, parts, |part| ask(step, part, parts));
                code = codes.iter().copied().find(|&code| code < 0).unwrap_or(codes[0]);
                if code < 0 {
                    break;
                }
            }
            code
        })
    }

    /// The index that `build` makes in this memory, with that scratch.
    fn built(
        sets: &[Shapes<'a, T>],
        build: impl FnOnce((*const sys::Shapes<T>, i32), (*mut Line, i64), (*mut Line, i64)) -> i64,
    ) -> Result<Self, Error> {
        let sets = sets.to_vec();
        let count = count_of(&sets) as i64;
        let mut memory = lines(answer(|| unsafe { sys::vesica_index_size(count) })?);
        let mut scratch = lines(answer(|| unsafe { sys::vesica_index_scratch(count) })?);
        let (bytes, room) = (size(&memory), size(&scratch));
        let built = answer(|| build(views(&sets), (memory.as_mut_ptr(), bytes), (scratch.as_mut_ptr(), room)));
        let incomplete = built == Err(Error::Shape);
        if !incomplete {
            built?;
        }
        let used = answer(|| unsafe { sys::vesica_index_bytes(memory.as_ptr().cast()) })?;
        memory.truncate(used / 64);
        memory.shrink_to_fit();
        Ok(Index { sets, memory, incomplete })
    }

    /// The index whose bytes were saved, over the same shapes. They are checked and copied.
    pub fn from_bytes(bytes: &[u8], sets: &[Shapes<'a, T>]) -> Result<Self, Error> {
        let mut memory = lines(bytes.len());
        unsafe { ptr::copy_nonoverlapping(bytes.as_ptr(), memory.as_mut_ptr().cast(), bytes.len()) };
        answer(|| unsafe { sys::vesica_index_check(memory.as_ptr().cast(), bytes.len() as i64) })?;
        let built_of = answer(|| unsafe { sys::vesica_index_count(memory.as_ptr().cast()) })?;
        if built_of != count_of(sets) {
            return Err(Error::Counts(built_of, count_of(sets)));
        }
        Ok(Index { sets: sets.to_vec(), memory, incomplete: false })
    }

    /// The bytes to save.
    pub fn as_bytes(&self) -> &[u8] {
        unsafe { slice::from_raw_parts(self.memory.as_ptr().cast(), self.memory.len() * 64) }
    }

    fn address(&self) -> *const core::ffi::c_void {
        self.memory.as_ptr().cast()
    }

    /// How many items there are, invalid shapes included.
    pub fn len(&self) -> usize {
        count_of(&self.sets)
    }

    /// Whether it has no items.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether invalid shapes were left out. Bytes that were saved do not tell.
    pub fn incomplete(&self) -> bool {
        self.incomplete
    }

    /// A box around all valid shapes, a little larger than the smallest one.
    pub fn bounds(&self) -> Result<Aabb<f64>, Error> {
        crate::error::filled(Aabb::default(), |out| unsafe { sys::vesica_index_bounds(self.address(), out) })
    }

    /// The items in spatial order: arrays that are laid so are joined quicker.
    pub fn order(&self) -> Result<Vec<i64>, Error> {
        let mut out = vec![0; self.len()];
        let (to, room) = (out.as_mut_ptr(), out.len() as i64);
        let valid = answer(|| unsafe { sys::vesica_index_order(self.address(), to, room) })?;
        out.truncate(valid);
        Ok(out)
    }

    /// The items that one shape overlaps, in the index's order.
    pub fn select<S: Shape<Scalar = T> + ?Sized>(&self, one: &S) -> Result<Vec<i64>, Error> {
        let one = Shapes::one(one);
        let (sets, count) = views(&self.sets);
        all_items(|to, room, state| {
            answer(|| unsafe { T::index_select(self.address(), sets, count, &one.view, to, room, state) })
        })
    }

    /// The items that one moving shape touches, in the index's order.
    pub fn cast<S: Shape<Scalar = T> + ?Sized>(&self, one: &S, motion: Motion<T>) -> Result<Vec<i64>, Error> {
        let one = Shapes::one(one);
        let ((sets, count), Motion { vx, vy, t_end }) = (views(&self.sets), motion);
        all_items(|to, room, state| {
            answer(|| unsafe { T::index_cast(self.address(), sets, count, &one.view, vx, vy, t_end, to, room, state) })
        })
    }

    /// The item that one moving shape touches first, the lowest of several. The normal points to `one`.
    pub fn cast_first<S>(&self, one: &S, motion: Motion<T>) -> Result<Option<(usize, Impact<T>)>, Error>
    where
        S: Shape<Scalar = T> + ?Sized,
    {
        let one = Shapes::one(one);
        let ((sets, count), Motion { vx, vy, t_end }) = (views(&self.sets), motion);
        let mut out = Impact::default();
        let (index, to) = (self.address(), &mut out);
        let item = answer(|| unsafe { T::index_cast_first(index, sets, count, &one.view, vx, vy, t_end, to) })?;
        Ok(first(item, self.len(), out))
    }

    /// The k items nearest to one shape, at most `within` away, each with its distance; infinity asks for any.
    pub fn nearest<S>(&self, one: &S, k: usize, within: T) -> Result<Vec<(i64, T)>, Error>
    where
        S: Shape<Scalar = T> + ?Sized,
    {
        let one = Shapes::one(one);
        let k = k.min(self.len());
        let (mut items, mut distances) = (vec![0; k], vec![T::default(); k]);
        let (sets, count) = views(&self.sets);
        let (to, far) = (items.as_mut_ptr(), distances.as_mut_ptr());
        let found =
            answer(|| unsafe { T::index_nearest(self.address(), sets, count, &one.view, k as i64, within, to, far) })?;
        Ok(items.into_iter().zip(distances).take(found.min(k)).collect())
    }

    /// All pairs of an item of this index and one of another; with itself the pairs a < b. Each pair once.
    pub fn join(&self, other: &Index<'_, T>, query: JoinQuery) -> Result<Vec<(i64, i64)>, Error> {
        self.join_part(other, query, 0, 1)
    }

    /// One of `parts` parts of a join, which threads may ask at the same time. One after the other they are the join.
    pub fn join_part(
        &self,
        other: &Index<'_, T>,
        query: JoinQuery,
        part: usize,
        parts: usize,
    ) -> Result<Vec<(i64, i64)>, Error> {
        const ROOM: usize = 1 << 14;
        let (mut a, mut b, mut state) = (vec![0; ROOM], vec![0; ROOM], [0; 4]);
        let mut pairs = Vec::new();
        while state[0] != -1 {
            let out = (a.as_mut_ptr(), b.as_mut_ptr(), ROOM as i64, state.as_mut_ptr());
            let found = self.ask_join(other, query, part, parts, out)?;
            pairs.extend(a[..found].iter().copied().zip(b[..found].iter().copied()));
        }
        Ok(pairs)
    }

    /// [`join`](Index::join) by so many threads; 0 stands for all processors, as far as that pays. The pairs are the
    /// same, in the same order.
    #[cfg(feature = "std")]
    pub fn join_parallel(
        &self,
        other: &Index<'_, T>,
        query: JoinQuery,
        threads: usize,
    ) -> Result<Vec<(i64, i64)>, Error>
    where
        T: Sync,
    {
        let threads = crate::threads::count_for(threads, self.len() + other.len());
        // Some parts take longer than others.
        let parts = if threads == 1 { 1 } else { 8 * threads };
        let found = crate::threads::each_part(threads, parts, |part| self.join_part(other, query, part, parts));
        Ok(found.into_iter().collect::<Result<Vec<_>, _>>()?.concat())
    }

    /// All pairs of an item of this index and one of another that are at most `distance` apart, as
    /// [`join`](Index::join) gives them. Of ellipses also those too near to it to tell. If it is negative, those that
    /// overlap at least that deep.
    pub fn join_within(&self, other: &Index<'_, T>, distance: T) -> Result<Vec<(i64, i64)>, Error> {
        const ROOM: usize = 1 << 14;
        let (mut a, mut b, mut state) = (vec![0; ROOM], vec![0; ROOM], [0; 4]);
        let ((sets_a, count_a), (sets_b, count_b)) = (views(&self.sets), views(&other.sets));
        let (index_a, index_b, room) = (self.address(), other.address(), ROOM as i64);
        let mut pairs = Vec::new();
        while state[0] != -1 {
            let (to_a, to_b, at) = (a.as_mut_ptr(), b.as_mut_ptr(), state.as_mut_ptr());
            let found = answer(|| unsafe {
                T::join_within(index_a, sets_a, count_a, index_b, sets_b, count_b, distance, 0, 1, to_a, to_b, room, at)
            })?;
            pairs.extend(a[..found].iter().copied().zip(b[..found].iter().copied()));
        }
        Ok(pairs)
    }

    /// All pairs of an item of this index and one of another that overlap and whose ratio is at least `threshold`, in
    /// the order of [`join`](Index::join). A pair without a ratio is left out.
    pub fn join_ratio(&self, other: &Index<'_, T>, ratio: Ratio, threshold: T) -> Result<Vec<RatioPair<T>>, Error> {
        const ROOM: usize = 1 << 14;
        let (mut a, mut b, mut values, mut state) = (vec![0; ROOM], vec![0; ROOM], vec![T::default(); ROOM], [0; 4]);
        let mut scratch = lines(answer(|| unsafe { sys::vesica_join_scratch() })?);
        let ((sets_a, count_a), (sets_b, count_b)) = (views(&self.sets), views(&other.sets));
        let (index_a, index_b, which, room) = (self.address(), other.address(), ratio as i32, ROOM as i64);
        let (with, bytes) = (scratch.as_mut_ptr().cast(), size(&scratch));
        let mut pairs = Vec::new();
        while state[0] != -1 {
            let (to_a, to_b, to, at) = (a.as_mut_ptr(), b.as_mut_ptr(), values.as_mut_ptr(), state.as_mut_ptr());
            let found = answer(|| unsafe {
                T::join_ratio(
                    which, threshold, index_a, sets_a, count_a, index_b, sets_b, count_b, 0, 1, with, bytes, to_a,
                    to_b, to, room, at,
                )
            })?;
            pairs.extend((0..found).map(|i| RatioPair { a: a[i], b: b[i], value: values[i] }));
        }
        Ok(pairs)
    }

    /// How many pairs [`join`](Index::join) gives.
    pub fn join_count(&self, other: &Index<'_, T>, query: JoinQuery) -> Result<usize, Error> {
        self.ask_join(other, query, 0, 1, (ptr::null_mut(), ptr::null_mut(), 0, ptr::null_mut()))
    }

    fn ask_join(
        &self,
        other: &Index<'_, T>,
        query: JoinQuery,
        part: usize,
        parts: usize,
        (out_a, out_b, room, state): (*mut i64, *mut i64, i64, *mut i64),
    ) -> Result<usize, Error> {
        let mut scratch = lines(answer(|| unsafe { sys::vesica_join_scratch() })?);
        let ((sets_a, count_a), (sets_b, count_b)) = (views(&self.sets), views(&other.sets));
        let (with, with_size) = (scratch.as_mut_ptr().cast(), size(&scratch));
        let (query, part, parts, index_b) = (query as i32, part as i64, parts as i64, other.address());
        answer(|| unsafe {
            T::join(
                query,
                self.address(),
                sets_a,
                count_a,
                index_b,
                sets_b,
                count_b,
                part,
                parts,
                with,
                with_size,
                out_a,
                out_b,
                room,
                state,
            )
        })
    }
}

/// Of each shape of some sets, the k items of an index that are nearest, and their distances: rows of k, one after the
/// other, filled up by -1 at distance infinity.
///
/// Returns how many were found. If a shape is invalid its row holds -1, all others are written, and it is an error.
pub fn nearest_of_each<T: Scalar>(
    sets: &[Shapes<'_, T>],
    index: &Index<'_, T>,
    k: usize,
    within: T,
    items: &mut [i64],
    distances: &mut [T],
) -> Result<usize, Error> {
    let needed = count_of(sets).saturating_mul(k);
    if items.len() < needed || distances.len() < needed {
        return Err(Error::Room { needed, given: items.len().min(distances.len()) });
    }
    let ((asked, asked_count), (view, count)) = (views(sets), views(&index.sets));
    let (to, far) = (items.as_mut_ptr(), distances.as_mut_ptr());
    answer(|| unsafe {
        T::join_nearest(asked, asked_count, index.address(), view, count, k as i64, within, 0, 1, to, far)
    })
}
