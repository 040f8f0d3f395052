// SPDX-License-Identifier: Apache-2.0
/// The length of a vector. The C library's hypot differs between systems in its last digit; this one gives the same
/// bits everywhere.
#pragma once

#include <cmath>
#include <vesica/arithmetic/double_double.hpp>
#include <vesica/arithmetic/scaled.hpp>

namespace vesica::detail::arithmetic {

/// sqrt(x^2 + y^2) where the larger of |x| and |y| is in [1/2, 1), right to 0.5 + 2^-48 units in its last place: the
/// squares and their sum are kept to 2^-105, and one step of Newton's corrects the root.
inline double length_of_scaled(double x, double y) noexcept {
  const Pair<double> xx = two_product_fused(x, x), yy = two_product_fused(y, y), sum = two_sum(xx.high, yy.high);
  const double root = std::sqrt(sum.high);
  const double rest = std::fma(-root, root, sum.high) + (sum.low + (xx.low + yy.low));
  return root + rest / (2 * root);
}

/// sqrt(x^2 + y^2) of finite numbers: infinite only where the length itself is beyond them.
inline double length(double x, double y) noexcept {
  const double larger = std::fmax(std::fabs(x), std::fabs(y));
  if (larger == 0) return 0;
  const int exponent = exponent_of(larger);
  return scale_far(length_of_scaled(scale_far(x, -exponent), scale_far(y, -exponent)), exponent);
}

}  // namespace vesica::detail::arithmetic
