// SPDX-License-Identifier: Apache-2.0
/// Points and AABBs, whose relation comparisons of stored numbers decide. Of two points, overlap is all there is.
#pragma once

#include <vesica/filter/comparison.hpp>
#include <vesica/relation/code.hpp>
#include <vesica/shapes.hpp>

namespace vesica::relation_of {

/// A point is the AABB with that corner twice.
template <class T>
constexpr Aabb<T> as_aabb(const Point<T>& p) noexcept {
  return {p.x, p.y, p.x, p.y};
}
template <class T>
constexpr const Aabb<T>& as_aabb(const Aabb<T>& box) noexcept {
  return box;
}

/// How two intervals stand to each other. An AABB is a product of two, and so are its inside and its outline's
/// complement: it is in another's inside iff both intervals are, where an interval of one point is its own inside.
struct Intervals {
  bool meet, insides_meet, a_in_b, a_in_inside_of_b, b_in_a, b_in_inside_of_a;
};

template <class T>
VESICA_INLINE Intervals intervals(T a0, T a1, T b0, T b1) noexcept {
  using namespace lane;
  const bool a_is_point = a0 == a1, b_is_point = b0 == b1;
  const bool equal_points = both(both(a_is_point, b_is_point), a0 == b0);
  return {both(a0 <= b1, b0 <= a1), either(both(a0 < b1, b0 < a1), equal_points),
          both(b0 <= a0, a1 <= b1), either(both(b0 < a0, a1 < b1), equal_points),
          both(a0 <= b0, b1 <= a1), either(both(a0 < b0, b1 < a1), equal_points)};
}

/// Of valid AABBs, as a number.
template <class T>
VESICA_INLINE std::int32_t aabb_aabb(const Aabb<T>& a, const Aabb<T>& b) noexcept {
  using namespace lane;
  const Intervals x = intervals(a.min_x, a.max_x, b.min_x, b.max_x), y = intervals(a.min_y, a.max_y, b.min_y, b.max_y);
  const std::int32_t meet = both(x.meet, y.meet), insides_meet = both(x.insides_meet, y.insides_meet);
  const std::int32_t a_in_b = both(x.a_in_b, y.a_in_b), b_in_a = both(x.b_in_a, y.b_in_a);
  const std::int32_t a_touches = !both(x.a_in_inside_of_b, y.a_in_inside_of_b);
  const std::int32_t b_touches = !both(x.b_in_inside_of_a, y.b_in_inside_of_a);
  const std::int32_t inside = a_in_b & (1 - b_in_a), contains = b_in_a & (1 - a_in_b), equal = a_in_b & b_in_a;
  const std::int32_t neither = (1 - a_in_b) & (1 - b_in_a);
  return inside * (3 + a_touches) + contains * (5 + b_touches) + equal * 7 + neither * (meet + (meet & insides_meet));
}

}  // namespace vesica::relation_of

namespace vesica::pair {

template <class V>
VESICA_INLINE auto standing(const Point<V>& point, const Aabb<V>& aabb) noexcept {
  return filter::point_aabb_standing(point, aabb);
}

template <class V>
VESICA_INLINE auto standing(const Aabb<V>& a, const Aabb<V>& b) noexcept {
  return filter::aabb_aabb_standing(a, b);
}

}  // namespace vesica::pair
