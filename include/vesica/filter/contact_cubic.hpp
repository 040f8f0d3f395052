// SPDX-License-Identifier: Apache-2.0
/// Whether two ellipses overlap, by the sign of the contact cubic near its minimum: a negative value proves them
/// disjoint, a positive minimum proves overlap. One square root, one division, no iteration and no cases.
#pragma once

#include <vesica/filter/circles.hpp>

namespace vesica::filter {

/// The cubic p(x) = d1 + c1 x + c2 x^2 + d2 x^3 of exact/ellipse_ellipse.hpp: overlap iff p(x) >= 0 for all x > 0.
/// d1, d2 > 0 have a relative error of at most 11u; c1, c2 err by at most 14u total1, 14u total2, which are sums of
/// magnitudes and so at least |c1|, |c2|.
template <class V>
struct ContactCubic {
  V d1, c1, c2, d2, total1, total2;
};

/// The contact cubic with det(S1 + x S2) = det1 + mu x + det2 x^2, all up to one positive factor and a factor on x.
/// det1 and det2 err by 11u of themselves, mu by 12u (mu + turned).
template <class V>
struct Pencil {
  ContactCubic<V> contact;
  V det1, mu, det2, turned;
};

/// The greater zero of l1 + 2 l2 x + 3 d2 x^2, by the form that adds like signs.
template <class V>
VESICA_INLINE constexpr V greater_zero(V l1, V l2, V d2, V root) noexcept {
  const V zero = V(0.0f), three(3.0f);
  const auto rising = l2 > zero;
  return rough_quotient(select(rising, zero - l1, root - l2), select(rising, l2 + root, three * d2));
}
#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE double greater_zero(double l1, double l2, double d2, double root) noexcept {
  const TwoDoubles q =
      select(TwoDoubles(0.0) < TwoDoubles(l2), TwoDoubles(-l1, l2 + root), TwoDoubles(root - l2, 3 * d2));
  return rough_quotient(q.first(), q.second());
}
#endif

/// p(t) at a t >= 0 that nearly minimises a lower estimate of p over x >= 0.
///
/// Proved: if it is beyond 40u h, its sign answers, where h = d1 + total1 t + total2 t^2 + d2 t^3. Below -40u h the
/// shapes are disjoint, above 40u h they overlap. So one evaluation, with one root and one quotient that need not be
/// accurate, decides both ways.
///
/// The lower estimate is d1 + l1 x + l2 x^2 + d2 x^3 with l_i = c_i - 16u total_i. It lies below p but for the errors
/// of d1 and d2. Its minimiser is t, by the form of the quadratic's root that adds like signs.
///
///   disjoint: p(t) < 0 at any t > 0 proves it. Coefficients err by 14u h, Horner's rule by 6u h: 20u h in all.
///   overlap: the lower estimate at t is 16u h and 6u h below the computed value; d1 and d2 err by 11u h. An error of t
///     enters squared: even where the quadratic's root is nearly double, t errs by less than 4 sqrt(u) t, and p by less
///     than 110 u^1.5 h. A rough root and quotient, each off by e, cost 3 e^2 h: less than u h for float's 2^-13, 6u h
///     for double's 2^-26. 39u h in all.
template <class V>
VESICA_INLINE constexpr Estimate<V> least_value(const ContactCubic<V>& p) noexcept {
  const V three = V(3.0f), shift = roundoffs<V>(16);
  const V l1 = p.c1 - shift * p.total1, l2 = p.c2 - shift * p.total2;
  const V root = rough_sqrt(positive_part(l2 * l2 - three * (p.d2 * l1)));
  const V t = positive_part(greater_zero(l1, l2, p.d2, root));
  const V value = ((p.d2 * t + p.c2) * t + p.c1) * t + p.d1;
  const V magnitude = ((p.d2 * t + p.total2) * t + p.total1) * t + p.d1;
  // positive_part() may lose a NaN, but any NaN in it came from the totals, which are in the magnitude too.
  return {value, roundoffs<V>(40) * magnitude};
}

template <class V>
VESICA_INLINE constexpr auto decide(const ContactCubic<V>& p) noexcept {
  const Estimate<V> least = least_value(p);
  return Verdict<decltype(least.value > least.error)>{certainly_positive(least), certainly_negative(least)};
}

/// Totals and leading terms together below 2^62 (double: 2^496): no square in least_value() overflows. Powers of t may;
/// so the error's limit is looked at too.
template <class V>
VESICA_INLINE constexpr auto totals_in_range(const ContactCubic<V>& p) noexcept {
  return (p.d1 + p.d2) + (p.total1 + p.total2) <= guard_power<V, 62>();
}

/// d: from the first ellipse's centre to the second's.
///
/// Proved: errors are as ContactCubic and Pencil state them, on which least_value() builds. With v, w the axes, N =
/// |v||w| and M = |v||D| <= |x0| + |x1| they are:
///
///   d1 = (a0 a1 V)^2: 9u
///   mu: c and s err by 2u N, so c^2 by 4u (c^2 + |c s|) + u c^2: in all 11u mu + 4u |c s| (a0^2 + a1^2)(b0^2 + b1^2)
///   al: x0 and x1 err by 3u M, so al by 10u al + 6u (a0^2 + a1^2) |x0 x1|
///   c1 = d1 + mu - al: two roundings more; 13u total1.
///
/// For ellipses thinner than 1 : 2^-26 errors of second order count where those of first order vanish: b^2 (3u M)^2 in
/// al when x0 is nearly zero, (2u N)^2 (a0^2 + a1^2)(b0^2 + b1^2) in mu when c or s is. The u^2 terms in the totals
/// cover them.
template <class V>
VESICA_INLINE constexpr Pencil<V> pencil(const Ellipse<V>& e, const Ellipse<V>& f, const Centre<V>& d, V vv,
                                         V ww) noexcept {
  const V c = e.ux * f.ux + e.uy * f.uy, s = e.ux * f.uy - e.uy * f.ux;
  const V x0 = e.ux * d.x + e.uy * d.y, x1 = e.ux * d.y - e.uy * d.x;
  const V y0 = f.ux * d.x + f.uy * d.y, y1 = f.ux * d.y - f.uy * d.x;
  const V a0 = e.a * e.a, a1 = e.b * e.b, b0 = f.a * f.a, b1 = f.b * f.b;
  const V r1 = (e.a * e.b) * vv, r2 = (f.a * f.b) * ww;
  const V d1 = r1 * r1, d2 = r2 * r2;
  const V mu = (c * c) * (a0 * b1 + a1 * b0) + (s * s) * (a0 * b0 + a1 * b1);
  const V m0 = e.b * x0, m1 = e.a * x1, n0 = f.b * y0, n1 = f.a * y1;
  const V al = m0 * m0 + m1 * m1, be = n0 * n0 + n1 * n1;
  const V sa = a0 + a1, sb = b0 + b1, u = roundoffs<V>(1), dd = roundoffs<V>(2) * (d.x * d.x + d.y * d.y);
  const V turned = (sa * sb) * (abs(c * s) + u * (c * c + s * s));
  const V across_e = abs(x0 * x1) + vv * dd, across_f = abs(y0 * y1) + ww * dd;  // V |D|^2 = x0^2 + x1^2
  return {{d1, (d1 + mu) - al, (d2 + mu) - be, d2, ((d1 + mu) + al) + (sa * across_e + turned),
           ((d2 + mu) + be) + (sb * across_f + turned)},
          d1,
          mu,
          d2,
          turned};
}

template <class V>
VESICA_INLINE constexpr ContactCubic<V> contact_cubic(const Ellipse<V>& e, const Ellipse<V>& f, const Centre<V>& d,
                                                      V vv, V ww) noexcept {
  return pencil(e, f, d, vv, ww).contact;
}

#if VESICA_HAS_TWO_DOUBLES
/// The same for one pair: what belongs to each of the two ellipses at once.
VESICA_INLINE ContactCubic<double> contact_cubic(const Ellipse<double>& e, const Ellipse<double>& f,
                                                 const Centre<double>& d, double vv, double ww) noexcept {
  using V = TwoDoubles;
  const V ux(e.ux, f.ux), uy(e.uy, f.uy), a(e.a, f.a), b(e.b, f.b), uu(vv, ww), dx(d.x), dy(d.y);
  const V c = ux * exchanged(ux) + uy * exchanged(uy), s = ux * exchanged(uy) - uy * exchanged(ux);
  const V aa = a * a, bb = b * b, other_aa = exchanged(aa), other_bb = exchanged(bb), root = (a * b) * uu;
  const V x0 = ux * dx + uy * dy, x1 = ux * dy - uy * dx, m0 = b * x0, m1 = a * x1, det = root * root;
  const V mu = (c * c) * (aa * other_bb + bb * other_aa) + (s * s) * (aa * other_aa + bb * other_bb);
  const V al = m0 * m0 + m1 * m1, squares = aa + bb, dd = V(roundoffs<double>(2)) * (dx * dx + dy * dy);
  const V turned = (squares * exchanged(squares)) * (abs(c * s) + V(roundoffs<double>(1)) * (c * c + s * s));
  const V coefficient = (det + mu) - al, total = ((det + mu) + al) + (squares * (abs(x0 * x1) + uu * dd) + turned);
  return {det.first(), coefficient.first(), coefficient.second(), det.second(), total.first(), total.second()};
}
#endif

/// Guard: half lengths and squared axes at least 2^-6 (double: 2^-48), so that d1 and d2 are at least 2^-36 (2^-288)
/// and all that underflows is negligible beside them.
template <class V>
VESICA_INLINE constexpr auto ellipse_ellipse_usable(const ContactCubic<V>& p, const Ellipse<V>& e, const Ellipse<V>& f,
                                                    V vv, V ww) noexcept {
  return both(at_least(guard_power<V, -6>(), e.a, e.b, f.a, f.b, vv, ww), totals_in_range(p));
}

VESICA_INLINE constexpr bool circles_apart(const Ellipse<double>& e, const Ellipse<double>& f, const Centre<double>& d,
                                           double vv, double ww, bool usable) noexcept {
  const double outer_e = max(e.a * e.a, e.b * e.b) * vv, outer_f = max(f.a * f.a, f.b * f.b) * ww;
  return circles_apart(d.x * d.x + d.y * d.y, outer_e + outer_f, usable);
}

/// by_ellipses() for two ellipses, with Q = (xx, xy; xy, yy).
///
/// Proved: all errors together are below 100u (qx + qy + xx yy), far below the 2^-40 that the code allows.
///
///   - xx and yy err by 5u of themselves, xy by 6u of sums of magnitudes, whose square is at most xx yy (Cauchy,
///     Schwarz).
///   - So the distance errs by 23u (qx + qy), and det Q by 25u xx yy.
///   - As m <= xx and m <= yy, what has m errs by 10u (qx + qy) + 36u xx yy.
///   - Underflow: xx and yy are at least 2^-144, and where xx yy <= 2^640, squares of half lengths are at most 2^832.
///     What underflows loses less than 2^-242 of an entry.
#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE DecidedVerdict<bool> look_at_ellipses(const Ellipse<double>& e, const Ellipse<double>& f,
                                                    const Centre<double>& d) noexcept {
  using V = TwoDoubles;
  // Both shapes together.
  const V axis_e(e.ux, e.uy), axis_f(f.ux, f.uy), ux = firsts(axis_e, axis_f), uy = seconds(axis_e, axis_f);
  const V lengths_e(e.a, e.b), lengths_f(f.a, f.b), a = firsts(lengths_e, lengths_f), b = seconds(lengths_e, lengths_f);
  const V aa = a * a, bb = b * b;
  const V uxx = ux * ux, uyy = uy * uy, uu = uxx + uyy, least = min(aa, bb) * uu;
  const double xy = sum((aa - bb) * (ux * uy)), m = 2 * min(least.first(), least.second());
  // Along both coordinates.
  const V xx_yy = sums(aa * uxx + bb * uyy, aa * uyy + bb * uxx), dd = V(d.x, d.y) * V(d.x, d.y);
  const V q_square = sums(exchanged(xx_yy) * dd, dd);
  const double q = q_square.first(), square = q_square.second(), squares = xx_yy.first() * xx_yy.second();
  const V shortest(guard_power<double, -6>());
  const bool usable = in_both(both(both(shortest <= a, shortest <= b), shortest <= uu));
  return by_ellipses<double>(q - 2 * (xy * (d.x * d.y)), squares - xy * xy, m * ((sum(xx_yy) + m) - square),
                             look_slack * (q + squares), 0x1p600, usable);
}
#endif

template <class V>
VESICA_COLD constexpr auto circles_within_meet(const Ellipse<V>& e, const Ellipse<V>& f) noexcept {
  const V vv = e.ux * e.ux + e.uy * e.uy, ww = f.ux * f.ux + f.uy * f.uy;
  const V a0 = e.a * e.a, a1 = e.b * e.b, b0 = f.a * f.a, b1 = f.b * f.b;
  const Centre<V> d = offset(place(e), place(f));
  return circles_meet<V>(d, min(a0, a1) * vv, min(b0, b1) * ww, max(a0, a1) * vv + max(b0, b1) * ww,
                         at_least(V(0x1p-48), e.a, e.b, f.a, f.b, vv, ww));
}

template <class V>
VESICA_INLINE constexpr auto ellipse_ellipse(const Ellipse<V>& e, const Ellipse<V>& f) noexcept {
  const V vv = e.ux * e.ux + e.uy * e.uy, ww = f.ux * f.ux + f.uy * f.uy;
  const ContactCubic<V> p = contact_cubic(e, f, offset(place(e), place(f)), vv, ww);
  const Estimate<V> least = least_value(p);
  return guarded(both(ellipse_ellipse_usable(p, e, f, vv, ww), least.error <= guard_power<V, 100>()),
                 certainly_positive(least), certainly_negative(least));
}

#if VESICA_HAS_TWO_DOUBLES
/// By the cubic; what it leaves undecided, by circles.
VESICA_INLINE DecidedVerdict<bool> by_cubic(const Ellipse<double>& e, const Ellipse<double>& f) noexcept {
  using V = TwoDoubles;
  const V ux(e.ux, f.ux), uy(e.uy, f.uy), uu = ux * ux + uy * uy, shortest(guard_power<double, -6>());
  const auto sizes = both(both(shortest <= V(e.a, f.a), shortest <= V(e.b, f.b)), shortest <= uu);
  const ContactCubic<double> p = contact_cubic(e, f, offset(place(e), place(f)), uu.first(), uu.second());
  const Estimate<double> least = least_value(p);
  const bool usable = both(in_both(sizes), both(totals_in_range(p), least.error <= guard_power<double, 100>()));
  if (both(usable, abs(least.value) > least.error)) [[likely]]
    return {least.value > 0, true};
  const bool meet = circles_within_meet(e, f).overlap;
  return {meet, meet};
}
#endif

/// Circle and ellipse: the same cubic with x = t / r^2, times r^2, is monic:
/// (r^2 + t)(P + t)(Q + t) - t (al + |D|^2 t), P = V a^2 and Q = V b^2 the squared half lengths. Of lower degree, so
/// cheaper and of wider range. Errors: r^2 P Q 11u; c1: 12u and 6u of (a^2 + b^2) |x0 x1|; c2: 7u.
template <class V>
VESICA_INLINE constexpr Pencil<V> pencil(const Circle<V>& disc, const Ellipse<V>& e, const Centre<V>& d,
                                         V vv) noexcept {
  const V x0 = e.ux * d.x + e.uy * d.y, x1 = e.ux * d.y - e.uy * d.x;
  const V aa = e.a * e.a, bb = e.b * e.b, rr = disc.r * disc.r;
  const V p = aa * vv, q = bb * vv, pq = p * q, sum = p + q;
  const V m0 = e.b * x0, m1 = e.a * x1;
  const V al = m0 * m0 + m1 * m1, dd = d.x * d.x + d.y * d.y;
  const V c1 = pq + rr * sum, c2 = rr + sum;
  const V across = abs(x0 * x1) + roundoffs<V>(2) * (vv * dd);
  return {{rr * pq, c1 - al, c2 - dd, V(1.0f), (c1 + al) + (aa + bb) * across, c2 + dd}, pq, sum, V(1.0f), V(0.0f)};
}

template <class V>
VESICA_INLINE constexpr ContactCubic<V> contact_cubic(const Circle<V>& disc, const Ellipse<V>& e, const Centre<V>& d,
                                                      V vv) noexcept {
  return pencil(disc, e, d, vv).contact;
}

#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE ContactCubic<double> contact_cubic(const Circle<double>& disc, const Ellipse<double>& e,
                                                 const Centre<double>& d, double vv) noexcept {
  using V = TwoDoubles;
  const V u(e.ux, e.uy), lengths(e.a, e.b), delta(d.x, d.y), squared = lengths * lengths, pq = squared * V(vv);
  const V x = firsts(u, u) * delta + flip_sign(seconds(u, u), V(0.0, -0.0)) * exchanged(delta);
  const V m = exchanged(lengths) * x, al_dd = sums(m * m, delta * delta), sum_lengths = sums(pq, squared);
  const double rr = disc.r * disc.r, product = pq.first() * pq.second(), al = al_dd.first(), dd = al_dd.second();
  const double c1 = product + rr * sum_lengths.first(), c2 = rr + sum_lengths.first();
  const double across = abs(x.first() * x.second()) + roundoffs<double>(2) * (vv * dd);
  return {rr * product, c1 - al, c2 - dd, 1, (c1 + al) + sum_lengths.second() * across, c2 + dd};
}
#endif

VESICA_INLINE constexpr bool circles_apart(const Circle<double>& disc, const Ellipse<double>& e,
                                           const Centre<double>& d, double vv, bool usable) noexcept {
  const double about = disc.r * disc.r + max(e.a * e.a, e.b * e.b) * vv;
  return circles_apart(d.x * d.x + d.y * d.y, about, usable);
}

#if VESICA_HAS_TWO_DOUBLES
/// The part of circle_ellipse()'s guard that needs no cubic.
VESICA_INLINE bool disc_ellipse_sizes(const Circle<double>& disc, const Ellipse<double>& e, double vv) noexcept {
  const TwoDoubles shortest(guard_power<double, -8>()), least(guard_power<double, -8>(), guard_power<double, -16>());
  return in_both(both(shortest <= TwoDoubles(e.a, e.b), least <= TwoDoubles(disc.r, vv)));
}

/// by_ellipses() for a disc and an ellipse, along whose axes Q is diagonal: p and q.
///
/// Proved: all errors are far below the 2^-40 that the code allows. p and q err by 4u of themselves, coordinates times
/// |v| by 3u |v| |D|, so x0^2 q and x1^2 p by less than 10u (x0^2 + x1^2) (p + q). The rest is as for two ellipses.
/// Underflow: p and q are at least 2^-128, and where V p q <= 2^340, at most 2^596. What underflows loses less than
/// 2^-478, beside V p q >= 2^-384.
VESICA_INLINE DecidedVerdict<bool> look_at_ellipses(const Circle<double>& disc, const Ellipse<double>& e,
                                                    const Centre<double>& d) noexcept {
  const double vv = e.ux * e.ux + e.uy * e.uy, aa = e.a * e.a, bb = e.b * e.b, rr = disc.r * disc.r;
  const double x0 = e.ux * d.x + e.uy * d.y, x1 = e.ux * d.y - e.uy * d.x, xx = x0 * x0, yy = x1 * x1;
  const double p = aa * vv + rr, q = bb * vv + rr, whole = p + q, m = 2 * min(rr, min(aa, bb) * vv);
  const double square = xx + yy, det = vv * (p * q);
  return by_ellipses<double>(xx * q + yy * p, det, m * (vv * (whole + m) - square), look_slack * (square * whole + det),
                             0x1p300, disc_ellipse_sizes(disc, e, vv));
}
#endif

template <class V>
VESICA_COLD constexpr auto circles_within_meet(const Circle<V>& disc, const Ellipse<V>& e) noexcept {
  const V vv = e.ux * e.ux + e.uy * e.uy, aa = e.a * e.a, bb = e.b * e.b, rr = disc.r * disc.r;
  return circles_meet<V>(offset(place(disc), place(e)), rr, min(aa, bb) * vv, rr + max(aa, bb) * vv,
                         both(at_least(V(0x1p-64), e.a, e.b, disc.r), vv >= V(0x1p-128)));
}

/// Guard: radius and half lengths at least 2^-8 and the squared axis 2^-16 (double: the 8th powers), so that
/// r^2 P Q >= 2^-80 stays normal.
template <class V>
VESICA_INLINE constexpr auto circle_ellipse(const Circle<V>& disc, const Ellipse<V>& e) noexcept {
  const V vv = e.ux * e.ux + e.uy * e.uy;
  const V low = guard_power<V, -8>();
  const auto sizes = both(at_least(low, e.a, e.b, disc.r), vv >= guard_power<V, -16>());
  const ContactCubic<V> p = contact_cubic(disc, e, offset(place(disc), place(e)), vv);
  const Estimate<V> least = least_value(p);
  return guarded(both(both(sizes, totals_in_range(p)), least.error <= guard_power<V, 100>()), certainly_positive(least),
                 certainly_negative(least));
}

#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE DecidedVerdict<bool> by_cubic(const Circle<double>& disc, const Ellipse<double>& e) noexcept {
  const double vv = e.ux * e.ux + e.uy * e.uy;
  const ContactCubic<double> p = contact_cubic(disc, e, offset(place(disc), place(e)), vv);
  const Estimate<double> least = least_value(p);
  const bool usable =
      both(disc_ellipse_sizes(disc, e, vv), both(totals_in_range(p), least.error <= guard_power<double, 100>()));
  if (both(usable, abs(least.value) > least.error)) [[likely]]
    return {least.value > 0, true};
  const bool meet = circles_within_meet(disc, e).overlap;
  return {meet, meet};
}
#endif

}  // namespace vesica::filter
