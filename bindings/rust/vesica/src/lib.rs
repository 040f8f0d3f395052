// SPDX-License-Identifier: Apache-2.0
//! Exact overlap queries between plain 2D shapes: points, segments, circles, boxes, rotated rectangles, ellipses,
//! capsules, rounded rectangles, polygons and polylines, in `f64` and `f32`.
//!
//! ```
//! use vesica::{overlap, overlap_many, nearest, Circle, Rect};
//!
//! let car = vesica::rect(0.0, 0.0, 0.5, 4.0, 2.0)?; // centre, angle, width, height
//! let people = [Circle { cx: 1.4, cy: 1.5, r: 0.5 }, Circle { cx: 8.0, cy: 1.0, r: 0.5 }];
//! assert!(overlap(&car, &people[0])?);
//! assert!(nearest(&car, &people[1])?.distance > 5.0);
//!
//! let mut hits = [false; 2];
//! assert_eq!(overlap_many(&[car], &people, &mut hits)?, 1); // arrays in step, or one against all
//! # Ok::<(), vesica::Error>(())
//! ```
//!
//! Shapes are closed and solid, and touching is overlap. Answers that are yes or no are exact for every valid input.
//! Slices are used where they lie. An invalid shape is an [`Error`]; in a batch all other answers are written all the
//! same. [`sys`] is the C library itself, with the whole text of each function.
//!
//! Without the feature `alloc` there is no index, and nothing allocates. The crate needs no `std`.
#![no_std]
#![warn(missing_docs)]
#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod batch;
mod construct;
#[cfg(feature = "alloc")]
mod detection;
mod error;
#[cfg(feature = "alloc")]
mod index;
mod measures;
mod motion;
mod path;
mod query;
mod shape;
#[cfg(feature = "std")]
mod threads;
mod topology;

pub use batch::*;
pub use construct::*;
#[cfg(feature = "alloc")]
pub use detection::*;
pub use error::Error;
#[cfg(feature = "alloc")]
pub use index::{nearest_of_each, Index, JoinQuery, RatioPair};
pub use measures::*;
pub use motion::*;
pub use path::{Polygon, Polyline};
pub use query::*;
pub use shape::{AnyShape, Kind, Shape, Shapes};
pub use topology::*;
pub use vesica_sys as sys;
pub use vesica_sys::{Aabb, Capsule, Circle, Ellipse, Point, Rect, RoundRect, Segment};
pub use vesica_sys::{ClosestPoints, Impact, Penetration, Scalar, Turn};

/// The README's example.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
