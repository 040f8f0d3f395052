// SPDX-License-Identifier: Apache-2.0
/// A look before a long filter: shapes are disjoint if their centres are beyond an ellipse about the sum of the shapes,
/// and overlap if these are within an ellipse inside it. For relations: they are disjoint if circles about them are.
///
/// Policy, the same for all pairs: a call looks first where its filter takes more than twice the time of the look and
/// of a jump that could not be predicted. These are the pairs of round shapes, for their contact cubic. Others would
/// lose more among close shapes than they gain among distant ones. Lanes never look: they cannot jump.
#pragma once

#include <vesica/filter/box.hpp>

namespace vesica::filter {

/// Far above the errors of all that is compared here.
inline constexpr double look_slack = 0x1p-40;

/// Squares of lengths up to this: one that is beyond the range, times the least squared axis, is above it in any
/// rounding mode.
inline constexpr double greatest_square = 0x1p800;

/// Are circles about two shapes apart? Of `distance` and `about`, the sum of the squared radii R and S, all errors
/// together are below 16u, and (R + S)^2 <= 2 (R^2 + S^2). usable: sizes and squared axes are at least
/// 2^-48 (discs: their powers are, as in the contact cubic's guards), so that nothing underflows that counts, and none
/// is NaN.
template <class V, class Mask>
VESICA_INLINE constexpr Mask circles_apart(V distance, V about, Mask usable) noexcept {
  return both(usable, both(distance > V(2 + look_slack) * about, distance <= V(greatest_square)));
}

/// For what is left in the end, of magnitudes that only comparisons of squares bear: do circles within two shapes
/// overlap? p and q are the squares of their radii, P <= Q: (P + Q)^2 >= 3 P^2 + Q^2, so no root is needed. `sum`:
/// infinite if a size or an axis is; none is NaN.
template <class V, class Mask>
VESICA_INLINE constexpr Verdict<Mask> circles_meet(const Centre<V>& d, V p, V q, V sum, Mask usable) noexcept {
  const V distance = d.x * d.x + d.y * d.y;
  const Mask meet = distance <= V(1 - look_slack) * ((p + q) + V(2.0f) * min(p, q));
  return {both(both(usable, distance + sum <= V(greatest_square)), meet), Mask(false)};
}

/// By ellipses about the first shape's centre; D is the other's.
///
/// Proved: D inside the ellipse of Q + m means overlap, and outside that of 2 Q that shapes are disjoint. S and T are
/// the matrices of the two shapes, Q = S + T, and m = 2 min(p^2, q^2), p and q being the radii of circles within them.
/// Two quadratic forms so settle most pairs before the cubic is formed.
///
///   - Along a unit vector n the shapes reach h and k, with h^2 = n.S n and k^2 = n.T n. They overlap iff n.D <= h + k
///     for all n, that is iff D is in their sum.
///   - h^2 + k^2 = n.Q n, and h^2 + k^2 <= (h + k)^2 <= 2 (h^2 + k^2). So the ellipse of Q, adj(Q) D.D <= det Q, is in
///     the sum, and that of 2 Q is about it.
///   - (h + k)^2 = h^2 + k^2 + 2 h k, and h k is not less than p q. So the ellipse of Q + m is in the sum too:
///     adj(Q) D.D + m |D|^2 <= det Q + m (tr Q + m).
///
/// distance: adj(Q) D.D. room: m (tr Q + m - |D|^2). error: above the errors of all, and NaN or infinite if a number of
/// a shape is. most: beyond this a factor of what underflows could be too large.
template <class V, class Mask>
VESICA_INLINE constexpr DecidedVerdict<Mask> by_ellipses(V distance, V det, V room, V error, V most,
                                                         Mask usable) noexcept {
  const V zero = V(0.0f), inside = (det + room) - (distance + error), outside = distance - (V(2.0f) * det + error);
  // Is one of them 0 or more? In one comparison, so that compilers make one jump of it: which of the two it is could
  // not be predicted.
  return {inside >= zero, both(both(usable, error <= most), abs(inside - outside) >= -(inside + outside))};
}

/// Lanes do not look.
template <class V>
inline constexpr bool looks = std::is_same_v<V, double>;

}  // namespace vesica::filter
