// SPDX-License-Identifier: Apache-2.0
/// area(a, b): the area of the intersection of two shapes.
///
/// relation() decides exactly whether the shapes are disjoint, nested, equal or crossing; only the area of a crossing
/// pair is computed here. Laws, each tested, without a tolerance: area(a, b) == area(b, a);
/// 0 for shapes that are disjoint, touch, or have no area; shape_area() of the inner one where one contains the other;
/// never more than the area of either; more than 0 where insides meet, unless that underflows; times 4^k when both
/// shapes are scaled by 2^k without leaving the format.
///
/// Accuracy: within 64u times the smaller shape's area times the larger aspect ratio (longer size over shorter), u =
/// 2^-53, for aspect ratios up to 10^4, even where the outlines nearly touch or coincide. With a capsule or a rounded
/// rectangle: if neither shape is more than 10^12 times as long as the other.
#pragma once

#include <cstring>
#include <type_traits>
#include <vesica/area/aabb_aabb.hpp>
#include <vesica/area/box_box.hpp>
#include <vesica/area/box_ellipse.hpp>
#include <vesica/area/ellipse_ellipse.hpp>
#include <vesica/area/extreme_ratio.hpp>
#include <vesica/area/rounded_pair.hpp>
#include <vesica/area/standard.hpp>
#include <vesica/relation.hpp>
#include <vesica/shape_area.hpp>

namespace vesica {

namespace detail::area {

template <class Shape>
inline constexpr bool is_box = ShapeTraits<Shape>::kind == Kind::aabb || ShapeTraits<Shape>::kind == Kind::rect;
template <class Shape>
inline constexpr bool has_area = form::FormOf<Shape>::has_area;
template <form::Inflated Shape>
inline constexpr bool has_area<Shape> = true;

/// The area of a crossing pair by the pair's core, from shapes as stored or in standard units.
template <class A, class B>
VESICA_INLINE Settled<double, bool> crossing_area(const filter::Box<double>& a, const filter::Box<double>& b,
                                                  const filter::Centre<double>& d) noexcept {
  if constexpr (is_box<A> && is_box<B>) {
    return crossing_area(a, b, d);
  } else if constexpr (is_box<A>) {
    return crossing_area(a, oval(b), filter::Centre<double>{-d.x, -d.y});
  } else if constexpr (is_box<B>) {
    return crossing_area(b, oval(a), d);
  } else {
    return crossing_area(oval(a), oval(b), d);
  }
}

template <class A, class B>
VESICA_INLINE Settled<double, bool> quick_area(const A& a, const B& b) noexcept {
  if constexpr (form::is_inflated<B>) {
    return quick_rounded_area(a, b);
  } else {
    return crossing_area<A, B>(filter::box(a), filter::box(b), filter::offset(filter::place(a), filter::place(b)));
  }
}

/// Which of two shapes of a form gives the frame for the computation.
inline bool frame_is_first(const StandardPair<double>& p, const Measure& area_a, const Measure& area_b) noexcept {
  const double rank_a = less(area_b, area_a) ? 1 : 0, rank_b = less(area_a, area_b) ? 1 : 0;
  return order(p.a, p.b, p.offset, rank_a, rank_b).first;
}

template <class A, class B>
Measure precise_boxes(const A& a, const B& b, bool first) noexcept {
  return first ? crossing_area_exact(exact::form(a), exact::form(b))
               : crossing_area_exact(exact::form(b), exact::form(a));
}

/// offset: from the ellipse's centre to the box's.
template <class Box, class Round>
Measure precise_box_ellipse(const Box& box, const Round& ellipse) noexcept {
  const auto p = standard_pair<DoubleDouble>(ellipse, box);
  const auto rough = [](const filter::Box<DoubleDouble>& s) {
    return filter::Box<double>{s.ux.high, s.uy.high, s.hx.high, s.hy.high};
  };
  const filter::Box<double> b = rough(p.b), e = rough(p.a);
  const auto image = parallelogram(p.b, oval(p.a), p.offset);
  const double whole = 4 * rounded(cross(image.edge_0, image.edge_1));
  if (!(whole <= small_parallelogram)) {
    const Lines l = exact_lines(exact::form(box), exact::form(ellipse), b, oval(e), p.exponent);
    return {area_within_lines(l) * rounded(image.scale), 2 * p.exponent};
  }
  if (is_straight(e, b.hx + b.hy)) {
    const exact::Box exact_box = exact::form(box);
    const UnitBox own = unit_box(exact_box);
    const HalfPlane h = tangent_half_plane(exact::form(ellipse), exact_box.cx, exact_box.cy, own.exponent);
    return {area_in_half_plane(filter::Box<double>{own.ux, own.uy, own.hx, own.hy}, h), 2 * own.exponent};
  }
  return {area_in_small_parallelogram(image) * rounded(image.scale), 2 * p.exponent};
}

/// a: the frame.
template <class A, class B>
Measure precise_ellipses(const A& a, const B& b) noexcept {
  const auto p = standard_pair<DoubleDouble>(a, b);
  const filter::Box<double> e{p.a.ux.high, p.a.uy.high, p.a.hx.high, p.a.hy.high};
  const filter::Box<double> f{p.b.ux.high, p.b.uy.high, p.b.hx.high, p.b.hy.high};
  if (is_straight(f, e.hx + e.hy)) {
    const exact::Ellipse smaller = exact::form(a);
    const UnitBox own = unit_box(exact::as_box(smaller));
    const HalfPlane h = tangent_half_plane(exact::form(b), smaller.cx, smaller.cy, own.exponent);
    const double vv = own.ux * own.ux + own.uy * own.uy;
    return {area_in_half_plane(Oval<double>{own.ux, own.uy, own.hx, own.hy}, h) * (own.hx * own.hy * vv),
            2 * own.exponent};
  }
  const auto g = against(oval(p.a), oval(p.b), p.offset);
  return {called_area_in_disc(g) * rounded(g.scale), 2 * p.exponent};
}

/// For pairs that certainly cross.
inline Measure precise_area(const Aabb<double>& a, const Aabb<double>& b, const Measure&, const Measure&) noexcept {
  return shape_measure(common(a, b));
}
template <class A, form::Inflated B>
Measure precise_area(const A& a, const B& b, const Measure&, const Measure&) noexcept {
  return precise_rounded_area(a, b);
}
template <class A, class B>
Measure precise_area(const A& a, const B& b, const Measure& area_a, const Measure& area_b) noexcept {
  const auto p = standard_pair<double>(a, b);
  const auto quick = crossing_area<A, B>(p.a, p.b, p.offset);
  if (quick.settled) return {quick.area, 2 * p.exponent};
  if constexpr (is_box<A> && !is_box<B>) {
    return precise_box_ellipse(a, b);
  } else if constexpr (is_box<B> && !is_box<A>) {
    return precise_box_ellipse(b, a);
  } else if constexpr (is_box<A>) {
    return precise_boxes(a, b, frame_is_first(p, area_a, area_b));
  } else {
    return frame_is_first(p, area_a, area_b) ? precise_ellipses(a, b) : precise_ellipses(b, a);
  }
}

/// If insides meet, the shared area is positive and at most the smaller shape's. A computed area that is not positive
/// is replaced by a positive one far below the error bound.
inline Measure between_bounds(const Measure& area, const Measure& least) noexcept {
  if (!(area.value > 0)) return {least.value, least.exponent - 120};
  return detail::area::least(area, least);
}

/// The numbers behind iou() and area(): the shared area and, unless it is 0, the area of each shape.
struct Shares {
  Measure shared, a, b;
  bool equal;

  Shares exchanged() const noexcept { return {shared, b, a, equal}; }
};

/// The relation, with a quick test for equal numbers: detections are often duplicates, and to prove them equal in exact
/// arithmetic takes a microsecond.
template <class A, class B>
std::int32_t relation_of(const A& a, const B& b) noexcept {
  if constexpr (std::is_same_v<A, B>) {
    // Bits, not values: shapes that differ in the sign of a zero take the usual path.
    if (std::memcmp(&a, &b, sizeof a) == 0)  // NOLINT(bugprone-suspicious-memory-comparison)
      return check(a) == 0 ? static_cast<std::int32_t>(Relation::equal) : error_shape;
  }
  return relation_or_error(a, b);
}

template <class A, class B>
std::int32_t shares_by_relation(const A& a, const B& b, Shares& out) noexcept;

/// The shares with the simpler shape that b is, such as the circle of a capsule without a length.
template <class A, class B>
std::int32_t shares_with_plain(const A& a, const B& b, Shares& out) noexcept {
  return with_plain(b, [&](const auto& plain) {
    if constexpr (in_order<A, std::remove_cvref_t<decltype(plain)>>) {
      return shares_by_relation(a, plain, out);
    } else {
      const std::int32_t error = shares_by_relation(plain, a, out);
      if (error == 0) out = out.exchanged();
      return error;
    }
  });
}

/// Returns 0 or error_shape.
template <class A, class B>
VESICA_COLD std::int32_t shares_by_relation(const A& a, const B& b, Shares& out) noexcept {
  if constexpr (form::is_inflated<B>) {
    if (check(a) != 0 || check(b) != 0) return error_shape;
    if (is_plain(b)) return shares_with_plain(a, b, out);
    if constexpr (form::is_inflated<A>) {
      if (is_plain(a)) {
        const std::int32_t error = shares_with_plain(b, a, out);
        if (error == 0) out = out.exchanged();
        return error;
      }
    }
  }
  if constexpr (!has_area<A> || !has_area<B>) {  // nothing is shared, however they relate
    if (check(a) != 0 || check(b) != 0) return error_shape;
    out = {{0, 0}, shape_measure(a), shape_measure(b), false};
    return 0;
  } else {
    const std::int32_t code = relation_of(a, b);
    if (code < 0) return code;
    out = {{0, 0}, shape_measure(a), shape_measure(b), false};
    if (out.a.value == 0 || out.b.value == 0) {
      out.equal = static_cast<Relation>(code) == Relation::equal;
      return 0;
    }
    switch (static_cast<Relation>(code)) {
      case Relation::disjoint:
      case Relation::touch:
        return 0;
      case Relation::inside:
      case Relation::inside_touch:
        out.shared = out.a;
        return 0;
      case Relation::contains:
      case Relation::contains_touch:
        out.shared = out.b;
        return 0;
      case Relation::equal:
        out.shared = out.a;
        out.equal = true;
        return 0;
      case Relation::cross:
        break;
    }
    out.shared = between_bounds(precise_area(a, b, out.a, out.b), least(out.a, out.b));
    return 0;
  }
}

}  // namespace detail::area

namespace detail {

/// The shared area of valid shapes as a measure; 0 or error_shape.
template <class A, class B>
std::int32_t shared_measure(const A& a, const B& b, detail::area::Measure& out) noexcept {
  if constexpr (detail::area::has_area<A> && detail::area::has_area<B>) {
    if (filter::Verdict<bool>(detail::overlap::filter(a, b)).disjoint) {
      out = {0, 0};
      return 0;
    }
    const auto quick = detail::area::quick_area(a, b);
    if (quick.settled) [[likely]] {
      out = {quick.area, 0};
      return 0;
    }
  }
  detail::area::Shares shares;
  const std::int32_t error = detail::area::shares_by_relation(a, b, shares);
  if (error == 0) out = shares.shared;
  return error;
}

/// shared / (a + b - shared), in an order in which nothing exceeds 1.
inline double ratio_of_union(const detail::area::Measure& shared, const detail::area::Measure& a,
                             const detail::area::Measure& b) noexcept {
  const detail::area::Measure most = detail::area::standard(detail::area::less(a, b) ? b : a),
                              lesser = detail::area::least(a, b);
  const detail::area::Measure part = detail::area::standard(shared);
  const int unit = most.exponent;
  const double rest = detail::area::in_units(lesser, unit) - detail::area::in_units(part, unit);
  const double all = most.value + rest;
  return arithmetic::scale(part.value / all, part.exponent - unit);
}

}  // namespace detail

/// The checked form: writes the area of the intersection. Any kinds, in either order; points and segments have none.
/// Returns 0, error_shape, or error_range when the area would be beyond the finite numbers; on error `out` is
/// untouched.
template <template <class> class A, template <class> class B, class T>
std::int32_t area_or_error(const A<T>& a, const B<T>& b, T& out) noexcept {
  if constexpr (!detail::in_order<A<T>, B<T>>) {
    return area_or_error(b, a, out);
  } else {
    detail::area::Measure area;
    const std::int32_t error = detail::shared_measure(widen(a), widen(b), area);
    return error != 0 ? error : detail::area::store(area, out);
  }
}

/// The area of the intersection. For valid shapes: it is 0 where one is invalid, and the greatest finite number for an
/// area beyond it. area_or_error() is the checked form.
template <template <class> class A, template <class> class B, class T>
T area(const A<T>& a, const B<T>& b) noexcept {
  T out = 0;
  return area_or_error(a, b, out) == error_range ? std::numeric_limits<T>::max() : out;
}

}  // namespace vesica
