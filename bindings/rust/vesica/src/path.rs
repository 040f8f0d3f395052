// SPDX-License-Identifier: Apache-2.0
//! Polygons and polylines, whose vertices stay where they are.
use crate::shape::KnownKind;
use crate::{Error, Kind, Scalar, Shape, Shapes};
use core::ffi::c_void;
use core::marker::PhantomData;
use core::mem::size_of;
use core::ptr;
use vesica_sys as sys;

macro_rules! paths {
    ($($(#[$text:meta])* $name:ident;)*) => {$(
        $(#[$text])*
        #[derive(Clone, Copy, Debug)]
        #[repr(transparent)]
        pub struct $name<'a, T> {
            path: sys::Polygon<T>,
            vertices: PhantomData<&'a T>,
        }

        impl<'a, T: Scalar> $name<'a, T> {
            /// Of vertices in one ring or chain.
            pub fn new(vertices: &'a [[T; 2]]) -> Result<Self, Error> {
                let path = path(vertices, ptr::null(), vertices.len())?;
                Ok($name { path, vertices: PhantomData })
            }

            /// Of vertices, and where each ring or chain begins among them, with the end: offsets that ascend.
            pub fn with_rings(vertices: &'a [[T; 2]], rings: &'a [i32]) -> Result<Self, Error> {
                ascend(rings, vertices.len())?;
                let path = path(vertices, rings.as_ptr(), rings.len() - 1)?;
                Ok($name { path, vertices: PhantomData })
            }
        }

        unsafe impl<T: Scalar> Shape for $name<'_, T> {
            type Scalar = T;
            fn kind(&self) -> Kind {
                Kind::$name
            }
            /// None: a kind with any number of vertices has no row of numbers.
            fn numbers(&self) -> &[T] {
                &[]
            }
            fn address(&self) -> *const c_void {
                (&self.path as *const sys::Polygon<T>).cast()
            }
        }
        impl<T: Scalar> KnownKind for $name<'_, T> {
            const KIND: Kind = Kind::$name;
        }

        // What it points to is only read.
        unsafe impl<T: Sync> Send for $name<'_, T> {}
        unsafe impl<T: Sync> Sync for $name<'_, T> {}
    )*};
}

paths! {
    /// Rings of vertices, each joined to a closed curve.
    ///
    /// What an odd number of them goes around is inside: a ring inside another is a hole, whatever their order and
    /// directions. Vertices and offsets are borrowed.
    Polygon;
    /// Chains of vertices, which are not closed and have no inside. Vertices and offsets are borrowed.
    Polyline;
}

fn path<T>(vertices: &[[T; 2]], rings: *const i32, count: usize) -> Result<sys::Polygon<T>, Error> {
    if vertices.is_empty() {
        return Err(Error::Rings);
    }
    let x: *const T = vertices.as_ptr().cast();
    Ok(sys::Polygon { x, y: x.wrapping_add(1), stride: size_of::<[T; 2]>() as isize, rings, count: count as i64 })
}

/// Offsets into `end` others.
fn ascend(offsets: &[i32], end: usize) -> Result<(), Error> {
    let first = *offsets.first().ok_or(Error::Rings)?;
    let is_sorted = offsets.windows(2).all(|pair| pair[0] <= pair[1]);
    if first < 0 || !is_sorted || offsets[offsets.len() - 1] as usize > end {
        return Err(Error::Rings);
    }
    Ok(())
}

impl<'a, T: Scalar> Shapes<'a, T> {
    /// Polygons or polylines of N vertices each, in one ring or chain: quads are `[[[T; 2]; 4]]`.
    pub fn even_paths<const N: usize>(kind: Kind, paths: &'a [[[T; 2]; N]]) -> Result<Self, Error> {
        if N == 0 {
            return Err(Error::Rings);
        }
        Self::of_vertices(kind, paths.as_ptr().cast(), paths.len(), N)
    }

    /// Polygons or polylines of one ring or chain each: where it begins among the vertices, with the end.
    pub fn paths(kind: Kind, vertices: &'a [[T; 2]], rings: &'a [i32]) -> Result<Self, Error> {
        ascend(rings, vertices.len())?;
        if vertices.is_empty() && rings.len() > 1 {
            return Err(Error::Rings);
        }
        let mut shapes = Self::of_vertices(kind, vertices.as_ptr().cast(), rings.len() - 1, vertices.len())?;
        shapes.view.rings = rings.as_ptr();
        Ok(shapes)
    }

    /// Polygons or polylines of any number of rings or chains: also where each begins among the rings, with the end.
    /// These are GeoArrow's offsets.
    pub fn nested_paths(
        kind: Kind,
        vertices: &'a [[T; 2]],
        rings: &'a [i32],
        polygons: &'a [i32],
    ) -> Result<Self, Error> {
        let mut shapes = Self::paths(kind, vertices, rings)?;
        ascend(polygons, rings.len() - 1)?;
        shapes.view.count = polygons.len() as i64 - 1;
        shapes.view.polygons = polygons.as_ptr();
        Ok(shapes)
    }

    fn of_vertices(kind: Kind, first: *const T, count: usize, each: usize) -> Result<Self, Error> {
        if kind != Kind::Polygon && kind != Kind::Polyline {
            return Err(Error::Kind);
        }
        let mut shapes = Self::at(kind, first, count, 2);
        shapes.view.each = each as i64;
        Ok(shapes)
    }
}
