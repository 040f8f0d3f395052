// SPDX-License-Identifier: Apache-2.0
/// The places where outlines of two ellipses meet. The form of one along a quarter of the other's outline is a quartic,
/// formed exactly and rounded once to 370 bits; its zeros are found to 2^-96 of a turn. Mostly each is certainly one
/// zero at which the sign changes, so that their number is known. Otherwise exact signs decide the number, and how many
/// places only touch: zeros closer than 2^-95 may be one group with as many places as are missing.
#pragma once

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <vesica/crossings/census.hpp>
#include <vesica/crossings/estimate.hpp>
#include <vesica/crossings/quartic_zeros.hpp>

namespace vesica::detail::crossings {

using exact::Outline;

/// Twice the form of f along e: mean + c1 cos + s1 sin + c2 cos of twice the angle + s2 sin of that. Negative within f.
struct Harmonics {
  Fixed mean, c1, s1, c2, s2;

  /// P.Q = along across, factors that do not cancel. Twice the square of the radius is taken from what is about as
  /// great: from 2 |C|^2 if C is not well within the rim, else half of it from each of |P|^2 and |Q|^2, which it nearly
  /// is where outlines coincide.
  template <int Offset>
  VESICA_CALLED explicit Harmonics(const Outline<Offset>& o) noexcept {
    const exact::Number<4> none;
    const bool within = is_within(o);
    const exact::Number<4>&of_c = within ? none : o.radius, &of_axes = within ? o.radius : none;
    exact::Number<8> terms[5];
    {
      const exact::Number<8> pp = beyond_rim(o.p.x, o.p.y, of_axes), qq = beyond_rim(o.q.x, o.q.y, of_axes);
      terms[0] = pp + qq;
      terms[3] = pp - qq;
    }
    terms[0] = terms[0] + exact::integer(2) * beyond_rim(o.c.x, o.c.y, of_c);
    terms[1] = exact::integer(4) * dot(o.c, o.p);
    terms[2] = exact::integer(4) * dot(o.c, o.q);
    terms[4] = exact::integer(2) * (along(o) * across(o));
    std::int64_t top = std::numeric_limits<std::int64_t>::min();
    for (const auto& x : terms) {
      if (x.sign != 0) top = std::max(top, exact::detail::top_bit(x));
    }
    // Coefficients of the quartics are less than 72 times the greatest of them.
    top += 10;
    Fixed* const out[5] = {&mean, &c1, &s1, &c2, &s2};
    for (int i = 0; i < 5; ++i) *out[i] = fixed(terms[i], top);
  }

 private:
  template <int Offset>
  static exact::Number<4> along(const Outline<Offset>& o) noexcept {
    return o.e.a * o.e.b * o.dot;
  }
  template <int Offset>
  static exact::Number<4> across(const Outline<Offset>& o) noexcept {
    return (o.f.a - o.f.b) * (o.f.a + o.f.b) * o.cross;
  }
  /// True if C is within a quarter of the radius at least.
  template <int Offset>
  static bool is_within(const Outline<Offset>& o) noexcept {
    const auto is_less = [&o](const auto& x) {
      return x.sign == 0 || exact::detail::top_bit(x) + 2 < exact::detail::top_bit(o.radius);
    };
    return is_less(o.c.x) && is_less(o.c.y);
  }

 public:
  /// As of ellipses about one centre.
  bool repeat_after_half_a_turn() const noexcept { return c1.is_zero() && s1.is_zero(); }
  /// The outline begun a quarter later.
  void advance() noexcept {
    const Fixed old = c1;
    c1 = s1;
    s1 = -old;
    c2 = -c2;
    s2 = -s2;
  }
  /// Along the first quarter, times 6 (1 + t^2)^2, for the tangent t of half the angle.
  Quartic quarter() const noexcept {
    const auto twice = [](const Fixed& x) { return x + x; };
    const auto three_times = [](const Fixed& x) { return x + x + x; };
    const Fixed b0 = three_times(twice(mean + c1 + c2));
    return {{b0, b0 + three_times(s1 + twice(s2)), twice(twice(twice(mean)) + three_times(c1 + s1 + twice(s2))),
             three_times(twice(c1 + twice(mean - c2 + s1 + s2))), three_times(twice(twice(twice(mean - c2 + s1))))}};
  }
};

/// The zeros all around the outline.
inline Spots find_spots(Harmonics harmonics) noexcept {
  const bool repeats = harmonics.repeat_after_half_a_turn();
  Spots spots, opposite;
  for (int quarter = 0; quarter < (repeats ? 2 : 4); ++quarter) {
    ZeroSearch(harmonics.quarter(), quarter, spots, repeats ? &opposite : nullptr);
    harmonics.advance();
  }
  for (int i = 0; i < opposite.count; ++i) spots.add(opposite.spot[i]);
  return spots;
}

/// Spots next to each other, which are one.
struct Group {
  /// The sign of the form along e.
  struct Sign {
    bool negative, is_certain;
    bool differs(const Sign& other) const noexcept { return negative != other.negative; }
  };
  Real at;  ///< quarters of the outline, and within one the tangent of half the angle
  int most;
  double height;
  Sign before, after;
  bool is_one_if_odd;  ///< no more than one zero, if the sign changes
  int places = 0;

  bool is_odd() const noexcept { return before.differs(after); }
  bool is_surely_odd() const noexcept { return is_odd() && before.is_certain && after.is_certain; }
};

struct Groups {
  Group group[16];
  int count = 0;

  explicit Groups(const Spots& spots) noexcept {
    const auto next_to = [&spots](const Real& p, const Real& q) { return std::fabs(rounded(q - p)) < spots.shortest; };
    int first = 0;
    const int n = spots.count;
    if (n == 0) return;
    // The outline is closed: a group across its start begins with the last spots.
    const bool closed = next_to(spots.spot[n - 1].to - Real(4.0), spots.spot[0].from);
    const auto joined = [&](int i) {
      return i % n == 0 ? closed : next_to(spots.spot[i % n - 1].to, spots.spot[i % n].from);
    };
    while (first < n && joined(first)) ++first;
    if (first == n) first = 0;
    for (int i = first; i < first + n;) {
      int end = i + 1;
      while (end < first + n && joined(end)) ++end;
      add(spots, i, end);
      i = end;
    }
    join_signs();
  }

  int surely_odd() const noexcept {
    return static_cast<int>(std::count_if(group, group + count, [](const Group& g) { return g.is_surely_odd(); }));
  }
  /// How many zeros there are, if each is certainly a crossing of its own: where no group may hold more than one, or
  /// four hold one at least, which are all there can be.
  std::optional<int> certain_crossings() const noexcept {
    const auto is_crossing = [](const Group& g) { return g.is_surely_odd() && g.is_one_if_odd; };
    if (std::all_of(group, group + count, is_crossing)) return count;
    return surely_odd() == 4 ? std::optional<int>(4) : std::nullopt;
  }

 private:
  void add(const Spots& spots, int from, int end) noexcept {
    const Spot &p = spots.spot[from % spots.count], &q = spots.spot[(end - 1) % spots.count];
    // One spot, or two that meet where the sign is not known: with a zero at most in each, an odd number is one.
    const bool meet = end - from == 1 || (end - from == 2 && !p.is_certain_after);
    Group g{p.from,
            0,
            p.height,
            {p.negative_before, p.is_certain_before},
            {q.negative_after, q.is_certain_after},
            meet && p.most == 1 && q.most == 1};
    // A zero that is known exactly may lie where two spots join. The outline's start is one.
    if (end - from > 1) g.at = spots.spot[(from + (end - from) / 2) % spots.count].from;
    for (int i = from; i < end; ++i) {
      const Spot& s = spots.spot[i % spots.count];
      g.most = std::max(g.most, s.most);
      g.height = std::fmin(g.height, s.height);
      if (i > from && rounded(s.from) == 0) g.at = Real(0.0);
    }
    group[count++] = g;
  }
  /// From one group to the next there is no zero: the sign after the one is that before the other.
  void join_signs() noexcept {
    for (int i = 0; i < count; ++i) {
      Group::Sign &after = group[i].after, &before = group[(i + 1) % count].before;
      if (after.is_certain) before = after;
      if (before.is_certain) after = before;
    }
    for (Group* g = group; g != group + count; ++g) g->most += (g->most % 2 == 1) != g->is_odd() ? 1 : 0;
  }
};

/// As many places as the census says: an odd group has a crossing, a touch is where the quartic's extreme is nearest to
/// 0, and missing ones are crossings too close to be distinguished.
inline void share_out(Groups& groups, const Census& census) noexcept {
  int crossing = census.crossing, touching = census.touching;
  for (int i = 0; i < groups.count; ++i) {
    Group& g = groups.group[i];
    if (!g.is_odd() || crossing == 0) continue;
    g.places = 1;
    g.most -= 1;
    --crossing;
  }
  const auto flatter = [](const Group& g, const Group& h) {
    if ((g.most >= 2) != (h.most >= 2)) return g.most >= 2;
    return g.places != h.places ? g.places < h.places : g.height < h.height;
  };
  const auto flattest = [&]() -> Group& {
    return *std::min_element(groups.group, groups.group + groups.count, flatter);
  };
  for (; touching > 0; --touching) {
    Group& g = flattest();
    ++g.places;
    g.most -= 2;
  }
  for (; crossing > 0; crossing -= 2) {
    Group& g = flattest();
    g.places += crossing > 1 ? 2 : 1;
    g.most -= 2;
  }
}

/// Cosine and sine of an angle.
struct Direction {
  Real x, y;
  explicit Direction(const Real& at) noexcept {
    const int up = static_cast<int>(rounded(at)), quarter = at < Real(up) ? up - 1 : up;
    const Real t = at - Real(quarter), square = t * t, sum = Real(1.0) + square;
    const Real c = (Real(1.0) - square) / sum, s = (t + t) / sum;
    switch (quarter & 3) {
      case 0:
        x = c, y = s;
        break;
      case 1:
        x = -s, y = c;
        break;
      case 2:
        x = -c, y = -s;
        break;
      default:
        x = s, y = -c;
        break;
    }
  }
};

/// Computes the position along f of a place of e.
class AlongOther {
 public:
  template <int Offset>
  explicit AlongOther(const Outline<Offset>& o) noexcept {
    int top = std::numeric_limits<int>::min();
    const auto see = [&top](const auto& x) {
      if (x.sign != 0) top = std::max(top, static_cast<int>(exact::detail::top_bit(x)));
    };
    see(o.c.x), see(o.c.y), see(o.p.x), see(o.p.y), see(o.q.x), see(o.q.y);
    cx_ = two_doubles(o.c.x, top), cy_ = two_doubles(o.c.y, top);
    precise_ = top - static_cast<int>(exact::detail::top_bit(o.radius)) < 60;
    px_ = two_doubles(o.p.x, top), py_ = two_doubles(o.p.y, top);
    qx_ = two_doubles(o.q.x, top), qy_ = two_doubles(o.q.y, top);
  }
  /// To less than 2^-30 of a turn.
  bool is_precise() const noexcept { return precise_; }
  Real operator()(const Direction& d) const noexcept {
    return turn(cx_ + px_ * d.x + qx_ * d.y, cy_ + py_ * d.x + qy_ * d.y);
  }

 private:
  Real cx_, cy_, px_, py_, qx_, qy_;
  bool precise_;
};

/// Points of a stored outline, rounded about once; sizes and coordinates times 2^lift stay within the range.
class StoredOutline {
 public:
  explicit StoredOutline(const vesica::Circle<double>& s) noexcept
      : StoredOutline(vesica::Ellipse<double>{s.cx, s.cy, 1, 0, s.r, s.r}) {}
  explicit StoredOutline(const vesica::Ellipse<double>& s) noexcept {
    using arithmetic::exponent_of, arithmetic::scale;
    const int axis = exponent_of(std::fmax(std::fabs(s.ux), std::fabs(s.uy)));
    const int size = axis + exponent_of(std::fmax(s.a, s.b));
    const double coordinate = std::fmax(std::fabs(s.cx), std::fabs(s.cy));
    const int top = coordinate > 0 ? std::max(size, exponent_of(coordinate)) : size;
    lift_ = top > 1000 ? 1000 - top : top < -900 ? 64 : 0;
    cx_ = scale(s.cx, lift_);
    cy_ = scale(s.cy, lift_);
    ux_ = scale(s.ux, -axis);
    uy_ = scale(s.uy, -axis);
    a_ = scale(s.a, axis + lift_);
    b_ = scale(s.b, axis + lift_);
  }
  void point(const Direction& d, double& x, double& y) const noexcept {
    const Real along = Real(a_) * d.x, across = Real(b_) * d.y;
    const Real dx = Real(ux_) * along - Real(uy_) * across, dy = Real(uy_) * along + Real(ux_) * across;
    x = arithmetic::scale(rounded(Real(cx_) + dx), -lift_);
    y = arithmetic::scale(rounded(Real(cy_) + dy), -lift_);
  }

 private:
  double cx_, cy_, ux_, uy_, a_, b_;
  int lift_;
};

/// The position of a point along a circle about the origin: quarters, and within one the tangent of half the angle.
inline Real along_circle(const Real& x, const Real& y, const Real& radius) noexcept {
  const double at_x = rounded(x), at_y = rounded(y);
  if (at_x > 0 && at_y >= 0) return y / (radius + x);
  if (at_y > 0) return Real(1.0) - x / (radius + y);
  if (at_x < 0) return Real(2.0) - y / (radius - x);
  return Real(3.0) + x / (radius - y);
}

/// The place at which f's outline begins, if it is one of them, is the first along f. Others may be nearer to it than
/// roundings, as seen from f; along e places are distinct.
inline void mend_start(const exact::Ellipse& e, const exact::Ellipse& f, Found& found) noexcept {
  const auto z = exact::image(e, f.cx - e.cx + f.a * f.ux, f.cy - e.cy + f.a * f.uy);
  const auto radius = e.a * e.b * exact::dot(e.ux, e.uy, e.ux, e.uy);
  if (exact::side_of_rim(z.x, z.y, radius) != 0) return;
  const int unit = exact::rounded(radius).exponent;
  const Real start = along_circle(two_doubles(z.x, unit), two_doubles(z.y, unit), two_doubles(radius, unit));
  const auto off = [&start](const Place& p) {
    const Real way = abs(p.along_a - start);
    return rounded(way) > 2 ? Real(4.0) - way : way;
  };
  Place* const end = found.place + found.count;
  Place* const next =
      std::min_element(found.place, end, [&](const Place& p, const Place& q) { return off(p) < off(q); });
  if (next != end) next->begins_b();
}

/// Twice the form of f along e, and positions along f.
struct Prepared {
  Harmonics harmonics;
  AlongOther along_other;
};
/// Not inlined: the exact outline takes stack only here.
VESICA_CALLED inline Prepared prepared(const exact::Ellipse& e, const exact::Ellipse& f) noexcept {
  const Outline<> outline(e, f);
  return {Harmonics(outline), AlongOther(outline)};
}

/// The places along e, whose outline is `stored`, with where they are along f.
inline Found places(const exact::Ellipse& e, const StoredOutline& stored, const exact::Ellipse& f) noexcept {
  Found found;
  const Prepared pair = prepared(e, f);
  Groups groups(find_spots(pair.harmonics));
  const std::optional<int> crossings = groups.certain_crossings();
  const Census all = crossings ? Census{*crossings, 0, false} : census(e, f, groups.surely_odd() > 0);
  found.shared = all.equal;
  if (all.crossing + all.touching == 0) return found;
  assert(groups.count > 0);
  share_out(groups, all);
  for (int i = 0; i < groups.count; ++i) {
    const Group& g = groups.group[i];
    if (g.places == 0) continue;
    const Direction d(g.at);
    Place place{0, 0, g.at, pair.along_other(d)};
    stored.point(d, place.x, place.y);
    for (int k = 0; k < g.places; ++k) found.add(place);
  }
  if (!pair.along_other.is_precise() || found.is_near_start_of_b()) mend_start(e, f, found);
  return found;
}

/// One place where outlines meet, along e, whose outline is `stored`: the first crossing that is found; where there is
/// none, a touch, or what is left of a census. That is taken only then, and where it is not `known`. Returns false
/// where they do not meet or are the same; then it writes nothing.
inline bool any_place(const exact::Ellipse& e, const StoredOutline& stored, const exact::Ellipse& f, double& x,
                      double& y, const std::optional<Census>& known) noexcept {
  Harmonics harmonics = prepared(e, f).harmonics;
  Spots spots;
  spots.shortest = 0x1p-64;  // one place alone need only be right beyond its rounding
  for (int quarter = 0; quarter < 4; ++quarter) {
    const int before = spots.count;
    ZeroSearch(harmonics.quarter(), quarter, spots, nullptr);
    for (int i = before; i < spots.count; ++i) {
      const Spot& s = spots.spot[i];
      if (s.negative_before == s.negative_after) continue;
      stored.point(Direction(s.from), x, y);
      return true;
    }
    harmonics.advance();
  }
  const Census all = known ? *known : census(e, f);
  if (all.crossing + all.touching == 0) return false;
  Groups groups(spots);
  share_out(groups, all);
  const auto fewer = [](const Group& g, const Group& h) { return g.places < h.places; };
  stored.point(Direction(std::max_element(groups.group, groups.group + groups.count, fewer)->at), x, y);
  return true;
}

}  // namespace vesica::detail::crossings
