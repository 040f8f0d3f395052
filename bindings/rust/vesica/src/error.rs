// SPDX-License-Identifier: Apache-2.0
//! What goes wrong, and the one way into the library.
use core::fmt;
use core::sync::atomic::{AtomicBool, Ordering};
use vesica_sys as sys;

/// Why there is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// A shape is invalid; [`check`](crate::check) tells why. In a batch, all other answers are written.
    Shape,
    /// Shapes of this kind cannot be asked this.
    Kind,
    /// An argument is out of its documented range.
    Argument,
    /// A number is NaN or infinite.
    NotFinite,
    /// A radius, half extent or half length is negative.
    NegativeSize,
    /// The axis is (0, 0).
    ZeroAxis,
    /// The min of a box exceeds its max.
    Inverted,
    /// A number of the result would be beyond the finite numbers of its type.
    Range,
    /// Bytes are not an index of this version, or are damaged.
    Index,
    /// A polygon has no vertex, or its offsets are negative, decrease, or exceed what they lead to.
    Rings,
    /// Edges of a polygon cross, or overlap along a stretch.
    NotSimple,
    /// A polygon is not convex, as the function requires.
    NotConvex,
    /// Arrays in step have neither equal lengths nor one shape.
    Counts(usize, usize),
    /// An output has too little room.
    Room {
        /// How many elements are needed.
        needed: usize,
        /// How many it has.
        given: usize,
    },
    /// The loaded library, of this version, is older than this crate.
    Older(i32),
    /// A code that this crate does not know.
    Unknown(i32),
}

impl Error {
    fn of(code: i32) -> Error {
        match code {
            sys::VESICA_E_SHAPE => Error::Shape,
            sys::VESICA_E_KIND => Error::Kind,
            sys::VESICA_E_ARGUMENT => Error::Argument,
            sys::VESICA_E_NOT_FINITE => Error::NotFinite,
            sys::VESICA_E_NEGATIVE_SIZE => Error::NegativeSize,
            sys::VESICA_E_ZERO_AXIS => Error::ZeroAxis,
            sys::VESICA_E_INVERTED => Error::Inverted,
            sys::VESICA_E_RANGE => Error::Range,
            sys::VESICA_E_INDEX => Error::Index,
            sys::VESICA_E_RINGS => Error::Rings,
            sys::VESICA_E_NOT_SIMPLE => Error::NotSimple,
            sys::VESICA_E_NOT_CONVEX => Error::NotConvex,
            _ => Error::Unknown(code),
        }
    }

    /// The library's code, `VESICA_E_...`; of what this crate itself refuses, that of an argument.
    pub fn code(self) -> i32 {
        match self {
            Error::Shape => sys::VESICA_E_SHAPE,
            Error::Kind => sys::VESICA_E_KIND,
            Error::NotFinite => sys::VESICA_E_NOT_FINITE,
            Error::NegativeSize => sys::VESICA_E_NEGATIVE_SIZE,
            Error::ZeroAxis => sys::VESICA_E_ZERO_AXIS,
            Error::Inverted => sys::VESICA_E_INVERTED,
            Error::Range => sys::VESICA_E_RANGE,
            Error::Index => sys::VESICA_E_INDEX,
            Error::Rings => sys::VESICA_E_RINGS,
            Error::NotSimple => sys::VESICA_E_NOT_SIMPLE,
            Error::NotConvex => sys::VESICA_E_NOT_CONVEX,
            Error::Unknown(code) => code,
            Error::Argument | Error::Counts(..) | Error::Room { .. } | Error::Older(_) => sys::VESICA_E_ARGUMENT,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Error::Counts(a, b) => write!(f, "{a} shapes and {b}: as many are needed, or one of either"),
            Error::Room { needed, given } => write!(f, "an output of {given} elements, where {needed} are needed"),
            Error::Older(version) => write!(
                f,
                "the loaded libvesica {version} is older than {}, which this crate needs: install a newer one",
                sys::VESICA_VERSION
            ),
            _ => f.write_str(message(self.code())),
        }
    }
}

#[cfg(feature = "std")]
impl std::error::Error for Error {}

fn message(code: i32) -> &'static str {
    unsafe {
        let text = sys::vesica_strerror(code);
        let length = (0..).take_while(|&i| *text.add(i) != 0).count();
        core::str::from_utf8(core::slice::from_raw_parts(text, length)).unwrap_or("an error without a text")
    }
}

fn not_older(version: i32) -> Result<(), Error> {
    if version < sys::VESICA_VERSION {
        return Err(Error::Older(version));
    }
    Ok(())
}

/// A library that is loaded with the program may be another than the one it was built with.
fn new_enough() -> Result<(), Error> {
    static KNOWN: AtomicBool = AtomicBool::new(false);
    if !KNOWN.load(Ordering::Relaxed) {
        not_older(unsafe { sys::vesica_version() })?;
        KNOWN.store(true, Ordering::Relaxed);
    }
    Ok(())
}

/// The answer of a C function, if it is one.
pub(crate) fn answer<Code: Into<i64>>(call: impl FnOnce() -> Code) -> Result<usize, Error> {
    new_enough()?;
    let code = call().into();
    usize::try_from(code).map_err(|_| Error::of(code as i32))
}

/// An output of a C function that fills in one struct.
pub(crate) fn filled<T, Code: Into<i64>>(out: T, call: impl FnOnce(&mut T) -> Code) -> Result<T, Error> {
    let mut out = out;
    answer(|| call(&mut out))?;
    Ok(out)
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn an_older_library_is_refused() {
        assert_eq!(not_older(sys::VESICA_VERSION), Ok(()));
        let error = not_older(99).unwrap_err();
        let words = "the loaded libvesica 99 is older than 100, which this crate needs: install a newer one";
        assert_eq!(error.to_string(), words);
    }

    #[test]
    fn codes_and_errors_agree() {
        for code in sys::VESICA_E_NOT_CONVEX..sys::VESICA_E_NULL {
            assert_eq!(Error::of(code).code(), code);
            assert!(!matches!(Error::of(code), Error::Unknown(_)));
        }
        assert!(Error::Shape.to_string().starts_with("a shape is invalid"));
    }
}
