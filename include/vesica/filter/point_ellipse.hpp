// SPDX-License-Identifier: Apache-2.0
/// Point against ellipse with an error bound.
#pragma once

#include <vesica/filter/box.hpp>

namespace vesica::filter {

/// (b v.X)^2 + (a v x X)^2 - (a b V)^2 with X from the centre to the point: positive outside.
///
/// Proved: it is off by at most 12u of the sum that the code forms, for axes of any length and ellipses however thin.
/// The first two terms err by 10u of themselves and 6u (a^2 + b^2) (|x0 x1| + 2u (x0^2 + x1^2)), as al in
/// filter/contact_cubic.hpp; (a b V)^2 by 9u, the difference by u of either.
template <class V>
VESICA_INLINE constexpr Estimate<V> outside_ellipse(const Ellipse<V>& e, const Centre<V>& d, V vv) noexcept {
  const V x0 = e.ux * d.x + e.uy * d.y, x1 = e.ux * d.y - e.uy * d.x;
  const V m0 = e.b * x0, m1 = e.a * x1, root = (e.a * e.b) * vv;
  const V al = m0 * m0 + m1 * m1, det = root * root;
  const V across = abs(x0 * x1) + roundoffs<V>(2) * (x0 * x0 + x1 * x1);
  return {al - det, roundoffs<V>(12) * ((al + det) + (e.a * e.a + e.b * e.b) * across)};
}

/// Guard: half lengths and the squared axis at least 2^-12 (double: 2^-96), so (a b V)^2 >= 2^-72 is normal; errors
/// below 2^100, where no term has overflowed.
template <class V>
VESICA_INLINE constexpr auto point_ellipse(const Ellipse<V>& e, const Centre<V>& d) noexcept {
  const V vv = e.ux * e.ux + e.uy * e.uy;
  const Estimate<V> gap = outside_ellipse(e, d, vv);
  const auto usable = both(at_least(guard_power<V, -12>(), e.a, e.b, vv), gap.error <= guard_power<V, 100>());
  return guarded(usable, gap);
}

}  // namespace vesica::filter
