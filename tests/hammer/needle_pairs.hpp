// SPDX-License-Identifier: Apache-2.0
/// Needles, and shapes beside their tips and sides: there an outline turns within less than a step of most searches.
#pragma once

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace hammer {

/// A rectangle or an ellipse 8 to 2^80 times as long as it is wide, and a shape of a random kind that all but touches
/// it, from outside or inside, along its axis or across it, by far less than a last place or more.
properties::Pair draw_needle_pair(properties::Random& random);

}  // namespace hammer
