// SPDX-License-Identifier: Apache-2.0
/// intersection(a, b): the region that two shapes share, as the vertices of a convex polygon: of two straight shapes,
/// or of a point or a segment and any shape.
///
/// Which corners and crossings are vertices is decided by exact signs; only coordinates are rounded. A corner of a
/// shape has the shape's own numbers, of a rectangle those of corners(). Others are within 4u of the greatest
/// coordinate and size of either shape, u = 2^-53.
///
/// Laws, each tested: there are vertices iff the shapes overlap; exchanging the shapes changes no bit; vertices are
/// within that bound of both shapes; the region has the area of area(), within the bounds of both.
#pragma once

#include <algorithm>
#include <vesica/crossings.hpp>
#include <vesica/intersection/corners.hpp>

namespace vesica {

/// Vertices x0 y0 x1 y1 ..., counter-clockwise from the lowest, the left one of two; the rest is 0.
template <class T>
struct SharedRegion {
  T at[16];
};

namespace detail::intersection {

template <class Shape>
inline constexpr bool is_round = crossings::is_round<Shape> || form::Inflated<Shape>;
template <class Shape>
inline constexpr bool is_thin = ShapeTraits<Shape>::kind == Kind::point || ShapeTraits<Shape>::kind == Kind::segment;

/// Both straight, or a point or a segment and anything.
template <class A, class B>
inline constexpr bool answers = (!is_round<A> && !is_round<B>) || is_thin<A> || is_thin<B>;

inline bool has_area(const Circle<double>& s) noexcept { return s.r > 0; }
inline bool has_area(const Ellipse<double>& s) noexcept { return s.a > 0 && s.b > 0; }
inline Point<double> straight(const Circle<double>& s) noexcept { return {s.cx, s.cy}; }
inline Rect<double> straight(const Ellipse<double>& s) noexcept { return {s.cx, s.cy, s.ux, s.uy, s.a, s.b}; }

template <class Shape>
exact::Ellipse outline(const Shape& s) noexcept {
  return exact::form(s);
}
template <form::Inflated Shape>
crossings::RoundOutline outline(const Shape& s) noexcept {
  return crossings::round_outline(s);
}

/// The places of the ends in a round shape, as Ends::add() takes them. Not inlined: the exact outline takes stack here
/// alone.
struct PlacesOfEnds {
  int count, start, end;
};
template <class A, class B>
VESICA_CALLED PlacesOfEnds places_of_ends(const A& a, const B& b) noexcept {
  const crossings::Corners ends(exact::form(a));
  const auto round = outline(b);
  const auto place = [&](int i) { return de9im::place_in(round, ends.x[i], ends.y[i]); };
  return {ends.count, place(0), ends.count == 1 ? 0 : place(1)};
}

/// A point or a segment that meets a round shape with area. Ends that are inside are vertices; an end outside is
/// replaced by the first or last place where the segment meets the outline.
template <class A, class B>
Vertices in_round(const A& a, const B& b) noexcept {
  const PlacesOfEnds ends = places_of_ends(a, b);
  const int start = ends.start, end = ends.end;
  Rounded corner{};
  corners(a, corner);
  Vertices v;
  if (ends.count == 1) {
    v.add(corner[0]);
    return v;
  }
  if (start >= 0 && end >= 0) {
    v.add(corner[0]);
    v.add(corner[1]);
    return v;
  }
  const CrossingPoints<double> met = crossings::between(a, b);
  const int last = met.count - 1;
  const bool single = start < 0 && end < 0 ? met.count == 1 : met.count == 1 && (start == 0 || end == 0);
  if (start >= 0) {
    v.add(corner[0]);
    if (!single) v.add({met.x[last], met.y[last]});
  } else if (end >= 0) {
    if (!single) v.add({met.x[0], met.y[0]});
    v.add(corner[1]);
  } else {
    v.add({met.x[0], met.y[0]});
    if (!single) v.add({met.x[last], met.y[last]});
  }
  return v;
}

/// For shapes that overlap, of kinds in order.
template <class A, class B>
Vertices region(const A& a, const B& b) noexcept {
  if constexpr (form::Inflated<B>) {
    return form::with_simplest(b, [&](const auto& q) {
      if constexpr (std::is_same_v<decltype(q), const B&>) {
        return in_round(a, b);
      } else {
        return region(a, q);
      }
    });
  } else if constexpr (is_round<B>) {
    return has_area(b) ? in_round(a, b) : region(a, straight(b));
  } else {
    Rounded corner_a{}, corner_b{};
    corners(a, corner_a);
    corners(b, corner_b);
    return common_region(exact::form(a), exact::form(b), corner_a, corner_b);
  }
}

/// Rounds to T, from the lowest vertex on. A zero becomes +0, as its sign could depend on the order of the shapes.
/// Returns the count, or error_range.
template <class T>
std::int32_t store(const Vertices& v, SharedRegion<T>& out) noexcept {
  T x[Vertices::most], y[Vertices::most];
  int first = 0;
  for (int i = 0; i < v.count; ++i) {
    x[i] = static_cast<T>(v.at[i].x) + T{0};
    y[i] = static_cast<T>(v.at[i].y) + T{0};
    if (!all_finite(x[i], y[i])) return error_range;
    if (y[i] < y[first] || (y[i] == y[first] && x[i] < x[first])) first = i;
  }
  SharedRegion<T> region{};
  for (int i = 0; i < v.count; ++i) {
    const int from = (first + i) % v.count;
    region.at[2 * i] = x[from];
    region.at[2 * i + 1] = y[from];
  }
  out = region;
  return v.count;
}

}  // namespace detail::intersection

/// The checked form: the number of vertices, 0 to 8 (Vertices says why), with the vertices in `out`; error_shape, or
/// error_range where one is beyond the finite numbers, and then `out` is untouched. Floats are the double vertices,
/// rounded.
template <template <class> class A, template <class> class B, class T>
requires(detail::intersection::answers<A<T>, B<T>>) std::int32_t
    intersection_or_error(const A<T>& first, const B<T>& second, SharedRegion<T>& out)
noexcept {
  namespace shared = detail::intersection;
  if constexpr (!detail::in_order<A<T>, B<T>>) {
    return intersection_or_error(second, first, out);
  } else {
    const A<double> a = widen(first);
    const B<double> b = widen(second);
    const std::int32_t overlapping = overlap_or_error(a, b);
    if (overlapping < 0) return overlapping;
    if (overlapping == 0) {
      out = {};
      return 0;
    }
    if constexpr (detail::in_order<B<T>, A<T>>) {
      if (detail::crossings::is_later(a, b)) return shared::store(shared::region(b, a), out);
    }
    return shared::store(shared::region(a, b), out);
  }
}

/// The same as a value: no vertices where there is an error.
template <template <class> class A, template <class> class B, class T>
requires(detail::intersection::answers<A<T>, B<T>>) SharedRegion<T> intersection(const A<T>& a, const B<T>& b)
noexcept {
  SharedRegion<T> out{};
  intersection_or_error(a, b, out);
  return out;
}

}  // namespace vesica
