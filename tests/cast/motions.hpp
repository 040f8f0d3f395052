// SPDX-License-Identifier: Apache-2.0
/// Velocities and ends for pairs of shapes: of all directions and lengths, towards the other shape, and about the very
/// numbers at which a hit becomes a miss.
#pragma once

#include <vector>

#include "cast/face.hpp"
#include "properties/random.hpp"

namespace cast_test {

/// A motion for a pair, from its own magnitudes.
Motion draw_motion(const Pair& pair, Scalar scalar, properties::Random& random);

struct Moving {
  Pair pair;
  Motion motion;
};

/// One number of the velocity, the end or a position bisected until neighbours differ in hit and miss, and the numbers
/// up to `places` about; nothing where a hit cannot be made a miss.
std::vector<Moving> about_grazing(const Moving& hit, Scalar scalar, properties::Random& random, int places);

}  // namespace cast_test
