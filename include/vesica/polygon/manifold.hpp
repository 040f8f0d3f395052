// SPDX-License-Identifier: Apache-2.0
/// manifold() with convex polygons. Edges that are on one line up to rounding are one edge.
#pragma once

#include <vesica/manifold.hpp>
#include <vesica/polygon/depth.hpp>

namespace vesica {

namespace detail::polygon {

using manifold::Face;

/// The part of a convex ring that faces a direction, seen from `origin`: the edge of the least angle to it. Edges
/// beside it that are on its line up to rounding continue it, since rounding would choose among them.
template <class T>
Face facing(const ConvexRing<T>& ring, const PlaneVector& origin, const PlaneVector& outward,
            const DepthUnit& unit) noexcept {
  const std::int64_t size = ring.size();
  const auto vertex = [&](std::int64_t i) -> manifold::Vertex {
    const Point<double> p = ring[i % size];
    return {{p.x - origin.x, p.y - origin.y}, ring.number(i % size)};
  };
  const auto normal = [](const Point<double>& p, const Point<double>& q) -> PlaneVector {
    return {q.y - p.y, p.x - q.x};
  };
  std::int64_t from = -1;
  double least = infinite;  // tangent of the angle; cosines near 1 would not show which is less
  Point<double> p = ring[0];
  for (std::int64_t i = 0; i < size; ++i) {
    const Point<double> q = ring[i + 1];
    const PlaneVector n = normal(p, q);
    p = q;
    const double along = support_minimum::dot(n, outward);
    if (!(along > 0)) continue;
    const double tangent = lane::abs(support_minimum::cross(n, outward)) / along;
    if (!(tangent < least)) continue;
    least = tangent;
    from = i;
  }
  // So small beside the other shape that no edge has a length in the pair's unit.
  if (from < 0) return manifold::point_face(vertex(0).at, 0);
  from += size;
  std::int64_t to = from + 1;
  const Point<double> start = ring[from - size];
  const PlaneVector line = support_minimum::unit_of_any(normal(start, ring[to - size]));
  const auto continues = [&](std::int64_t next, std::int64_t last) {
    const Point<double> q = ring[next % size];
    const double rise = line.x * (q.x - start.x) + line.y * (q.y - start.y);
    const PlaneVector n = next > last ? normal(ring[last % size], q) : normal(q, ring[last % size]);
    return lane::abs(rise) <= manifold::least_share * unit.size && !(support_minimum::dot(n, line) < 0);
  };
  while (to - from < size && continues(from - 1, from)) --from;
  while (to - from < size && continues(to + 1, to)) ++to;
  return {vertex(from), vertex(to), true, 0};
}

/// From a ring's first vertex.
template <class T>
manifold::View view_from(const ConvexRing<T>& ring, const DepthUnit& unit) noexcept {
  const Point<double> origin = ring.stored(0);
  return {{origin.x, origin.y}, {origin.x, origin.y}, unit.exponent, unit.size};
}

template <class T>
PlaneVector first_vertex(const ConvexRing<T>& ring) noexcept {
  const Point<double> p = ring[0];
  return {p.x, p.y};
}

/// Valid shapes whose depth is p.
template <class T, class Other>
Contacts<double> contacts(const Edges<T>& a, const Other& b, const Penetration<double>& p) noexcept {
  if (p.x == 0 && p.y == 0) return manifold::no_contact;
  const CoreForm core = core_form(b);
  const Convexity shape = convexity(a);
  if (shape.flat) return manifold::of_cores(core_form(shape.span), core, p);
  Box box, about;
  if (!is_valid(a, box) || !is_valid(b, about)) return manifold::no_contact;
  const DepthUnit unit(box, about);
  const ConvexRing<T> ring(a, shape, unit);
  const PlacedForm form(core.form, unit);
  const PlaneVector origin = first_vertex(ring), n{p.x, p.y}, centre = -form.offset({origin.x, origin.y});
  return manifold::FacingPair(facing(ring, origin, n, unit), manifold::facing(form.centred(), centre, -n, core), p,
                              view_from(ring, unit))
      .find();
}
template <class T>
Contacts<double> contacts(const Edges<T>& a, const Edges<T>& b, const Penetration<double>& p) noexcept {
  if (p.x == 0 && p.y == 0) return manifold::no_contact;
  const Convexity shape_a = convexity(a), shape_b = convexity(b);
  if (shape_b.flat) return contacts(a, shape_b.span, p);
  if (shape_a.flat || compared(a, b) > 0) return manifold::turned_round(contacts(b, a, depth::turned_round(p)));
  Box box_a, box_b;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return manifold::no_contact;
  const DepthUnit unit(box_a, box_b);
  const ConvexRing<T> ring_a(a, shape_a, unit), ring_b(b, shape_b, unit);
  const PlaneVector origin = first_vertex(ring_a), n{p.x, p.y};
  return manifold::FacingPair(facing(ring_a, origin, n, unit), facing(ring_b, origin, -n, unit), p,
                              view_from(ring_a, unit))
      .find();
}

/// A path and another shape, which need not be valid.
template <class T, class Other>
std::int32_t manifold_or_error(const Edges<T>& a, const Other& b, bool reversed, Contacts<double>& out) noexcept {
  Penetration<double> p{};
  const std::int32_t error = convex_depth(a, b, p);
  if (error != 0) return error;
  const Contacts<double> m = contacts(a, b, p);
  return manifold::checked(reversed ? manifold::turned_round(m) : m, out);
}

}  // namespace detail::polygon

/// The checked form with a convex polygon, in either order; error_not_convex for others. A path whose vertices are on
/// one line is a segment, from its leftmost vertex on.
template <template <class> class A, template <class> class B>
std::int32_t manifold_or_error(const A<double>& a, const B<double>& b,
                               Contacts<double>& out) noexcept requires AnyPath<A<double>, B<double>> {
  return detail::polygon::with_edges(a, b, [&out](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::manifold_or_error(edges, other, reversed, out);
  });
}
template <template <class> class A, template <class> class B>
std::int32_t manifold_or_error(const A<float>& a, const B<float>& b,
                               Contacts<float>& out) noexcept requires AnyPath<A<float>, B<float>> {
  Contacts<double> wide = detail::manifold::no_contact;
  const std::int32_t code =
      detail::polygon::with_edges(a, b, [&wide](const auto& edges, const auto& other, bool reversed) {
        return detail::polygon::manifold_or_error(edges, other, reversed, wide);
      });
  if (code < 0) return code;
  return detail::manifold::rounded_to(wide, out) ? code : static_cast<std::int32_t>(error_range);
}

}  // namespace vesica
