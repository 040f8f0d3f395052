// SPDX-License-Identifier: Apache-2.0
// Quartics with known zeros.
#pragma once

#include <vesica/crossings/fixed.hpp>

namespace crossings_test {

/// By the coefficients of powers of t: as Bernstein coefficients, over 2^down.
inline vesica::detail::crossings::Quartic quartic_of_powers(const double (&power)[5], int down) {
  constexpr double binomial[5][5] = {
      {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
  vesica::detail::crossings::Quartic q;
  for (int i = 0; i < 5; ++i) {
    double value = 0;
    for (int j = 0; j <= i; ++j) value += binomial[i][j] / binomial[4][j] * power[j];
    q.coefficient[i] = vesica::detail::crossings::fixed(vesica::exact::from_double(value), down);
  }
  return q;
}

}  // namespace crossings_test
