// SPDX-License-Identifier: Apache-2.0
/// Shapes and their motion in integers of any size: corners, or the image of the unit disc.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "cast/face.hpp"

namespace swept {

using Integer = mpz_class;

struct Vector {
  Integer x, y;
};
inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator-(const Vector& a) { return {-a.x, -a.y}; }
inline Integer dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
inline Integer cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

/// The hull of one to four corners in their order around, which may coincide; or, without corners, the ellipse
/// { centre + s p + t q : s^2 + t^2 <= 1 } with p x q > 0 and p.q = 0.
struct Figure {
  std::vector<Vector> corners;
  Vector centre, p, q;
  bool is_disc = false;
};

/// A time n / d >= 0; infinite where d = 0.
struct Time {
  Integer n, d;
};

/// The figures of a moving pair, and the velocity of b, in a unit of length and one of time that are powers of two.
struct Scene {
  Figure a, b;
  Vector velocity;
  int time_unit;  ///< its exponent

  Scene(const cast_test::Pair& pair, double vx, double vy);
  Time time(double t) const;
};

}  // namespace swept
