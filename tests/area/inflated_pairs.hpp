// SPDX-License-Identifier: Apache-2.0
/// The cases of hard_pairs.hpp for shapes that are a core with a radius.
#pragma once

#include "area/hard_pairs.hpp"
#include "inflated/shapes.hpp"

namespace hard {

struct InflatedPair {
  inflated::Shape a, b;
};

/// Two valid shapes with area, of the kinds given.
InflatedPair draw_inflated(Case c, int kind_a, int kind_b, double most_ratio, properties::Random& random);

}  // namespace hard
