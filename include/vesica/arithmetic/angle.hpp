// SPDX-License-Identifier: Apache-2.0
/// The angle of a vector in the first quadrant. The last digits of the C library's atan2 differ between systems; this
/// one gives the same bits everywhere.
#pragma once

#include <cmath>

namespace vesica::detail::arithmetic {

/// atan(i / 8), each the nearest double.
inline constexpr double angle_of_eighth[] = {0x0.0p+0,
                                             0x1.fd5ba9aac2f6ep-4,
                                             0x1.f5b75f92c80ddp-3,
                                             0x1.6f61941e4def1p-2,
                                             0x1.dac670561bb4fp-2,
                                             0x1.1e00babdefeb4p-1,
                                             0x1.4978fa3269ee1p-1,
                                             0x1.700a7c5784634p-1,
                                             0x1.921fb54442d18p-1};
/// pi / 2 and what it is short of.
inline constexpr double right_angle = 0x1.921fb54442d18p+0, right_angle_rest = 0x1.1a62633145c07p-54;

/// atan(t) for 0 <= t <= 1, to 2u: atan(t) = atan(c) + atan((t - c) / (1 + t c)), where c is the eighth next to t. What
/// is left is at most 1/16 in magnitude, and the first term left out of its series, x^15 / 15, at most 2^-59 of it.
inline double angle_of_tangent(double t) noexcept {
  const int eighths = static_cast<int>(16 * t + 1) / 2;
  const double c = 0.125 * eighths;
  const double x = (t - c) / (1 + t * c), y = x * x;
  const double tail = y * (1.0 / 3 - y * (1.0 / 5 - y * (1.0 / 7 - y * (1.0 / 9 - y * (1.0 / 11 - y * (1.0 / 13))))));
  return angle_of_eighth[eighths] + (x - x * tail);
}

/// The angle from the x axis, in radians, of (x, y) with x, y >= 0; 0 of (0, 0).
inline double angle_of(double x, double y) noexcept {
  if (y <= x) return x == 0 ? 0 : angle_of_tangent(y / x);
  return right_angle - angle_of_tangent(x / y);
}

}  // namespace vesica::detail::arithmetic
