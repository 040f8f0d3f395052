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

/// A polygon, or an ellipse when there are no corners; and all that is at most the radius from a polygon.
struct Region {
  Corners corners;
  Ellipse ellipse;
  mpz_class radius = 0;
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

/// A polygon's edges as pairs of corner indices: none, one, or as many as corners.
inline std::size_t edge_count(const Corners& c) { return c.size() > 2 ? c.size() : c.size() == 2 ? 1 : 0; }
inline const Vector& edge_end(const Corners& c, std::size_t edge) { return c[(edge + 1) % c.size()]; }

/// Is x in the polygon, outline included?
bool contains(const Corners& c, const Vector& x);

/// Does an edge of a cross one of b, both of them inside?
bool edges_cross(const Corners& a, const Corners& b);

/// Do two solid ellipses share a point?
bool ellipses_overlap(const Ellipse& a, const Ellipse& b);
/// Do a convex polygon, counter-clockwise, and a solid ellipse share a point?
bool polygon_overlaps_ellipse(const Corners& c, const Ellipse& e);

/// A disc as its centre with a radius; other regions as they are.
Region with_core(const Region& region);
/// Are two regions whose cores are apart, not both of them ellipses but discs, at most the distance apart?
bool near(const Region& a, const Region& b, const mpz_class& distance);
/// Is an ellipse at most `reach` from a convex polygon that is apart from it?
bool near_ellipse(const Corners& c, const Ellipse& e, const mpz_class& reach);

/// The relation of two regions with cores that are polygons, of which at least one has a radius.
int rounded_relation(const Region& a, const Region& b);

/// X in the frame where the ellipse is the disc of radius p x q about the origin.
Vector to_disc(const Ellipse& e, const Vector& x);

}  // namespace oracle
