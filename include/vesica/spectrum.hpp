// SPDX-License-Identifier: Apache-2.0
/// Directions, lengths and eigenvalues of symmetric 2 x 2 matrices to a few units in the last place, at any magnitude:
/// numbers carry their power of two apart until the very end.
#pragma once

#include <cmath>

namespace vesica::detail {

/// value * 2^exponent.
struct Scaled {
  double value;
  int exponent;
};

/// x * 2^exponent, rounded once, for |x| in [2^-20, 2^20] or 0. Unlike the C library's it never sets errno.
inline double unscale(double x, int exponent) noexcept {
  const int clamped = exponent < -2000 ? -2000 : exponent > 2000 ? 2000 : exponent;
  const int half = clamped / 2;
  return x * std::ldexp(1.0, half) * std::ldexp(1.0, clamped - half);
}

inline double unscale(const Scaled& x) noexcept { return unscale(x.value, x.exponent); }

/// The exponent e with 2^(e-1) <= |x| < 2^e; 0 for 0.
inline int exponent_of(double x) noexcept {
  int exponent;
  std::frexp(x, &exponent);
  return exponent;
}

/// A vector as unit vector and length. The zero vector gets (1, 0) and 0.
struct Direction {
  double x, y;
  Scaled length;
};

/// Each component and the length are off by less than 2 units in the last place (std::hypot's one, and a rounding).
inline Direction direction(double x, double y) noexcept {
  if (x == 0 && y == 0) return {1, 0, {0, 0}};
  const int exponent = exponent_of(std::fmax(std::fabs(x), std::fabs(y)));
  const double scaled_x = std::ldexp(x, -exponent), scaled_y = std::ldexp(y, -exponent);
  const double length = std::hypot(scaled_x, scaled_y);
  return {scaled_x / length, scaled_y / length, {length, exponent}};
}

/// A positive semidefinite symmetric matrix taken apart: the square roots of its eigenvalues, and the unit
/// eigenvector of the larger, with x >= 0 (and (0, 1) for (0, +-1); (1, 0) when the eigenvalues are equal).
struct Spectrum {
  double x, y;
  Scaled larger, smaller;
};

enum class Definite { no, semi, positive };

