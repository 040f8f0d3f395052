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
  if (shared == 0) return 0;
  const bool same = s.a.exponent == s.b.exponent && s.a.exponent == s.shared.exponent && shared >= 0x1p-500;
  return same ? shared / (greater(a, b) + (lesser(a, b) - shared)) : iou_of(s.shared, s.a, s.b);
}

/// From the areas; the facts of both are functions, since IoU needs none. Returns 0 or error_argument.
template <class FactsOfA, class FactsOfB>
std::int32_t ratio_of_shares(Ratio which, const PathShares& s, const FactsOfA& a, const FactsOfB& b,
                             double& out) noexcept {
  if (ratio::is_of_area(which)) return ratio::over_area(s.shared, which, a(), b(), out);
  if (s.a.value == 0 && s.b.value == 0) return error_argument;
  out = over_union(s);
  if (which != Ratio::over_union) out = ratio::less_than_union(out, which, a(), b());
  return 0;
}

/// reversed: the ratio is b's with a.
template <class T, class Other>
std::int32_t ratio_or_error(Ratio which, const Edges<T>& a, const Other& b, bool reversed, double& out) noexcept {
  PathShares found;
  if (shares(a, b, found) != 0) return error_shape;
  const auto p = [&] { return facts(found.box_a, found.a); };
  const auto q = [&] { return other_facts(b, found); };
  return reversed ? ratio_of_shares(which, found, q, p, out) : ratio_of_shares(which, found, p, q, out);
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
