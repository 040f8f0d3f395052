// SPDX-License-Identifier: Apache-2.0
// Ratios of shared area: queries that follow from the shared area or from IoU, and from the shapes.
#pragma once

#include <vesica/ratio.hpp>

#include "query.hpp"

namespace vesica::queries {

/// `which` is a Ratio.
const Query& ratio(Ratio which) noexcept;

/// Two shapes given by kind and flat numbers. Returns 0, error_shape or error_argument; the pair's kinds are known to
/// be kinds, and `which` to be a Ratio.
std::int32_t ratio_of_pair(Ratio which, std::int32_t kind_a, const double* a, std::int32_t kind_b, const double* b,
                           double& out) noexcept;

/// True if the number is a Ratio that does not depend on the order of the two shapes.
inline bool is_symmetric(std::int32_t which) noexcept {
  return is_ratio(which) && which != static_cast<std::int32_t>(Ratio::over_first) &&
         which != static_cast<std::int32_t>(Ratio::over_second);
}

}  // namespace vesica::queries
