// SPDX-License-Identifier: Apache-2.0
/// How near contact a pair of circle and ellipse is, measured against the bound that a method left uncertain reports.
#pragma once

#include <algorithm>
#include <cmath>

#include "methods/method_pairs.hpp"

namespace method_pairs {

/// The radius at which the circle touches the ellipse; 0 with the centre in the ellipse.
inline double radius_at_contact(const vesica_circle_f64& circle, const vesica_ellipse_f64& ellipse) {
  const auto overlaps = [&](double r) {
    const vesica_circle_f64 c{circle.cx, circle.cy, r};
    return vesica_overlap_circle_ellipse_f64(&c, &ellipse) == 1;
  };
  double apart = 0, together = 1;
  while (!overlaps(together)) together *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (apart + together) / 2;
    (overlaps(middle) ? together : apart) = middle;
  }
  return together;
}

/// The largest |radius - radius at contact| of a pair that the method leaves uncertain, over the bound it reports. For
/// 0 to 8 iterations and ellipses of aspects up to 1e6.
template <class Function>
double largest_share_of_bound(Function function) {
  Random random(properties::seed());
  double largest = 0;
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const double angle = random.between(0, 7), a = random.between(0.25, 2);
    const double b = a * std::pow(10.0, -random.between(0, random.chance(0.5) ? 1 : 6));
    const vesica_ellipse_f64 ellipse{0, 0, std::cos(angle), std::sin(angle), a, b};
    vesica_circle_f64 circle{random.between(-3, 3), random.between(-3, 3), 0};
    const double contact = radius_at_contact(circle, ellipse);
    for (std::int32_t n = 0; n <= 8; ++n) {
      vesica_approximation_f64 out;
      circle.r = std::max(0.0, contact + a * random.between(-1, 1) * std::pow(4.0, -n));
      if (function(&circle, &ellipse, n, &out) != VESICA_UNCERTAIN) continue;
      largest = std::max(largest, std::abs(circle.r - contact) / out.outline_error);
    }
  }
  return largest;
}

}  // namespace method_pairs
