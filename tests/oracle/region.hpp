// SPDX-License-Identifier: Apache-2.0
/// Shapes as integer geometry in one common unit, a power of two: a list of corners, or an ellipse as the image
/// C + s P + t Q of the unit disc.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <vector>

#include "oracle/motion.hpp"

namespace oracle {

struct Vector {
  mpz_class x, y;
};

inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
inline bool operator==(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y; }
inline mpz_class dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
inline mpz_class cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
/// > 0 when a, b, c turn counter-clockwise.
inline int orientation(const Vector& a, const Vector& b, const Vector& c) { return sgn(cross(b - a, c - a)); }

/// One corner (a point), two (a segment) or four counter-clockwise (a box with area); no corner twice.
using Corners = std::vector<Vector>;

/// { centre + s p + t q : s^2 + t^2 <= 1 } with p x q > 0.
struct Ellipse {
  Vector centre, p, q;
};

/// A polygon, or an ellipse when there are no corners.
struct Region {
  Corners corners;
  Ellipse ellipse;
};

/// Two shapes in one unit. Kinds and flat numbers as in vesica.h.
struct RegionPair {
  Region a, b;
};
RegionPair regions(int kind_a, const double* a, int kind_b, const double* b);

/// The same, and how far the second is moved.
struct MovingPair {
  Region a, b;
  Vector by;
};
MovingPair regions_on_way(int kind_a, const double* a, int kind_b, const double* b, const Way& way);

/// A polygon's edges as pairs of corner indices: none, one or four.
inline std::size_t edge_count(const Corners& c) { return c.size() == 2 ? 1 : c.size() == 4 ? 4 : 0; }
inline const Vector& edge_end(const Corners& c, std::size_t edge) { return c[(edge + 1) % c.size()]; }

/// Is x in the polygon, outline included?
bool contains(const Corners& c, const Vector& x);

/// Do two solid ellipses share a point?
bool ellipses_overlap(const Ellipse& a, const Ellipse& b);

/// X in the frame where the ellipse is the disc of radius p x q about the origin.
Vector to_disc(const Ellipse& e, const Vector& x);

}  // namespace oracle
