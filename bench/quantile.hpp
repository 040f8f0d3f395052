// SPDX-License-Identifier: Apache-2.0
/// The one of many times that a noisy machine disturbs least.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace vesica::bench {

/// The value a share of the numbers stays below. Not interpolated: there are hundreds.
inline double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

}  // namespace vesica::bench
