// SPDX-License-Identifier: Apache-2.0
/// What quick hits of round shapes and of boxes have in common: numbers whose products are exact to all digits that count,
/// and the floor of a time that is known to twice the precision.
#pragma once

#include <vesica/cast/quick.hpp>

namespace vesica::detail::cast {

/// Whether a number is 0 or moderate: products with it are exact to all digits that count.
VESICA_INLINE bool is_plain(double x) noexcept {
  return lane::either(x == 0, lane::both(abs(x) >= least_moderate, abs(x) <= most_moderate));
}

/// The floor of a time, which is before the end.
VESICA_INLINE Quick floor_of(const Twofold<double>& time, double error, double end, double& t) noexcept {
  const Twofold<double> x = arithmetic::renormalised(time);
  if (!(error < 0x1p-56 * x.high && abs(x.low) > error && x.high <= 0x1p100)) return Quick::open;
  t = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x.high) - static_cast<std::uint64_t>(x.low < 0));
  return t < end ? Quick::hit : t > end ? Quick::missed : Quick::open;
}

/// Offsets of centres, exact where they are stored.
VESICA_INLINE Vector exact_offset(double x, double y, double cx, double cy) noexcept {
  return {nearest::exact_difference(x, cx), nearest::exact_difference(y, cy)};
}
VESICA_INLINE Vector exact_offset(const Point<double>& p, const form::Corners<double>& place) noexcept {
  const form::Corners<double> to{p.x, p.y, p.x, p.y};
  const auto x = form::twice_offset_x(place, to, 1), y = form::twice_offset_y(place, to, 1);
  return {{0.5 * x.high, 0.5 * x.low}, {0.5 * y.high, 0.5 * y.low}};
}

/// An axis or a velocity, of which nothing was rounded, as factors.
template <class Products>
VESICA_INLINE auto plain_factor(double x, double y) noexcept {
  return arithmetic::VectorFactor<decltype(Products::factor(x))>{Products::factor(x), Products::factor(y)};
}

/// All numbers of a pair that are multiplied are 0 or moderate, and a length is.
VESICA_INLINE bool is_plain(const Vector& d, const Motion& v) noexcept {
  const double far = abs(d.x.high) + abs(d.y.high);
  return lane::both(
      lane::both(lane::both(is_plain(d.x.high), is_plain(d.y.high)), lane::both(is_plain(v.vx), is_plain(v.vy))),
      lane::both(far >= 0x1p-40, far <= 0x1p40));
}
VESICA_INLINE bool is_plain_size(double x) noexcept { return lane::both(x >= 0x1p-40, x <= 0x1p40); }

}  // namespace vesica::detail::cast
