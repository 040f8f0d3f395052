// SPDX-License-Identifier: Apache-2.0
/// Steps of searches that go from one case to a better one. The numbers are doubles.
#pragma once

#include "properties/random.hpp"
#include "stress/query.hpp"

namespace stress {

/// Returns the pair with some numbers changed: a new exponent, a copy of another number, a neighbour, a sum; all
/// numbers of one role scaled; or moved to where the relation changes. A valid pair stays valid.
Pair changed(Pair pair, properties::Random& random);

/// The case with another pair, or where a shape moves another motion.
Case changed(Case c, properties::Random& random);

}  // namespace stress
