// SPDX-License-Identifier: Apache-2.0
/// How far a computed common point is from an outline. Such points are computed in plain arithmetic, which may fail for
/// needles; this measures the result.
#pragma once

#include <vesica/scalar.hpp>

namespace vesica::detail::nearest {

/// In a pair's unit, in which the scale is about 1, so far from a shape or its outline a common point may be. If it is
/// farther, one of the exact places of crossings.hpp is taken.
inline constexpr double least_certain = 0x1p-52;

/// No less than the distance of the point (x, y) from an ellipse's outline, and hardly more where that is short: the
/// lesser of the distances along either axis, in the ellipse's frame. Beyond the end of an axis the end takes the place
/// of what the other would meet.
inline double off_ellipse(double a, double b, double x, double y) noexcept {
  using namespace lane;
  x = abs(x), y = abs(y);
  const double along = min(x / a, 1.0), across = min(y / b, 1.0);
  const double at_x = a * sqrt((1 - across) * (1 + across)), at_y = b * sqrt((1 - along) * (1 + along));
  return min(abs(x - at_x) + positive_part(y - b), abs(y - at_y) + positive_part(x - a));
}

}  // namespace vesica::detail::nearest
