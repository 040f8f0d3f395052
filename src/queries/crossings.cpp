// SPDX-License-Identifier: Apache-2.0
#include <vesica/crossings.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct CrossingsOfPair {
  static constexpr Reversal reversal = Reversal::unknown;
  template <class T>
  using Result = CrossingPoints<T>;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return crossings_or_error(a, b, out);
  }
};

}  // namespace

// Places are in order along the first shape, so neither order of a pair tells the other. There are no batches.
constinit const Query crossings{
    .doubles = pair_table<CrossingsOfPair, double>(),
    .floats = pair_table<CrossingsOfPair, float>(),
    .reversal = CrossingsOfPair::reversal,
};

}  // namespace vesica::queries
