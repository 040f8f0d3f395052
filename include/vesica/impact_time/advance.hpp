// SPDX-License-Identifier: Apache-2.0
/// Conservative advancement: a time before which there is no contact, by directions that separate the shapes. Each step
/// is proved by separation.hpp; what leads to it need not be right.
#pragma once

#include <vesica/cast.hpp>
#include <vesica/impact_time/separation.hpp>

namespace vesica::detail::impact_time {

/// No contact before `from`, nor from `to` on, by the discs around the shapes. never: none at all.
struct Window {
  double from, to;
  bool never, apart;  // apart: at the start
};

/// True if the discs are apart from one time to another, along the connection of the centres at some time.
inline bool discs_apart(const Scene& s, double time, double from, double to) noexcept {
  const PlaneVector d = s.offset(time);
  const double length = lane::sqrt(dot(d, d)), reach = (s.a.reach + s.b.reach) * (1 + 0x1p-40) + 2 * s.error;
  if (!(length > reach)) return false;
  const PlaneVector n{d.x / length, d.y / length};
  return dot(n, s.offset(from)) > reach && dot(n, s.offset(to)) > reach;
}

inline Window window(const Scene& s) noexcept {
  constexpr double before = 1 - 0x1p-20, after = 1 + 0x1p-20;
  const double reach = s.a.reach + s.b.reach, dd = dot(s.d, s.d), dv = dot(s.d, s.v), vv = dot(s.v, s.v);
  const double least = dd - reach * reach, root = lane::sqrt(lane::max(dv * dv - vv * least, 0));
  const double nearest = vv > 0 ? lane::min(lane::max(-dv / vv, 0), 1) : 0;
  if (discs_apart(s, nearest, 0, 1)) return {1, 1, true, true};
  const double first = least > 0 ? before * (least / (root - dv)) : 0, last = vv > 0 ? after * ((root - dv) / vv) : 1;
  Window w{0, 1, false, least > 0 && discs_apart(s, 0, 0, 0)};
  if (first > 0 && first < 1 && discs_apart(s, first, 0, first)) w.from = first;
  if (last > w.from && last < 1 && discs_apart(s, last, last, 1)) w.to = last;
  return w;
}

/// The most directions, and the most poses in all, that are tried. A direction costs more, up to 30 us with extreme
/// magnitudes; two or three are usual.
inline constexpr int most_directions = 256, most_poses = 4096;

/// A time and how far a direction separates there.
struct Reached {
  double t;
  Separation by;
};

/// Goes on along one direction until it separates the shapes by a fiftieth of what it did, or `enough`, or until `to`.
/// AnyScene: a Scene, or one with polygons (polygon/impact_time.hpp), here and below.
template <class AnyScene>
Reached march(const AnyScene& s, const Heading& h, Reached at, double enough, double to, int& poses) noexcept {
  const double goal = lane::max(0.02 * at.by.least, enough);
  double room = to - at.t, beyond = 2;  // where the direction was seen not to be enough
  for (int i = 0; i < 16 && poses < most_poses && at.t < to; ++i, ++poses) {
    double step = lane::min(room, to - at.t);
    const double bound = curve(s, h.kept, at.by.along, 0);
    if (bound * (step * step) > 7.5 * at.by.least) step = lane::sqrt(7.5 * at.by.least / bound);
    if (at.by.rate < 0) step = lane::min(step, 0.99 * at.by.least / -at.by.rate);
    const double t = step < to - at.t ? at.t + step : to;
    if (!(t > at.t)) break;
    const Pose next = pose(s, t);
    const Separation by = separation(s, next, at_pose(h, next), h.kept);
    if (is_clear_between(s, h.kept, at.by, by.least, (t - at.t) * (1 + 0x1p-50))) {
      at = {t, by};
      room = beyond < to ? 0.9 * (beyond - t) : to - t;
      if (by.least <= goal) break;
    } else {
      // The chord's zero, or the step that would have been clear.
      const double cut = by.least < 0 ? at.by.least / (at.by.least - by.least) : 0.6;
      room = (t - at.t) * lane::min(0.95 * cut, 0.6);
      if (by.least < 0) beyond = t;
    }
  }
  return at;
}

enum class Outcome { missed, close };

/// The time up to which there is no contact, a direction that separates the shapes then, and the distance as the
/// library returns it, if it was asked.
struct Advanced {
  Outcome outcome;
  double t;
  Direction along;
};

/// From a point of the first to one of the second shape, of least distance; about the first centre.
struct Gap {
  PlaneVector a, b;
  double distance;
};

template <class Ask>
Gap gap_at(const Scene& s, const Pose& at, const Ask& ask) noexcept {
  ClosestPoints<double> c;
  ask.nearest(body_of(s.a, at.axis_a, {0, 0}), body_of(s.b, at.axis_b, at.offset), c);
  return {{c.ax, c.ay}, {c.bx, c.by}, c.distance};
}

/// Two points of boxes along the normal of a face: the vertex of the one that comes first, and the point of the face
/// nearest to it. Where edges are parallel there may be nearer ones.
inline Gap gap_at_face(const Scene& s, const Pose& at, const Heading& h) noexcept {
  const bool on_a = h.kept == Kept::with_a;
  const Turning &face = on_a ? s.a : s.b, &other = on_a ? s.b : s.a;
  const PlaneVector &u = on_a ? at.axis_a : at.axis_b, &w = on_a ? at.axis_b : at.axis_a;
  // About the face's centre; n leads out of the face.
  const PlaneVector n = on_a ? h.n : -h.n, offset = on_a ? at.offset : -at.offset;
  const double x = lane::flip_sign(other.hx, -dot(w, n)), y = lane::flip_sign(other.hy, -cross(w, n));
  const PlaneVector vertex = offset + support_minimum::out_of_frame(w, {x, y});
  const PlaneVector local = support_minimum::into_frame(u, vertex);
  const auto within = [](double c, double half) { return lane::max(lane::min(c, half), -half); };
  const PlaneVector nearest = support_minimum::out_of_frame(u, {within(local.x, face.hx), within(local.y, face.hy)});
  const PlaneVector way = vertex + -nearest;
  const double distance = lane::sqrt(dot(way, way));
  if (on_a) return {nearest, vertex, distance};
  return {at.offset + vertex, at.offset + nearest, distance};
}

/// The direction that separates best. `before` is the best one at an earlier time.
template <class Ask>
Direction best_direction(const Scene& s, const Pose& at, const Heading& before, const Ask& ask) noexcept {
  if (s.has_boxes()) return best_face(s, at);
  const PlaneVector n = at_pose(before, at);
  Direction best{{n, before.kept, before.in_frame}, separation(s, at, n, before.kept)};
  try_faces(s, at, best);
  const Gap gap = gap_at(s, at, ask);
  const PlaneVector way = gap.b + -gap.a;
  const double size = lane::max(lane::abs(way.x), lane::abs(way.y));
  if (size > 0) try_direction(s, at, support_minimum::unit_of_any(way), best);
  try_outline(s, at, s.a, at.axis_a, gap.a, best);
  try_outline(s, at, s.b, at.axis_b, gap.b + -at.offset, best);
  return best;
}

/// From w.from, where `best` is the direction that separates best.
template <class AnyScene, class Ask>
Advanced advance(const AnyScene& s, const Window& w, Direction best, double tolerance, const Ask& ask) noexcept {
  // Faces may give 0.7 of the distance. The gap that is returned in the end has errors on top.
  const double share = (s.has_boxes() ? 0.6 : 0.9) * tolerance;
  const double enough = lane::max(lane::min(share, tolerance - 5 * s.error), 0.25 * share);
  double t = w.from;
  int poses = 0;
  for (int i = 0; i < most_directions && poses < most_poses && best.by.least > enough; ++i) {
    const Reached reached = march(s, best.heading, {t, best.by}, 0.3 * enough, w.to, poses);
    if (reached.t >= w.to) return {Outcome::missed, 1, best};
    if (!(reached.t > t)) break;
    t = reached.t;
    best = best_direction(s, pose(s, t), best.heading, ask);
  }
  return {Outcome::close, t, best};
}

/// The distance of the shapes at t; of such as overlap less than 0, about their depth. Of boxes by the best face.
template <class Ask>
double signed_gap(const Scene& s, double t, const Ask& ask) noexcept {
  const Pose at = pose(s, t);
  if (s.has_boxes()) return best_face(s, at).by.least + s.error;
  const Gap gap = gap_at(s, at, ask);
  if (gap.distance > 0) return gap.distance;
  Penetration<double> p;
  ask.depth(body_of(s.a, at.axis_a, {0, 0}), body_of(s.b, at.axis_b, at.offset), p);
  return -p.depth;
}

inline double thickness(const Turning& s) noexcept { return lane::min(s.hx, s.hy) + s.radius; }

/// True if there surely is contact a little after t, where the gap is known: by secants, towards a depth that thin
/// shapes have too.
template <class AnyScene, class Ask>
bool surely_meet_after(const AnyScene& s, double t, double rate, double gap, const Ask& ask) noexcept {
  // The rate holds in one direction; at worst they come together as fast as they can.
  const double most = s.speed + lane::abs(s.a.spin) * s.a.reach + lane::abs(s.b.spin) * s.b.reach;
  const double error = 2 * s.error, deeper = lane::min(thickness(s.a) + thickness(s.b), gap) + 4 * error;
  double from = 0, step = (gap + deeper) / (rate < 0 ? -rate : most);
  for (int i = 0; i < 8 && from < 1 - t; ++i) {
    step = lane::min(step, 1 - t);
    const double next_gap = signed_gap(s, t + step, ask);
    if (next_gap < -error) return true;
    const double closing = (gap - next_gap) / (step - from);
    if (closing > 0) {
      const double more = (next_gap + deeper) / closing;
      from = step;
      gap = next_gap;
      step += lane::min(more, 8 * step);
    } else {
      step = 0.5 * (from + step);  // they parted again
    }
  }
  return false;
}

}  // namespace vesica::detail::impact_time
