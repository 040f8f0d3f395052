// SPDX-License-Identifier: Apache-2.0
/// The area that two rounded boxes share, or one of them and an ellipse. A rounded box is a box with a radius, as is
/// every other shape with an area. In the frame of one of the two, the outline of the other is clamped to the first. It
/// has edges and quarters of circles or of an ellipse. The shared area is the integral of -y dx along what is clamped.
///
/// Why so: no term depends on another one, so the outlines may coincide. A part of the outline is inside the frame's
/// shape, above it, below it or beside it. The clamped outline is continuous where parts are cut. So a cut that misses
/// its crossing changes the area only by the gap there times the distance missed.
#pragma once

#include <vesica/area/ellipse_ellipse.hpp>

namespace vesica::detail::area {

/// { s u + t perp(u) : |s| <= hx, |t| <= hy } and all points at most r away; u has length 1. Or the ellipse with these
/// half lengths.
template <class V>
struct RoundedBox {
  V ux, uy, hx, hy, r;
  bool is_oval = false;
};

/// The frame's shape: |x| <= hx, |y| <= hy with the radius r, which reaches to |x| = ex and |y| = ey.
template <class V>
struct RoundedFrame {
  V hx, hy, r, ex, ey;
};

/// Its upper outline as a function of x.
struct Profile {
  double hx, hy, r, ex, ey, half;

  template <class V>
  explicit Profile(const RoundedFrame<V>& f) noexcept
      : hx(rounded(f.hx)),
        hy(rounded(f.hy)),
        r(rounded(f.r)),
        ex(rounded(f.ex)),
        ey(rounded(f.ey)),
        half(ey * hx + (hy * r + pi_high / 4 * (r * r))) {}

  bool holds(const Vector<double>& p) const noexcept {
    const double x = max(std::fabs(p.x) - hx, 0.0), y = max(std::fabs(p.y) - hy, 0.0);
    return x * x + y * y <= r * r;
  }
  /// For |x| < ex.
  double height(double x) const noexcept {
    const double beyond = std::fabs(x) - hx, square = (r - beyond) * (r + beyond);
    return beyond <= 0 ? ey : square > 0 ? hy + std::sqrt(square) : hy;
  }
  /// The integral of the height from 0 to x, where x is clamped to the shape.
  double integral(double x) const noexcept {
    const double size = std::fabs(x), beyond = size - hx, square = (r - beyond) * (r + beyond);
    double area = half;
    if (beyond <= 0) {
      area = ey * size;
    } else if (size < ex && square > 0) {
      const double up = std::sqrt(square);
      area = ey * hx + (hy * beyond + 0.5 * (r * r * angle(beyond, up) + beyond * up));
    }
    return x < 0 ? -area : area;
  }
};

/// The integral of y dx along the clamped outline, part by part.
class Walk {
 public:
  explicit Walk(const Profile& profile) noexcept : profile_(profile) {}

  void inside(double more) noexcept {
    leave();
    sum_ += more;
  }
  /// A part above the shape, y > 0, or below it; all of it on one side, unless it is beside the shape.
  void outside(double x0, double x1, double y) noexcept {
    const double side = y < 0 ? -1 : 1;
    if (side != side_) {
      leave();
      side_ = side;
      from_ = x0;
    }
    to_ = x1;
  }
  double sum() noexcept {
    leave();
    return sum_;
  }

 private:
  void leave() noexcept {
    if (side_ != 0) sum_ += side_ * (profile_.integral(to_) - profile_.integral(from_));
    side_ = 0;
  }

  const Profile& profile_;
  double sum_ = 0, side_ = 0, from_ = 0, to_ = 0;
};

template <class V>
V lesser(const V& x, const V& y) noexcept {
  return y < x ? y : x;
}
template <class V>
V greater(const V& x, const V& y) noexcept {
  return x < y ? y : x;
}

/// The direction of two edges, with what both need of it.
template <class V>
struct EdgeDirection {
  Vector<V> e;
  V over_x, over_y, over_length;

  explicit EdgeDirection(const Vector<V>& edge) noexcept
      : e(edge), over_x(over(edge.x)), over_y(over(edge.y)), over_length(over(sqrt(dot(edge, edge)))) {}
  friend EdgeDirection reversed(const EdgeDirection& d) noexcept {
    EdgeDirection result = d;
    result.e = {-d.e.x, -d.e.y};
    result.over_x = -d.over_x;
    result.over_y = -d.over_y;
    return result;
  }
  static V over(const V& x) noexcept { return rounded(x) == 0 ? V(0.0) : V(1.0) / x; }
};

/// A part of a line, by its parameters.
template <class V>
struct Stretch {
  V from, to;

  /// |p + t e| <= reach
  static Stretch in_strip(const V& p, const V& over_e, const V& reach) noexcept {
    if (rounded(over_e) == 0) return abs(p) < reach ? Stretch{V(-0x1p600), V(0x1p600)} : Stretch{V(1.0), V(-1.0)};
    const V t0 = (-reach - p) * over_e, t1 = (reach - p) * over_e;
    return {lesser(t0, t1), greater(t0, t1)};
  }
  Stretch common(const Stretch& other) const noexcept { return {greater(from, other.from), lesser(to, other.to)}; }
  bool is_empty() const noexcept { return !(from < to); }
};

/// Where a line crosses the outline, given where it crosses the box around it (side -1 where it enters). In a corner it
/// meets the arc, or nothing at all: of the corner only the part outside the arc is outside.
template <class V>
bool at_corner(const RoundedFrame<V>& f, const Vector<V>& p, const EdgeDirection<V>& d, double side, V& t) noexcept {
  const V x = p.x + t * d.e.x, y = p.y + t * d.e.y;
  if (!(abs(x) > f.hx && abs(y) > f.hy)) return true;
  const Vector<V> m{p.x - (rounded(x) < 0 ? -f.hx : f.hx), p.y - (rounded(y) < 0 ? -f.hy : f.hy)};
  const V distance = cross(m, d.e) * d.over_length, room = (f.r - distance) * (f.r + distance);
  if (!(room > V(0.0))) return false;
  t = (sqrt(room) * side - dot(m, d.e) * d.over_length) * d.over_length;
  return true;
}

/// Adds an edge from p on. `within`: it begins and ends inside the shape.
template <class V>
void add_edge(const RoundedFrame<V>& f, const Profile& profile, const Vector<V>& p, const EdgeDirection<V>& d,
              bool within, Walk& walk) noexcept {
  const Vector<double> begin = rounded(p), end = rounded(p + d.e);
  if (within) return walk.inside(0.5 * (begin.y + end.y) * (end.x - begin.x));
  if (lesser(begin.y, end.y) >= profile.ey || greater(begin.y, end.y) <= -profile.ey)
    return walk.outside(begin.x, end.x, begin.y);
  if (rounded(d.over_x) == 0) return;
  const Stretch<V> wide = Stretch<V>::in_strip(p.x, d.over_x, f.ex), edge = wide.common({V(0.0), V(1.0)});
  if (edge.is_empty()) return;
  Stretch<V> inside = wide.common(Stretch<V>::in_strip(p.y, d.over_y, f.ey));
  const bool enters = !inside.is_empty() &&
                      (profile.r == 0 || (at_corner(f, p, d, -1, inside.from) && at_corner(f, p, d, 1, inside.to)));
  inside = inside.common(edge);
  // Before the line enters, or after it leaves, all of the edge is on one side.
  if (!enters || inside.is_empty()) inside = {edge.to, edge.to};
  const auto x = [&](const V& t) { return rounded(p.x + t * d.e.x); };
  const auto y = [&](const V& t) { return rounded(p.y + t * d.e.y); };
  const double enter = x(inside.from), leave = x(inside.to);
  if (edge.from < inside.from) walk.outside(x(edge.from), enter, y((edge.from + inside.from) * V(0.5)));
  if (inside.from < inside.to) walk.inside(0.5 * (y(inside.from) + y(inside.to)) * (leave - enter));
  if (inside.to < edge.to) walk.outside(leave, x(edge.to), y((inside.to + edge.to) * V(0.5)));
}

/// The quarter of an ellipse from centre + f0 to centre + f1: centre + x f0 + y f1 for x^2 + y^2 = 1, x, y >= 0.
template <class V>
struct Arc {
  Vector<V> centre, f0, f1;

  Vector<V> offset(const Vector<V>& at) const noexcept {
    return {at.x * f0.x + at.y * f1.x, at.x * f0.y + at.y * f1.y};
  }
  Vector<V> point(const Vector<V>& at) const noexcept { return centre + offset(at); }
};

/// Places on a quarter of the unit circle, ascending, the two ends among them.
template <class V>
struct ArcCuts {
  Vector<V> place[100];  // two for each line, and twenty for each pair of an arc and an ellipse
  int count = 2;

  ArcCuts() noexcept {
    place[0] = {V(1.0), V(0.0)};
    place[1] = {V(0.0), V(1.0)};
  }
  void add(const Vector<V>& p) noexcept {
    if (!(p.x > V(0.0) && p.y > V(0.0))) return;
    const V key = p.y - p.x;
    int i = count - 1;
    place[count++] = place[i];
    for (; i > 1 && key < place[i - 1].y - place[i - 1].x; --i) place[i] = place[i - 1];
    place[i] = p;
  }
  /// Where a x + b y = c.
  void add_line(const V& a, const V& b, const V& c) noexcept {
    if (!may_meet(a, b, c)) return;
    const V over = V(1.0) / sqrt(a * a + b * b), at = c * over;
    add_pair({a * over, b * over}, at, V(1.0), at, V(1.0));
  }
  /// Where the arc, whose radius is r, meets a circle about `d` from its centre. The places are found on the lesser
  /// circle: the line through them may be all but tangent to the other.
  void add_circle(const Arc<V>& arc, const V& r, const Vector<V>& d, const V& radius) noexcept {
    const V a = dot(d, arc.f0), b = dot(d, arc.f1), square = dot(d, d);
    if (!may_meet(a, b, ((r - radius) * (r + radius) + square) * V(0.5))) return;
    const V distance = sqrt(square), over = V(1.0) / (distance * r), half = V(0.5) / distance;
    const Vector<V> n{a * over, b * over};  // along d, in the frame of the arc
    const bool is_lesser = rounded(r) <= rounded(radius);
    const V own = is_lesser ? r : radius, other = is_lesser ? radius : r;
    const V along = ((distance - other) * (distance + other) + own * own) * half;
    add_pair(n, is_lesser ? along : distance - along, own, along, V(1.0) / r);
  }

 private:
  static bool may_meet(const V& a, const V& b, const V& c) noexcept {
    const V sum = a + b;
    return lesser(lesser(a, b), sum) < c && c < greater(greater(a, b), sum);
  }
  /// The two places at `at` along n that are the end points of a chord of a circle of radius r. Where circles all but
  /// touch, one place: it may be where an arc and a side of the outline join, of which each misses the crossing.
  void add_pair(const Vector<V>& n, const V& at, const V& r, const V& distance, const V& scale) noexcept {
    const V room = (r - distance) * (r + distance);
    if (!(room > V(0.0))) {
      if (room > r * r * V(-0x1p-10)) add(at > V(0.0) ? n : Vector<V>{-n.x, -n.y});
      return;
    }
    const V reach = sqrt(room) * scale, x = n.x * (at * scale), y = n.y * (at * scale);
    add({x - n.y * reach, y + n.x * reach});
    add({x + n.y * reach, y - n.x * reach});
  }
};

/// The arcs of both outlines are circles.
template <class V>
struct CircleArcs {
  V r;

  /// d: from the arc's centre to that of an arc of the frame's shape.
  void add_cuts(const RoundedFrame<V>& f, const Arc<V>& arc, const Vector<V>& d, ArcCuts<V>& cuts) const noexcept {
    cuts.add_circle(arc, r, d, f.r);
  }
  static constexpr bool finds_contact = true;
};

/// The arcs of one outline are circles, and the other outline is an ellipse, which may be the frame's unit disc.
template <class V>
struct MixedArcs {
  Oval<V> ellipse;
  V r;
  bool in_unit_disc;

  static constexpr bool finds_contact = false;

  void add_cuts(const RoundedFrame<V>& f, const Arc<V>& arc, const Vector<V>& d, ArcCuts<V>& cuts) const noexcept {
    if (is_apart(f, arc, d)) return;
    const Oval<V> circle{V(1.0), V(0.0), r, r};
    const V over_x = in_unit_disc ? V(1.0) / ellipse.a : V(1.0), over_y = in_unit_disc ? V(1.0) / ellipse.b : V(1.0);
    const Vector<V> apart = in_unit_disc ? Vector<V>{arc.centre.x * ellipse.a, arc.centre.y * ellipse.b} : d;
    // The lesser of the two is the unit disc, as for two ellipses.
    const bool on_circle = r * r < ellipse.a * ellipse.b;
    const Placed<V> p =
        on_circle ? placed(circle, ellipse, {-apart.x, -apart.y}) : placed(ellipse, circle, {apart.x, apart.y});
    const Vector<V> centre = on_circle == in_unit_disc ? Vector<V>{V(0.0), V(0.0)} : d;
    const Cuts all = area::cuts(p.against);
    for (int i = 0; i < all.count; ++i) {
      const V along(all.x[i]), height = sqrt((V(1.0) - along) * (V(1.0) + along));
      for (const double side : {-1.0, 1.0}) {
        const Vector<V> at = p.undone({along, height * side});
        const Vector<V> from_centre = on_circle ? Vector<V>{r * at.x, r * at.y} : on_ellipse(at);
        add(arc, centre + Vector<V>{from_centre.x * over_x, from_centre.y * over_y}, cuts);
      }
    }
  }

 private:
  /// True if the box about the arc's triangle does not meet that about the frame's circle.
  static bool is_apart(const RoundedFrame<V>& f, const Arc<V>& arc, const Vector<V>& d) noexcept {
    const auto beyond = [&](const V& a, const V& b, const V& at) {
      const V sum = a + b;
      return lesser(lesser(a, b), sum) > at + f.r || greater(greater(a, b), sum) < at - f.r;
    };
    return beyond(arc.f0.x, arc.f1.x, d.x) || beyond(arc.f0.y, arc.f1.y, d.y);
  }
  /// A point of the ellipse, from its centre.
  Vector<V> on_ellipse(const Vector<V>& at) const noexcept {
    const V x = at.x * ellipse.a, y = at.y * ellipse.b;
    return {ellipse.ux * x - ellipse.uy * y, ellipse.uy * x + ellipse.ux * y};
  }
  /// Adds a point, which is given from the arc's centre.
  static void add(const Arc<V>& arc, const Vector<V>& p, ArcCuts<V>& cuts) noexcept {
    const V x = cross(p, arc.f1), y = cross(arc.f0, p), length = sqrt(x * x + y * y);
    cuts.add({x / length, y / length});
  }
};

/// Where an arc may cross the outline, or pass its end.
template <class V, class Arcs>
void add_cuts(const RoundedFrame<V>& f, const Arc<V>& arc, const Arcs& arcs, ArcCuts<V>& cuts) noexcept {
  const bool is_wide = rounded(f.hx) > 0, is_high = rounded(f.hy) > 0;
  const auto add_lines = [&](bool upright, const V& reach) {
    for (const double side : {-1.0, 1.0}) {
      if (upright) {
        cuts.add_line(arc.f0.x, arc.f1.x, reach * side - arc.centre.x);
      } else {
        cuts.add_line(arc.f0.y, arc.f1.y, reach * side - arc.centre.y);
      }
    }
  };
  add_lines(true, f.ex);
  if (is_wide) add_lines(false, f.ey);
  if (rounded(f.r) == 0) return;
  if (!Arcs::finds_contact && is_wide) add_lines(true, f.hx);
  if (!Arcs::finds_contact && is_high) add_lines(false, f.hy);
  for (int i = is_wide ? -1 : 1; i <= 1; i += 2) {
    for (int j = is_high ? -1 : 1; j <= 1; j += 2) {
      arcs.add_cuts(f, arc, {f.hx * double(i) - arc.centre.x, f.hy * double(j) - arc.centre.y}, cuts);
    }
  }
}

/// How far a place is above the profile, or below it; `aside` if it is beside the shape.
struct Look {
  double gap, y;
  bool aside;

  template <class V>
  Look(const Profile& profile, const Arc<V>& arc, const Vector<V>& p, const Vector<V>& q, double share) noexcept {
    const Vector<V> sum{p.x * (1 - share) + q.x * share, p.y * (1 - share) + q.y * share};
    const V over = V(1.0) / sqrt(dot(sum, sum));
    const Vector<double> at = rounded(arc.point({sum.x * over, sum.y * over}));
    y = at.y;
    aside = !(std::fabs(at.x) < profile.ex);
    gap = aside ? 0 : std::fabs(y) - profile.height(at.x);
  }
};

/// Adds a part of an arc between two cuts.
template <class V>
void add_part(const Profile& profile, const Arc<V>& arc, const Vector<V>& p, const Vector<V>& q, Walk& walk) noexcept {
  Look look(profile, arc, p, q, 0.5);
  if (look.aside) return;
  if (std::fabs(look.gap) < 0x1p-20 * profile.ey) {
    // If outlines touch between two cuts, one look may find that very place.
    for (const double share : {0.1875, 0.84375}) {
      const Look other(profile, arc, p, q, share);
      if (!other.aside && std::fabs(other.gap) > std::fabs(look.gap)) look = other;
    }
  }
  const Vector<double> from = rounded(arc.point(p)), to = rounded(arc.point(q));
  if (look.gap > 0) return walk.outside(from.x, to.x, look.y);
  const Vector<double> chord = rounded(q - p), sum = rounded(q + p);
  const double segment = segment_area(dot(chord, chord), dot(sum, sum)) * rounded(cross(arc.f0, arc.f1));
  walk.inside(0.5 * (from.y + to.y) * (to.x - from.x) - segment);
}

/// Adds an arc. It lies in the triangle of its ends and where the tangents there meet.
template <class V, class Arcs>
void add_arc(const RoundedFrame<V>& f, const Profile& profile, const Arc<V>& arc, const Arcs& arcs, bool ends_within,
             Walk& walk) noexcept {
  const Vector<double> begin = rounded(arc.centre + arc.f0), end = rounded(arc.centre + arc.f1),
                       apex = rounded(arc.centre + arc.f0 + arc.f1);
  if (ends_within && profile.holds(apex)) {
    const double segment = (pi_high / 4 - 0.5) * rounded(cross(arc.f0, arc.f1));
    return walk.inside(0.5 * (begin.y + end.y) * (end.x - begin.x) - segment);
  }
  const auto least = [](double x, double y, double z) { return lesser(lesser(x, y), z); };
  if (least(begin.y, end.y, apex.y) >= profile.ey || least(-begin.y, -end.y, -apex.y) >= profile.ey)
    return walk.outside(begin.x, end.x, begin.y);
  if (least(begin.x, end.x, apex.x) >= profile.ex || least(-begin.x, -end.x, -apex.x) >= profile.ex) return;
  ArcCuts<V> cuts;
  add_cuts(f, arc, arcs, cuts);
  for (int i = 1; i < cuts.count; ++i) add_part(profile, arc, cuts.place[i - 1], cuts.place[i], walk);
}

/// The outline that is followed: its centre, the halves of its edges, and the half axes of its arcs, which may be 0.
template <class V>
struct RoundedOutline {
  Vector<V> centre, g0, g1, f0, f1;
};

template <class V, class Arcs>
double area_within(const RoundedFrame<V>& f, const RoundedOutline<V>& o, const Arcs& arcs) noexcept {
  const Profile profile(f);
  const V two(2.0);
  const Vector<V>&k = o.centre, &g0 = o.g0, &g1 = o.g1, none{V(0.0), V(0.0)};
  const Vector<V> corner[4] = {k + g0 + g1, k - g0 + g1, k - g0 - g1, k + g0 - g1};
  const Vector<V> radius[4] = {o.f0, o.f1, none - o.f0, none - o.f1};
  const EdgeDirection<V> along({two * g0.x, two * g0.y}), across({two * g1.x, two * g1.y});
  const EdgeDirection<V> edge[4] = {reversed(along), reversed(across), along, across};
  const bool has_arcs = rounded(cross(o.f0, o.f1)) > 0;
  bool within[8];
  for (int i = 0; i < 4; ++i) {
    within[2 * i] = profile.holds(rounded(corner[i] + radius[i]));
    within[2 * i + 1] = profile.holds(rounded(corner[i] + radius[(i + 1) % 4]));
  }
  Walk walk(profile);
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    const Arc<V> arc{corner[i], radius[i], radius[next]};
    if (has_arcs) add_arc(f, profile, arc, arcs, within[2 * i] && within[2 * i + 1], walk);
    if (rounded(edge[i].over_length) > 0)
      add_edge(f, profile, corner[i] + radius[next], edge[i], within[2 * i + 1] && within[2 * next], walk);
  }
  const double sum = walk.sum();
  return sum < 0 ? -sum : 0;
}

/// The area shared, d from a's centre to b's. a is the frame. At most one is an ellipse; as the frame it becomes the
/// unit disc.
template <class V>
double area_in_rounded_box(const RoundedBox<V>& a, const RoundedBox<V>& b, const filter::Centre<V>& d) noexcept {
  const V c = a.ux * b.ux + a.uy * b.uy, s = a.ux * b.uy - a.uy * b.ux, zero(0.0), one(1.0);
  const Vector<V> k{a.ux * d.x + a.uy * d.y, a.ux * d.y - a.uy * d.x};
  const Vector<V> g0{b.hx * c, b.hx * s}, g1{-(b.hy * s), b.hy * c}, f0{b.r * c, b.r * s}, f1{-f0.y, f0.x};
  const Vector<V> none{zero, zero};
  const RoundedFrame<V> f{a.hx, a.hy, a.r, a.hx + a.r, a.hy + a.r};
  if (b.is_oval) {
    return area_within(f, RoundedOutline<V>{k, none, none, g0, g1}, MixedArcs<V>{{c, s, b.hx, b.hy}, a.r, false});
  }
  const RoundedOutline<V> outline{k, g0, g1, f0, f1};
  if (!a.is_oval) return area_within(f, outline, CircleArcs<V>{b.r});
  const V over_x = one / a.hx, over_y = one / a.hy;
  const auto image = [&](const Vector<V>& p) { return Vector<V>{p.x * over_x, p.y * over_y}; };
  const double area = area_within(RoundedFrame<V>{zero, zero, one, one, one},
                                  RoundedOutline<V>{image(k), image(g0), image(g1), image(f0), image(f1)},
                                  MixedArcs<V>{{one, zero, a.hx, a.hy}, b.r, true});
  return area * (rounded(a.hx) * rounded(a.hy));
}

}  // namespace vesica::detail::area
