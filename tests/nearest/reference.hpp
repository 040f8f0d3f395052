// SPDX-License-Identifier: Apache-2.0
/// The distance of two disjoint shapes to more than 40 digits, with its own proof and none of the library's code.
#pragma once

#include <gmpxx.h>

#include "properties/pair.hpp"

namespace nearest_reference {

using Real = mpf_class;

struct Vector {
  Real x, y;
};

/// A shape about its centre: { s u + t perp(u) : |s| <= a, |t| <= b } or, curved, the ellipse in it; and radius r about
/// that. All as stored, without rounding.
struct Shape {
  Vector centre, u;
  Real a, b, r;
  bool curved;
};

Shape shape(int kind, const properties::Numbers& numbers);

/// Sets the precision of all numbers made from now on: enough for the magnitudes of a pair.
void set_precision(const properties::Pair& pair);

/// A distance between its bounds: the width of a gap between two lines that separate the shapes, and the distance of
/// two points of them.
struct Distance {
  Real lower, upper;
  /// True if the bounds agree to a relative 2^-80.
  bool proved() const;
};

/// A direction to begin with (any; the bounds do not rest on it) spares most of the work.
Distance distance(const Shape& a, const Shape& b, double hint_x, double hint_y);

/// The largest coordinate of the offset of centres, or half length: what error bounds are multiples of.
Real scale(const Shape& a, const Shape& b);

/// Longer over shorter half length, 1 for what has only one.
Real aspect(const Shape& s);

/// How far a point is from the shape's outline, negative inside; a rough value suffices up to `enough`.
Real beyond_outline(const Shape& s, double x, double y, const Real& enough);

}  // namespace nearest_reference
