// SPDX-License-Identifier: Apache-2.0
// The distance of vesica::nearest() between points, circles and AABBs, without its search for the closest points.
#pragma once

#include <cstdint>
#include <vesica/nearest/point_box.hpp>

#include "index/shapes.hpp"

namespace vesica::index {

/// The points within `radius` of an AABB: a point, a circle or an AABB.
struct Core {
  double low[2], high[2], radius;
};

inline bool has_core(std::int32_t kind) noexcept {
  return Kind{kind} == Kind::point || Kind{kind} == Kind::circle || Kind{kind} == Kind::aabb;
}

/// For a kind that has one.
template <class T>
Core core_of(const Set& set, std::int64_t item) noexcept {
  const auto number = [&](int k) { return static_cast<double>(number_of<T>(set, k, item)); };
  const double x = number(0), y = number(1);
  if (Kind{set.kind} == Kind::aabb) return {{x, y}, {number(2), number(3)}, 0};
  return {{x, y}, {x, y}, Kind{set.kind} == Kind::circle ? number(2) : 0};
}

/// How far apart two intervals are, exactly.
inline detail::arithmetic::Twofold<double> gap(const Core& a, const Core& b, int axis) noexcept {
  if (b.low[axis] > a.high[axis]) return detail::arithmetic::exact_difference(b.low[axis], a.high[axis]);
  if (a.low[axis] > b.high[axis]) return detail::arithmetic::exact_difference(a.low[axis], b.high[axis]);
  return {0, 0};
}

inline double common_extent(const Core& a, const Core& b, int axis) noexcept {
  const double low = a.low[axis] < b.low[axis] ? a.low[axis] : b.low[axis];
  const double high = a.high[axis] > b.high[axis] ? a.high[axis] : b.high[axis];
  return high - low;
}

/// Writes the distance with the bits of vesica::nearest(), if they are certain: that rounds a number once whose error
/// is some 2^-100 of both shapes' common extent, and so is this one's. Where all that is within 2^-90 of it is rounded
/// alike, the bits are the same. Numbers far from 1, where others are rounded too, are left out.
template <class T>
bool plain_distance(const Core& a, const Core& b, T& out) noexcept {
  const double radii = a.radius + b.radius, x = common_extent(a, b, 0), y = common_extent(a, b, 1);
  const double extent = (x > y ? x : y) + 2 * radii;
  if (!(extent <= 0x1p100)) return false;
  const detail::arithmetic::Twofold<double> gap_x = gap(a, b, 0), gap_y = gap(a, b, 1);
  if (gap_x.high == 0 && gap_y.high == 0) {
    out = 0;
    return true;
  }
  const auto d =
      renormalised(detail::nearest::length(gap_x, gap_y) - detail::arithmetic::exact_sum(a.radius, b.radius));
  const double doubt = extent * 0x1p-90;
  out = static_cast<T>(d.high);
  return extent >= 0x1p-100 && out > 0 && d.high + (d.low + doubt) == d.high && d.high + (d.low - doubt) == d.high;
}

}  // namespace vesica::index
