// SPDX-License-Identifier: Apache-2.0
/// Relations of the exact forms, and of discs by the lower degrees they allow.
#pragma once

#include <vesica/exact/disc.hpp>
#include <vesica/exact/ellipse_ellipse.hpp>

namespace vesica::exact {

/// A shape in the form that relations are decided in.
template <class Shape>
constexpr auto relation_form(const Shape& shape) noexcept {
  return form(shape);
}
constexpr const Circle<double>& relation_form(const Circle<double>& disc) noexcept { return disc; }

constexpr bool degenerate(const Circle<double>& disc) noexcept { return disc.r == 0; }
constexpr Box as_box(const Circle<double>& disc) noexcept { return as_box(form(disc)); }

namespace detail {

constexpr bool is_point(const Box& box) noexcept { return box.hx.sign == 0 && box.hy.sign == 0; }

/// From contact(a, b) <= 0 and how far each stays within the other.
constexpr Relation relation_of(int touching, int in_b, int in_a) noexcept {
  if (in_b >= 0 && in_a >= 0) return Relation::equal;
  if (in_b >= 0) return in_b > 0 ? Relation::inside : Relation::inside_touch;
  if (in_a >= 0) return in_a > 0 ? Relation::contains : Relation::contains_touch;
  return touching < 0 ? Relation::cross : Relation::touch;
}

/// Neither round form may be degenerate. In the order of the definition: containment goes before contact, since a point
/// on an outline touches but is inside.
template <class Other>
constexpr Relation box_relation(const Box& a, const Other& b) noexcept {
  if (is_point(a)) {
    const int in_b = clearance(a, b);
    if (in_b <= 0) return in_b < 0 ? Relation::disjoint : Relation::inside_touch;
    return clearance(b, a) > 0 ? Relation::equal : Relation::inside;
  }
  const int touching = contact(a, b);
  if (touching > 0) return Relation::disjoint;
  return relation_of(touching, clearance(a, b), clearance(b, a));
}

}  // namespace detail

/// detail::box_relation() of two boxes, which computes common terms once.
constexpr Relation relate(const Box& a, const Box& b) noexcept {
  if (detail::is_point(a)) return detail::box_relation(a, b);
  const detail::BoxPair seen(a, b);
  const detail::FrameOfBox of_a(seen, a, b);
  const int first = of_a.widest_gap();
  if (first > 0) return Relation::disjoint;
  const detail::FrameOfBox of_b(seen, b, a);
  const int second = of_b.widest_gap();
  if (second > 0) return Relation::disjoint;
  return detail::relation_of(first > second ? first : second, detail::clearance(of_b), detail::clearance(of_a));
}

template <class Round>
constexpr Relation relate(const Box& a, const Round& b) noexcept {
  return degenerate(b) ? detail::box_relation(a, as_box(b)) : detail::box_relation(a, b);
}

template <class Round>
constexpr Relation relate(const Round& a, const Box& b) noexcept {
  return converse(relate(b, a));
}

constexpr Relation relate(const Ellipse& a, const Ellipse& b) noexcept {
  if (degenerate(a)) return relate(as_box(a), b);
  if (degenerate(b)) return relate(a, as_box(b));
  return relation(a, b);
}

constexpr Relation relate(const Circle<double>& a, const Circle<double>& b) noexcept {
  if (degenerate(a)) return relate(as_box(a), b);
  if (degenerate(b)) return relate(a, as_box(b));
  return relation(a, b);
}

constexpr Relation relate(const Circle<double>& a, const Ellipse& b) noexcept { return relate(form(a), b); }
constexpr Relation relate(const Ellipse& a, const Circle<double>& b) noexcept { return relate(a, form(b)); }

}  // namespace vesica::exact
