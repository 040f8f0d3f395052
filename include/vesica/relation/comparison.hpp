// SPDX-License-Identifier: Apache-2.0
/// Points and AABBs: comparisons of stored numbers decide their relation. Two points are equal or disjoint.
#pragma once

#include <vesica/filter/comparison.hpp>
#include <vesica/relation_code.hpp>
#include <vesica/shapes.hpp>

namespace vesica::detail::relation {

/// A point is the AABB with that corner twice.
template <class T>
constexpr Aabb<T> as_aabb(const Point<T>& p) noexcept {
  return {p.x, p.y, p.x, p.y};
}
template <class T>
constexpr const Aabb<T>& as_aabb(const Aabb<T>& box) noexcept {
  return box;
}

/// How two intervals relate. An AABB is a product of two intervals, and so is its inside. So it lies in another's
/// inside iff both intervals do, where an interval of one point is its own inside.
struct Intervals {
  bool meet, insides_meet, a_in_b, a_in_inside_of_b, b_in_a, b_in_inside_of_a;
};

template <class T>
constexpr Intervals intervals(T a0, T a1, T b0, T b1) noexcept {
  const bool equal_points = a0 == a1 && b0 == b1 && a0 == b0;
  return {a0 <= b1 && b0 <= a1, (a0 < b1 && b0 < a1) || equal_points,
          b0 <= a0 && a1 <= b1, (b0 < a0 && a1 < b1) || equal_points,
          a0 <= b0 && b1 <= a1, (a0 < b0 && b1 < a1) || equal_points};
}

/// Relation of two valid AABBs.
template <class T>
constexpr Relation aabb_aabb(const Aabb<T>& a, const Aabb<T>& b) noexcept {
  const Intervals x = intervals(a.min_x, a.max_x, b.min_x, b.max_x), y = intervals(a.min_y, a.max_y, b.min_y, b.max_y);
  const bool a_in_b = x.a_in_b && y.a_in_b, b_in_a = x.b_in_a && y.b_in_a;
  if (a_in_b && b_in_a) return Relation::equal;
  if (a_in_b) return x.a_in_inside_of_b && y.a_in_inside_of_b ? Relation::inside : Relation::inside_touch;
  if (b_in_a) return x.b_in_inside_of_a && y.b_in_inside_of_a ? Relation::contains : Relation::contains_touch;
  if (x.insides_meet && y.insides_meet) return Relation::cross;
  return x.meet && y.meet ? Relation::touch : Relation::disjoint;
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Point<V>& point, const Aabb<V>& aabb) noexcept {
  return filter::point_aabb_certain_facts(point, aabb);
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Aabb<V>& a, const Aabb<V>& b) noexcept {
  return filter::aabb_aabb_certain_facts(a, b);
}

}  // namespace vesica::detail::relation
