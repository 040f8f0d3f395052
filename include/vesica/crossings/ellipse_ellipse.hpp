// SPDX-License-Identifier: Apache-2.0
/// Where the outlines of two ellipses meet. The form of one along a quarter of the other's outline is a quartic, formed
/// exactly and rounded once to 300 bits or more; its zeros are found to 2^-96 of a turn. Mostly each is certainly one
/// zero at which the sign changes, so that it is known how many there are. Else exact signs tell that, and how many
/// places only touch: zeros closer than 2^-95 may be one spot with as many places as are missing.
#pragma once

#include <algorithm>
#include <cassert>
#include <initializer_list>
#include <limits>
#include <optional>
#include <vesica/crossings/census.hpp>
#include <vesica/crossings/quartic_zeros.hpp>
#include <vesica/crossings/rough.hpp>

namespace vesica::detail::crossings {

using exact::Image, exact::Outline;

/// The first limbs of a number, so many or all.
template <int Degree>
exact::Number<Degree> first_limbs(const exact::Number<Degree>& x, int count) noexcept {
  if (x.size <= count) return x;
  exact::Number<Degree> out;
  out.sign = x.sign;
  out.low = x.low + (x.size - count);
  out.size = count;
  exact::detail::move_limbs(x.limb + (x.size - count), count, out.limb);
  out.strip();
  return out;
}
template <int Degree>
Image<Degree> first_limbs(const Image<Degree>& z, int count) noexcept {
  return {first_limbs(z.x, count), first_limbs(z.y, count)};
}

using BeyondRim = exact::BeyondRim<4, 4>;
inline BeyondRim first_limbs(BeyondRim z, int count) noexcept {
  z.less = first_limbs(z.less, count);
  z.more = first_limbs(z.more, count);
  z.other = first_limbs(z.other, count);
  return z;
}

/// What the form of f along e is made of. P.Q = along across, factors that do not cancel. Twice the square of the
/// radius is taken from what is about as great: from 2 |C|^2 if C is not well within the rim, else half of it from each
/// of |P|^2 and |Q|^2, which it nearly is where outlines coincide.
struct FormParts {
  Image<3> c;
  Image<4> p, q;
  exact::Number<4> along, across;
  BeyondRim beyond_c, beyond_p, beyond_q;

  /// Of so many leading limbs of each number.
  FormParts(const Outline& o, int limbs) noexcept : FormParts(o, limbs, is_within(o)) {}
  /// No product is as great as 2 to this power.
  std::int64_t top() const noexcept {
    std::int64_t top = std::numeric_limits<std::int64_t>::min();
    const auto see = [&top](const auto& a, const auto& b) {
      if (a.sign != 0 && b.sign != 0) top = std::max(top, exact::detail::top_bit(a) + exact::detail::top_bit(b));
    };
    for (const BeyondRim* z : {&beyond_c, &beyond_p, &beyond_q}) see(z->less, z->more), see(z->other, z->other);
    see(c.x, p.x), see(c.y, p.y), see(c.x, q.x), see(c.y, q.y);
    return top;
  }

 private:
  FormParts(const Outline& o, int limbs, bool within) noexcept
      : c(first_limbs(o.c, limbs)),
        p(first_limbs(o.p, limbs)),
        q(first_limbs(o.q, limbs)),
        along(o.e.a * o.e.b * first_limbs(o.dot, limbs)),
        across(first_limbs(o.f.a - o.f.b, limbs) * first_limbs(o.f.a + o.f.b, limbs) * first_limbs(o.cross, limbs)),
        beyond_c(first_limbs(BeyondRim(o.c.x, o.c.y, within ? exact::Number<4>() : o.radius), limbs)),
        beyond_p(first_limbs(BeyondRim(o.p.x, o.p.y, within ? o.radius : exact::Number<4>()), limbs)),
        beyond_q(first_limbs(BeyondRim(o.q.x, o.q.y, within ? o.radius : exact::Number<4>()), limbs)) {}

  /// Whether C is within a quarter of the radius at least.
  static bool is_within(const Outline& o) noexcept {
    const auto is_less = [&o](const exact::Number<3>& x) {
      return x.sign == 0 || exact::detail::top_bit(x) + 2 < exact::detail::top_bit(o.radius);
    };
    return is_less(o.c.x) && is_less(o.c.y);
  }
};

/// Twice the form of f along e: mean + c1 cos + s1 sin + c2 cos of twice the angle + s2 sin of that. Negative within f.
struct Harmonics {
  Fixed mean, c1, s1, c2, s2;

  explicit Harmonics(const Outline& outline) noexcept {
    // Numbers of very unlike exponents have many limbs, of which the first almost always do. 8 are right to 2^-448.
    if (!set(FormParts(outline, 8), true)) set(FormParts(outline, exact::Number<4>::capacity), false);
  }

 private:
  /// False where shortened numbers leave less than 320 bits.
  bool set(const FormParts& o, bool is_short) noexcept {
    const auto two = exact::integer(2), four = exact::integer(4);
    const exact::Number<8> pp = o.beyond_p.value(), qq = o.beyond_q.value();
    const exact::Number<8> exact_mean = two * o.beyond_c.value() + pp + qq, exact_c1 = four * dot(o.c, o.p),
                           exact_s1 = four * dot(o.c, o.q), exact_c2 = pp - qq, exact_s2 = two * (o.along * o.across);
    std::int64_t top = std::numeric_limits<std::int64_t>::min();
    for (const auto* x : {&exact_mean, &exact_c1, &exact_s1, &exact_c2, &exact_s2}) {
      if (x->sign != 0) top = std::max(top, exact::detail::top_bit(*x));
    }
    // Where outlines coincide there is neither a term nor a product, and both are the least number.
    if (is_short && top + 100 < o.top()) return false;
    // Coefficients of the quartics are less than 72 times the greatest of these.
    top += 10;
    mean = fixed(exact_mean, top);
    c1 = fixed(exact_c1, top);
    s1 = fixed(exact_s1, top);
    c2 = fixed(exact_c2, top);
    s2 = fixed(exact_s2, top);
    return true;
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
  /// Of the form along e.
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
    // Where spots meet may be a zero that is known exactly; a start is.
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
/// 0, and what is missing are crossings too close to be told apart.
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

/// Where a place of e is along f.
class AlongOther {
 public:
  explicit AlongOther(const Outline& o) noexcept {
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

/// Where a point of a circle about the origin is along it: quarters, and within one the tangent of half the angle.
inline Real along_circle(const Real& x, const Real& y, const Real& radius) noexcept {
  const double at_x = rounded(x), at_y = rounded(y);
  if (at_x > 0 && at_y >= 0) return y / (radius + x);
  if (at_y > 0) return Real(1.0) - x / (radius + y);
  if (at_x < 0) return Real(2.0) - y / (radius - x);
  return Real(3.0) + x / (radius - y);
}

/// The place at which f's outline begins, if it is one of them, is the first along f. Others may be nearer to it than
/// roundings, as seen from f; along e places are told apart.
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

/// The places along e, whose outline is `stored`, with where they are along f.
inline Found places(const exact::Ellipse& e, const StoredOutline& stored, const exact::Ellipse& f) noexcept {
  Found found;
  const Outline outline(e, f);
  Groups groups(find_spots(Harmonics(outline)));
  const std::optional<int> crossings = groups.certain_crossings();
  const Census all = crossings ? Census{*crossings, 0, false} : census(outline, groups.surely_odd() > 0);
  found.shared = all.equal;
  if (all.crossing + all.touching == 0) return found;
  assert(groups.count > 0);
  share_out(groups, all);
  const AlongOther along_other(outline);
  for (int i = 0; i < groups.count; ++i) {
    const Group& g = groups.group[i];
    if (g.places == 0) continue;
    const Direction d(g.at);
    Place place{0, 0, g.at, along_other(d)};
    stored.point(d, place.x, place.y);
    for (int k = 0; k < g.places; ++k) found.add(place);
  }
  if (!along_other.is_precise() || found.is_near_start_of_b()) mend_start(e, f, found);
  return found;
}

/// One place where outlines meet, along e, whose outline is `stored`: the first crossing that is found; where there is
/// none, a touch, or what is left of a census. That is taken only then, and where it is not `known`. Returns false
/// where they do not meet or are the same; then it writes nothing.
inline bool any_place(const exact::Ellipse& e, const StoredOutline& stored, const exact::Ellipse& f, double& x,
                      double& y, const std::optional<Census>& known) noexcept {
  const Outline outline(e, f);
  Harmonics harmonics(outline);
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
  const Census all = known ? *known : census(outline);
  if (all.crossing + all.touching == 0) return false;
  Groups groups(spots);
  share_out(groups, all);
  const auto fewer = [](const Group& g, const Group& h) { return g.places < h.places; };
  stored.point(Direction(std::max_element(groups.group, groups.group + groups.count, fewer)->at), x, y);
  return true;
}

}  // namespace vesica::detail::crossings
