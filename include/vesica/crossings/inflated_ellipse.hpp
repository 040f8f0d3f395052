// SPDX-License-Identifier: Apache-2.0
/// The places where outlines of an ellipse and a core with a radius meet: pieces as in inflated.hpp, each with the
/// ellipse.
///
/// Let d be a side's direction, n its normal, W = |d|^2, r the radius and P a corner. Images are seen in the frame
/// where the ellipse is a disc, m being that of P. At P + (x d + y n) / W the ellipse's form, times W, is
///   W rim + 2 (x m.d + y m.n) + (x^2 d.d + 2 x y d.n + y^2 n.n) / W,   rim = m.m - radius^2.
/// An edge has y = r sqrt(W), so that it is a quadratic in x / sqrt(W), and all signs are those of a + b sqrt(W).
///
/// An arc has x^2 + y^2 = r^2 W. With the tangent t of half the angle from n towards d the form times (1 + t^2)^2 is
/// c0 + c1 t + c2 t^2 + c3 t^3 + c4 t^4. Places of the whole circle are found as those of two ellipses. Where one is
/// near an end of the arc, exact counts say which are on the arc.
///
/// Proved: how many zeros have t > 0, counted with multiplicity, follows from signs of c0 ... c4, from how many of all
/// four are real, and from the sign of c3^2 c0 - c1^2 c4. These are of degree 24 at most.
///
///   - Zeros at t = 0 and infinity are the first and the last coefficients that vanish. The others are left.
///   - If all are real, Descartes' rule is exact.
///   - If one is, it has the sign of minus the product of both end coefficients.
///   - If two are, and these coefficients have unlike signs, so have the zeros. Otherwise scale t so that c0 = c4 = 1.
///     Zeros p and q of one sign and a pair of absolute square 1 / (p q) with the real part z have, with m = p q,
///       c1 + c3 = -(1 + m) ((p + q) / m + 2 z).
///     For p, q > 0 this is negative: p + q >= 2 sqrt(m) and z >= -1 / sqrt(m), with equality of both only where all
///     four are real. So c3 sqrt(c0) + c1 sqrt(c4) has the opposite sign of p and q.
///   - The same holds where the pair is a double zero beyond 0 from two simple ones.
///
/// Proved: a quarter of the circle has n0 zeros, known from those of both half circles that share it and from whether
/// the form changes its sign along it. Let n1, n2, n3 be those of the other quarters in order.
///
///   - The half circles give n0 + n1 and n3 + n0, so n0 is known up to 2 s. Two values need n1 >= 2 and n3 >= 2, and
///     then there are four zeros: 0, 2, 0, 2 or 2, 0, 2, 0.
///   - Where the zeros are at angles a from the quarter's start, the form's slope over the form there is
///     -1/2 sum cot(a / 2). Angles in the first quarter have cotangents above 1, in the third above -1; in the second
///     below 1, in the fourth below -1. So the slope's sign decides.
///
/// Proved: outlines of a rounded rectangle and an ellipse meet in at most 12 places, and of a capsule in at most 8. Let
/// f = h_a - h_b be the difference of support functions, and g = f + f''. As in inflated.hpp places are zeros of f, and
/// a touch counts as two.
///
///   - g is the ellipse's radius of curvature less r, which has four zeros at most, less a point mass at each side's
///     normal. Each mass adds two changes of sign: 12 with four sides, 8 with two.
///   - Between zeros less than pi apart, g has a value of the sign opposite to that of f. So f has no more zeros than
///     changes of sign of g, unless two zeros are pi or more apart. Then the others lie in the other half turn with two
///     masses at most, or with three at its ends, and f has two zeros more at most than there are changes: 10, or 8.
#pragma once

#include <vesica/crossings/ellipse_ellipse.hpp>
#include <vesica/crossings/inflated.hpp>

namespace vesica::detail::crossings {

/// From an ellipse's centre to a corner.
inline Offset offset(const RoundOutline& k, int i, const exact::Ellipse& e) noexcept {
  return {k.corners.x[i] - e.cx, k.corners.y[i] - e.cy};
}
inline exact::Image<3> image(const exact::Ellipse& e, const Side& s) noexcept { return exact::image(e, s.x, s.y); }
inline exact::Number<4> radius_of_disc(const exact::Ellipse& e) noexcept {
  return e.a * e.b * exact::dot(e.ux, e.uy, e.ux, e.uy);
}

/// W rim. Not inlined, as are others below: a call has little stack.
VESICA_CALLED inline exact::Number<10> rim_times_square(const RoundOutline& k, const exact::Image<4>& m,
                                                        const exact::Ellipse& e) noexcept {
  return k.unit.square * exact::beyond_rim(m.x, m.y, radius_of_disc(e));
}

/// The form at an end of an edge, over a positive factor.
VESICA_CALLED inline Estimate form_at_end(const RoundOutline& k, int corner, const Side& d,
                                          const exact::Ellipse& e) noexcept {
  const Offset p = offset(k, corner, e);
  const auto m = exact::image(e, p.x, p.y);
  const auto across = image(e, d.normal());
  const exact::Number<10> rest = rim_times_square(k, m, e) + exact::square(k.radius) * dot(across, across);
  return root_sum(rest, exact::integer(2) * (k.radius * dot(m, across)), k.unit);
}
/// Half its slope along the edge there, likewise.
VESICA_CALLED inline Estimate slope_at_end(const RoundOutline& k, int corner, const Side& d,
                                           const exact::Ellipse& e) noexcept {
  const Offset p = offset(k, corner, e);
  const auto along = image(e, d);
  return root_sum(k.radius * dot(along, image(e, d.normal())), dot(exact::image(e, p.x, p.y), along), k.unit);
}

/// The line of an edge and an ellipse: the image of the edge's direction, how far the line is from the centre along its
/// normal, and the square of half the chord; all over positive factors.
struct LineAndEllipse {
  Estimate x, y, square, off, room;

  VESICA_CALLED LineAndEllipse(const RoundOutline& k, int i, const exact::Ellipse& e) noexcept {
    const Side d = k.side(i);
    const auto along = image(e, d);
    const auto through = dot(d.normal(), offset(k, i, e));
    const auto length = dot(along, along);
    x = Estimate(along.x);
    y = Estimate(along.y);
    square = Estimate(length);
    off = root_sum(through, k.radius, k.unit);
    room = root_sum(length - exact::square(through) - exact::square(k.radius) * k.unit.square,
                    exact::integer(-2) * (k.radius * through), k.unit);
  }
  /// The position along the ellipse of an end of the chord, or of its middle.
  Real along_ellipse(int end) const noexcept {
    const Estimate none, half = end == 0 ? none : end < 0 ? -root(room) : root(room);
    return turn_of(half * x + off * y, half * y - off * x);
  }
};

/// An edge and an ellipse. Along the edge the form is square s^2 + 2 slope s + value.
inline void cross_edge_and_ellipse(const RoundOutline& k, int i, const exact::Ellipse& e, Found& found) noexcept {
  const Side d = k.side(i), n = d.normal();
  const Estimate value = form_at_end(k, i, d, e);
  const int start = value.sign(), end = form_at_end(k, k.next(i), d, e).sign();
  if (start <= 0 && end <= 0) return;
  const Estimate slope = slope_at_end(k, i, d, e);
  const int falls = -slope.sign(), rises = slope_at_end(k, k.next(i), d, e).sign();
  if ((start == 0 && falls <= 0) || (end == 0 && rises <= 0)) return;
  const bool both_outside = start > 0 && end > 0;
  if (both_outside && !(falls > 0 && rises > 0)) return;
  const LineAndEllipse line(k, i, e);
  if (line.room.sign() < 0 || (line.room.sign() == 0 && !both_outside)) return;
  const Offset whole = offset(k, k.next(i), k, i);
  const Estimate &unit = k.unit.estimate, length = Estimate(dot(d, whole)) / unit;
  const auto add = [&](const Estimate& s, int side) {
    const Estimate out(k.radius);
    found.add({to_double(Estimate(k.corners.x[i]) + (s * Estimate(d.x) + out * Estimate(n.x)) / unit),
               to_double(Estimate(k.corners.y[i]) + (s * Estimate(d.y) + out * Estimate(n.y)) / unit),
               RoundOutline::on_edge(i, to_double(s / length)), line.along_ellipse(side)});
  };
  if (line.room.sign() == 0) return add(-slope / line.square, 0);
  const bool slopes_up = slope.sign() > 0;
  const Estimate half = Estimate(radius_of_disc(e)) * unit * root(line.room);
  const Estimate both = (slopes_up ? slope : -slope) + half;
  const Estimate larger = both / line.square, lesser = value / both;
  if (start > 0) add(slopes_up ? -larger : lesser, -1);
  if (end > 0) add(slopes_up ? -lesser : larger, 1);
}

/// The form along the circle about a corner, as the numbers that its coefficients are sums of; over positive factors,
///   c0, c4 = ends +- out sqrt(W),  c1, c3 = 4 r (along sqrt(W) +- turned),  c2 = 2 middle.
struct FormAlongCircle {
  exact::Number<10> ends, middle;
  exact::Number<8> out;
  exact::Number<7> turned, along;

  FormAlongCircle(const RoundOutline& k, int corner, const Side& d, const exact::Ellipse& e) noexcept {
    set_rim(k, corner, e);
    set_rest(k, corner, d, e);
  }

 private:
  VESICA_CALLED void set_rim(const RoundOutline& k, int corner, const exact::Ellipse& e) noexcept {
    const Offset p = offset(k, corner, e);
    middle = rim_times_square(k, exact::image(e, p.x, p.y), e);
  }
  VESICA_CALLED void set_rest(const RoundOutline& k, int corner, const Side& d, const exact::Ellipse& e) noexcept {
    const Offset p = offset(k, corner, e);
    const auto m = exact::image(e, p.x, p.y);
    const auto x = image(e, d), y = image(e, d.normal());
    const auto xx = exact::square(k.radius) * dot(x, x), yy = exact::square(k.radius) * dot(y, y);
    ends = middle + yy;
    middle = middle + exact::integer(2) * xx - yy;
    out = exact::integer(2) * (k.radius * dot(m, y));
    turned = k.radius * dot(x, y);
    along = dot(m, x);
  }
};

/// True if estimates show that the form has one sign along an arc: on a quarter in Bernstein form.
VESICA_CALLED inline bool surely_misses(const RoundOutline& k, int i, const exact::Ellipse& e) noexcept {
  const FormAlongCircle form(k, i, k.side(k.before(i)), e);
  const Estimate &unit = k.unit.estimate, ends(form.ends), out = Estimate(form.out) * unit;
  const Estimate along = Estimate(form.along) * unit, turned(form.turned), four = times(4, Estimate(k.radius));
  Estimate c[5] = {ends + out, four * (along + turned), times(2, Estimate(form.middle)), four * (along - turned),
                   ends - out};
  if (k.corners.count == 4) {
    constexpr double parts[5][5] = {
        {12, 0, 0, 0, 0}, {12, 3, 0, 0, 0}, {12, 6, 2, 0, 0}, {12, 9, 6, 3, 0}, {1, 1, 1, 1, 1}};
    Estimate sums[5];
    for (int j = 0; j < 5; ++j) {
      for (int l = 0; l < 5; ++l) sums[j] = sums[j] + times(parts[j][l], c[l]);
    }
    std::copy(sums, sums + 5, c);
  }
  return std::all_of(c, c + 5,
                     [&c](const Estimate& x) { return x.sign_is_known() && x.sign() != 0 && x.sign() == c[0].sign(); });
}

/// The signs of the coefficients along a circle, from the normal of a side on.
struct SignsAlongCircle {
  int c[5];

  VESICA_COLD SignsAlongCircle(const RoundOutline& k, int corner, const Side& d, const exact::Ellipse& e) noexcept {
    const FormAlongCircle form(k, corner, d, e);
    c[0] = root_sum(form.ends, form.out, k.unit).sign();
    c[1] = root_sum(form.turned, form.along, k.unit).sign();
    c[2] = form.middle.sign;
    c[3] = root_sum(-form.turned, form.along, k.unit).sign();
    c[4] = root_sum(form.ends, -form.out, k.unit).sign();
  }
  /// How many zeros are exactly at the start and half a turn on.
  int at_start() const noexcept {
    int n = 0;
    while (n < 4 && c[n] == 0) ++n;
    return n;
  }
  int at_end() const noexcept {
    int n = 0;
    while (n < 4 && c[4 - n] == 0) ++n;
    return n;
  }
  int after_start() const noexcept { return c[at_start()]; }
  int before_end() const noexcept { return c[4 - at_end()]; }
  int changes() const noexcept {
    int n = 0, last = 0;
    for (const int sign : c) {
      n += sign * last < 0 ? 1 : 0;
      last = sign != 0 ? sign : last;
    }
    return n;
  }
};

/// The sign of c3^2 c0 - c1^2 c4.
VESICA_COLD inline int tilt(const RoundOutline& k, const FormAlongCircle& form) noexcept {
  const auto squares =
      exact::detail::sum_of_products(k.unit.square * form.along, form.along, 1, form.turned, form.turned);
  return exact::compare_products(form.out, squares, exact::integer(2) * (form.turned * form.along), form.ends);
}
VESICA_COLD inline int tilt(const RoundOutline& k, int corner, const Side& d, const exact::Ellipse& e) noexcept {
  return tilt(k, FormAlongCircle(k, corner, d, e));
}

/// Zeros along the half circle from the normal of a side on, counted with multiplicity; `zeros` are real in all.
struct HalfCircle {
  const RoundOutline& k;
  int corner;
  Side d;
  const exact::Ellipse& e;
  SignsAlongCircle sign;
  int ahead;

  HalfCircle(const RoundOutline& outline, int i, const Side& side, const exact::Ellipse& ellipse, int zeros) noexcept
      : k(outline), corner(i), d(side), e(ellipse), sign(k, corner, d, e) {
    const int others = 4 - sign.at_start() - sign.at_end(), real = others - (4 - zeros);
    if (real == others) {
      ahead = sign.changes();
    } else if (real < 2 || sign.c[0] != sign.c[4]) {
      ahead = real > 0 && sign.after_start() != sign.before_end() ? 1 : 0;
    } else {
      ahead = pair_is_ahead() ? 2 : 0;
    }
  }
  /// True if two zeros are ahead: two real ones on one side, and two complex ones, or a double one on the other side.
  bool pair_is_ahead() const noexcept {
    const int c1 = sign.c[0] * sign.c[1], c3 = sign.c[0] * sign.c[3];
    return c1 * c3 >= 0 ? c1 + c3 < 0 : sign.c[0] * c3 * tilt(k, corner, d, e) < 0;
  }
};

/// The places where the circle about a corner meets an ellipse, and how many zeros these are.
struct CircleCensus {
  int places, zeros;
  bool has_pair_and_touch;  ///< two simple zeros and a double one

  /// The places of this many of the zeros. `has_pair`: the simple ones are among them, if they are two.
  template <class HasPair>
  int places_of(int n, const HasPair& has_pair) const noexcept {
    if (n == zeros) return places;
    if (places == zeros) return n;
    if (has_pair_and_touch && (n == 3 || (n == 2 && has_pair()))) return 2;
    return n > 0 ? 1 : 0;
  }
};

/// How many places are at the ends of an arc and between them.
struct ArcCounts {
  int begin, inside, end;
};
VESICA_COLD inline ArcCounts counts_on_half(const RoundOutline& k, int i, const exact::Ellipse& e,
                                            const CircleCensus& all) noexcept {
  const HalfCircle half(k, i, k.side(k.before(i)), e, all.zeros);
  const int begin = half.sign.at_start(), end = half.sign.at_end();
  const auto has_pair = [&] { return begin == 2 || end == 2 || (begin + end == 0 && half.pair_is_ahead()); };
  return {begin > 0 ? 1 : 0, all.places_of(half.ahead, has_pair), end > 0 ? 1 : 0};
}
VESICA_COLD inline ArcCounts counts_on_quarter(const RoundOutline& k, int i, const exact::Ellipse& e,
                                               const CircleCensus& all) noexcept {
  const Side& d = k.side(k.before(i));
  // One from the arc's begin on, the other to its end.
  const HalfCircle from(k, i, d, e, all.zeros), to(k, i, d.normal(), e, all.zeros);
  const int begin = from.sign.at_start(), end = to.sign.at_end();
  const int opposite_begin = from.sign.at_end(), opposite_end = to.sign.at_start();
  const int others = all.zeros - begin - end - opposite_begin - opposite_end;
  const int with_next = from.ahead - end, with_last = to.ahead - begin;
  int inside = std::max(0, with_next + with_last - others);
  if (inside % 2 != (from.sign.after_start() != to.sign.before_end() ? 1 : 0)) ++inside;
  if (inside + 2 <= std::min(with_next, with_last) && from.sign.c[0] * from.sign.c[1] < 0) inside += 2;
  const auto has_pair = [&] {
    if (others < 4) return begin == 2 || end == 2 || opposite_begin == 2 || opposite_end == 2;
    if (with_next == 4) return to.pair_is_ahead();
    return with_next != 3 && from.pair_is_ahead();
  };
  return {begin > 0 ? 1 : 0, all.places_of(inside, has_pair), end > 0 ? 1 : 0};
}

VESICA_COLD inline exact::ContactCubic contact_cubic(const RoundOutline& k, int i, const exact::Ellipse& e) noexcept {
  const Offset p = offset(k, i, e);
  return exact::disc_contact_cubic(k.radius, p.x, p.y, e);
}
VESICA_COLD inline Census census(const RoundOutline& k, int i, const exact::Ellipse& e, bool cross) noexcept {
  exact::ContactCubic p = contact_cubic(k, i, e);
  return census(p, cross);
}
/// True if places are zeros of multiplicity 3 or 4, where not all are simple.
VESICA_COLD inline bool osculates(const RoundOutline& k, int i, const exact::Ellipse& e) noexcept {
  const exact::ContactCubic p = contact_cubic(k, i, e);
  return exact::discriminant_sign(p) == 0 && has_triple_root(p);
}

/// The circle about a corner and an ellipse.
struct CircleAndEllipse {
  AlongOther along_ellipse;
  Census all;
  bool is_certain;  ///< all are simple zeros
  int count = 0;
  Real at[4];      ///< along the circle, as of Groups
  Real turned[4];  ///< from the begin of the arc

  CircleAndEllipse(const RoundOutline& k, int i, const exact::Ellipse& e) noexcept
      : CircleAndEllipse(k, i, e, prepared(k, i, e)) {}
  CircleCensus zeros(const RoundOutline& k, int i, const exact::Ellipse& e) const noexcept {
    const int places = all.crossing + all.touching, least = all.crossing + 2 * all.touching;
    const bool has_more = !is_certain && least == 2 && osculates(k, i, e);
    return {places, has_more ? 4 : least, all.crossing == 2 && all.touching == 1};
  }

 private:
  /// Not inlined: the exact outline takes stack only here.
  VESICA_CALLED static Prepared prepared(const RoundOutline& k, int i, const exact::Ellipse& e) noexcept {
    const exact::Ellipse disc{{}, {}, exact::from_double(1), {}, k.radius, k.radius};
    const Offset p = offset(k, i, e);
    const Outline outline(disc, e, p.x, p.y);
    return {Harmonics(outline), AlongOther(outline)};
  }
  CircleAndEllipse(const RoundOutline& k, int i, const exact::Ellipse& e, const Prepared& pair) noexcept
      : along_ellipse(pair.along_other) {
    Groups groups(find_spots(pair.harmonics));
    const std::optional<int> crossings = groups.certain_crossings();
    is_certain = crossings.has_value();
    all = is_certain ? Census{*crossings, 0, false} : census(k, i, e, groups.surely_odd() > 0);
    if (all.crossing + all.touching == 0) return;
    share_out(groups, all);
    const Side& d = k.side(k.before(i));
    const int unit = k.unit.estimate.exponent;
    const Real x = two_doubles(d.x, unit), y = two_doubles(d.y, unit);
    for (const Group* g = groups.group; g != groups.group + groups.count; ++g) {
      const Direction p(g->at);
      for (int n = 0; n < g->places && count < 4; ++n) {
        at[count] = g->at;
        turned[count++] = turn(y * p.x - x * p.y, x * p.x + y * p.y);
      }
    }
  }
};

/// How far apart two positions along a closed outline of 4 are.
inline Real apart(const Real& p, const Real& q) noexcept {
  const Real way = abs(p - q);
  return rounded(way) > 2 ? Real(4.0) - way : way;
}

/// An arc in turns from its begin, and places of its circle.
struct TurnsOfArc {
  Real end;

  explicit TurnsOfArc(const RoundOutline& k) noexcept : end(k.corners.count == 2 ? 2.0 : 1.0) {}
  bool is_inside(const Real& turned) const noexcept { return turned < end; }
  Real from_nearer_end(const Real& turned) const noexcept {
    const Real p = apart(turned, Real(0.0)), q = apart(turned, end);
    return p < q ? p : q;
  }
  /// How far a place is from where it counts: place j of an arc with these counts.
  Real off(const Real& turned, int j, const ArcCounts& counts) const noexcept {
    if (j < counts.begin) return apart(turned, Real(0.0));
    const bool inside = j < counts.begin + counts.inside;
    if (!inside && j < counts.begin + counts.inside + counts.end) return apart(turned, end);
    return is_inside(turned) == inside ? Real(0.0) : from_nearer_end(turned);
  }
};

/// Which place is the first of the arc. Places are in order around the circle, and all of an arc's follow one another.
inline int first_on_arc(const CircleAndEllipse& circle, const TurnsOfArc& arc, const ArcCounts& counts) noexcept {
  int first = 0;
  Real least(8.0);
  for (int i = 0; i < circle.count; ++i) {
    Real off(0.0);
    for (int j = 0; j < circle.count; ++j) off = off + arc.off(circle.turned[(i + j) % circle.count], j, counts);
    if (off < least) least = off, first = i;
  }
  return first;
}

inline ArcCounts counts_on_arc(const RoundOutline& k, int i, const exact::Ellipse& e, const CircleAndEllipse& circle,
                               const TurnsOfArc& arc) noexcept {
  // Places are known to far less.
  const Real margin(0x1p-30);
  ArcCounts counts{0, 0, 0};
  for (int j = 0; j < circle.count; ++j) {
    if (arc.from_nearer_end(circle.turned[j]) < margin) {
      const CircleCensus all = circle.zeros(k, i, e);
      return k.corners.count == 2 ? counts_on_half(k, i, e, all) : counts_on_quarter(k, i, e, all);
    }
    counts.inside += arc.is_inside(circle.turned[j]) ? 1 : 0;
  }
  return counts;
}

/// Adds the places of an arc. Returns true if it is one of the ellipse, and adds none then.
inline bool cross_arc_and_ellipse(const RoundOutline& k, int i, const exact::Ellipse& e, Found& found) noexcept {
  if (surely_misses(k, i, e)) return false;
  const CircleAndEllipse circle(k, i, e);
  if (circle.count == 0) return circle.all.equal;
  const TurnsOfArc arc(k);
  const ArcCounts counts = counts_on_arc(k, i, e, circle, arc);
  const int first = first_on_arc(circle, arc, counts), all = counts.begin + counts.inside + counts.end;
  const Estimate r(k.radius);
  const auto add = [&](const Estimate& x, const Estimate& y, const Real& along, int j) {
    // If the estimate is not precise, all are one place up to rounding.
    const bool is_precise = circle.along_ellipse.is_precise();
    found.add({to_double(Estimate(k.corners.x[i]) + r * x), to_double(Estimate(k.corners.y[i]) + r * y), along,
               is_precise ? circle.along_ellipse(Direction(circle.at[j])) : Real()});
  };
  const Real begins(k.arc_begins(i));
  for (int n = 0; n < all; ++n) {
    const int j = (first + n) % circle.count;
    const bool is_begin = n < counts.begin;
    if (is_begin || n >= counts.begin + counts.inside) {
      const Side out = k.side(is_begin ? k.before(i) : i).normal();
      const Estimate& unit = k.unit.estimate;
      add(Estimate(out.x) / unit, Estimate(out.y) / unit, is_begin ? begins : Real(RoundOutline::arc_ends(i)), j);
      continue;
    }
    const Direction p(circle.at[j]);
    const Real turned = circle.turned[j],
               part = rounded(turned) > 2 + 0.5 * rounded(arc.end) ? Real() : turned / arc.end;
    add({p.x, 0x1p-90, 0}, {p.y, 0x1p-90, 0}, begins + (part < Real(1.0) ? part : Real(std::nextafter(1.0, 0.0))), j);
  }
  return false;
}

/// The place on a piece that is nearest to a position along the outline; null if it has none.
template <class OnPiece>
Place* place_near(Found& found, const Real& along, const OnPiece& is_on_piece) noexcept {
  Place* best = nullptr;
  for (Place* p = found.place; p != found.place + found.count; ++p) {
    if (!is_on_piece(p->along_a)) continue;
    if (best == nullptr || abs(p->along_a - along) < abs(best->along_a - along)) best = p;
  }
  return best;
}

/// The place at which the ellipse's outline begins, or null. Decided exactly: others may be nearer than roundings.
VESICA_COLD inline Place* start_of_ellipse(const RoundOutline& k, const exact::Ellipse& e, const Position& x,
                                           const Position& y, Found& found) noexcept {
  for (int i = 0; i < k.corners.count; ++i) {
    const Offset w{x - k.corners.x[i], y - k.corners.y[i]};
    if (exact::compare(exact::dot(w.x, w.y, w.x, w.y), exact::square(k.radius)) != 0) continue;
    const Real along = along_arc(k, i, [&w](const Side& g) { return Estimate(dot(g, w)); });
    if (rounded(along) < 0) continue;
    const Real begins(k.arc_begins(i)), ends(RoundOutline::arc_ends(i)), next(k.arc_begins(i) + 1);
    const bool is_end = !(along < ends) && !(ends < along);
    return place_near(found, along, [&](const Real& at) {
      return is_end ? !(at < ends) && !(ends < at) : !(at < begins) && at < next;
    });
  }
  for (int i = 0; i < k.edges; ++i) {
    const Side d = k.side(i);
    const Offset from{x - k.corners.x[i], y - k.corners.y[i]};
    const Offset to{x - k.corners.x[k.next(i)], y - k.corners.y[k.next(i)]};
    if (root_sum(dot(d.normal(), from), -k.radius, k.unit).sign() != 0) continue;
    if (dot(d, from).sign <= 0 || dot(d, to).sign >= 0) continue;
    // In the disc's frame the start is (radius, 0). So an edge that leads away from +x enters the disc there.
    const bool enters = exact::dot(e.ux, e.uy, d.x, d.y).sign < 0;
    const Real begins(2.0 * i), ends(2.0 * i + 1);
    return place_near(found, enters ? begins : ends, [&](const Real& at) { return begins < at && at < ends; });
  }
  return nullptr;
}
VESICA_COLD inline void mend_start(const RoundOutline& k, const exact::Ellipse& e, Found& found) noexcept {
  const Position x = e.cx + e.a * e.ux, y = e.cy + e.a * e.uy;
  Place* const start = start_of_ellipse(k, e, x, y, found);
  if (start == nullptr) return;
  start->x = nearest(x);
  start->y = nearest(y);
  start->begins_b();
}

/// With an ellipse that is the circle about a corner.
VESICA_COLD inline Found crossings_with_own_circle(const RoundOutline& k, const exact::Ellipse& e) noexcept {
  Found found = crossings(k, RoundOutline({e.cx, e.cy, exact::from_double(1), {}, {}, {}}, k.radius));
  for (Place* p = found.place; p != found.place + found.count; ++p) {
    const exact::Length x = exact::from_double(p->x) - e.cx, y = exact::from_double(p->y) - e.cy;
    p->along_b = turn_of(Estimate(exact::dot(e.ux, e.uy, x, y)), Estimate(exact::cross(e.ux, e.uy, x, y)));
  }
  return found;
}

/// A core that is not a point with a radius, and an ellipse that is not degenerate.
inline Found crossings(const RoundOutline& k, const exact::Ellipse& e) noexcept {
  Found found;
  bool has_own_circle = false;
  for (int i = 0; i < k.corners.count; ++i) {
    has_own_circle = has_own_circle || cross_arc_and_ellipse(k, i, e, found);
  }
  if (has_own_circle) {
    found = crossings_with_own_circle(k, e);
  } else {
    for (int i = 0; i < k.edges; ++i) cross_edge_and_ellipse(k, i, e, found);
  }
  if (found.is_near_start_of_b()) mend_start(k, e, found);
  return found;
}

}  // namespace vesica::detail::crossings
