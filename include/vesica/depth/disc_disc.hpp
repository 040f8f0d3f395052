// SPDX-License-Identifier: Apache-2.0
/// How deep two circles, or a point and a circle, overlap: the sum of the radii less the distance of the centres.
#pragma once

#include <vesica/exact/disc.hpp>
#include <vesica/exact/rounded.hpp>
#include <vesica/support_minimum/order.hpp>

namespace vesica::detail::depth {

using namespace support_minimum;

template <class Shape>
inline constexpr bool is_disc = false;
template <>
inline constexpr bool is_disc<Point<double>> = true;
template <>
inline constexpr bool is_disc<Circle<double>> = true;

/// In units of 2^exponent; the unit vector along which the second shape is to be moved.
struct Depth {
  FastDoubleDouble<double> value;
  PlaneVector direction;
  int exponent;
};

inline const Circle<double>& as_circle(const Circle<double>& c) noexcept { return c; }
inline Circle<double> as_circle(const Point<double>& p) noexcept { return {p.x, p.y, 0}; }

/// Below this share of the sizes the difference of rounded lengths has lost digits that its last place needs.
inline constexpr double least_plain_difference = 0x1p-40;

/// With s the sum of radii and D the offset of centres, s - |D| = (s^2 - D.D) / (s + |D|). The numerator is formed
/// exactly and taken to two doubles, so that the quotient is rounded once.
inline Depth tiny_disc_depth(const Circle<double>& a, const Circle<double>& b, const Depth& plain,
                             const FastDoubleDouble<double>& both_lengths) noexcept {
  using exact::from_double;
  const auto x = from_double(b.cx) - from_double(a.cx), y = from_double(b.cy) - from_double(a.cy);
  const auto numerator = exact::square(from_double(a.r) + from_double(b.r)) - (exact::square(x) + exact::square(y));
  const auto [high, low] = exact::rounded_twice(numerator);
  const auto quotient = arithmetic::AccurateDoubleDouble(high.value, low) /
                        arithmetic::AccurateDoubleDouble(both_lengths.high, both_lengths.low);
  return {{quotient.high, quotient.low}, plain.direction, high.exponent - plain.exponent};
}

/// For discs that overlap; concentric ones move apart along x, the first in order to the left.
inline Depth disc_disc_depth(const Circle<double>& a, const Circle<double>& b) noexcept {
  const Form f = support_minimum::form(a), g = support_minimum::form(b);
  const PlacedPair pair = place(f, g);
  const FastDoubleDouble<double> radii = sum(scale(a.r, -pair.exponent), scale(b.r, -pair.exponent));
  const Offset raw = offset_of_centres(f, g);
  if (raw.x.high == 0 && raw.y.high == 0) {
    return {radii, {out_of_order(f, g, pair) ? -1.0 : 1.0, 0}, pair.exponent};
  }
  const FastDoubleDouble<double> distance = root(pair.d.x * pair.d.x + pair.d.y * pair.d.y), value = radii - distance;
  const Depth plain{value, unit_of_any({raw.x.high, raw.y.high}), pair.exponent};
  return value.high > least_plain_difference ? plain : tiny_disc_depth(a, b, plain, radii + distance);
}

}  // namespace vesica::detail::depth
