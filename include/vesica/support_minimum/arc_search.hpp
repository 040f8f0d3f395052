// SPDX-License-Identifier: Apache-2.0
/// The global minimum over all unit directions n of F(n) = h1(n) + sign h2(n) + n.e, where h1 and h2 are support
/// functions. The depth of an overlap (sign 1) and the distance between nested outlines (sign -1) are such minima.
///
/// The method is branch and bound over arcs of directions. As a function of the angle, F'' + F = radius1 + sign radius2
/// with the radii of curvature of the two outlines. The circle is cut at the axes of both shapes, and for sign -1 also
/// where the ratio of the radii is extreme: on each arc in between, the radii and their ratio are monotone. Between the
/// normals of its faces a box is a single corner, which goes into e. So the value and the first two derivatives of F at
/// the ends of an arc bound F on all of it (arc_bound.hpp), and so does its greatest slope. The arc with the least
/// bound is refined until no bound is below the least value met: by safeguarded Newton steps where F must be convex,
/// else by splitting the arc. Since h(-n) = h(n), only the half circle n.e <= 0 is searched.
///
/// Measured on nested and overlapping ellipses at aspects up to 1e6, including nearly equal, nearly concentric and
/// nearly osculating ones: 10 to 25 evaluations on average, 65 at most, never more than 6 arcs at a time, and 30 to 40
/// ns an evaluation; of needles at aspects up to 2^240 85 evaluations at most. The tests in boundary_distance/ and
/// depth/ fail if any of their pairs takes a quarter of the limit below.
///
/// Most pairs with ellipses do not come here: the cores for lanes (two_ellipses.hpp, box_ellipse.hpp) settle them
/// first.
#pragma once

#include <initializer_list>
#include <vesica/support_minimum/arc_bound.hpp>
#include <vesica/support_minimum/support.hpp>

namespace vesica::detail::support_minimum {

struct Objective {
  CentredShape first, second;
  double sign;  ///< 1, or -1
  PlaneVector e;
  double tolerance;  ///< F may be missed by this much: its own rounding
};

/// The minimum of F; `at` is F with the corners of boxes that are the furthest along `towards`. Along the normal of
/// a face two corners are as far: then `at.n` does not say which of them.
struct Minimum {
  Sample at;
  PlaneVector towards;
  int evaluations, most_arcs;
  bool settled;  ///< no limit was met
};

inline constexpr int evaluation_limit = 400;
inline constexpr int arc_limit = 24;
inline constexpr int polish_limit = 12;
/// Two values at the same minimum differ by their rounding, which is up to this many tolerances.
inline constexpr double polish_slack = 16;
/// A slope of up to this many tolerances, or a step of up to this angle, counts as none.
inline constexpr double level_slack = 4, level_turn = 0x1p-48;
/// F differs by less than 2^-68 along a shorter arc.
inline constexpr double least_depth_arc = 0x1p-72;

/// The corners of boxes that are the furthest along a direction, and e with these.
struct Corners {
  PlaneVector towards, e;
};

/// Between two samples.
struct Arc {
  Sample a, b;
  Corners corners;
  double bound;
};

class ArcSearch {
 public:
  explicit ArcSearch(const Objective& objective) noexcept : objective_(objective) {
    const bool centred = objective.e.x == 0 && objective.e.y == 0;
    away_ = centred ? PlaneVector{1, 0} : unit_of_any(-objective.e);
    const double of_offset = lane::abs(objective.e.x) + lane::abs(objective.e.y);
    steepest_ = steepest(objective.first) + steepest(objective.second) + of_offset;
  }

  Minimum run() noexcept {
    if (is_disc(objective_.first) && is_disc(objective_.second)) {
      complete(curved(away_), {away_, objective_.e});
      return minimum_;
    }
    cut_at_axes();
    if (objective_.sign < 0 && objective_.first.curved && objective_.second.curved) cut_at_extreme_ratios();
    start();
    refine();
    polish();
    const PlaneVector& n = minimum_.at.n;
    minimum_.towards = rule_now(corners_towards(n)) ? n : corners_.towards;
    return minimum_;
  }

  /// The least value of F between two directions that are less than a half turn apart, the first to the right of the
  /// second, where it is below a value that is known. The second shape is a point.
  Minimum run_between(const PlaneVector& from, const PlaneVector& to, double known) noexcept {
    minimum_.at.value = known;
    const CentredShape& s = objective_.first;
    PlaneVector cuts[4];
    int count = 0;
    for (const PlaneVector& n : {s.axis, perp(s.axis), -s.axis, -perp(s.axis)}) {
      if (!between(from, n, to)) continue;
      int i = count++;
      for (; i > 0 && cross(n, cuts[i - 1]) > 0; --i) cuts[i] = cuts[i - 1];
      cuts[i] = n;
    }
    cuts[count++] = to;
    const Corners corners{from, objective_.e};
    Sample a = sample(from, corners);
    for (int i = 0; i < count; ++i) {
      const Sample b = sample(cuts[i], corners);
      put({a, b, corners, 0});
      a = b;
    }
    refine();
    if (minimum_.at.value < known) {
      const Sample found = minimum_.at;
      approach();
      if (!between(from, minimum_.at.n, to)) minimum_.at = found;
    }
    return minimum_;
  }

 private:
  void refine() noexcept {
    while (arc_count_ > 0 && minimum_.settled) {
      const Arc arc = take_least();
      if (!may_improve(arc.bound)) break;
      if (curvature(arc.a, arc.b, objective_.sign).low > lane::max(arc.a.value, arc.b.value)) {
        descend(arc);
      } else {
        split(arc);
      }
    }
  }

  static bool is_disc(const CentredShape& s) noexcept { return s.curved && s.a == s.b; }

  bool may_improve(double bound) const noexcept { return bound < minimum_.at.value - objective_.tolerance; }

  /// Grows with the angle from -perp(away_) on, from 0 to 2 over the half circle, and is continuous at its ends.
  double place_of(const PlaneVector& n) const noexcept {
    const double up = lane::positive_part(dot(n, away_)), along = cross(n, away_), wide = lane::abs(along);
    return along > 0 ? up / (up + wide) : 1 + wide / (up + wide);
  }

  /// Puts a line's direction on the searched half circle among the cuts, which are in order of angle.
  void cut(const PlaneVector& line) noexcept {
    const PlaneVector n = dot(line, away_) < 0 ? -line : line;
    const double place = place_of(n);
    int i = cut_count_++;
    for (; i > 0 && place < places_[i - 1]; --i) {
      cuts_[i] = cuts_[i - 1];
      places_[i] = places_[i - 1];
    }
    cuts_[i] = n;
    places_[i] = place;
  }

  void cut_at_axes() noexcept {
    cut(objective_.first.axis);
    cut(perp(objective_.first.axis));
    cut(objective_.second.axis);
    cut(perp(objective_.second.axis));
  }

  /// The ratio of squared heights n.S1 n / n.S2 n is extreme where S1 n and S2 n are parallel. In the frame of the
  /// first shape S1 = diag(d, g) and S2 = (p, q; q, w): d q x^2 + (d w - g p) x y - g q y^2 = 0.
  void cut_at_extreme_ratios() noexcept {
    const CentredShape &f = objective_.first, &s = objective_.second;
    const PlaneVector r = into_frame(f.axis, s.axis);
    const double c = r.x * r.x, t = r.y * r.y, aa = s.a * s.a, bb = s.b * s.b, d = f.a * f.a, g = f.b * f.b;
    const double p = aa * c + bb * t, w = aa * t + bb * c, q = (s.a - s.b) * (s.a + s.b) * (r.x * r.y);
    const double k = d * w - g * p, l = 2 * (d * q), m = 2 * (g * q), root = lane::sqrt(k * k + l * m);
    const double sum = k < 0 ? k - root : k + root;
    cut_in_frame(sum, -l);
    cut_in_frame(m, sum);
  }
  void cut_in_frame(double x, double y) noexcept {
    if (x != 0 || y != 0) cut(out_of_frame(objective_.first.axis, unit_of_any({x, y})));
  }

  /// F without the corners of boxes and without e.
  Sample curved(const PlaneVector& n) noexcept {
    if (++minimum_.evaluations >= evaluation_limit) minimum_.settled = false;
    Sample s{n, 0, 0, 0, 0};
    if (objective_.first.curved) add(ellipse_support(objective_.first, n), 1, s, s.radius1);
    if (objective_.second.curved) add(ellipse_support(objective_.second, n), objective_.sign, s, s.radius2);
    return s;
  }
  static void add(const SupportValues& part, double sign, Sample& s, double& radius) noexcept {
    s.value += sign * part.height;
    s.slope += sign * part.slope;
    radius = part.radius;
  }

  static Sample with_offset(Sample s, const PlaneVector& e) noexcept {
    s.value += dot(s.n, e);
    s.slope += dot(perp(s.n), e);
    return s;
  }
  Sample evaluate(const PlaneVector& n, const PlaneVector& e) noexcept { return with_offset(curved(n), e); }

  /// Keeps the least value.
  Sample complete(const Sample& of_curved, const Corners& corners) noexcept {
    const Sample s = with_offset(of_curved, corners.e);
    if (s.value < minimum_.at.value) {
      minimum_.at = s;
      corners_ = corners;
    }
    return s;
  }
  Sample sample(const PlaneVector& n, const Corners& corners) noexcept { return complete(curved(n), corners); }

  Corners corners_towards(const PlaneVector& direction) const noexcept {
    PlaneVector e = objective_.e;
    if (!objective_.first.curved) e = e + corner(objective_.first, direction);
    if (!objective_.second.curved) e = e + objective_.sign * corner(objective_.second, direction);
    return {direction, e};
  }
  bool rule_now(const Corners& corners) const noexcept {
    return corners.e.x == corners_.e.x && corners.e.y == corners_.e.y;
  }

  void start() noexcept {
    Sample from = curved(-perp(away_)), last = from;
    last.n = perp(away_);
    for (int i = 0; i <= cut_count_; ++i) {
      const Sample to = i < cut_count_ ? curved(cuts_[i]) : last;
      const Corners corners = corners_towards(from.n + to.n);
      put({complete(from, corners), complete(to, corners), corners, 0});
      from = to;
    }
  }

  /// No slope of the shape's support function is greater.
  static double steepest(const CentredShape& s) noexcept { return s.curved ? lane::abs(s.a - s.b) : s.a + s.b; }

  /// The greater of two lower bounds. The one from the curvature says nothing if a needle turns on the arc. The
  /// other: from either end F falls by at most the greatest slope times the angle, so it is at least the mean of both
  /// ends less half of that for the whole arc; an angle up to a quarter turn is at most pi / 2 < 1.6 times its sine.
  double bound_on(const Sample& a, const Sample& b) const noexcept {
    const double by_slope = 0.5 * (a.value + b.value) - 0.8 * steepest_ * cross(a.n, b.n);
    return lane::max(lower_bound(a, b, curvature(a, b, objective_.sign)), by_slope);
  }

  void put(const Arc& arc) noexcept {
    const double bound = bound_on(arc.a, arc.b);
    if (!may_improve(bound)) return;
    if (arc_count_ == arc_limit) {
      minimum_.settled = false;
      return;
    }
    arcs_[arc_count_] = arc;
    arcs_[arc_count_++].bound = bound;
    if (arc_count_ > minimum_.most_arcs) minimum_.most_arcs = arc_count_;
  }

  Arc take_least() noexcept {
    int least = 0;
    for (int i = 1; i < arc_count_; ++i) least = arcs_[i].bound < arcs_[least].bound ? i : least;
    const Arc arc = arcs_[least];
    arcs_[least] = arcs_[--arc_count_];
    return arc;
  }

  static bool between(const PlaneVector& a, const PlaneVector& n, const PlaneVector& b) noexcept {
    return cross(a, n) > 0 && cross(n, b) > 0;
  }

  void split(const Arc& arc) noexcept {
    const PlaneVector n = middle(arc.a, arc.b);
    if (!between(arc.a.n, n, arc.b.n)) return;
    const Sample s = sample(n, arc.corners);
    put({arc.a, s, arc.corners, 0});
    put({s, arc.b, arc.corners, 0});
  }

  /// If the radius of curvature varies much along an arc, it is halved in its logarithm, else the angle.
  PlaneVector middle(const Sample& a, const Sample& b) const noexcept {
    const double ratio1 = ratio(a.radius1, b.radius1), ratio2 = ratio(a.radius2, b.radius2);
    const PlaneVector half = unit(a.n + b.n);
    if (lane::max(ratio1, ratio2) < 8) return half;
    const PlaneVector n = ratio1 < ratio2 ? mean_height(objective_.second, a.n, b.n, half)
                                          : mean_height(objective_.first, a.n, b.n, half);
    return between(a.n, n, b.n) ? n : half;
  }
  static double ratio(double x, double y) noexcept { return x > 0 && y > 0 ? lane::max(x, y) / lane::min(x, y) : 1; }
  /// The direction in the quadrant of `guide` whose squared height is the geometric mean of two others'.
  static PlaneVector mean_height(const CentredShape& s, const PlaneVector& a, const PlaneVector& b,
                                 const PlaneVector& guide) noexcept {
    const double square = ellipse_support(s, a).height * ellipse_support(s, b).height;
    const double d = s.a * s.a - square, g = square - s.b * s.b;
    const PlaneVector quadrant = into_frame(s.axis, guide);
    if (!(d * g > 0)) return guide;
    const double size = lane::max(lane::abs(d), lane::abs(g));
    const double x = lane::sqrt(lane::abs(g) / size), y = lane::sqrt(lane::abs(d) / size);
    return out_of_frame(s.axis, unit({lane::flip_sign(x, quadrant.x), lane::flip_sign(y, quadrant.y)}));
  }

  /// The minimum of the circle that F's value, slope and curvature describe: exact for circles, else Newton's step to
  /// first order. k = F'' > 0.
  static PlaneVector towards_minimum(const Sample& s, double k) noexcept {
    return unit(k * s.n + -(s.slope * perp(s.n)));
  }

  /// The one minimum of an arc on which F is convex: falling at a, rising at b. A step that would leave the arc, and
  /// every third that fails to halve it, splits it instead. Ends where a step would gain less than F's rounding. A
  /// depth has no points that a turn of a needle's normal might move: it ends where the arc is beneath any rounding.
  void descend(const Arc& arc) noexcept {
    Sample a = arc.a, b = arc.b, s = a.value < b.value ? a : b;
    double width = cross(a.n, b.n);
    int slow = 0;
    while (minimum_.settled) {
      const double k = bend(s);
      PlaneVector n = k > 0 ? towards_minimum(s, k) : s.n;
      const bool inside = between(a.n, n, b.n);
      const bool last = k > 0 && s.slope * (s.slope / k) < objective_.tolerance / 8;
      if (last && !inside) return;
      if (!inside || slow == 2) n = middle(a, b);
      if (!between(a.n, n, b.n)) return;
      slow = slow == 2 ? 0 : slow;
      s = sample(n, arc.corners);
      if (last || s.slope == 0) return;
      (s.slope < 0 ? a : b) = s;
      const double left = cross(a.n, b.n);
      slow = left > width / 2 ? slow + 1 : 0;
      width = left > width / 2 ? width : left;
      if (objective_.sign > 0 && left < least_depth_arc) return;
    }
  }

  /// The search ends where F is least up to rounding. The direction may then still be off by the square root of that.
  /// Further steps improve the closest points, wherever the slope is less in the end. A depth has none, and may be
  /// least at a kink: on a hill as flat as its rounding it may stay.
  void polish() noexcept {
    const Sample found = minimum_.at;
    const Corners ruled = corners_;
    approach();
    if (objective_.sign < 0 && !is_level(minimum_.at)) leave_hill();
    const bool flatter = lane::abs(minimum_.at.slope) <= lane::abs(found.slope);
    if (flatter && minimum_.at.value <= found.value + polish_slack * objective_.tolerance) return;
    minimum_.at = found;
    corners_ = ruled;
  }

  double bend(const Sample& s) const noexcept { return s.radius1 + objective_.sign * s.radius2 - s.value; }
  /// Up to rounding, which does not show in closest points (the slope is how far they are off at a right angle to the
  /// distance), or for a Newton step of a few last places of the direction.
  bool is_level(const Sample& s) const noexcept {
    return lane::abs(s.slope) <= lane::max(level_slack * objective_.tolerance, level_turn * bend(s));
  }

  /// If outlines nearly osculate, F is as flat as its rounding over a hill and the minimum beside it. The search may
  /// end on the hill or at its foot, where Newton's steps do not lead down, or far too far. Longer and longer steps
  /// down do, until the slope changes its sign; then that place is bisected.
  void leave_hill() noexcept {
    Sample from = minimum_.at, to = from;
    for (double step = 0x1p-28; to.slope * from.slope > 0 && step < 0.125; step *= 4) {
      const PlaneVector n = unit(to.n + lane::flip_sign(step, -from.slope) * perp(to.n));
      if (!rule_now(corners_towards(n))) return;
      from = to;
      to = evaluate(n, corners_.e);
    }
    while (!is_level(from) && !is_level(to) && lane::abs(cross(from.n, to.n)) > 0x1p-51) {
      const Sample middle = evaluate(unit(from.n + to.n), corners_.e);
      (middle.slope * from.slope > 0 ? from : to) = middle;
    }
    minimum_.at = lane::abs(from.slope) < lane::abs(to.slope) ? from : to;
  }

  /// Newton's steps, while each halves the slope. Where a thin shape's curvature changes faster than a step allows for,
  /// a quarter of the step is tried. Where a step leads to other corners of boxes, it starts again from these if they
  /// tie; else, and at a kink of the depth, which is a minimum itself, the steps end.
  void approach() noexcept {
    double damping = 1;
    for (int i = 0; i < polish_limit; ++i) {
      const Sample& s = minimum_.at;
      const double k = bend(s);
      if (!(k > 0) || s.slope == 0) return;
      const PlaneVector n = towards_minimum(s, damping * k);
      const Corners corners = corners_towards(n);
      if (!rule_now(corners)) {
        if (!exchange_corners(corners)) return;
        continue;
      }
      const Sample next = evaluate(n, corners_.e);
      const bool better = lane::abs(next.slope) <= lane::abs(s.slope) * (1 - 0.5 / damping);
      if (better && next.value <= s.value + polish_slack * objective_.tolerance) {
        minimum_.at = next;
        damping = 1;
      } else {
        damping *= 4;
      }
    }
  }

  /// If boxes' corners tie to within rounding, takes others at the same direction; not for the depth.
  bool exchange_corners(const Corners& corners) noexcept {
    if (objective_.sign > 0) return false;
    const Sample other = evaluate(minimum_.at.n, corners.e);
    if (other.value > minimum_.at.value + polish_slack * objective_.tolerance) return false;
    minimum_.at = other;
    corners_ = corners;
    return true;
  }

  const Objective& objective_;
  PlaneVector away_;
  double steepest_;
  PlaneVector cuts_[6];
  double places_[6];
  int cut_count_ = 0;
  Arc arcs_[arc_limit];
  int arc_count_ = 0;
  Minimum minimum_{{{1, 0}, 0x1p1000, 0, 0, 0}, {1, 0}, 0, 0, true};
  Corners corners_{{1, 0}, {0, 0}};  // at the minimum
};

/// Sizes and e must be at most about 2^20, the sizes of curved shapes at least 2^-250.
inline Minimum minimise(const Objective& objective) noexcept { return ArcSearch(objective).run(); }

}  // namespace vesica::detail::support_minimum
