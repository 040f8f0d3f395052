// SPDX-License-Identifier: Apache-2.0
/// Directions, lengths and eigenvalues of symmetric 2 x 2 matrices to a few units in the last place, at any
/// magnitude: a power of two is kept apart from each number until the very end.
#pragma once

#include <cmath>
#include <vesica/arithmetic/length.hpp>

namespace vesica::detail::arithmetic {

/// A vector as unit vector and length; (1, 0) and 0 for the zero vector.
struct UnitAndLength {
  double x, y;
  Scaled length;
};

/// (x, y) * 2^exponent taken apart. All three numbers are right to 3 units in the last place.
inline UnitAndLength unit_and_length(double x, double y, int exponent = 0) noexcept {
  if (x == 0 && y == 0) return {1, 0, {0, 0}};
  const int own = exponent_of(std::fmax(std::fabs(x), std::fabs(y)));
  const double scaled_x = scale(x, -own), scaled_y = scale(y, -own);
  const double length = length_of_scaled(scaled_x, scaled_y);
  return {scaled_x / length, scaled_y / length, {length, own + exponent}};
}

/// A positive semidefinite matrix taken apart: the unit eigenvector of the larger eigenvalue, with x >= 0, or (1, 0)
/// for equal eigenvalues; and the square roots of both eigenvalues.
struct Spectrum {
  double x, y;
  Scaled larger, smaller;
};

enum class Definite { no, semi, positive };

/// a b - c^2, right to 2 roundoffs, hence with the right sign (Kahan; Jeannerod, Louvet, Muller, "Further analysis
/// of Kahan's algorithm for the accurate computation of 2 x 2 determinants", 2013).
inline double determinant(double a, double b, double c) noexcept {
  const double square = c * c;
  return std::fma(a, b, -square) + std::fma(-c, c, square);
}

/// Unit eigenvector from (cos, sin) of twice its angle; y takes the sign of xy, which a sine may have lost to
/// underflow. Exchanging xx and yy exchanges |x| and |y|, which are equal where the cosine is 0.
inline void halve_angle(double cosine, double sine, double xy, Spectrum& out) noexcept {
  const double major = std::sqrt((1 + std::fabs(cosine)) / 2);
  const double minor = cosine == 0 ? major : std::fabs(sine) / (2 * major);
  out.x = cosine >= 0 ? major : minor;
  out.y = std::copysign(cosine >= 0 ? minor : major, xy == 0 ? 1.0 : xy);
}

/// Takes a symmetric matrix apart; `out` is written unless the answer, which is exact, is `no`.
///
/// No step cancels but the determinant's, which is done in fused operations: the larger eigenvalue is a sum of
/// positive terms, the smaller the determinant over it. Each of the four numbers is right to 8 units in its last place.
inline Definite spectrum(double xx, double xy, double yy, Spectrum& out) noexcept {
  if (xx < 0 || yy < 0 || ((xx == 0 || yy == 0) && xy != 0)) return Definite::no;
  // Each row scaled by its own power of two, so that the diagonal lies in [1/4, 1) and no product underflows.
  const int i = (exponent_of(xx) + 1) >> 1, j = (exponent_of(yy) + 1) >> 1;
  const double x = scale(xx, -2 * i), y = scale(yy, -2 * j), off = scale(xy, -i - j);
  const double det = std::fabs(off) < 1 ? determinant(x, y, off) : -1;
  if (det < 0) return Definite::no;
  // Twice the eigenvector's angle is the angle of (xx - yy, 2 xy), whose length is the eigenvalues' difference.
  const int k = exponent_of(std::fmax(std::fabs(xx - yy), std::fabs(xy)));
  const UnitAndLength twice = unit_and_length(scale(xx - yy, -k), 2 * scale(xy, -k), k);
  halve_angle(twice.x, twice.y, xy, out);
  if (xy == 0) {  // spares the nicest matrices the detour
    const Scaled root_x{std::sqrt(x), i}, root_y{std::sqrt(y), j};
    out.larger = xx >= yy ? root_x : root_y;
    out.smaller = xx >= yy ? root_y : root_x;
  } else {
    const int e = i > j ? i : j;
    const double difference = scale(twice.length.value, twice.length.exponent - 2 * e);
    const double larger = ((scale(xx, -2 * e) + scale(yy, -2 * e)) + difference) / 2;
    out.larger = {std::sqrt(larger), e};
    out.smaller = {std::sqrt(det / larger), i + j - e};
  }
  return det > 0 ? Definite::positive : Definite::semi;
}

}  // namespace vesica::detail::arithmetic
