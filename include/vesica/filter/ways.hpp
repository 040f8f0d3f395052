// SPDX-License-Identifier: Apache-2.0
/// Polynomials of degree 2 in differences of stored numbers, and their signs: exact for numbers of any length, unless
/// their exponents are far apart. For what the filters leave open, one pair at a time.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>
#include <vesica/filter/residues.hpp>

namespace vesica::filter {

/// A length: rounded, and in units.
template <class Number>
struct Span {
  double x;
  Number in_units;

  template <class Unit>
  VESICA_INLINE constexpr Span(double x_, Unit& unit) noexcept : x(x_), in_units(unit.number(x_)) {}
  VESICA_INLINE constexpr Span(double x_, const Number& in_units_) noexcept : x(x_), in_units(in_units_) {}
  VESICA_INLINE constexpr Span operator+(const Span& s) const noexcept { return {x + s.x, in_units + s.in_units}; }
};

/// The way from one stored point to another: rounded, and in units.
template <class Number>
struct Way {
  double x, y;
  Number in_units_x, in_units_y;
};

/// A stored point.
template <class Number>
struct Spot {
  double x, y;
  Number in_units_x, in_units_y;

  template <class Unit>
  VESICA_INLINE constexpr Spot(double x_, double y_, Unit& unit) noexcept
      : x(x_), y(y_), in_units_x(unit.number(x_)), in_units_y(unit.number(y_)) {}
  VESICA_INLINE constexpr Way<Number> to(const Spot& p) const noexcept {
    return {p.x - x, p.y - y, p.in_units_x - in_units_x, p.in_units_y - in_units_y};
  }
};

/// A sum of products of two spans or coordinates of ways. As `magnitude` it has the sum M of the magnitudes of its
/// terms.
template <class Number>
struct Quadratic {
  double value, magnitude;
  Residue128 in_units;
};

template <class Number>
VESICA_INLINE constexpr Quadratic<Number> cross(const Way<Number>& a, const Way<Number>& b) noexcept {
  const double left = a.x * b.y, right = a.y * b.x;
  return {left - right, lane::abs(left) + lane::abs(right), a.in_units_x * b.in_units_y - a.in_units_y * b.in_units_x};
}
template <class Number>
VESICA_INLINE constexpr Quadratic<Number> dot(const Way<Number>& a, const Way<Number>& b) noexcept {
  const double left = a.x * b.x, right = a.y * b.y;
  return {left + right, lane::abs(left) + lane::abs(right), a.in_units_x * b.in_units_x + a.in_units_y * b.in_units_y};
}
template <class Number>
VESICA_INLINE constexpr Quadratic<Number> square(const Span<Number>& s) noexcept {
  const double squared = s.x * s.x;
  return {squared, squared, s.in_units * s.in_units};
}
template <class Number>
VESICA_INLINE constexpr Quadratic<Number> operator+(const Quadratic<Number>& a, const Quadratic<Number>& b) noexcept {
  return {a.value + b.value, a.magnitude + b.magnitude, a.in_units + b.in_units};
}
template <class Number>
VESICA_INLINE constexpr Quadratic<Number> operator-(const Quadratic<Number>& a, const Quadratic<Number>& b) noexcept {
  return {a.value - b.value, a.magnitude + b.magnitude, a.in_units - b.in_units};
}

/// A number with the sign of D: a cross or dot product of two ways, which may have been computed as the sum of two
/// such, or a dot product less a square.
///
/// Proved: the sign is right though only 128 bits of D are kept. A residue modulo 2^128 has the sign of D as long as
/// |D| < 2^127, in squares of the unit.
///
///   - In near units ways and spans are below 2^63. Products and squares are below 2^126, and a square is only taken
///     from a sum of squares, so |D| < 2^127: the residue's sign is taken.
///   - In far units, G, they are below 2^87. As G >= 2^-400 no product underflows: terms err by 3u of themselves, their
///     sum or difference by u more, and a sum or difference of two such by u again, in all by less than 6u M with what
///     is of second order (u = 2^-53).
///   - So a rounded value beyond 8u M has the sign of D, and is taken.
///   - Elsewhere |D| <= 14u M. M has four terms at most, together below 2^176 G^2. So |D| < 2^127 G^2: the residue's
///     sign is taken.
template <class Number>
VESICA_INLINE constexpr std::int64_t sign(const Quadratic<Number>& d) noexcept {
  if constexpr (std::is_same_v<Number, Integer64>) return d.in_units.sign();
  const double residue = std::bit_cast<double>(d.in_units.sign());
  return std::bit_cast<std::int64_t>(lane::select(lane::abs(d.value) > 0x1p-50 * d.magnitude, d.value, residue));
}

}  // namespace vesica::filter
