// SPDX-License-Identifier: Apache-2.0
/// Shapes that are a core with a radius (form/inflated.hpp): the closest points of their cores, and the direction
/// between them.
#pragma once

#include <vesica/nearest/disjoint.hpp>

namespace vesica::detail::nearest {

/// The closest points of two disjoint cores, and the unit vector from a to b. Lengths are in units of 2^exponent, and
/// `size` is at least the pair's scale.
struct ClosestCores {
  Located a, b;
  double nx, ny;
  Twofold<double> distance, radii;
  double radius_a, radius_b;
  double size;
  int exponent;

  /// A point at `length` units from a's core, on the way to b's.
  Located from_a(double length) const noexcept {
    return {a.x + scale_far(length * nx, exponent), a.y + scale_far(length * ny, exponent)};
  }
  Located from_b(double length) const noexcept {
    return {b.x - scale_far(length * nx, exponent), b.y - scale_far(length * ny, exponent)};
  }

  /// The point that divides the way as the radii do. If the shapes overlap, it is at most a radius from either core. It
  /// is the same whichever shape is the first.
  Located common() const noexcept {
    const double sum = rounded(radii);
    const bool a_first = a.x < b.x || (a.x == b.x && a.y < b.y);
    if (sum == 0) return a_first ? a : b;
    return a_first ? from_a(rounded(distance) * (radius_a / sum)) : from_b(rounded(distance) * (radius_b / sum));
  }
};

template <class A, class B>
ClosestCores closest_cores(const A& a, const B& b) noexcept {
  int steps = 0;
  const ScaledPair p = scaled_pair(a, b);
  const Closest c = closest_of_forms(p, steps);
  const auto core_a = form::inflated(a).core;
  const auto core_b = form::inflated(b).core;
  const double larger = max(abs(c.nx), abs(c.ny));
  // No direction: so near that any will do, but for its sign when the shapes are exchanged.
  const bool is_back = p.d.x.high < 0 || (p.d.x.high == 0 && p.d.y.high < 0);
  const double x = larger == 0 ? (is_back ? -1 : 1) : c.nx / larger, y = larger == 0 ? 0 : c.ny / larger;
  const double length = sqrt(x * x + y * y);
  return {located(core_a, p.a, c.a, p.exponent),
          located(core_b, p.b, c.b, p.exponent),
          x / length,
          y / length,
          c.distance,
          exact_sum(p.a.radius, p.b.radius),
          p.a.radius,
          p.b.radius,
          p.size,
          p.exponent};
}

}  // namespace vesica::detail::nearest
