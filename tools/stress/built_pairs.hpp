// SPDX-License-Identifier: Apache-2.0
/// Pairs that are hard for plain arithmetic: needles, whose outline turns within a step of most searches; and shapes
/// whose directions are all equally good up to rounding.
#pragma once

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace stress {

/// A rectangle or an ellipse 8 to 2^80 times as long as it is wide, and a shape of a random kind that all but touches
/// it, from outside or inside, along its axis or across it, by far less than a last place or more.
properties::Pair draw_needle_pair(properties::Random& random);

/// Two circles, squares, or rectangles and ellipses that may be as thin as needles, with sizes, axes and places that
/// are equal up to a few last places or a little more; one of them may be larger or smaller.
properties::Pair draw_tie_pair(properties::Random& random);

}  // namespace stress
