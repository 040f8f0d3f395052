// SPDX-License-Identifier: Apache-2.0
/// The least value over all directions of h_a(n) + sign h_b(n) - n.D by sampling densely and refining every local
/// minimum among the samples: slow, simple, and without any of the library's code. In double.
#pragma once

#include <vector>

#include "properties/pair.hpp"

namespace outline_reference {

struct Direction {
  double x, y;
};
Direction unit(double x, double y);

/// { s axis + t perp(axis) } with a unit axis.
struct DenseShape {
  double cx, cy, ux, uy, a, b;
  bool curved;

  double height(const Direction& n) const;
  /// Out of the shape's frame, at unit length.
  Direction world(double x, double y) const;
};

/// From a kind and numbers as in vesica.h.
DenseShape dense_shape(int kind, const properties::Numbers& numbers);

struct DensePair {
  DenseShape a, b;
  double sign, dx, dy;

  DensePair(const DenseShape& s, const DenseShape& t, int sign_)
      : a(s), b(t), sign(sign_), dx(t.cx - s.cx), dy(t.cy - s.cy) {}
  double operator()(const Direction& n) const;
};

/// An arc with a local minimum of the samples inside.
struct Bracket {
  Direction before, at, after;
  double value;
};

/// From evenly spaced directions, from the normals at even steps of each shape's eccentric angle, and from directions
/// at geometrically spaced angles from each shape's axes.
std::vector<Bracket> local_minima(const DensePair& f);

/// The golden section: the least value met in a bracket, whose middle moves there.
double refine(const DensePair& f, Bracket& bracket);

/// Off by some roundoffs of the largest length.
double dense_minimum(const DensePair& f);

}  // namespace outline_reference
