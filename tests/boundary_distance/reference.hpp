// SPDX-License-Identifier: Apache-2.0
/// The least value over all directions of h_a(n) + sign h_b(n) - n.D, to 90 digits and without any of the library's
/// code: directions are sampled densely, from every local minimum among them one is refined in multiple precision, and
/// the least counts. With sign 1 it is the depth of an overlap, with sign -1 the distance between nested outlines, a
/// outer.
#pragma once

#include <gmpxx.h>

#include <array>

#include "properties/pair.hpp"

namespace outline_reference {

using properties::Numbers;
using Real = mpf_class;

/// A shape about its centre: { s axis + t perp(axis) }, the axis a unit vector, and a true length along and across it;
/// and all that is at most the radius from it.
struct Shape {
  Real cx, cy, ux, uy, a, b;
  bool curved;
  Real radius = 0;
};

/// From a kind and numbers as in vesica.h.
Shape shape(int kind, const Numbers& numbers);

struct Least {
  Real value;
  double nx, ny;  ///< where it is
};

Least least(const Shape& a, const Shape& b, int sign);

/// The largest of the coordinates of the offset and the half lengths: what error bounds are multiples of.
double scale(const Shape& a, const Shape& b);

/// (computed - exact) / (2^-53 scale).
double error_in_roundoffs(double computed, const Real& exact, double scale);

/// How far a point is from the outline of a shape, at most (to first order for ellipses).
double distance_from_outline(const Shape& s, double x, double y);

/// The greater ratio of a shape's half lengths, 1 for a shape without area.
double aspect(const Shape& s);

}  // namespace outline_reference
