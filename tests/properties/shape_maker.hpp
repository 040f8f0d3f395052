// SPDX-License-Identifier: Apache-2.0
/// Single random shapes about the origin, and the ways two of them are brought together.
#pragma once

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace properties {

struct Vector {
  double x, y;
};

/// A shape about the origin: the longer and the shorter half size, and the length its axis is stored with.
struct Proportions {
  double longer, shorter, axis_length;
};

/// In a random direction, and either size along it.
Numbers shape_at_origin(int kind, Random& random, const Proportions& proportions);

/// Half a length along the unit vector u and half a length across it; its kind takes what it has.
Numbers shape_at_origin(int kind, Vector u, double along, double across, double axis_length);

/// A shape about the origin whose numbers and corners are small integers; each size is 0 in one of five.
Numbers integer_shape(int kind, Random& random);

/// A random point of the shape's carrier, reaching `reach` times as far as the shape does (1: a point of the shape);
/// one of five lies on an axis just inside the outline.
Vector random_point(int kind, const Numbers& numbers, Random& random, double reach);

/// A centre, end point, corner or vertex of the shape, rounded.
Vector special_point(int kind, const Numbers& numbers, Random& random);

Numbers moved(int kind, Numbers numbers, Vector by);

/// Sizes, or extents of a segment or an AABB, become 0, each with probability 1/2.
Numbers collapsed(int kind, Numbers numbers, Random& random);

/// All lengths times 2^exponent: positions, and for boxes and ellipses either the sizes or the axis.
Numbers scaled(int kind, Numbers numbers, int exponent, bool scale_axis);

}  // namespace properties
