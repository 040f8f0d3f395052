// SPDX-License-Identifier: Apache-2.0
//! The C functions of Vesica, with the texts of its headers. The crate `vesica` is what programs use.
//!
//! [`Scalar`] has the functions in `f64` and `f32` by one name, and structs are generic: `Rect<f64>` is
//! `vesica_rect_f64`.
#![no_std]
#![allow(non_camel_case_types)]

#[rustfmt::skip]
mod declarations;
pub use declarations::*;
