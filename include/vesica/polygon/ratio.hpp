// SPDX-License-Identifier: Apache-2.0
/// iou() and ratio() of polygons and polylines, from areas and, for the hull and the centres, from their boxes.
#pragma once

#include <vesica/polygon/area.hpp>
#include <vesica/ratio.hpp>

namespace vesica {

namespace detail::polygon {

/// A path's place and sizes are those of its box.
inline ratio::Facts facts(const Box& box, const Measure& area) noexcept {
  ratio::Facts facts = ratio::facts(box, 1);
  facts.area = area;
  return facts;
}
template <class T>
ratio::Facts other_facts(const Edges<T>&, const PathShares& shares) noexcept {
  return facts(shares.box_b, shares.b);
}
template <template <class> class Shape>
requires(!std::is_same_v<Shape<double>, Edges<double>>) ratio::Facts
    other_facts(const Shape<double>& s, const PathShares& shares)
noexcept {
  ratio::Facts facts = ratio::facts(s, 1);
  facts.area = shares.b;
  return facts;
}

/// iou_of() without a change of units where all have one.
inline double over_union(const PathShares& s) noexcept {
  const double a = s.a.value, b = s.b.value, shared = s.shared.value;
  const bool same = s.a.exponent == s.b.exponent && s.a.exponent == s.shared.exponent && shared >= 0x1p-500;
  return same ? shared / (greater(a, b) + (lesser(a, b) - shared)) : iou_of(s.shared, s.a, s.b);
}

/// reversed: the ratio is b's with a.
template <class T, class Other>
std::int32_t ratio_or_error(Ratio which, const Edges<T>& a, const Other& b, bool reversed, double& out) noexcept {
  PathShares found;
  if (shares(a, b, found) != 0) return error_shape;
  if (ratio::is_of_area(which)) {
    const ratio::Facts p = facts(found.box_a, found.a), q = other_facts(b, found);
    return reversed ? ratio::over_area(found.shared, which, q, p, out)
                    : ratio::over_area(found.shared, which, p, q, out);
  }
  if (found.a.value == 0 && found.b.value == 0) return error_argument;
  const double iou = over_union(found);
  out = which == Ratio::over_union
            ? iou
            : ratio::less_than_union(iou, which, facts(found.box_a, found.a), other_facts(b, found));
  return 0;
}

}  // namespace detail::polygon

/// The checked form with a polygon or a polyline, as for other shapes. Width and height of a path, and its centre, are
/// those of its box.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>> std::int32_t ratio_or_error(Ratio which, const A<T>& a, const B<T>& b, T& out)
noexcept {
  using namespace detail::polygon;
  if (!is_ratio(static_cast<std::int32_t>(which))) return error_argument;
  double result;
  std::int32_t error;
  if constexpr (!Path<A<T>>) {
    error = detail::polygon::ratio_or_error(which, Edges<T>(b), widen(a), true, result);
  } else if constexpr (Path<B<T>>) {
    error = detail::polygon::ratio_or_error(which, Edges<T>(a), Edges<T>(b), false, result);
  } else {
    error = detail::polygon::ratio_or_error(which, Edges<T>(a), widen(b), false, result);
  }
  if (error == 0) out = static_cast<T>(result);
  return error;
}

/// The checked form with a polygon or a polyline, as for other shapes.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>> std::int32_t iou_or_error(const A<T>& a, const B<T>& b, T& out)
noexcept { return ratio_or_error(Ratio::over_union, a, b, out); }

}  // namespace vesica
