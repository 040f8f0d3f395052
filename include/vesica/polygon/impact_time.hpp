// SPDX-License-Identifier: Apache-2.0
/// impact_time() with convex polygons: as in impact_time.hpp, with the support function of the vertices. A polygon
/// turns about the middle of its bounds, each coordinate rounded to a double. A path on one line is a segment.
///
/// Straight shapes are corners in their own frame, and a radius; a disc is one corner. Only an ellipse has none. If
/// there is one, the path is the first shape.
///
/// A polygon's h is the greatest of cosines times at most its reach, as a box's is. So separation.hpp holds with the
/// reach as its bend.
#pragma once

#include <vesica/impact_time.hpp>
#include <vesica/polygon/cast.hpp>

namespace vesica {

/// How paths turn; names of impact_time/ hide those of polygon/ here.
namespace detail::polygon::turning {

using impact_time::Body;
using impact_time::Direction;
using impact_time::Gap;
using impact_time::Heading;
using impact_time::Kept;
using impact_time::Pose;
using impact_time::Separation;
using impact_time::Support;
using impact_time::Turning;
using support_minimum::into_frame;
using support_minimum::out_of_frame;

/// Corners counter-clockwise, about the shape's centre, in the scene's unit and the shape's frame: of a path's ring, or
/// up to four of their own.
template <class T>
struct Corners {
  const Edges<T>* path = nullptr;
  Range ring{0, 0};
  bool clockwise = false;
  Point<double> centre{};
  double factor[2] = {1, 1};
  PlaneVector own[4] = {};
  std::int64_t count = 0;  // 0 of an ellipse

  PlaneVector scaled(const Point<double>& p) const noexcept {
    return {(p.x - centre.x) * factor[0] * factor[1], (p.y - centre.y) * factor[0] * factor[1]};
  }
  PlaneVector operator[](std::int64_t k) const noexcept {
    return path == nullptr ? own[k] : scaled(path->vertex(clockwise ? ring.last - 1 - k : ring.first + k));
  }
  PlaneVector next(std::int64_t k) const noexcept { return (*this)[k + 1 == count ? 0 : k + 1]; }

  /// Calls visit(normal, corner) for each edge, with its unit normal outward. A segment has normals at its ends too.
  template <class Visit>
  void for_faces(const Visit& visit) const noexcept {
    for (std::int64_t k = 0; k < count; ++k) {
      const PlaneVector p = (*this)[k], q = next(k), way = q + -p;
      if (way.x == 0 && way.y == 0) continue;
      visit(support_minimum::unit_of_any({way.y, -way.x}), p);
      if (count == 2) visit(support_minimum::unit_of_any(way), q);
    }
  }
};

/// The first shape is a path. hx and hy of one with corners are its thickness, or less.
template <class T>
struct PathScene : impact_time::Scene {
  Corners<T> of_a, of_b;

  bool has_boxes() const noexcept { return false; }  // directions between corners are tried too
};

template <class T>
Support support(const Corners<T>& corners, const Turning& s, const PlaneVector& axis, const PlaneVector& n) noexcept {
  if (corners.count == 0) return impact_time::support(s, axis, n);
  const PlaneVector in_frame = into_frame(axis, n);
  Support most{-infinite, 0};
  for (std::int64_t k = 0; k < corners.count; ++k) {
    const PlaneVector p = corners[k];
    const double along = support_minimum::dot(p, in_frame);
    if (along > most.h) most = {along, support_minimum::cross(p, in_frame)};
  }
  return {most.h + s.radius, most.rate};
}

/// As impact_time::separation().
template <class T>
Separation separation(const PathScene<T>& s, const Pose& at, const PlaneVector& n, Kept kept) noexcept {
  using support_minimum::cross;
  using support_minimum::dot;
  const Support a = support(s.of_a, s.a, at.axis_a, n), b = support(s.of_b, s.b, at.axis_b, -n);
  const double rate = rate_of(s, kept), along = dot(n, at.offset);
  const double change =
      (dot(n, s.v) + rate * cross(n, at.offset)) - (s.a.spin - rate) * a.rate - (s.b.spin - rate) * b.rate;
  return {((along - a.h) - b.h) - s.error, change, along};
}

/// The normal of an edge that separates best, and by how much, without the radii.
struct BestFace {
  Heading heading{{1, 0}, Kept::still, {}};
  double by = -infinite;
};
template <class T>
BestFace best_face(const PathScene<T>& s, const Pose& at) noexcept {
  using support_minimum::dot;
  BestFace best;
  const auto look = [&](const PlaneVector& n, double own, double other, Kept kept, const PlaneVector& in_frame) {
    const double by = (dot(n, at.offset) - own) - other;
    if (by > best.by) best = {{n, kept, in_frame}, by};
  };
  s.of_a.for_faces([&](const PlaneVector& normal, const PlaneVector& corner) {
    const PlaneVector n = out_of_frame(at.axis_a, normal);
    look(n, dot(normal, corner), support(s.of_b, s.b, at.axis_b, -n).h - s.b.radius, Kept::with_a, normal);
  });
  s.of_b.for_faces([&](const PlaneVector& normal, const PlaneVector& corner) {
    const PlaneVector n = -out_of_frame(at.axis_b, normal);
    look(n, dot(normal, corner), support(s.of_a, s.a, at.axis_a, n).h - s.a.radius, Kept::with_b, -normal);
  });
  return best;
}

/// The shortest way found so far between a point and an edge.
struct ShortestWay {
  double square = infinite;
  PlaneVector from{}, to{};  // a point of the first and of the second shape

  void look(const PlaneVector& point, const PlaneVector& p, const PlaneVector& q, bool point_is_second) noexcept {
    using support_minimum::dot;
    const PlaneVector edge = q + -p, way = point + -p;
    const double along = dot(edge, way), length = dot(edge, edge), off = support_minimum::cross(edge, way);
    const bool inside = along > 0 && along < length;
    if (inside && !(off * off < square * length)) return;
    const PlaneVector foot = inside ? p + (along / length) * edge : along > 0 ? q : p, apart = point + -foot;
    const double found = dot(apart, apart);
    if (!(found < square)) return;
    square = found;
    from = point_is_second ? foot : point;
    to = point_is_second ? point : foot;
  }
};

/// The closest points of two shapes with corners that are apart, without their radii.
template <class T>
Gap corners_gap(const PathScene<T>& s, const Pose& at) noexcept {
  // In the first shape's frame.
  const PlaneVector axis = into_frame(at.axis_a, at.axis_b), offset = into_frame(at.axis_a, at.offset);
  ShortestWay way;
  PlaneVector p = offset + out_of_frame(axis, s.of_b[0]);
  for (std::int64_t i = 0; i < s.of_b.count; ++i) {
    const PlaneVector q = offset + out_of_frame(axis, s.of_b.next(i));
    PlaneVector v = s.of_a[0];
    for (std::int64_t k = 0; k < s.of_a.count; ++k) {
      const PlaneVector w = s.of_a.next(k);
      way.look(p, v, w, true);
      way.look(v, p, q, false);
      v = w;
    }
    p = q;
  }
  return {out_of_frame(at.axis_a, way.from), out_of_frame(at.axis_a, way.to), lane::sqrt(way.square)};
}

/// The closest points of a path's edges and an ellipse, whose sizes are multiplied by `part`. Edges that are farther
/// from its centre than another one from the ellipse are left out.
template <class T, class Ask>
Gap ellipse_gap(const PathScene<T>& s, const Pose& at, double part, const Ask& ask) noexcept {
  Body ellipse = body_of(s.b, at.axis_b, at.offset);
  ellipse.number[4] *= part;
  ellipse.number[5] *= part;
  const auto posed = [&](const PlaneVector& p) { return out_of_frame(at.axis_a, p); };
  const auto from_centre = [&](const PlaneVector& p, const PlaneVector& q) {
    ShortestWay way;
    way.look(at.offset, p, q, true);
    return lane::sqrt(way.square);
  };
  std::int64_t closest = 0;
  double least = infinite;
  for (std::int64_t k = 0; k < s.of_a.count; ++k) {
    const double distance = from_centre(posed(s.of_a[k]), posed(s.of_a.next(k)));
    if (distance < least) {
      least = distance;
      closest = k;
    }
  }
  Gap gap{{0, 0}, at.offset, infinite};
  const auto look = [&](std::int64_t k) {
    const PlaneVector p = posed(s.of_a[k]), q = posed(s.of_a.next(k));
    if (from_centre(p, q) - s.b.reach > gap.distance) return;
    ClosestPoints<double> c;
    ask.nearest({Kind::segment, {p.x, p.y, q.x, q.y}}, ellipse, c);
    if (c.distance < gap.distance) gap = {{c.ax, c.ay}, {c.bx, c.by}, c.distance};
  };
  look(closest);
  for (std::int64_t k = 0; k < s.of_a.count; ++k) {
    if (k != closest) look(k);
  }
  return gap;
}

template <class T, class Ask>
Gap gap_at(const PathScene<T>& s, const Pose& at, const Ask& ask) noexcept {
  if (s.of_b.count == 0) return ellipse_gap(s, at, 1, ask);
  Gap gap = corners_gap(s, at);
  const double radii = s.a.radius + s.b.radius;
  if (!(gap.distance > 0) || radii == 0) return gap;
  const PlaneVector n = support_minimum::unit_of_any(gap.b + -gap.a);
  gap.a = gap.a + s.a.radius * n;
  gap.b = gap.b + -(s.b.radius * n);
  gap.distance = lane::max(gap.distance - radii, 0);
  return gap;
}

template <class T>
void try_direction(const PathScene<T>& s, const Pose& at, const Heading& h, Direction& best) noexcept {
  const Separation by = separation(s, at, h.n, h.kept);
  if (by.least > best.by.least) best = {h, by};
}

/// The direction that separates best. `before` is the best one at an earlier time.
template <class T, class Ask>
Direction best_direction(const PathScene<T>& s, const Pose& at, const Heading& before, const Ask& ask) noexcept {
  const Heading turned{at_pose(before, at), before.kept, before.in_frame};
  Direction best{turned, separation(s, at, turned.n, turned.kept)};
  const BestFace face = best_face(s, at);
  if (face.by > -infinite) try_direction(s, at, face.heading, best);
  const Gap gap = s.of_b.count == 0 ? ellipse_gap(s, at, 1, ask) : corners_gap(s, at);
  const PlaneVector way = gap.b + -gap.a;
  if (way.x != 0 || way.y != 0) try_direction(s, at, {support_minimum::unit_of_any(way), Kept::still, {}}, best);
  if (s.of_b.count == 0) {
    // The normal of the ellipse's outline there.
    const PlaneVector p = into_frame(at.axis_b, gap.b + -at.offset);
    const PlaneVector out{p.x * s.b.hy / s.b.hx, p.y * s.b.hx / s.b.hy};
    if ((out.x != 0 || out.y != 0) && all_finite(out.x, out.y)) {
      const PlaneVector n = -out_of_frame(at.axis_b, support_minimum::unit_of_any(out));
      try_direction(s, at, {n, Kept::still, {}}, best);
    }
  }
  return best;
}

/// The distance of the shapes at t; less than -s.error only if they surely overlap.
template <class T, class Ask>
double signed_gap(const PathScene<T>& s, double t, const Ask& ask) noexcept {
  const Pose at = pose(s, t);
  if (s.of_b.count != 0) {
    // The edges' normals separate corners that are apart. Two single corners have none.
    const double radii = s.a.radius + s.b.radius, by = best_face(s, at).by;
    return (by > 0 || by == -infinite ? corners_gap(s, at).distance : by) - radii;
  }
  double beyond = -infinite;  // of the ellipse's centre
  s.of_a.for_faces([&](const PlaneVector& normal, const PlaneVector& corner) {
    beyond = greater(beyond, support_minimum::dot(out_of_frame(at.axis_a, normal), at.offset) -
                                 support_minimum::dot(normal, corner));
  });
  if (beyond > -infinite && beyond < -2 * s.error) return -infinite;
  // An ellipse so much smaller that it stays inside where both poses are off by the error.
  const double least = lane::min(s.b.hx, s.b.hy);
  if (least > 8 * s.error && ellipse_gap(s, at, 1 - 4 * s.error / least, ask).distance == 0) return -infinite;
  return ellipse_gap(s, at, 1, ask).distance;
}

/// A valid convex path about the middle of its bounds.
template <class T>
struct TurningPath {
  const Edges<T>& edges;
  Convexity shape;
  Point<double> centre;
  double reach;

  TurningPath(const Edges<T>& path, const Box& box, const Convexity& c) noexcept
      : edges(path), shape(c), centre{middle(box.min_x, box.max_x), middle(box.min_y, box.max_y)} {
    const double x = greater(box.max_x - centre.x, centre.x - box.min_x),
                 y = greater(box.max_y - centre.y, centre.y - box.min_y), most = greater(x, y);
    const int exponent = most > 0 ? arithmetic::exponent_of(most) : 0;
    double square = 0;
    for (std::int64_t i = shape.ring.first; i < shape.ring.last; ++i) {
      const Point<double> p = path.vertex(i);
      const double dx = arithmetic::scale_far(p.x - centre.x, -exponent),
                   dy = arithmetic::scale_far(p.y - centre.y, -exponent);
      square = greater(square, dx * dx + dy * dy);
    }
    reach = arithmetic::scale_far(lane::sqrt(square) * (1 + 0x1p-48), exponent);
  }

  /// A disc that holds it, wherever it turns.
  Body disc() const noexcept { return {Kind::circle, {centre.x, centre.y, reach}}; }

  Corners<T> corners(int exponent) const noexcept {
    Corners<T> c;
    c.centre = centre;
    c.factor[0] = arithmetic::scale_far(1, -(exponent / 2));
    c.factor[1] = arithmetic::scale_far(1, -(exponent - exponent / 2));
    if (shape.flat) {
      c.own[0] = c.scaled(start_of(shape.span));
      c.own[1] = c.scaled(end_of(shape.span));
      c.count = has_length(shape.span) ? 2 : 1;
      return c;
    }
    c.path = &edges;
    c.ring = shape.ring;
    c.clockwise = shape.clockwise;
    c.count = shape.ring.length();
    return c;
  }

 private:
  static double middle(double low, double high) noexcept {
    const double sum = low + high;
    return all_finite(sum) ? 0.5 * sum : 0.5 * low + 0.5 * high;
  }
};

/// At most the radius of a disc in a polygon: the area over the outline's length.
template <class T>
double thickness_of(const Corners<T>& corners) noexcept {
  double doubled = 0, length = 0;
  for (std::int64_t k = 0; k < corners.count; ++k) {
    const PlaneVector p = corners[k], q = corners.next(k), way = q + -p;
    doubled += support_minimum::cross(p, q);
    length += lane::sqrt(support_minimum::dot(way, way));
  }
  return doubled > 0 ? 0.5 * doubled / length : 0;
}

/// A path in a scene that was made with its disc.
inline void take_turn(Turning& s, double reach, double angle) noexcept {
  s.bend = s.reach;
  s.round = false;
  s.spin = reach > 0 ? angle : 0;
}

/// A body's corners, unless it is an ellipse. A disc becomes a corner with a radius.
template <class T>
Corners<T> corners_of(Turning& s) noexcept {
  Corners<T> c;
  if (s.round && s.hx != s.hy) return c;
  if (s.round) {
    s.radius += s.hx;
    s.hx = s.hy = 0;
    s.round = false;
  }
  const int count = (s.hx > 0 ? 2 : 1) * (s.hy > 0 ? 2 : 1);
  for (int i = 0; i < count; ++i) {
    const bool right = s.hx > 0 && (i == 1 || i == 2), top = s.hy > 0 && (count == 2 ? i == 1 : i >= 2);
    c.own[i] = {right ? s.hx : -s.hx, top ? s.hy : -s.hy};
  }
  c.count = count;
  return c;
}

template <class T>
PathScene<T> scene_of(const TurningPath<T>& a, const Turn<double>& turn_a, const Body& b,
                      const Turn<double>& turn_b) noexcept {
  PathScene<T> s{impact_time::scene(a.disc(), turn_a, b, turn_b), {}, {}};
  take_turn(s.a, a.reach, turn_a.angle);
  s.still = s.still && s.a.spin == 0;
  impact_time::measure(s);
  s.of_a = a.corners(s.exponent);
  s.of_b = corners_of<T>(s.b);
  s.a.hx = s.a.hy = thickness_of(s.of_a);
  s.a.radius = 0;
  return s;
}
template <class T>
PathScene<T> scene_of(const TurningPath<T>& a, const Turn<double>& turn_a, const TurningPath<T>& b,
                      const Turn<double>& turn_b) noexcept {
  PathScene<T> s{impact_time::scene(a.disc(), turn_a, b.disc(), turn_b), {}, {}};
  take_turn(s.a, a.reach, turn_a.angle);
  take_turn(s.b, b.reach, turn_b.angle);
  s.still = s.still && s.a.spin == 0 && s.b.spin == 0;
  impact_time::measure(s);
  s.of_a = a.corners(s.exponent);
  s.of_b = b.corners(s.exponent);
  s.a.hx = s.a.hy = thickness_of(s.of_a);
  s.b.hx = s.b.hy = thickness_of(s.of_b);
  s.a.radius = s.b.radius = 0;
  return s;
}

/// The shape whose point is asked for: a body about its centre, and how it moves.
struct Given {
  Body body;
  const Turn<double>& turn;
  bool second;  // it is the scene's second shape
};

/// As impact_time::contact_at().
template <class To, class T, class Ask>
std::int32_t contact_at(const PathScene<T>& s, const Given& first, const impact_time::Advanced& found, const Ask& ask,
                        Impact<double>& out, double& gap) noexcept {
  To minus_t = 0;
  arithmetic::round_up_to(-found.t, minus_t);
  const double t = 0 - static_cast<double>(minus_t);
  const Pose at = pose(s, t);
  const Gap closest = gap_at(s, at, ask);
  const bool meet = surely_meet_after(s, t, found.along.by.rate, closest.distance, ask);
  const PlaneVector from = first.second ? closest.b + -at.offset : closest.a;
  const PlaneVector p = impact_time::placed_point(first.body, first.turn, t, from, s.exponent);
  const double most = arithmetic::scale_far((closest.distance + 2 * s.error) * (1 + 0x1p-50), s.exponent);
  if (!all_finite(p.x, p.y, most)) return error_range;
  const PlaneVector n = first.second ? -found.along.heading.n : found.along.heading.n;
  out = {t, p.x, p.y, n.x + 0.0, n.y + 0.0};
  gap = most;
  return meet ? static_cast<std::int32_t>(cast_hit) : cast_near;
}

/// As impact_time::impact_time(), for a scene; overlap() asks whether the shapes do at the start.
template <class To, class T, class Overlap, class Ask>
std::int32_t impact_in(const PathScene<T>& s, const Given& first, double tolerance, const Overlap& overlap,
                       const Ask& ask, Impact<double>& out, double& gap) noexcept {
  const impact_time::Window w = impact_time::window(s);
  if (w.never) return cast_miss;
  constexpr Heading any{{1, 0}, Kept::still, {}};
  const Direction start = best_direction(s, pose(s, w.from), any, ask);
  if (!w.apart && !(start.by.least > 0) && overlap()) return cast_start;
  if (s.still) return cast_miss;
  const double enough = s.exponent == 0 ? tolerance : arithmetic::scale_far(tolerance, -s.exponent);
  const impact_time::Advanced found = impact_time::advance(s, w, start, enough, ask);
  if (found.outcome == impact_time::Outcome::missed) return cast_miss;
  return contact_at<To>(s, first, found, ask, out, gap);
}

/// A path and another shape, which is a body too; reversed: the other one comes first. cast_start is for the caller to
/// describe. ask.nearest() is of a segment and an ellipse.
template <class To, class T, class Other, class Ask>
std::int32_t impact_time_or_error(const Edges<T>& a, const Turn<double>& turn_a, const Other& b, const Body& body_b,
                                  const Turn<double>& turn_b, bool reversed, double tolerance, const Ask& ask,
                                  Impact<double>& out, double& gap) noexcept {
  Box box, about;
  if (!is_valid(a, box) || !is_valid(b, about)) return error_shape;
  const Convexity shape = convexity(a);
  if (!shape.convex) return error_not_convex;
  const TurningPath<T> path(a, box, shape);
  if (!all_finite(path.reach)) return error_range;
  const Body core = cast::core_of(body_b);
  const PathScene<T> s = scene_of(path, turn_a, core, turn_b);
  const Given first = reversed ? Given{core, turn_b, true} : Given{path.disc(), turn_a, false};
  return impact_in<To>(
      s, first, tolerance, [&] { return overlap_valid(a, box, b, about); }, ask, out, gap);
}
template <class To, class T, class Ask>
std::int32_t impact_time_or_error(const Edges<T>& a, const Turn<double>& turn_a, const Edges<T>& b,
                                  const Turn<double>& turn_b, double tolerance, const Ask& ask, Impact<double>& out,
                                  double& gap) noexcept {
  Box box_a, box_b;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return error_shape;
  const Convexity shape_a = convexity(a), shape_b = convexity(b);
  if (!shape_a.convex || !shape_b.convex) return error_not_convex;
  const TurningPath<T> path_a(a, box_a, shape_a), path_b(b, box_b, shape_b);
  if (!all_finite(path_a.reach, path_b.reach)) return error_range;
  const PathScene<T> s = scene_of(path_a, turn_a, path_b, turn_b);
  return impact_in<To>(
      s, {path_a.disc(), turn_a, false}, tolerance, [&] { return overlap_valid(a, box_a, b, box_b); }, ask, out, gap);
}

struct AskNearest {
  void nearest(const Body& segment, const Body& ellipse, ClosestPoints<double>& out) const noexcept {
    vesica::nearest_or_error(cast::shape<Segment>(segment), cast::shape<Ellipse>(ellipse), out);
  }
};

}  // namespace detail::polygon::turning

/// The checked form with convex polygons, in either order; error_not_convex for others. A path whose vertices are on
/// one line is a segment. A path turns about the middle of its bounds.
template <template <class> class A, template <class> class B, class T>
std::int32_t impact_time_or_error(const A<T>& a, const Turn<T>& turn_a, const B<T>& b, const Turn<T>& turn_b,
                                  std::type_identity_t<T> tolerance, Impact<T>& out,
                                  T& gap) noexcept requires AnyPath<A<T>, B<T>> {
  namespace impl = detail::impact_time;
  namespace paths = detail::polygon::turning;
  if (!impl::is_sound(turn_a) || !impl::is_sound(turn_b) || !(tolerance > 0)) return error_argument;
  Impact<double> found{};
  double found_gap = 0;
  const Turn<double> first = impl::widen(turn_a), second = impl::widen(turn_b);
  const auto enough = static_cast<double>(tolerance);
  const std::int32_t answer =
      detail::polygon::with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
        if constexpr (Path<A<T>> && Path<B<T>>) {
          static_cast<void>(reversed);
          return paths::impact_time_or_error<T>(edges, first, other, second, enough, paths::AskNearest{}, found,
                                                found_gap);
        } else {
          return paths::impact_time_or_error<T>(edges, reversed ? second : first, other, detail::cast::body(other),
                                                reversed ? first : second, reversed, enough, paths::AskNearest{}, found,
                                                found_gap);
        }
      });
  return impl::finish(answer, a, b, found, found_gap, out, gap);
}

}  // namespace vesica
