// SPDX-License-Identifier: Apache-2.0
/// Crossing pairs whose area is hard to compute: what other libraries get wrong, aspects from 1 to 10^4.
#pragma once

#include <array>

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace hard {

enum class Case {
  anywhere,          ///< centres about as far apart as the shapes are large
  nearly_tangent,    ///< outlines pushed past contact from outside, by 10^-17 to 10^-1 of the lesser size
  nested_tangent,    ///< the same from inside
  osculating,        ///< the same with equal curvatures where they meet
  nearly_identical,  ///< one shape and itself with each number changed by up to 10^-17 to 10^-2
  sharing_axes,      ///< parallel or perpendicular axes, centres on a common axis: edges and vertices in common
};

inline constexpr std::array all_cases{Case::anywhere,   Case::nearly_tangent,   Case::nested_tangent,
                                      Case::osculating, Case::nearly_identical, Case::sharing_axes};
const char* name(Case c);

/// Two valid shapes with area, of the kinds given, circle to ellipse, which may or may not cross; sizes differ by up to
/// 10^most_ratio. A kind that cannot have an aspect or a turned axis has none.
properties::Pair draw(Case c, int kind_a, int kind_b, double most_ratio, properties::Random& random);

}  // namespace hard
