// SPDX-License-Identifier: Apache-2.0
/// The distance along a direction that rounding has left too far from the best one: nearly touching shapes:
/// one bends sharply where they are closest. There the last step of Newton's method is so long that its own rounding
/// shows in the distance. Here that step is computed to twice the precision.
#pragma once

#include <vesica/nearest/direction.hpp>

namespace vesica::detail::nearest {

/// The support point and the height |N| h along N, each to some 2^-100 of the ellipse's size.
struct FineSupport {
  Vector<double> point;
  Twofold<double> height;
  double curvature;
};

VESICA_CALLED inline FineSupport fine_support(const Axes<double>& e,
                                              const VectorFactor<TwofoldFactor<double>>& n) noexcept {
  const VectorFactor<Factor<double>> u = factor(e.ux, e.uy);
  const Twofold<double> p = factor(e.a) * factor(dot(u, n)), q = factor(e.b) * factor(cross(u, n));
  const Root<double> height = root(square(factor(p)) + square(factor(q)));
  const auto scale = factor(inverse(height));
  const auto s = factor(factor(e.a) * factor(renormalised(factor(p) * scale)));
  const auto t = factor(factor(e.b) * factor(renormalised(factor(q) * scale)));
  return {{s * u.x - t * u.y, s * u.y + t * u.x}, height.value, support(e, normal(n)).curvature};
}

inline FineSupport fine_support(const Axes<double>* e, const VectorFactor<TwofoldFactor<double>>& n) noexcept {
  return e == nullptr ? FineSupport{{{0, 0}, {0, 0}}, {0, 0}, 0} : fine_support(*e, n);
}

/// A turn below this moves the distance by less than the last place of any that is promised.
inline constexpr double short_turn = 0x1p-50;

/// Turns at most. Beside the tip of a thin ellipse the first ones only double the way to it: its outline bends most
/// along the sides.
inline constexpr int most_turns = 12;

/// A slope left above this is of a direction that leads to another part of an outline: a needle's turns within less
/// than a step.
inline constexpr double stray_slope = 0x1p-50;

/// The distance between two ellipses, or with a null pointer from a point to an ellipse; d from the first centre to the
/// second, n near the direction from the first to the second. `found`: the distance as it was, which stays where n
/// leads astray.
inline Twofold<double> polished_distance(const Twofold<double>& found, const Vector<double>& d, Direction<double> n,
                                         const Axes<double>* a, const Axes<double>& b) noexcept {
  for (int round = 0;; ++round) {
    const auto vector = factor(Vector<double>{{n.x, 0}, {n.y, 0}});
    const auto normal_of = normal(vector);
    const FineSupport sa = fine_support(a, vector), sb = fine_support(&b, vector);
    const Vector<double> gap = renormalised(d - (sa.point + sb.point));
    const double slope = rounded(cross(vector, factor(gap))) / normal_of.length;
    const double along = rounded(dot(vector, factor(gap))) / normal_of.length;
    const double bend = along + (sa.curvature + sb.curvature), turn = bend > 0 ? slope / bend : 0.0;
    if (round == most_turns || abs(turn) <= short_turn) {
      if (!(abs(slope) <= stray_slope)) return found;
      const Twofold<double> phi =
          factor(dot(vector, factor(d)) - (sa.height + sb.height)) * factor(normal_of.inverse_length);
      // The turn gains no more than the way to the points of support has across the direction.
      return {phi.high, phi.low + min(0.5 * (slope * turn), abs(slope))};
    }
    n = turned(n, turn);
  }
}

}  // namespace vesica::detail::nearest
