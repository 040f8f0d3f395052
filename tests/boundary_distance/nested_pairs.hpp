// SPDX-License-Identifier: Apache-2.0
/// Random pairs whose second shape lies strictly inside the first, by the exact relation.
#pragma once

#include <optional>

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace nested_pairs {

enum class Style {
  any,   ///< aspect ratios up to 20, any place
  thin,  ///< up to 1e6, the inner shape often nearly parallel to the outer
  nearly_concentric,
  nearly_equal,    ///< the inner shape is the outer one but for 1e-1 to 1e-15; concentric or not
  near_osculating  ///< at an end of the outer shape, a circle of about the radius of curvature there
};
inline constexpr Style all_styles[] = {Style::any, Style::thin, Style::nearly_concentric, Style::nearly_equal,
                                       Style::near_osculating};
const char* name(Style style);

/// Outer and inner: kinds with area (2 to 7) and any. Sizes about 1; gaps from 1 down to 1e-15. No result where a draw
/// could not be brought inside.
std::optional<properties::Pair> draw(Style style, int outer, int inner, properties::Random& random);

}  // namespace nested_pairs
