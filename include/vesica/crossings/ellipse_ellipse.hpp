// SPDX-License-Identifier: Apache-2.0
/// Where the outlines of two ellipses meet. The number of places, and how many of them only touch, is computed exactly.
/// Then that many places are searched for in double-doubles, along the outline of the lesser ellipse as the unit
/// circle.
#pragma once

#include <vesica/area/ellipse_ellipse.hpp>
#include <vesica/area/standard.hpp>
#include <vesica/check.hpp>
#include <vesica/crossings/box_ellipse.hpp>
#include <vesica/exact/ellipse_ellipse.hpp>

namespace vesica::detail::crossings {

/// Places at which the outlines cross, and at which they touch. Where they touch and cross at once (osculation) they
/// cross.
struct Census {
  int crossing, touching;
  bool equal;
};

/// With three equal roots of p, contact is of the highest order.
inline bool has_triple_root(const exact::ContactCubic& p) noexcept {
  return (exact::square(p.c2) - exact::integer(3) * (p.d2 * p.c1)).sign == 0;
}

/// With the double root x0 = -B / (2A) of p, whether S1 + x0 S2 has rank 1: d2 x0^2 + mu x0 + d1 = 0. Of nested
/// ellipses, these touch at two places. p'(x0) = c1 + 2 c2 x0 + 3 d2 x0^2 = 0 makes it (3 mu - 2 c2) x0 = c1 - 3 d1:
/// degree 24.
inline bool has_rank_one(const exact::ContactCubic& p) noexcept {
  const auto a = exact::square(p.c2) - exact::integer(3) * (p.d2 * p.c1);
  const auto b = p.c1 * p.c2 - exact::integer(9) * (p.d1 * p.d2);
  const exact::Number<8> left = exact::integer(2) * p.c2 - exact::integer(3) * p.mu;
  const exact::Number<8> right = exact::integer(2) * p.c1 - exact::integer(6) * p.d1;
  return exact::compare(left * b, right * a) == 0;
}

inline Census census(const exact::Ellipse& e, const exact::Ellipse& f) noexcept {
  const exact::ContactCubic p = exact::contact_cubic(e, f);
  const bool concentric = p.al.sign == 0;
  switch (exact::relation(e, f)) {
    case Relation::disjoint:
    case Relation::inside:
    case Relation::contains:
      return {0, 0, false};
    case Relation::equal:
      return {0, 0, true};
    case Relation::touch:
      return {0, 1, false};
    case Relation::inside_touch:
    case Relation::contains_touch:
      return {0, concentric || (!has_triple_root(p) && has_rank_one(p)) ? 2 : 1, false};
    case Relation::cross:
      break;
  }
  if (concentric) return {4, 0, false};
  const int roots = exact::discriminant_sign(p);
  if (roots < 0) return {2, 0, false};
  if (roots > 0) return {4, 0, false};
  return has_triple_root(p) ? Census{2, 0, false} : Census{2, 1, false};
}

using Real = detail::area::DoubleDouble;

/// The circle, cut where the other's quadratic form along it has an extreme, at most 4 such places, and at x = 1 and
/// x = -1; in order round the circle from x = 1.
struct Cut {
  double x, side;
  double value;  ///< the form less 1: outside the other positive, inside negative
  bool extreme;
};

struct UnitCircle {
  const detail::area::Against<Real>& f;
  Cut cut[12];
  int count = 0;

  void add(double x, double side, bool extreme) noexcept {
    const double value = detail::area::HalfCircle<Real>{f, side}.value(x);
    cut[count++] = {x, side, value, extreme};
  }
};

/// The place between two where the slope, monotone there, changes its sign, if it does.
inline void add_extreme(UnitCircle& circle, double side, double low, double high) noexcept {
  const detail::area::HalfCircle<Real> half{circle.f, side};
  double at_low = half.slope(low), at_high = half.slope(high);
  if (!(low < high) || (at_low < 0) == (at_high < 0)) return;
  double from = low, to = high;
  for (int i = 0; i < 200; ++i) {
    double x = to - at_high * ((to - from) / (at_high - at_low));
    if (i % 3 == 2 || !(x > from && x < to)) x = from + 0.5 * (to - from);
    if (!(x > from && x < to)) break;
    const double slope = half.slope(x);
    const bool before = (slope < 0) == (at_low < 0);
    (before ? from : to) = x;
    (before ? at_low : at_high) = slope;
  }
  circle.add(std::fabs(at_low) < std::fabs(at_high) ? from : to, side, true);
}

/// How the form changes along the circle at one of its points: its value less 1, and half its first and second
/// derivative by the angle.
struct Form {
  Real value, slope, bend;
  Form(const detail::area::Against<Real>& f, const Real& x, const Real& y) noexcept {
    const Real z0 = (x - f.x) * f.over_p, z1 = (y - f.y) * f.over_q, d0 = -(y * f.over_p), d1 = x * f.over_q;
    value = z0 * z0 + z1 * z1 - Real(1.0);
    slope = z0 * d0 + z1 * d1;
    bend = d0 * d0 + d1 * d1 - (z0 * x * f.over_p + z1 * y * f.over_q);
  }
};

/// Half the circle from x = 1 (upper) or from x = -1 (lower), in the parts between which the slope is monotone.
inline void add_half(UnitCircle& circle, double side) noexcept {
  const auto& f = circle.f;
  // An end is an extreme where the other's centre is on the line through both, or so near it that no x tells them
  // apart.
  const Form end(f, Real(side), Real(0.0));
  circle.add(side, side, std::fabs(rounded(end.slope)) <= 0x1p-24 * std::fabs(rounded(end.bend)));
  if (side < 0) {
    add_extreme(circle, side, -1, 1);
    return;
  }
  const double concave = detail::area::reach_of_concave(f), bend = concave > 0 ? concave : 1;
  add_extreme(circle, side, bend, 1);
  add_extreme(circle, side, -bend, bend);
  add_extreme(circle, side, -1, -bend);
}

/// A place on the circle, and how far the form rises or falls beside it. A crossing with a small change is doubtful; an
/// extreme with a small value may be a place where the outlines touch.
struct Candidate {
  double x, side, depth;
  bool extreme;
  int beside = 0;  ///< which of two crossings about an extreme it is, -1 or 1
};

struct Candidates {
  Candidate candidate[12];
  int count = 0;
  void add(const Candidate& c) noexcept {
    if (count < 12) candidate[count++] = c;
  }
  void sort_by_depth() noexcept {
    for (int i = 1; i < count; ++i) {
      const Candidate c = candidate[i];
      int k = i;
      for (; k > 0 && candidate[k - 1].depth > c.depth; --k) candidate[k] = candidate[k - 1];
      candidate[k] = c;
    }
  }
};

/// Sign changes between neighbouring cuts. A zero counts as outside, so that each crossing lies between two.
inline Candidates sign_changes(const UnitCircle& circle) noexcept {
  Candidates found;
  for (int i = 0; i < circle.count; ++i) {
    const Cut &p = circle.cut[i], &q = circle.cut[i + 1 == circle.count ? 0 : i + 1];
    if ((p.value < 0) == (q.value < 0)) continue;
    // A part that ends at x = 1 or x = -1 is on the half it begins on.
    const detail::area::HalfCircle<Real> half{circle.f, p.side};
    const Cut &low = p.x < q.x ? p : q, &high = p.x < q.x ? q : p;
    const double x = low.x < high.x ? detail::area::crossing(half, low.x, low.value, high.x, high.value) : low.x;
    found.add({x, p.side, std::fmin(std::fabs(p.value), std::fabs(q.value)), false});
  }
  found.sort_by_depth();
  return found;
}

inline Candidates extremes(const UnitCircle& circle) noexcept {
  Candidates found;
  for (int i = 0; i < circle.count; ++i) {
    const Cut& c = circle.cut[i];
    if (c.extreme) found.add({c.x, c.side, std::fabs(c.value), true});
  }
  found.sort_by_depth();
  return found;
}

/// As many places as the census says. Two crossings too close to show between extremes are both placed at an extreme.
/// Crossings that rounding makes beside a place where the outlines touch are recognised by the least change of the
/// form.
inline Candidates chosen(const UnitCircle& circle, const Census& census) noexcept {
  const Candidates crossing = sign_changes(circle), flat = extremes(circle);
  Candidates all;
  for (int i = 0; i < census.crossing && i < crossing.count; ++i) all.add(crossing.candidate[crossing.count - 1 - i]);
  for (int i = 0; all.count < census.crossing && flat.count > 0; ++i) {
    Candidate c = flat.candidate[i / 2 % flat.count];
    c.beside = i % 2 == 0 ? -1 : 1;
    all.add(c);
  }
  for (int i = 0; i < census.touching && flat.count > 0; ++i) all.add(flat.candidate[i % flat.count]);
  return all;
}

/// A point of the circle.
struct OnCircle {
  Real x, y;

  /// By the angle whose tangent is given, clockwise.
  void turn(const Real& tangent) noexcept {
    const Real length = sqrt(Real(1.0) + tangent * tangent), turned = (x + y * tangent) / length;
    y = (y - x * tangent) / length;
    x = turned;
  }
  /// Steps of Newton's method along the circle, to where the form is extreme or to where it is 1.
  void approach(const detail::area::Against<Real>& f, bool extreme) noexcept {
    for (int i = 0; i < 50; ++i) {
      const Form form(f, x, y);
      const Real step = extreme ? form.slope / form.bend : form.value / (Real(2.0) * form.slope);
      const double angle = std::fabs(rounded(step));
      if (!(angle < 0x1p-20)) break;
      turn(step);
      if (angle < 0x1p-60) break;
    }
  }
};

/// From x = 1 or x = -1 onto the half circle that a side has, by the form's parabola, where it has a root on each.
inline void leave_end(const detail::area::Against<Real>& f, double side, OnCircle& at) noexcept {
  const Form form(f, at.x, at.y);
  if ((rounded(form.value) < 0) == (rounded(form.bend) < 0) || rounded(form.value) == 0) return;
  const bool ahead = (side > 0) == (rounded(at.x) > 0), positive = rounded(form.bend) > 0;
  const Real root = sqrt(form.slope * form.slope - form.value * form.bend);
  at.turn((form.slope - (ahead == positive ? root : -root)) / form.bend);
}

/// Near x = 1 and x = -1 a double x determines y poorly, and two crossings may have the x of the extreme between them.
/// There they are placed by the roots of the form's parabola.
inline detail::area::Vector<double> point_of_circle(const detail::area::Against<Real>& f, const Candidate& c) noexcept {
  const Real x(c.x);
  OnCircle at{x, Real(c.side) * sqrt((Real(1.0) - x) * (Real(1.0) + x))};
  if (!c.extreme && rounded(at.y) == 0) leave_end(f, c.side, at);
  at.approach(f, c.extreme);
  if (c.beside != 0) {
    const Form form(f, at.x, at.y);
    const Real reach = sqrt(-form.value / form.bend);
    at.turn(c.beside < 0 ? -reach : reach);
    if (rounded(reach) > 0) at.approach(f, false);
  }
  return {rounded(at.x), rounded(at.y)};
}

/// From the frame of `placed` to the one in which e is the unit disc along its own axes.
inline detail::area::Vector<double> turned_back(const detail::area::Placed<Real>& p,
                                                const detail::area::Vector<double>& at) noexcept {
  const double s = p.exchange ? at.y : at.x, t = p.exchange ? at.x : at.y;
  const double x = rounded(p.x) < 0 ? -s : s, y = rounded(p.y) < 0 ? -t : t;
  const double cosine = rounded(p.cosine), sine = rounded(p.sine);
  return {cosine * x + sine * y, cosine * y - sine * x};
}

inline detail::area::Oval<double> stored(const vesica::Circle<double>& s) noexcept { return {1, 0, s.r, s.r}; }
inline detail::area::Oval<double> stored(const vesica::Ellipse<double>& s) noexcept { return {s.ux, s.uy, s.a, s.b}; }

/// For ellipses so thin or so different in size that their numbers leave the range of double. To rounding the lesser
/// one is then its longer axis, or even its centre.
inline void add_places_of_axis(const exact::Ellipse& e, const exact::Ellipse& f, int count, Found& found) noexcept {
  exact::Box axis = exact::as_box(e);
  (exact::compare(e.a, e.b) < 0 ? axis.hx : axis.hy) = {};
  const Found meeting = crossings(axis, f);
  const Place centre{nearest(e.cx), nearest(e.cy), 0, 0};
  for (int i = 0; found.count < count; ++i) {
    found.add(meeting.count == 0 ? centre : meeting.place[i / 2 % meeting.count]);
  }
}

/// e: the lesser. Places along e count as along_a.
template <class E, class F>
Found places(const E& e, const F& f, const Census& census) noexcept {
  Found found;
  found.shared = census.equal;
  if (census.crossing + census.touching == 0) return found;
  const auto pair = detail::area::standard_pair<Real>(e, f);
  const auto placed = detail::area::placed(detail::area::oval(pair.a), detail::area::oval(pair.b), pair.offset);
  UnitCircle circle{placed.against, {}, 0};
  add_half(circle, 1);
  add_half(circle, -1);
  const Candidates all = chosen(circle, census);
  const detail::area::Oval<double> own = stored(e);
  const filter::Centre<double> centre = filter::place(e);
  const auto other = [](const filter::Box<Real>& s) {
    return filter::Box<double>{rounded(s.ux), rounded(s.uy), rounded(s.hx), rounded(s.hy)};
  };
  const filter::Box<double> s = other(pair.a), t = other(pair.b);
  for (int i = 0; i < all.count; ++i) {
    const detail::area::Vector<double> k = turned_back(placed, point_of_circle(placed.against, all.candidate[i]));
    const double x = centre.x + (own.ux * (own.a * k.x) - own.uy * (own.b * k.y));
    const double y = centre.y + (own.uy * (own.a * k.x) + own.ux * (own.b * k.y));
    const double off_x = s.ux * (s.hx * k.x) - s.uy * (s.hy * k.y) - rounded(pair.offset.x);
    const double off_y = s.uy * (s.hx * k.x) + s.ux * (s.hy * k.y) - rounded(pair.offset.y);
    const double along = t.hy * (t.ux * off_x + t.uy * off_y), across = t.hx * (t.ux * off_y - t.uy * off_x);
    if (vesica::detail::all_finite(k.x, k.y)) found.add({x, y, turn(k.x, k.y), turn(along, across)});
  }
  const int count = census.crossing + census.touching;
  if (found.count < count) add_places_of_axis(exact::form(e), exact::form(f), count, found);
  return found;
}

}  // namespace vesica::detail::crossings
