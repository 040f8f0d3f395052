// SPDX-License-Identifier: Apache-2.0
/// Angles, and areas of what a chord cuts off the unit disc, by polynomials: the same bits on every platform.
#pragma once

#include <cmath>
#include <vesica/area/measure.hpp>

namespace vesica::detail::area {

/// The tangents of pi / 8 and 3 pi / 8. Arguments are reduced to the interval up to the first.
inline constexpr double tan_eighth = 0x1.a827999fcef32p-2, tan_three_eighths = 0x1.3504f333f9de6p+1;

/// (t - arctan t) / t^3 as a polynomial in z = t^2, interpolated at Chebyshev's points. Its relative error is at most
/// 2^-52 for |t| <= tan(pi / 8).
inline double arctangent_defect(double z) noexcept {
  double p = 0x1.3a31b1c0fd3b7p-6;
  p = p * z - 0x1.4162c02b1dda3p-5;
  p = p * z + 0x1.a0999c632b6edp-5;
  p = p * z - 0x1.dfe6497e96323p-5;
  p = p * z + 0x1.10fa77b1a6d57p-4;
  p = p * z - 0x1.3b1263064f6b9p-4;
  p = p * z + 0x1.745d0b28a7e37p-4;
  p = p * z - 0x1.c71c71853d7fap-4;
  p = p * z + 0x1.2492492436201p-3;
  p = p * z - 0x1.999999999934cp-3;
  return p * z + 0x1.5555555555555p-2;
}

/// (arctan t - t / (1 + t^2)) / t^3 likewise, within 2^-53. The two terms agree to first order, and for a shallow
/// segment their difference would keep nothing.
inline double segment_series(double z) noexcept {
  double p = -0x1.73f02327836dap-2;
  p = p * z + 0x1.78a267dcd50b1p-1;
  p = p * z - 0x1.cd1e4df91e1d1p-1;
  p = p * z + 0x1.e0f344d146db7p-1;
  p = p * z - 0x1.e1743ef8eca8ap-1;
  p = p * z + 0x1.ddd623c5da3f2p-1;
  p = p * z - 0x1.d89d2d616ddf1p-1;
  p = p * z + 0x1.d1745a563849ap-1;
  p = p * z - 0x1.c71c71baac99ep-1;
  p = p * z + 0x1.b6db6db6be540p-1;
  p = p * z - 0x1.99999999997eep-1;
  return p * z + 0x1.5555555555555p-1;
}

/// The angle of (x, y), y >= 0, from the positive x axis: 0 to pi, within 2^-51; 0 for the origin.
inline double angle(double y, double x) noexcept {
  const double length = std::fabs(x);
  double t, base;
  if (y <= tan_eighth * length) {
    if (y == 0) return x < 0 ? pi_high : 0;
    t = y / length;
    base = 0;
  } else if (y < tan_three_eighths * length) {
    t = (y - length) / (y + length);
    base = pi_high / 4;
  } else {
    t = -length / y;
    base = pi_high / 2;
  }
  const double z = t * t, between = base + (t - t * z * arctangent_defect(z));
  return x < 0 ? pi_high - between : between;
}

/// The area between an arc of the unit circle of at most half a turn and its chord: (w - sin w) / 2 for the arc's
/// angle w, given the squares of numbers in the ratio of sin (w / 2) to cos (w / 2). The lengths of the difference and
/// of the sum of the arc's end points are such. Relative error below 2^-49 for a shallow segment, and absolute below
/// 2^-51 for any.
inline double segment_area(double sine_squared, double cosine_squared) noexcept {
  if (sine_squared <= tan_eighth * tan_eighth * cosine_squared) {
    if (sine_squared == 0) return 0;
    const double z = sine_squared / cosine_squared;
    return std::sqrt(z) * z * segment_series(z);
  }
  const double sine = std::sqrt(sine_squared), cosine = std::sqrt(cosine_squared);
  return angle(sine, cosine) - sine * cosine / (sine_squared + cosine_squared);
}

}  // namespace vesica::detail::area
