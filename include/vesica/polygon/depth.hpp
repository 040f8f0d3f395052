// SPDX-License-Identifier: Apache-2.0
/// depth() of convex polygons. The depth is the least reach of the Minkowski sum over all normals: along normals of
/// faces of either shape, and against an ellipse also along normals at which a vertex is nearest to its outline. A
/// radius adds to the depth of its core. The decision between 0 and more is exact.
#pragma once

#include <vesica/depth.hpp>
#include <vesica/polygon/convex.hpp>
#include <vesica/polygon/least.hpp>
#include <vesica/polygon/overlap.hpp>
#include <vesica/polygon/relation.hpp>
#include <vesica/support_minimum/core_form.hpp>

namespace vesica {

namespace detail::polygon {

using support_minimum::PlaneVector;
using TwiceDouble = arithmetic::FastDoubleDouble<double>;
/// A normal of about unit length, to twice the precision.
using TwiceNormal = support_minimum::DoubleDoubleVector<double>;

/// Lengths of a pair are multiplied by `factor`, a power of two, so that its box is about as large as 1.
struct DepthUnit {
  double factor;
  int exponent;
  double size;  // 1, or the power of two that the box is about as large as where the unit cannot follow

  DepthUnit(const Box& a, const Box& b) noexcept {
    const double wide = greater(a.max_x, b.max_x) - lesser(a.min_x, b.min_x);
    const double high = greater(a.max_y, b.max_y) - lesser(a.min_y, b.min_y);
    const double extent = greater(wide, high);
    const int needed = extent > 0 ? arithmetic::exponent_of(lesser(extent, std::numeric_limits<double>::max())) : 0;
    exponent = needed > 1000 ? 1000 : needed < -1000 ? -1000 : needed;
    factor = arithmetic::scale_far(1, -exponent);
    size = arithmetic::scale_far(1, needed - exponent);
  }
};

/// A convex ring with area, counter-clockwise, in the pair's unit. The vertex after the last is the first.
template <class T>
class ConvexRing {
 public:
  ConvexRing(const Edges<T>& edges, const Convexity& c, const DepthUnit& unit) noexcept
      : edges_(edges), ring_(c.ring), clockwise_(c.clockwise), factor_(unit.factor) {}

  std::int64_t size() const noexcept { return ring_.length(); }
  Point<double> stored(std::int64_t i) const noexcept { return edges_.vertex(number(i)); }
  Point<double> operator[](std::int64_t i) const noexcept {
    const Point<double> p = stored(i);
    return {p.x * factor_, p.y * factor_};
  }
  /// The number of vertex i in the caller's memory.
  std::int64_t number(std::int64_t i) const noexcept {
    const std::int64_t k = i >= size() ? i - size() : i;
    return clockwise_ ? ring_.last - 1 - k : ring_.first + k;
  }
  /// The rounded normal out of the edge that begins at vertex i; false if its ends are the same.
  bool normal(std::int64_t i, PlaneVector& n) const noexcept {
    const Point<double> p = (*this)[i], q = (*this)[i + 1];
    const PlaneVector outward{q.y - p.y, p.x - q.x};
    if (outward.x == 0 && outward.y == 0) return false;
    n = support_minimum::unit_of_any(outward);
    return true;
  }
  bool has_edge() const noexcept {
    PlaneVector n;
    std::int64_t i = 0;
    while (i < size() && !normal(i, n)) ++i;
    return i < size();
  }
  TwiceNormal twice_normal(std::int64_t i) const noexcept {
    const Point<double> p = (*this)[i], q = (*this)[i + 1];
    const TwiceDouble x = arithmetic::sum(q.y, -p.y), y = arithmetic::sum(p.x, -q.x);
    const int k = -arithmetic::exponent_of(greater(lane::abs(x.high), lane::abs(y.high)));
    const auto scaled = [k](const TwiceDouble& v) {
      return TwiceDouble{arithmetic::scale_far(v.high, k), arithmetic::scale_far(v.low, k)};
    };
    return {scaled(x), scaled(y)};
  }
  /// The vertex farthest along a direction, as seen from a vertex: far from the origin sums of products would round.
  std::int64_t farthest(const PlaneVector& n) const noexcept {
    std::int64_t best = 0;
    double most = -infinite;
    const Point<double> first = (*this)[0];
    for (std::int64_t i = 0; i < size(); ++i) {
      const Point<double> p = (*this)[i];
      const double along = (p.x - first.x) * n.x + (p.y - first.y) * n.y;
      if (along > most) {
        most = along;
        best = i;
      }
    }
    return best;
  }

 private:
  const Edges<T>& edges_;
  Range ring_;
  bool clockwise_;
  double factor_;
};

/// Reaches that differ by less, or a depth that is less, are compared to twice the precision, or exactly.
inline constexpr double depth_tie = 0x1p-45;

/// The least reach so far and its direction.
struct LeastReach {
  TwiceDouble value{0x1p1000};
  PlaneVector n{1, 0};

  bool may_be(double reach) const noexcept { return reach <= value.high + depth_tie; }
  void take(const TwiceDouble& reach, const PlaneVector& direction) noexcept {
    if (!(arithmetic::rounded(reach - value) < 0)) return;
    value = reach;
    n = direction;
  }
};

inline TwiceDouble along(const TwiceNormal& n, const TwiceDouble& x, const TwiceDouble& y) noexcept {
  return n.x * x + n.y * y;
}
inline TwiceDouble over_length(const TwiceDouble& x, const TwiceNormal& n) noexcept {
  return arithmetic::quotient_by_root(x, along(n, n.x, n.y));
}

/// A box or an ellipse in the pair's unit.
class PlacedForm {
 public:
  PlacedForm(const support_minimum::Form& f, const DepthUnit& unit) noexcept {
    const double k = unit.factor;
    from_ = {f.from.x * k, f.from.y * k};
    to_ = {f.to.x * k, f.to.y * k};
    const int axis = form::axis_exponent(f.u.x, f.u.y);
    u_ = {arithmetic::scale_far(f.u.x, -axis), arithmetic::scale_far(f.u.y, -axis)};
    a_ = arithmetic::scale_far(f.a, axis - unit.exponent);
    b_ = arithmetic::scale_far(f.b, axis - unit.exponent);
    const double length = lane::sqrt(u_.x * u_.x + u_.y * u_.y), thinnest = f.curved ? 0x1p-250 : 0.0;
    centred_ = {
        {u_.x / length, u_.y / length}, lane::max(a_ * length, thinnest), lane::max(b_ * length, thinnest), f.curved};
  }

  const support_minimum::CentredShape& centred() const noexcept { return centred_; }
  bool curved() const noexcept { return centred_.curved; }
  const PlaneVector& axis() const noexcept { return u_; }
  /// From the centre to a point.
  PlaneVector offset(const Point<double>& p) const noexcept {
    return {0.5 * ((p.x - from_.x) + (p.x - to_.x)), 0.5 * ((p.y - from_.y) + (p.y - to_.y))};
  }
  /// How far the shape must move along a unit normal until it is beyond a point, rounded.
  double reach(const PlaneVector& n, const Point<double>& p) const noexcept {
    const PlaneVector o = offset(p);
    const double height = centred_.curved ? support_minimum::ellipse_support(centred_, n).height
                                          : support_minimum::dot(support_minimum::corner(centred_, n), n);
    return (n.x * o.x + n.y * o.y) + height;
  }
  /// The same to twice the precision, for a normal of any length.
  TwiceDouble reach(const TwiceNormal& n, const Point<double>& p) const noexcept {
    const auto x = form::twice_offset(p.x, p.x, from_.x, to_.x, 1), y = form::twice_offset(p.y, p.y, from_.y, to_.y, 1);
    const TwiceDouble offset = polygon::along(n, {x.high, x.low}, {y.high, y.low}) * 0.5;
    const TwiceDouble s = polygon::along(n, u_.x, u_.y) * a_, t = polygon::along(n, -u_.y, u_.x) * b_;
    const TwiceDouble height =
        centred_.curved ? arithmetic::root(s * s + t * t) : arithmetic::magnitude(s) + arithmetic::magnitude(t);
    return over_length(offset + height, n);
  }

 private:
  PlaneVector from_, to_, u_;
  double a_, b_;
  support_minimum::CentredShape centred_;
};

/// Along the normal of a face of the form, or its opposite.
template <class T>
void look_along(const ConvexRing<T>& ring, const PlacedForm& form, const PlaneVector& axis,
                LeastReach& least) noexcept {
  const PlaneVector n = support_minimum::unit(axis);
  const Point<double> top = ring[ring.farthest(n)];
  const double reach = form.reach(n, top);
  if (!least.may_be(reach)) return;
  const TwiceNormal exact{axis.x, axis.y};
  TwiceDouble most = form.reach(exact, top);
  for (std::int64_t i = 0; i < ring.size(); ++i) {
    const Point<double> p = ring[i];
    if (form.reach(n, p) < reach - depth_tie) continue;
    const TwiceDouble found = form.reach(exact, p);
    if (arithmetic::rounded(found - most) > 0) most = found;
  }
  least.take(most, n);
}

/// Between the normals of the faces beside a vertex, against a curved outline.
inline void look_at_vertex(const PlacedForm& form, const Point<double>& p, const PlaneVector& before,
                           const PlaneVector& after, LeastReach& least) noexcept {
  if (!(support_minimum::cross(before, after) > 0)) return;
  const support_minimum::CentredShape point{{1, 0}, 0, 0, false};
  const support_minimum::Objective objective{form.centred(), point, 1, form.offset(p), 0x1p-54};
  const support_minimum::Minimum found =
      support_minimum::ArcSearch(objective).run_between(before, after, least.value.high);
  if (!(found.at.value < least.value.high)) return;
  const PlaneVector& n = found.at.n;
  least.take(form.reach(TwiceNormal{n.x, n.y}, p), n);
}

template <class T>
LeastReach least_reach(const ConvexRing<T>& ring, const PlacedForm& form) noexcept {
  LeastReach least;
  PlaneVector before{}, n;
  for (std::int64_t i = ring.size() - 1; !ring.normal(i, before);) --i;
  for (std::int64_t i = 0; i < ring.size(); ++i) {
    if (!ring.normal(i, n)) continue;
    const Point<double> p = ring[i];
    if (least.may_be(form.reach(n, p))) least.take(form.reach(ring.twice_normal(i), p), n);
    if (form.curved()) look_at_vertex(form, p, before, n, least);
    before = n;
  }
  if (form.curved()) return least;
  const PlaneVector u = form.axis(), w = support_minimum::perp(u);
  for (const PlaneVector& axis : {u, w, -u, -w}) look_along(ring, form, axis, least);
  return least;
}

/// Calls visit(i, n, reach, k) for each edge of the first ring: its normal, how far the second ring must move along it,
/// rounded, and the vertex of the second that counts, which goes round as the edges do.
template <class T, class Visit>
void for_reaches(const ConvexRing<T>& a, const ConvexRing<T>& b, Visit visit) noexcept {
  PlaneVector n;
  std::int64_t k = -1;
  for (std::int64_t i = 0; i < a.size(); ++i) {
    if (!a.normal(i, n)) continue;
    if (k < 0) k = b.farthest(-n);
    const auto rise = [&](const Point<double>& p, const Point<double>& q) {
      return n.x * (q.x - p.x) + n.y * (q.y - p.y);
    };
    for (std::int64_t steps = 0; steps < b.size() && rise(b[k], b[k + 1]) <= 0; ++steps)
      k = k + 1 < b.size() ? k + 1 : 0;
    visit(i, n, -rise(a[i], b[k]), k);
  }
}

/// The reaches of the first ring's edges; sign -1 if it is the shape that moves.
template <class T>
void look_at_edges(const ConvexRing<T>& a, const ConvexRing<T>& b, double sign, LeastReach& least) noexcept {
  for_reaches(a, b, [&](std::int64_t i, const PlaneVector& n, double reach, std::int64_t k) {
    if (!least.may_be(reach)) return;
    const TwiceNormal exact = a.twice_normal(i);
    const Point<double> p = a[i];
    TwiceDouble most{-0x1p1000};
    for (std::int64_t j = k + b.size() - 1; j <= k + b.size() + 1; ++j) {
      const Point<double> q = b[j % b.size()];
      const TwiceDouble found = along(exact, arithmetic::sum(p.x, -q.x), arithmetic::sum(p.y, -q.y));
      if (arithmetic::rounded(found - most) > 0) most = found;
    }
    least.take(over_length(most, exact), {sign * n.x, sign * n.y});
  });
}

/// Is the second of two rings that overlap beyond an edge of the first? Touching its line is allowed.
template <class T>
bool is_beyond_edge(const ConvexRing<T>& a, const ConvexRing<T>& b) noexcept {
  bool beyond = false;
  for_reaches(a, b, [&](std::int64_t i, const PlaneVector&, double reach, std::int64_t) {
    if (beyond || reach > depth_tie) return;
    const Point<double> p = a.stored(i), q = a.stored(i + 1);
    bool all = true;
    for (std::int64_t j = 0; all && j < b.size(); ++j) {
      const Point<double> r = b.stored(j);
      all = side(r.x, r.y, {p.x, p.y, q.x, q.y}) <= 0;
    }
    beyond = all;
  });
  return beyond;
}

/// Does a line along a face of either shape separate a ring from a box? Exact.
template <class T>
VESICA_COLD bool is_separated(const ConvexRing<T>& ring, const PlacedForm& form, const exact::Box& box) noexcept {
  using exact::Number, exact::from_double;
  const auto from_centre = [&](const Point<double>& p, const auto& nx, const auto& ny) {
    return exact::dot(nx, ny, from_double(p.x) - box.cx, from_double(p.y) - box.cy);
  };
  PlaneVector n;
  for (std::int64_t i = 0; i < ring.size(); ++i) {
    if (!ring.normal(i, n) || form.reach(n, ring[i]) > depth_tie) continue;
    const Point<double> p = ring.stored(i), q = ring.stored(i + 1);
    const Number<1> nx = from_double(q.y) - from_double(p.y), ny = from_double(p.x) - from_double(q.x);
    const Number<3> height = box.hx * exact::abs(exact::dot(nx, ny, box.ux, box.uy)) +
                             box.hy * exact::abs(exact::cross(nx, ny, box.ux, box.uy));
    if ((from_centre(p, nx, ny) + height).sign <= 0) return true;
  }
  const auto uu = exact::dot(box.ux, box.uy, box.ux, box.uy);
  if (uu.sign == 0) return false;
  for (int turn = 0; turn < 4; ++turn) {
    // u, its perpendicular, and their opposites.
    const exact::Length ux = turn == 0 ? box.ux : turn == 1 ? -box.uy : turn == 2 ? -box.ux : box.uy;
    const exact::Length uy = turn == 0 ? box.uy : turn == 1 ? box.ux : turn == 2 ? -box.uy : -box.ux;
    const Number<3> height = (turn % 2 == 0 ? box.hx : box.hy) * uu;
    bool beyond = true;
    for (std::int64_t i = 0; beyond && i < ring.size(); ++i) {
      beyond = (from_centre(ring.stored(i), ux, uy) + height).sign <= 0;
    }
    if (beyond) return true;
  }
  return false;
}

using support_minimum::core_form, support_minimum::CoreForm;

inline exact::Box exact_box(const exact::Box& box) noexcept { return box; }
inline exact::Box exact_box(const exact::Ellipse& e) noexcept { return exact::as_box(e); }
/// The core in exact numbers.
template <template <class> class Shape>
VESICA_COLD exact::Box exact_core(const Shape<double>& s) noexcept {
  return exact_box(exact::form(form::inflated(s).core));
}
template <template <class> class Shape>
bool core_meets(const Edge& e, const Shape<double>& s) noexcept {
  return vesica::overlap(e, form::inflated(s).core);
}
template <template <class> class Shape>
std::int32_t edge_depth(const Edge& e, const Shape<double>& s, Penetration<double>& out) noexcept {
  return vesica::depth_or_error(e, s, out);
}
inline std::int32_t edge_depth(const Edge& e, const Edge& f, Penetration<double>& out) noexcept {
  return vesica::depth_or_error(e, f, out);
}

/// A depth in the pair's unit, which `is_zero` settles where it is small.
template <class IsZero>
std::int32_t settled_depth(const LeastReach& least, const DepthUnit& unit, double radius, const IsZero& is_zero,
                           Penetration<double>& out) noexcept {
  double depth = arithmetic::scale_rounded(least.value.high, least.value.low, unit.exponent);
  if (!(least.value.high > depth_tie)) depth = is_zero() ? 0 : detail::depth::above_zero(depth);
  depth += radius;
  if (!all_finite(depth)) return error_range;
  out = {depth, least.n.x + 0.0, least.n.y + 0.0};
  return 0;
}

/// A convex polygon with area and a valid shape that overlaps it.
template <class T, class Other>
std::int32_t depth_of_overlapping(const Edges<T>& a, const Box& box, const Convexity& shape, const Other& b,
                                  Penetration<double>& out) noexcept {
  const CoreForm core = core_form(b);
  const auto any_edge = [&a](const auto& test) {
    return a.for_edges([&](const Edge& e, std::int64_t) { return test(e); });
  };
  if (core.radius > 0 && !any_edge([&](const Edge& e) { return core_meets(e, b); }) && !inside(a, stored_point(b))) {
    // The least distance to the core leaves the greatest depth.
    Penetration<double> most{-1, 0, 0}, found;
    std::int32_t error = 0;
    any_edge([&](const Edge& e) {
      if (!edge_meets(e, b)) return false;
      error = edge_depth(e, b, found);
      if (error == 0 && found.depth > most.depth) most = found;
      return error != 0;
    });
    if (error == 0) out = most;
    return error;
  }
  const DepthUnit unit(box, box_about(b));
  const ConvexRing<T> ring(a, shape, unit);
  // So small beside the other shape that no edge has a length in the pair's unit.
  if (!ring.has_edge()) return edge_depth(shape.span, b, out);
  const PlacedForm form(core.form, unit);
  const auto has_no_depth = [&] {
    if (!form.curved()) return is_separated(ring, form, exact_core(b));
    return !insides_meet_valid(a, box, b);
  };
  return settled_depth(least_reach(ring, form), unit, core.radius, has_no_depth, out);
}

template <class T, class Other>
std::int32_t convex_depth(const Edges<T>& a, const Other& b, Penetration<double>& out) noexcept {
  Box box, about;
  if (!is_valid(a, box) || !is_valid(b, about)) return error_shape;
  const Convexity shape = convexity(a);
  if (!shape.convex) return error_not_convex;
  if (shape.flat) return edge_depth(shape.span, b, out);
  if (overlap_valid(a, box, b, about)) return depth_of_overlapping(a, box, shape, b, out);
  out = {0, 0, 0};
  return 0;
}

/// Two rings are asked in one order, so that exchanging them changes no bit.
template <class T>
std::int32_t convex_depth(const Edges<T>& a, const Edges<T>& b, Penetration<double>& out) noexcept {
  Box box_a, box_b;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return error_shape;
  const Convexity shape_a = convexity(a), shape_b = convexity(b);
  if (!shape_a.convex || !shape_b.convex) return error_not_convex;
  if (shape_a.flat && shape_b.flat) return edge_depth(shape_a.span, shape_b.span, out);
  if (shape_a.flat || (!shape_b.flat && compared(a, b) > 0)) {
    const std::int32_t error = convex_depth(b, a, out);
    if (error == 0) out = depth::turned_round(out);
    return error;
  }
  if (!overlap_valid(a, box_a, b, box_b)) {
    out = {0, 0, 0};
    return 0;
  }
  if (shape_b.flat) return depth_of_overlapping(a, box_a, shape_a, shape_b.span, out);
  const DepthUnit unit(box_a, box_b);
  const ConvexRing<T> ring_a(a, shape_a, unit), ring_b(b, shape_b, unit);
  LeastReach least;
  look_at_edges(ring_a, ring_b, 1, least);
  look_at_edges(ring_b, ring_a, -1, least);
  const auto has_no_depth = [&] { return is_beyond_edge(ring_a, ring_b) || is_beyond_edge(ring_b, ring_a); };
  return settled_depth(least, unit, 0, has_no_depth, out);
}

/// For shapes of either order.
template <class A, class B>
std::int32_t depth_of_any(const A& a, const B& b, Penetration<double>& out) noexcept {
  return with_edges(a, b, [&out](const auto& edges, const auto& other, bool reversed) {
    const std::int32_t error = convex_depth(edges, other, out);
    if (error == 0 && reversed) out = depth::turned_round(out);
    return error;
  });
}

}  // namespace detail::polygon

/// The checked form with a convex polygon, in either order; error_not_convex for others. A path whose vertices are on
/// one line is a segment.
template <template <class> class A, template <class> class B>
std::int32_t depth_or_error(const A<double>& a, const B<double>& b,
                            Penetration<double>& out) noexcept requires AnyPath<A<double>, B<double>> {
  return detail::polygon::depth_of_any(a, b, out);
}
template <template <class> class A, template <class> class B>
std::int32_t depth_or_error(const A<float>& a, const B<float>& b,
                            Penetration<float>& out) noexcept requires AnyPath<A<float>, B<float>> {
  Penetration<double> wide{0, 0, 0};
  const std::int32_t error = detail::polygon::depth_of_any(a, b, wide);
  if (error != 0) return error;
  return detail::depth::rounded_to(wide, out) ? 0 : error_range;
}

}  // namespace vesica
