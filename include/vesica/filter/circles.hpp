// SPDX-License-Identifier: Apache-2.0
/// A look before a long filter: shapes are disjoint if circles about them are, and overlap if circles within them do.
///
/// Policy, the same for all pairs: a call looks first where its filter takes more than twice the time of the look and
/// of a jump that could not be predicted. These are the pairs of round shapes, for their contact cubic. Others would
/// lose more among shapes that are close than they gain among shapes that are apart. Lanes never look: they cannot jump.
#pragma once

#include <limits>
#include <vesica/filter/box.hpp>

namespace vesica::filter {

/// The squared radii of a circle about a shape and of one within it.
struct Circles {
  double about, within;
};

/// For the squares of half lengths and of the axis's length.
VESICA_INLINE constexpr Circles circles(double aa, double bb, double axis) noexcept {
  return {max(aa, bb) * axis, min(aa, bb) * axis};
}

/// d: from one centre to the other. `sum`: of numbers that are NaN or infinite if a size is. usable: sizes and squared
/// axes are at least 2^-48 (discs: their powers are, as in the contact cubic's guards), so that nothing underflows that
/// counts, and all errors together are below 16u of each side (u = 2^-53). With R and S the outer radii
/// (R + S)^2 <= 2 (R^2 + S^2), and with p <= q the inner ones (p + q)^2 >= 3 p^2 + q^2.
VESICA_INLINE constexpr Verdict<bool> by_circles(const Centre<double>& d, const Circles& a, const Circles& b,
                                                 double sum, bool usable) noexcept {
  constexpr double finite = std::numeric_limits<double>::max(), slack = 0x1p-40;
  const double distance = d.x * d.x + d.y * d.y, about = a.about + b.about;
  const double within = (a.within + b.within) + 2 * min(a.within, b.within);
  return guarded(both(usable, (distance + about) + sum <= finite), distance <= (1 - slack) * within,
                 distance > (2 + slack) * about);
}

/// Lanes do not look.
template <class V>
inline constexpr bool looks = std::is_same_v<V, double>;

}  // namespace vesica::filter
