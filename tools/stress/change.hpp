// SPDX-License-Identifier: Apache-2.0
/// Steps of searches that go from one case to a better one. The numbers are doubles.
#pragma once

#include "properties/random.hpp"
#include "stress/query.hpp"

namespace stress {

/// The pair with some of its numbers changed: another exponent, that of another number, a neighbour, their sum; all of
/// one role scaled; or moved to where the relation changes. It is valid if it was.
Pair changed(Pair pair, properties::Random& random);

/// The case with another pair, or where a shape moves another motion.
Case changed(Case c, properties::Random& random);

}  // namespace stress
