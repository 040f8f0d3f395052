// SPDX-License-Identifier: Apache-2.0
/// Certificates that a polynomial is positive: its Bernstein coefficients on each piece of an interval.
///
/// A polynomial whose Bernstein coefficients on an interval are positive is positive there (R. T. Farouki, "The
/// Bernstein polynomial basis: A centennial retrospective", CAGD 29 (2012) 379). Here x = Y / X runs over a ray of
/// ratios between the vectors (1, 0) and (0, 1): pieces are split by de Casteljau's algorithm with sums in the place of
/// means, which changes coefficients by positive factors only.
#pragma once

#include <cstddef>
#include <vesica/support_minimum/from_nearest.hpp>

namespace vesica::detail::support_minimum {

constexpr double binomial(int n, int k) noexcept {
  double b = 1;
  for (int i = 0; i < k; ++i) b = b * (n - i) / (i + 1);
  return b;
}

/// c[k] belongs to X^(degree - k) Y^k.
template <int degree, class V>
struct Polynomial {
  V c[std::size_t{degree + 1}];
};

// Everything below is written out by templates: loops over coefficients would stay loops, and the coefficients in
// memory.
namespace coefficients {

template <int k, int i, int m, int n, class V>
VESICA_INLINE V convolution(const Polynomial<m, V>& p, const Polynomial<n, V>& q) noexcept {
  if constexpr (i == m || i == k) {
    return p.c[i] * q.c[k - i];
  } else {
    return p.c[i] * q.c[k - i] + convolution<k, i + 1>(p, q);
  }
}
template <int k, int m, int n, class V>
VESICA_INLINE void multiply(const Polynomial<m, V>& p, const Polynomial<n, V>& q,
                            Polynomial<m + n, V>& product) noexcept {
  product.c[k] = convolution<k, (k > n ? k - n : 0)>(p, q);
  if constexpr (k < m + n) multiply<k + 1>(p, q, product);
}

template <int k, int degree, class V>
VESICA_INLINE void set_bernstein(const Polynomial<degree, V>& p, V side, V margin,
                                 Polynomial<degree, V>& out) noexcept {
  constexpr double share = 1 / binomial(degree, k);
  const V c = V(share) * p.c[k];
  out.c[k] = (k % 2 == 1 ? side * c : c) - margin;
  if constexpr (k < degree) set_bernstein<k + 1>(p, side, margin, out);
}

template <int k, int degree, class V>
VESICA_INLINE void stretch(Polynomial<degree, V>& p, const double* powers) noexcept {
  p.c[k] = V(powers[k]) * p.c[k];
  if constexpr (k < degree) stretch<k + 1>(p, powers);
}
template <int level, int k, int degree, class V>
VESICA_INLINE void add_neighbours(Polynomial<degree, V>& p) noexcept {
  p.c[k] = p.c[k] + p.c[k + 1];
  if constexpr (k + 1 < level) add_neighbours<level, k + 1>(p);
}
template <int level, int degree, class V>
VESICA_INLINE V collapse(Polynomial<degree, V>& p, V least) noexcept {
  add_neighbours<level, 0>(p);
  const V less = min(least, p.c[0]);
  if constexpr (level > 1) {
    return collapse<level - 1>(p, less);
  } else {
    return less;
  }
}

template <int k, int degree, class V>
VESICA_INLINE V least_coefficient(const Polynomial<degree, V>& p) noexcept {
  if constexpr (k == 0) {
    return p.c[0];
  } else {
    return min(least_coefficient<k - 1>(p), p.c[k]);
  }
}

}  // namespace coefficients

template <int m, int n, class V>
VESICA_INLINE Polynomial<m + n, V> operator*(const Polynomial<m, V>& p, const Polynomial<n, V>& q) noexcept {
  Polynomial<m + n, V> product;
  coefficients::multiply<0>(p, q, product);
  return product;
}
template <class V>
VESICA_INLINE Polynomial<4, V> operator-(const Polynomial<4, V>& p, const Polynomial<4, V>& q) noexcept {
  return {{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2], p.c[3] - q.c[3], p.c[4] - q.c[4]}};
}

/// The square of a polynomial of degree 2.
template <class V>
VESICA_INLINE Polynomial<4, V> square(const Polynomial<2, V>& p) noexcept {
  const V two(2.0), twice = two * p.c[0];
  return {
      {p.c[0] * p.c[0], twice * p.c[1], p.c[1] * p.c[1] + twice * p.c[2], (two * p.c[1]) * p.c[2], p.c[2] * p.c[2]}};
}

/// The square root of the quadratic form (xx, xy; xy, yy) of a unit vector at an angle from the first axis, squared
/// again, by the tangent of half that angle: times (1 + x^2)^2.
template <class V>
VESICA_INLINE Polynomial<4, V> form_by_half_angle(V xx, V xy, V yy) noexcept {
  const V four(4.0), slope = four * xy;
  return {{xx, slope, four * yy - (xx + xx), -slope, xx}};
}
/// The same of radius + (x, y) . the unit vector, times 1 + x^2.
template <class V>
VESICA_INLINE Polynomial<2, V> disc_by_half_angle(V radius, V x, V y) noexcept {
  return {{radius + x, y + y, radius - x}};
}

/// Bernstein coefficients for x > 0 (side 1), or of the mirror image (side -1), less a margin for their rounding: the
/// margin is as a polynomial margin (1 + x)^degree.
template <int degree, class V>
VESICA_INLINE Polynomial<degree, V> bernstein(const Polynomial<degree, V>& p, double side, V margin) noexcept {
  Polynomial<degree, V> out;
  coefficients::set_bernstein<0>(p, V(side), margin, out);
  return out;
}

/// Values of x at which a ray is cut, as what cut() takes: the powers of each piece's length over the one's before it.
template <int Count>
struct Cuts {
  static constexpr int count = Count;
  double at[std::size_t{count}];
  double powers[std::size_t{count}][7];

  consteval explicit Cuts(const double (&x)[std::size_t{count}]) noexcept : at{}, powers{} {
    for (int i = 0; i < count; ++i) {
      at[i] = x[i];
      const double length = i > 0 ? x[i] - x[i - 1] : x[0], before = i > 1 ? x[i - 1] - x[i - 2] : i == 1 ? x[0] : 1;
      powers[i][0] = 1;
      for (int k = 1; k < 7; ++k) powers[i][k] = powers[i][k - 1] * (length / before);
    }
  }
};

/// Cuts the piece between the vectors P and Q at P + r Q, given the powers of r. p is then the piece from there to r Q;
/// the least coefficient of the other is returned.
template <int degree, class V>
VESICA_INLINE V cut(Polynomial<degree, V>& p, const double* powers) noexcept {
  coefficients::stretch<1>(p, powers);
  return coefficients::collapse<degree>(p, p.c[0]);
}

template <int degree, class V>
VESICA_INLINE V least_coefficient(const Polynomial<degree, V>& p) noexcept {
  return coefficients::least_coefficient<degree>(p);
}

}  // namespace vesica::detail::support_minimum
