// SPDX-License-Identifier: Apache-2.0
#include <vesica/crossings.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct CrossingsOfPair {
  using Result = CrossingPoints<double>;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return crossings_or_error(a, b, out);
  }
};

}  // namespace

// Places are in order along the first shape, so neither order of a pair tells the other. There are no batches.
constinit const Query crossings{
    .pairs = pairs_in_both_orders<CrossingsOfPair>(),
};

}  // namespace vesica::queries
