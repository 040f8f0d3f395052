// SPDX-License-Identifier: Apache-2.0
/// Shared by the fast hits of round shapes and of boxes: numbers whose products are exact to all digits that count, and
/// the floor of a time that is known to twice the precision.
#pragma once

#include <vesica/cast/early_out.hpp>

namespace vesica::detail::cast {

/// True if a number is 0 or moderate: products with it are exact to all digits that count.
template <class V>
VESICA_INLINE MaskOf<V> is_plain(V x) noexcept {
  return either(x == V(0.0), both(abs(x) >= V(least_moderate), abs(x) <= V(most_moderate)));
}

/// The floor of a time.
template <class V>
struct Floor {
  V t;
  MaskOf<V> certain;
};
/// The double before x is x (1 - 2^-53), rounded: the product is off x by more than half the step below it, or exact if
/// x is a power of two. For scalars integer arithmetic on the bits is faster.
template <class V>
VESICA_INLINE Floor<V> floor_of(const Twofold<V>& time, V error) noexcept {
  const Twofold<V> x = arithmetic::renormalised(time);
  const auto certain = both(both(error<V(0x1p-56) * x.high, abs(x.low)> error), x.high <= V(0x1p100));
  if constexpr (std::is_same_v<V, double>) {
    return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(x.high) - static_cast<std::uint64_t>(x.low < 0)),
            certain};
  } else {
    return {select(x.low < V(0.0), x.high * V(1 - 0x1p-53), x.high), certain};
  }
}
/// The floor of a quotient of exact numbers: `first` is the rounded quotient, `rest` its remainder, `over` the inverse
/// of the divisor. rest * over has a relative error below 2^-50. Without a remainder `first` is exact. If the product
/// underflows to 0, the floor is not certain.
VESICA_INLINE Floor<double> floor_of_quotient(double first, double rest, double over) noexcept {
  const double step = rest * over;
  const Floor<double> floor = floor_of(Twofold<double>{first, step}, 0x1p-49 * abs(step));
  return {rest == 0 ? first : floor.t, rest == 0 || floor.certain};
}
/// floor_of() for a time that must come before the end.
VESICA_INLINE EarlyOut floor_of(const Twofold<double>& time, double error, double end, double& t) noexcept {
  const auto [floor, certain] = floor_of(time, error);
  if (!certain) return EarlyOut::open;
  t = floor;
  return t < end ? EarlyOut::hit : t > end ? EarlyOut::missed : EarlyOut::open;
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

/// An unrounded axis or velocity, as factors.
template <class Products, class V>
VESICA_INLINE auto plain_factor(V x, V y) noexcept {
  return arithmetic::VectorFactor<decltype(Products::factor(x))>{Products::factor(x), Products::factor(y)};
}

/// True if all factors of a pair are 0 or moderate, and the distance is moderate.
template <class V>
VESICA_INLINE MaskOf<V> is_plain(const arithmetic::Vector<V>& d, const OffsetOf<V>& v) noexcept {
  const V distance = abs(d.x.high) + abs(d.y.high);
  return both(both(both(is_plain(d.x.high), is_plain(d.y.high)), both(is_plain(v.x), is_plain(v.y))),
              both(distance >= V(0x1p-40), distance <= V(0x1p40)));
}
/// The same for scalars, by bits: 0 becomes the greatest, and the least of four sizes decides.
VESICA_INLINE bool is_plain(const Vector& d, const Motion& v) noexcept {
  const auto size = [](double x) { return (std::bit_cast<std::uint64_t>(x) << 1) - 1; };
  const auto lesser = [](std::uint64_t x, std::uint64_t y) { return x < y ? x : y; };
  const double distance = abs(d.x.high) + abs(d.y.high), speed = abs(v.vx) + abs(v.vy);
  const std::uint64_t least = lesser(lesser(size(d.x.high), size(d.y.high)), lesser(size(v.vx), size(v.vy)));
  return distance >= 0x1p-40 && distance <= 0x1p40 && speed <= most_moderate && least >= size(least_moderate);
}
VESICA_INLINE Offset velocity(const Motion& v) noexcept { return {v.vx, v.vy}; }
template <class V>
VESICA_INLINE MaskOf<V> is_plain_size(V x) noexcept {
  return both(x >= V(0x1p-40), x <= V(0x1p40));
}

}  // namespace vesica::detail::cast
