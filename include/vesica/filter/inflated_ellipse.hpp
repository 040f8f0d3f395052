// SPDX-License-Identifier: Apache-2.0
/// Certain facts about an ellipse and a core with a radius, by polygons inside and around their arcs. Both shapes are
/// convex, so an arc is within a shape if its ends are, and the point where their tangents meet. If that point is not,
/// the arc is halved.
#pragma once

#include <vesica/filter/inflated.hpp>

namespace vesica::filter {

/// A point of the unit circle or outside it.
struct ArcPoint {
  double x, y;
};

/// Is an arc of the unit circle, of at most a quarter, mapped into a shape? 1 if it certainly is and clear of the
/// outline, -1 if it certainly is not, 0 if neither is certain. room(point) says how far inside the shape a point is
/// mapped; the arc's ends are inside.
template <class Room>
constexpr int arc_within(const Room& room, ArcPoint from, const ArcPoint& to) noexcept {
  constexpr int most_halvings = 12, most_steps = 40;
  ArcPoint ends[most_halvings + 1] = {to};
  int count = 1;
  for (int step = 0; step < most_steps; ++step) {
    const ArcPoint end = ends[count - 1], sum{from.x + end.x, from.y + end.y};
    const double k = 1 / (1 + (from.x * end.x + from.y * end.y));
    if (certainly_positive(room(ArcPoint{k * sum.x, k * sum.y}))) {
      from = end;
      if (--count == 0) return 1;
      continue;
    }
    if (count > most_halvings) return 0;
    const double norm = 1 / sqrt(sum.x * sum.x + sum.y * sum.y);
    const ArcPoint middle{norm * sum.x, norm * sum.y};
    const Estimate<double> inside = room(middle);
    if (!certainly_positive(inside)) return certainly_negative(inside) ? -1 : 0;
    ends[count++] = middle;
  }
  return 0;
}

/// arc_within() for a whole circle, of quarters whose ends may be outside.
template <class Room>
constexpr int circle_within(const Room& room) noexcept {
  constexpr ArcPoint ends[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  bool all = true;
  for (int k = 0; k < 4; ++k) {
    // Either end of the quarter: a core has a corner for each.
    for (int end = k; end <= k + 1; ++end) {
      const Estimate<double> inside = room(k, ends[end]);
      if (certainly_negative(inside)) return -1;
      all = all && certainly_positive(inside);
    }
  }
  for (int k = 0; k < 4 && all; ++k) {
    const int within = arc_within([&](const ArcPoint& p) { return room(k, p); }, ends[k], ends[k + 1]);
    if (within < 0) return -1;
    all = within > 0;
  }
  return all ? 1 : 0;
}

/// d leads from the box's centre to the ellipse's.
///
/// Proved: points that are mapped err by less than is allowed for, with axes of the unit circle's points off by 4u and
/// tangents' meeting points, at most sqrt(2) from the centre, by 8u.
///
///   - In the box's frame, with T = |kx| + |ky| + (hx + hy) U and W = (a + b) (|c| + |s|): k errs by 6u T, half axes
///     such as a c by 5u (a + b) |u||v|, products with the point's coordinates by 9u, their sum by 2u. In all less than
///     6u T + 30u W, for which 32u (T + W) is taken. Squares are as in least_square(), the reach as in Reached.
///   - In the ellipse's frame, with L = |x0| + |x1| + (hx + hy + 2 r / |u|) (|c| + |s|): x0, x1 err by 4u L, corners by
///     7u L as in box_out_of_ellipse(), r / |u| by 4u of itself and its products by 14u. 32u L is taken. (a b V)^2 errs
///     by 9u.
///   - The axis of a box may be off by 2u. So may normals at which arcs of a core begin: the sides between them reach
///     beyond its true sides but for 4u (hx + hy) |u|, which both bounds cover.
///
/// Guard: that of box_ellipse_usable(), a radius of at least 2^-80, and lengths of at most 2^200: no square overflows.
/// Without a radius, the box is asked. Not inlined: the code is long.
VESICA_CALLED constexpr CertainFacts<bool> ellipse_inflated_certain_facts(const Ellipse<double>& e,
                                                                          const Box<double>& box, double radius,
                                                                          const Centre<double>& d) noexcept {
  if (radius == 0) return box_ellipse_certain_facts(box, e, d).exchanged();
  const Verdict<bool> verdict = inflated_box_ellipse(box, radius, e, d);
  if (verdict.disjoint) return apart();
  if (!verdict.overlap) return {};

  const BoxFrame<double> f = box_frame(box, e, d);
  const double length = sqrt(f.uu), reach = radius / length, turned = abs(f.c) + abs(f.s);
  const double x0 = e.ux * d.x + e.uy * d.y, x1 = e.ux * d.y - e.uy * d.x;
  const double in_box = ((abs(f.kx) + abs(f.ky)) + (f.ex + f.ey)) + (e.a + e.b) * turned;
  const double in_ellipse = (abs(x0) + abs(x1)) + ((box.hx + box.hy) + 2 * reach) * turned;
  const double low = guard_power<double, -5>(), high = guard_power<double, 15>(), most = guard_power<double, 25>();
  const bool axes = in_range(f.uu, low, high) && in_range(f.vv, low, high);
  const bool sizes = at_least(guard_power<double, -10>(), e.a, e.b, radius) && at_least(0.0, box.hx, box.hy);
  if (!(axes && sizes && in_box <= most && in_ellipse <= most && radius <= most)) return {};

  const double reached = radius * radius * f.uu, box_error = roundoffs<double>(32) * in_box;
  const auto in_core = [&](int, const ArcPoint& p) -> Estimate<double> {
    const double x = positive_part(abs(f.kx + (p.x * f.ac - p.y * f.bs)) - f.ex),
                 y = positive_part(abs(f.ky + (p.x * f.as + p.y * f.bc)) - f.ey);
    return {reached - (x * x + y * y),
            (box_error + box_error) * ((x + y) + box_error) + roundoffs<double>(14) * reached};
  };
  const double root = e.a * e.b * f.vv, det = root * root, error = roundoffs<double>(32) * in_ellipse;
  const double error0 = e.b * error, error1 = e.a * error;
  const auto in_conic = [&](int quarter, const ArcPoint& p) -> Estimate<double> {
    const double along = (quarter == 0 || quarter == 3 ? box.hx : -box.hx) + reach * p.x,
                 across = (quarter < 2 ? box.hy : -box.hy) + reach * p.y;
    const double m0 = e.b * ((along * f.c + across * f.s) - x0), m1 = e.a * ((across * f.c - along * f.s) - x1);
    return {det - (m0 * m0 + m1 * m1),
            ((error0 + error0) * (abs(m0) + error0) + (error1 + error1) * (abs(m1) + error1)) +
                roundoffs<double>(16) * det};
  };
  const int inside = circle_within(in_core), contains = inside > 0 ? -1 : circle_within(in_conic);
  return {false, true, inside > 0, contains > 0, inside < 0 && contains < 0};
}

}  // namespace vesica::filter
