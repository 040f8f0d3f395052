// SPDX-License-Identifier: Apache-2.0
/// Which of two ellipses contains the other, where that is certain: by the contact cubic at negative arguments.
#pragma once

#include <vesica/filter/certain_facts.hpp>
#include <vesica/filter/contact_cubic.hpp>

namespace vesica::filter {

/// At least 64 sqrt(u): 2^-6 for float, 2^-20 for double.
template <class V>
VESICA_INLINE constexpr V coarse() noexcept {
  using T = typename Element<V>::Type;
  return V(sizeof(T) == 4 ? T(0x1p-6) : T(0x1p-20));
}

/// The numbers that decide whether the first ellipse of a pencil lies within the second.
template <class V>
struct Nesting {
  V y;
  Estimate<V> top;     ///< of q at y
  Estimate<V> beyond;  ///< positive where y > y+, negative where y < y+
  V slack;             ///< how far `beyond` can grow up to the true maximum of q
};

template <class V>
VESICA_INLINE constexpr auto certainly_nested(const Nesting<V>& n) noexcept {
  return both(certainly_positive(n.top), certainly_positive(n.beyond));
}

template <class V>
VESICA_INLINE constexpr auto certainly_not_nested(const Nesting<V>& n) noexcept {
  return either(certainly_negative(n.top), n.beyond.value + n.slack < -n.beyond.error);
}

/// The numbers of a pencil whose first ellipse has the lesser area, or an area equal up to rounding.
///
/// Proved: the answers certainly_nested() and certainly_not_nested() are right despite all rounding. So relation and
/// containment need the exact stage near contact alone.
///
/// 1. What decides. The first lies in the second iff q(y) = p(-y) = d1 - c1 y + c2 y^2 - d2 y^3 reaches 0 at some y at
/// which M = y S2 - S1 is positive semidefinite, that is at or beyond y+, the greater root of the convex det M = det1 -
/// mu y + det2 y^2; clear of its outline if q > 0 somewhere beyond y+ (exact/ellipse_ellipse.hpp). At y+ q <= 0, so
/// that takes a local maximum yM > y+ of q, or yM = y+ with q = 0. Then q has three positive roots, so c2 > 0.
///
/// 2. Where q is looked at. y is yM for coefficients moved up: h2 = c2 + 128u total2 for c2, l1 = c1 - 128u total1 for
/// c1; where q has no maximum, its inflection. Where h2 < 0 so is c2, "neither" is right, and y may be anything.
///
/// 3. On which side of y+ that is. y > y+ iff w |w| > delta, with w = 2 det2 y - mu and delta = mu^2 - 4 det1 det2 >=
/// 0; y < y+ iff w |w| < delta. With W = 2 det2 y + mu + turned, w errs by 14u W, w |w| so by 29u |w| W + (14u W)^2,
/// delta by 24u mu (mu + turned) + (12u W)^2 and 27u mu^2.
///
/// 4. Within. q(y) > 0 and y > y+ at one y prove it; errors are 14u of the coefficients and 6u of Horner's rule.
///
/// 5. Neither. Areas that are equal but for rounding could be the other way round, |S2| >= (1 - 23u) |S1|. If then the
/// second lay in the first, map the first to the unit disc: the second's half axes have a product of at least 1 - 12u
/// and none exceeds 1, so it contains a disc of radius 1 - 12u about a point 12u away, and times 1 + 25u about its
/// centre it would contain the first. So it is enough to prove that the first does not lie in the second so enlarged,
/// whose cubic differs by at most 50u total1, 100u total2 and 100u d2. With 14u and 11u of rounding, the moved
/// coefficients' q lies above, but for 111u of d2 and 11u of d1, and so does its slope at y > 0. Then either of two
/// will do:
///   q(y) < 0: by as much as 111u for d1 and d2, 128u of the totals moved there and perhaps not needed, 6u of Horner's
///     rule. An error of y enters squared, as in least_value(): a root and a quotient each off by 2^-26 (2^-13) cost 12
///     e^2 = 24u, the discriminant's rounding, at a nearly double root, less than u. 160u in all.
///   y < y+: q falls from yM on, and yM <= (1 + e) y with e = 16.1 sqrt(u). For the discriminant of q', h2^2 - 3 d2 l1,
///     errs by 114u B, B = h2^2 + 3 |d2 l1|, its root, at worst where it vanishes and B <= 2 h2^2, by sqrt(228u) h2,
///     which is 15.1 sqrt(u) h2, and a rough root and quotient add sqrt(u) / 2 each. At (1 + e) y, w |w| exceeds that
///     at y by less than 3e (2 det2 y + mu)^2; the enlargement is far below the rest of the slack.
/// (If q' has no root, q falls everywhere; then too one of the two holds, but for rounding: at the inflection y either
/// y < y+, or q(y) <= q(y+) <= 0.)
template <class V>
VESICA_INLINE constexpr Nesting<V> nesting(const Pencil<V>& s) noexcept {
  const ContactCubic<V>& p = s.contact;
  const V shift = roundoffs<V>(128);
  const V l1 = p.c1 - shift * p.total1, h2 = p.c2 + shift * p.total2, triple = V(3.0f) * p.d2;
  // positive_part() may lose a NaN, but any NaN in it came from the totals, which guards look at.
  const V y = rough_quotient(h2 + rough_sqrt(positive_part(h2 * h2 - triple * l1)), triple);

  const V d2y = p.d2 * y;
  const V value = p.d1 - ((d2y - p.c2) * y + p.c1) * y;
  const V error = roundoffs<V>(192) * (((d2y + p.total2) * y + p.total1) * y + p.d1);

  const V det2y = s.det2 * y, slope = det2y + det2y, w = slope - s.mu, sum = slope + s.mu, bound = sum + s.turned;
  const V beyond = w * abs(w) - (s.mu * s.mu - V(4.0f) * (s.det1 * s.det2));
  const V beyond_error = roundoffs<V>(64) * (bound * ((abs(w) + s.mu) + roundoffs<V>(8) * bound));

  return {y, {value, error}, {beyond, beyond_error}, coarse<V>() * (sum * sum)};
}

/// a and b exchanged where the mask says so.
template <class Mask, class V>
VESICA_INLINE constexpr void exchange_where(Mask mask, V& a, V& b) noexcept {
  const V first = select(mask, b, a);
  b = select(mask, a, b);
  a = first;
}
/// By bits, as select() of scalars, but once for both.
VESICA_INLINE constexpr void exchange_where(bool mask, double& a, double& b) noexcept {
  const auto bits_a = std::bit_cast<std::uint64_t>(a), bits_b = std::bit_cast<std::uint64_t>(b);
  const std::uint64_t change = (bits_a ^ bits_b) & (std::uint64_t{0} - static_cast<std::uint64_t>(mask));
  a = std::bit_cast<double>(bits_a ^ change);
  b = std::bit_cast<double>(bits_b ^ change);
}

/// The pencil with its two ellipses exchanged where the mask says so: x turns into 1 / x.
template <class Mask, class V>
VESICA_INLINE constexpr Pencil<V> exchanged_where(Mask mask, Pencil<V> s) noexcept {
  exchange_where(mask, s.contact.d1, s.contact.d2);
  exchange_where(mask, s.contact.c1, s.contact.c2);
  exchange_where(mask, s.contact.total1, s.contact.total2);
  exchange_where(mask, s.det1, s.det2);
  return s;
}

/// first_greater: the pencil's first ellipse has the greater area.
template <class Mask, class V>
VESICA_INLINE constexpr CertainFacts<Mask> certain_facts(const Pencil<V>& s, Mask first_greater) noexcept {
  const Nesting<V> n = nesting(exchanged_where(first_greater, s));
  return certain_facts(decide(s.contact), certainly_nested(n), certainly_not_nested(n), first_greater);
}

/// The guard of the overlap filter. c1, c2 are sums with terms of 2^-36 and more (double: 2^-288): where they do not
/// vanish but for rounding, their squares and products with d2 are normal; y+ is at least sqrt(det1 / det2), beside
/// which what underflows in y otherwise is below 2^-38.
template <class V>
VESICA_INLINE constexpr auto ellipse_ellipse_certain_facts(const Ellipse<V>& e, const Ellipse<V>& f) noexcept {
  const V vv = e.ux * e.ux + e.uy * e.uy, ww = f.ux * f.ux + f.uy * f.uy;
  const Centre<V> d = offset(place(e), place(f));
  if constexpr (looks<V>) {
    if (circles_apart(e, f, d, vv, ww, at_least(guard_power<V, -6>(), e.a, e.b, f.a, f.b, vv, ww))) return apart();
  }
  const Pencil<V> s = pencil(e, f, d, vv, ww);
  return guarded(ellipse_ellipse_usable(s.contact, e, f, vv, ww), certain_facts(s, s.det1 > s.det2));
}

/// a: the circle; b: the ellipse, which is the pencil's first. Guard: radius and half lengths at least 2^-5, the
/// squared axis 2^-8 (double: the 8th powers), so that the terms of c1 and c2 are again 2^-36 and more.
template <class V>
VESICA_INLINE constexpr auto circle_ellipse_certain_facts(const Circle<V>& disc, const Ellipse<V>& e) noexcept {
  const V vv = e.ux * e.ux + e.uy * e.uy, rr = disc.r * disc.r;
  const Centre<V> d = offset(place(disc), place(e));
  const auto sizes = both(at_least(guard_power<V, -5>(), e.a, e.b, disc.r), vv >= guard_power<V, -8>());
  if constexpr (looks<V>) {
    if (circles_apart(disc, e, d, vv, sizes)) return apart();
  }
  const Pencil<V> s = pencil(disc, e, d, vv);
  return guarded(both(sizes, totals_in_range(s.contact)), certain_facts(s, s.det1 > rr * rr).exchanged());
}

}  // namespace vesica::filter
