// SPDX-License-Identifier: Apache-2.0
/// Outlines of shapes that are a core with a radius (form/inflated.hpp), where the shapes overlap.
#pragma once

#include <array>
#include <limits>
#include <vesica/nearest.hpp>
#include <vesica/relation_code.hpp>
#include <vesica/support_minimum/placed_pair.hpp>

namespace vesica::detail::boundary_distance {

using nearest::ScaledShape;
using support_minimum::PlaneVector;

/// The distance, and the closest points as offsets from the centres of their shapes. In units of the pair.
struct NestedOutlines {
  nearest::Twofold<double> distance;
  PlaneVector outer, inner;
};

/// How far a point is from a box, below 0 inside; and the closest point of the box's outline, with the unit normal.
struct FromBox {
  nearest::Twofold<double> distance;
  PlaneVector foot, normal;
};

inline FromBox from_box(const nearest::Box<double>& box, const nearest::Vector<double>& p) noexcept {
  using namespace nearest;
  const PointBox<double> outside = point_box(box, p);
  nearest::Direction<double> normal = out_of(box, outside);
  Spot<double> spot = outside.spot;
  Twofold<double> distance = outside.distance;
  if (!(rounded(distance) > 0)) {
    const auto u = factor(box.u), v = factor(p);
    const Twofold<double> uu = square(u.x) + square(u.y), kx = renormalised(dot(u, v)), ky = renormalised(cross(u, v));
    const Twofold<double> x = renormalised(flipped(kx, kx.high) - factor(box.hx) * factor(uu)),
                          y = renormalised(flipped(ky, ky.high) - factor(box.hy) * factor(uu));
    const bool to_end = less(y, x);
    distance = factor(to_end ? x : y) * factor(inverse(root(uu)));
    (to_end ? spot.s : spot.t) = lane::flip_sign((to_end ? box.hx : box.hy).high, to_end ? kx.high : ky.high);
    const Vector<double> along =
        to_end ? flipped(box.u, kx.high) : Vector<double>{flipped(-box.u.y, ky.high), flipped(box.u.x, ky.high)};
    normal = {along.x.high, along.y.high};
  }
  const Contact foot = on_box(box, spot);
  return {distance, {foot.x, foot.y}, support_minimum::unit_of_any({normal.x, normal.y})};
}

/// The inner shape lies strictly inside the outer one; d leads from the outer one's centre to the other's. Inside a
/// shape the distance from a point to its outline is its radius less the distance from its core. That is concave in the
/// point, so the inner core has its least one at a corner.
inline NestedOutlines nested_outlines(const ScaledShape& outer, const ScaledShape& inner,
                                      const nearest::Vector<double>& d) noexcept {
  FromBox farthest{{-0x1p1000, 0}, {}, {}};
  PlaneVector corner{};
  for (const double i : {-1.0, 1.0}) {
    for (const double j : {-1.0, 1.0}) {
      const auto at = nearest::vertex(inner.box, i, j);
      const FromBox found = from_box(outer.box, renormalised(d + at));
      if (nearest::less(farthest.distance, found.distance)) farthest = found, corner = {at.x.high, at.y.high};
    }
  }
  return {arithmetic::exact_difference(outer.radius, inner.radius) - farthest.distance,
          farthest.foot + outer.radius * farthest.normal, corner + inner.radius * farthest.normal};
}

/// An outline in double, seen from a's centre: four edges, and an arc about each corner of the core.
struct RoundedOutline {
  PlaneVector centre, axis;
  double hx, hy, radius;

  RoundedOutline(const ScaledShape& s, const PlaneVector& at) noexcept
      : centre(at), axis(support_minimum::unit({s.box.u.x.high, s.box.u.y.high})), radius(s.radius) {
    const double length = dot(axis, {s.box.u.x.high, s.box.u.y.high});
    hx = s.box.hx.high * length, hy = s.box.hy.high * length;
  }
  PlaneVector at(double x, double y) const noexcept { return centre + support_minimum::out_of_frame(axis, {x, y}); }
  PlaneVector corner(int k) const noexcept { return at((k & 1) != 0 ? hx : -hx, (k & 2) != 0 ? hy : -hy); }
  /// The ends of edge k, from the first to the second.
  PlaneVector end(int k, bool second) const noexcept {
    const double sign = (k & 1) != 0 ? 1 : -1, along = second ? 1 : -1;
    return (k & 2) != 0 ? at(sign * (hx + radius), along * hy) : at(along * hx, sign * (hy + radius));
  }
  /// How far a point is out of the shape, or below 0 from the outline.
  double beyond(const PlaneVector& p) const noexcept {
    const PlaneVector seen = support_minimum::into_frame(axis, p + -centre);
    const double x = lane::abs(seen.x) - hx, y = lane::abs(seen.y) - hy;
    const double beyond_x = lane::positive_part(x), beyond_y = lane::positive_part(y);
    const double outside = lane::sqrt(beyond_x * beyond_x + beyond_y * beyond_y);
    return outside > 0 ? outside - radius : lane::max(x, y) - radius;
  }
  double off(const PlaneVector& p) const noexcept { return lane::abs(beyond(p)); }
  /// The point of the outline closest to another point.
  PlaneVector closest(const PlaneVector& p) const noexcept {
    const PlaneVector seen = support_minimum::into_frame(axis, p + -centre);
    const double x = lane::abs(seen.x) - hx, y = lane::abs(seen.y) - hy;
    PlaneVector foot{lane::min(lane::abs(seen.x), hx), lane::min(lane::abs(seen.y), hy)};
    PlaneVector normal = x > y ? PlaneVector{1, 0} : PlaneVector{0, 1};
    if (x > 0 && y > 0) normal = support_minimum::unit_of_any({x, y});
    if (x <= 0 && y <= 0) (x > y ? foot.x : foot.y) = x > y ? hx : hy;
    const PlaneVector at_foot = foot + radius * normal;
    return at(lane::flip_sign(at_foot.x, seen.x), lane::flip_sign(at_foot.y, seen.y));
  }
};

/// A point of two outlines that meet: of the places where an edge or an arc of one meets, or comes closest to, one of
/// the other's, and of the ends of edges, the one that is least off both outlines. Where outlines coincide along a
/// stretch, it begins at an end. A crossing that rounding puts beyond an end is no worse than that end.
class CommonOutlinePoint {
 public:
  CommonOutlinePoint(const RoundedOutline& a, const RoundedOutline& b) noexcept : a_(a), b_(b) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        edges(i, j);
        edge_and_arc(a_, i, b_, j);
        edge_and_arc(b_, i, a_, j);
        arcs(i, j);
      }
      for (const bool second : {false, true}) consider(a_.end(i, second)), consider(b_.end(i, second));
    }
  }
  PlaneVector best() const noexcept { return best_; }

 private:
  void consider(const PlaneVector& p) noexcept {
    const double off = lane::max(a_.off(p), b_.off(p));
    if (off < least_) least_ = off, best_ = p;
  }
  void edges(int i, int j) noexcept {
    const PlaneVector p = a_.end(i, false), along = a_.end(i, true) + -p;
    const PlaneVector q = b_.end(j, false), other = b_.end(j, true) + -q;
    const double place = cross(q + -p, other) / cross(along, other);
    if (place >= 0 && place <= 1) consider(p + place * along);
  }
  void edge_and_arc(const RoundedOutline& s, int i, const RoundedOutline& round, int j) noexcept {
    const PlaneVector p = s.end(i, false), along = s.end(i, true) + -p, from = round.corner(j) + -p;
    if (along.x == 0 && along.y == 0) return;
    const PlaneVector unit = support_minimum::unit_of_any(along);
    const double off = cross(unit, from), middle = dot(unit, from);
    const double half = lane::sqrt(lane::positive_part((round.radius - off) * (round.radius + off)));
    for (const double x : {middle - half, middle + half}) consider(p + x * unit);
  }
  void arcs(int i, int j) noexcept {
    const PlaneVector p = a_.corner(i), way = b_.corner(j) + -p;
    if (way.x == 0 && way.y == 0) return;
    const PlaneVector unit = support_minimum::unit_of_any(way);
    const double distance = dot(unit, way), r = a_.radius, s = b_.radius;
    const double x = 0.5 * (distance + (r - s) * ((r + s) / distance));
    const double y = lane::sqrt(lane::positive_part((r - x) * (r + x)));
    for (const double side : {-y, y}) consider(p + support_minimum::out_of_frame(unit, {x, side}));
  }

  const RoundedOutline &a_, &b_;
  PlaneVector best_{};
  double least_ = 0x1p1000;
};

/// True if b comes first. Only what (a, b) and (b, a) have in common decides.
inline bool out_of_order(const nearest::ScaledPair& p) noexcept {
  const auto key = [](const ScaledShape& s, double sign, const nearest::Vector<double>& d) {
    const nearest::Vector<double>& u = s.box.u;
    return std::array<double, 9>{s.radius, s.box.hx.high, s.box.hy.high,   u.x.high,       u.y.high,
                                 u.x.low,  u.y.low,       sign * d.x.high, sign * d.y.high};
  };
  return key(p.b, -1, p.d) < key(p.a, 1, p.d);
}

/// For shapes that overlap, by their relation. The centres lie amid two stored points.
inline ClosestPoints<double> closest_outlines(Relation relation, const nearest::ScaledPair& p,
                                              const form::Corners<double>& a, const form::Corners<double>& b) noexcept {
  const auto located = [&p](const form::Corners<double>& from, const PlaneVector& offset) {
    return PlaneVector{
        support_minimum::located_coordinate(from.x0, from.x1, arithmetic::scale_far(offset.x, p.exponent)) + 0.0,
        support_minimum::located_coordinate(from.y0, from.y1, arithmetic::scale_far(offset.y, p.exponent)) + 0.0};
  };
  if (relation == Relation::inside || relation == Relation::contains) {
    const bool inside = relation == Relation::inside;
    const NestedOutlines n =
        inside ? nested_outlines(p.b, p.a, nearest::flipped(p.d, -1.0)) : nested_outlines(p.a, p.b, p.d);
    const PlaneVector on_a = located(a, inside ? n.inner : n.outer), on_b = located(b, inside ? n.outer : n.inner);
    const double distance = nearest::scaled_distance(n.distance, p.exponent);
    return {lane::max(distance, std::numeric_limits<double>::denorm_min()), on_a.x, on_a.y, on_b.x, on_b.y};
  }
  const bool exchanged = out_of_order(p);
  const double turn = exchanged ? -1 : 1;
  const RoundedOutline first(exchanged ? p.b : p.a, {0, 0}),
      second(exchanged ? p.a : p.b, {turn * p.d.x.high, turn * p.d.y.high});
  const PlaneVector at = located(exchanged ? b : a, CommonOutlinePoint(first, second).best());
  return {0, at.x, at.y, at.x, at.y};
}
template <class A, class B>
ClosestPoints<double> closest_outlines(Relation relation, const A& a, const B& b) noexcept {
  const auto corners = [](const auto& s) { return form::corners(form::of(form::inflated(s).core).place); };
  return closest_outlines(relation, nearest::scaled_pair(a, b), corners(a), corners(b));
}

}  // namespace vesica::detail::boundary_distance
