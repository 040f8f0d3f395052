// SPDX-License-Identifier: Apache-2.0
//! One shape, and arrays of shapes as the library sees them.
use crate::{Error, Scalar};
use core::ffi::c_void;
use core::marker::PhantomData;
use core::slice;
use vesica_sys::{self as sys, Aabb, Capsule, Circle, Ellipse, Point, Rect, RoundRect, Segment};

/// The kinds of shapes.
///
/// [`Capsule`] and [`RoundRect`] are for `check`, `bounds`, `shape_area`, both overlaps, `relation`, `contains`,
/// `nearest`, `depth`, `signed_distance`, `within`, `cast`, `impact_time`, `sweep_bounds`, and `boundary_distance` but
/// with an ellipse; the same holds of arrays. An index of them has joins by overlap or distance, `select`,
/// `nearest` and casts. Other functions return [`Error::Kind`] for them.
///
/// [`Polygon`](crate::Polygon) and [`Polyline`](crate::Polyline) are for the same but `impact_time`, and for
/// `boundary_distance` with any kind; polylines have no area. `depth` needs convex ones, else it is
/// [`Error::NotConvex`]; so do `signed_distance` and `within` where they ask for a depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
#[repr(i32)]
pub enum Kind {
    Point = sys::VESICA_POINT,
    Segment = sys::VESICA_SEGMENT,
    Circle = sys::VESICA_CIRCLE,
    Aabb = sys::VESICA_AABB,
    Rect = sys::VESICA_RECT,
    Ellipse = sys::VESICA_ELLIPSE,
    Capsule = sys::VESICA_CAPSULE,
    RoundRect = sys::VESICA_ROUND_RECT,
    Polygon = sys::VESICA_POLYGON,
    Polyline = sys::VESICA_POLYLINE,
}

impl Kind {
    /// How many numbers a shape of this kind has; 0 for polygons and polylines, which have any number.
    pub const fn fields(self) -> usize {
        match self {
            Kind::Point => 2,
            Kind::Circle => 3,
            Kind::Segment | Kind::Aabb => 4,
            Kind::Capsule => 5,
            Kind::Rect | Kind::Ellipse => 6,
            Kind::RoundRect => 7,
            Kind::Polygon | Kind::Polyline => 0,
        }
    }
}

/// One shape: a struct of the library's, or [`AnyShape`].
///
/// # Safety
/// `numbers` has at least as many numbers as the kind has, and `address` leads to the kind's struct.
pub unsafe trait Shape {
    /// `f64` or `f32`.
    type Scalar: Scalar;
    /// Its kind.
    fn kind(&self) -> Kind;
    /// Its numbers, in the order of its struct.
    fn numbers(&self) -> &[Self::Scalar];
    /// Where its struct is.
    fn address(&self) -> *const c_void {
        self.numbers().as_ptr().cast()
    }
}

/// A shape whose type says its kind, so that slices of it are arrays of shapes.
pub trait KnownKind: Shape + Copy {
    /// Its kind.
    const KIND: Kind;
}

macro_rules! shapes {
    ($($name:ident)*) => {$(
        unsafe impl<T: Scalar> Shape for $name<T> {
            type Scalar = T;
            fn kind(&self) -> Kind {
                Kind::$name
            }
            fn numbers(&self) -> &[T] {
                // repr(C), and all fields are of type T.
                unsafe { slice::from_raw_parts((self as *const Self).cast(), Kind::$name.fields()) }
            }
        }
        impl<T: Scalar> KnownKind for $name<T> {
            const KIND: Kind = Kind::$name;
        }
    )*};
}
shapes! { Point Segment Circle Aabb Rect Ellipse Capsule RoundRect }

/// The most numbers that a shape of any kind has.
const MOST_FIELDS: usize = Kind::RoundRect.fields();

/// A shape whose kind is known at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnyShape<T> {
    kind: Kind,
    numbers: [T; MOST_FIELDS],
}

impl<T: Scalar> AnyShape<T> {
    /// From a kind and as many numbers as it has.
    pub fn new(kind: Kind, numbers: &[T]) -> Result<Self, Error> {
        if kind.fields() == 0 {
            return Err(Error::Kind);
        }
        if numbers.len() != kind.fields() {
            return Err(Error::Room { needed: kind.fields(), given: numbers.len() });
        }
        let mut shape = AnyShape { kind, numbers: [T::default(); MOST_FIELDS] };
        shape.numbers[..numbers.len()].copy_from_slice(numbers);
        Ok(shape)
    }
}

unsafe impl<T: Scalar> Shape for AnyShape<T> {
    type Scalar = T;
    fn kind(&self) -> Kind {
        self.kind
    }
    fn numbers(&self) -> &[T] {
        &self.numbers[..self.kind.fields()]
    }
}

/// An array of shapes of one kind, however it lies in memory. It borrows the memory and copies nothing.
///
/// Functions take a slice of structs, or a reference to one shape, in its place.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Shapes<'a, T> {
    pub(crate) view: sys::Shapes<T>,
    pub(crate) memory: PhantomData<&'a T>,
}

impl<'a, T: Scalar> Shapes<'a, T> {
    /// Shapes whose numbers follow one another, a shape after the other.
    pub fn packed(kind: Kind, numbers: &'a [T]) -> Result<Self, Error> {
        Self::records(kind, numbers, kind.fields())
    }

    /// Records of `step` numbers each, of which the first are a shape's.
    pub fn records(kind: Kind, numbers: &'a [T], step: usize) -> Result<Self, Error> {
        if kind.fields() == 0 {
            return Err(Error::Kind);
        }
        let longest = isize::MAX as usize / core::mem::size_of::<T>();
        if step < kind.fields() || step > longest || numbers.len() % step != 0 {
            return Err(Error::Room { needed: kind.fields().max(step), given: numbers.len() });
        }
        Ok(Self::at(kind, numbers.as_ptr(), numbers.len() / step, step))
    }

    /// A column for each number of the kind, in its order, all of one length.
    pub fn columns(kind: Kind, columns: &[&'a [T]]) -> Result<Self, Error> {
        if kind.fields() == 0 {
            return Err(Error::Kind);
        }
        if columns.len() != kind.fields() {
            return Err(Error::Room { needed: kind.fields(), given: columns.len() });
        }
        let count = columns[0].len();
        let mut shapes = Self::at(kind, columns[0].as_ptr(), count, 1);
        for (field, column) in shapes.view.field.iter_mut().zip(columns) {
            if column.len() != count {
                return Err(Error::Counts(count, column.len()));
            }
            *field = column.as_ptr();
        }
        Ok(shapes)
    }

    /// An array of one shape.
    pub(crate) fn one<S: Shape<Scalar = T> + ?Sized>(shape: &'a S) -> Self {
        Self::at(shape.kind(), shape.address().cast(), 1, shape.kind().fields())
    }

    /// `step` counts numbers. Fields lie one after the other.
    pub(crate) fn at(kind: Kind, first: *const T, count: usize, step: usize) -> Self {
        let mut field = [first; 8];
        for (i, place) in field.iter_mut().enumerate() {
            *place = first.wrapping_add(i);
        }
        let stride = (step * core::mem::size_of::<T>()) as isize;
        let (kind, count, none) = (kind as i32, count as i64, core::ptr::null());
        let view = sys::Shapes { kind, reserved: 0, count, stride, field, rings: none, polygons: none, each: 0 };
        Shapes { view, memory: PhantomData }
    }

    /// How many shapes there are.
    pub fn len(&self) -> usize {
        self.view.count as usize
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.view.count == 0
    }
}

impl<'a, S: KnownKind> From<&'a [S]> for Shapes<'a, S::Scalar> {
    fn from(shapes: &'a [S]) -> Self {
        let step = core::mem::size_of::<S>() / core::mem::size_of::<S::Scalar>();
        Shapes::at(S::KIND, shapes.as_ptr().cast(), shapes.len(), step)
    }
}

impl<'a, S: KnownKind> From<&'a S> for Shapes<'a, S::Scalar> {
    fn from(shape: &'a S) -> Self {
        core::slice::from_ref(shape).into()
    }
}

impl<'a, S: KnownKind, const N: usize> From<&'a [S; N]> for Shapes<'a, S::Scalar> {
    fn from(shapes: &'a [S; N]) -> Self {
        shapes.as_slice().into()
    }
}

impl<'a, T: Scalar> From<&'a AnyShape<T>> for Shapes<'a, T> {
    fn from(shape: &'a AnyShape<T>) -> Self {
        Shapes::at(shape.kind, shape.numbers.as_ptr(), 1, MOST_FIELDS)
    }
}

// What a view points to is only read.
unsafe impl<T: Sync> Send for Shapes<'_, T> {}
unsafe impl<T: Sync> Sync for Shapes<'_, T> {}
