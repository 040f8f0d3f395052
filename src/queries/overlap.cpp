// SPDX-License-Identifier: Apache-2.0
#include "queries/overlap.hpp"

#include "query.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_OVERLAP(template, A, B)
VESICA_EACH_PAIR(VESICA_DEFINE)
#undef VESICA_DEFINE

namespace queries {

// Batches of overlap have an engine of their own, which calls overlap_of_pair().
constinit const Query overlap{
    .doubles = pair_table<OverlapOfPair, double>(),
    .floats = pair_table<OverlapOfPair, float>(),
    .reversal = OverlapOfPair::reversal,
    .paths = polygon::overlap,
};

consteval OverlapTable overlap_table() noexcept {
  OverlapTable table{};
#define VESICA_ENTER(a, A, b, B)                                                                             \
  table.of[static_cast<int>(ShapeTraits<A<double>>::kind)][static_cast<int>(ShapeTraits<B<double>>::kind)] = \
      overlap_of_pair<A<double>, B<double>>;
  VESICA_EACH_PAIR(VESICA_ENTER)
#undef VESICA_ENTER
  return table;
}
constinit const OverlapTable overlap_in_order = overlap_table();

}  // namespace queries
}  // namespace vesica
