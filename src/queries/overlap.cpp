// SPDX-License-Identifier: Apache-2.0
#include "queries/overlap.hpp"

#include "query.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_OVERLAP(template, A, B)
VESICA_EACH_PAIR(VESICA_DEFINE)
#undef VESICA_DEFINE

namespace queries {

// Batches of overlap have an engine of their own.
constinit const Query overlap{
    .doubles = pair_table<OverlapOfPair, double>(),
    .floats = pair_table<OverlapOfPair, float>(),
    .reversal = OverlapOfPair::reversal,
};

}  // namespace queries
}  // namespace vesica
