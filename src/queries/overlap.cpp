// SPDX-License-Identifier: Apache-2.0
#include <vesica/overlap.hpp>

#include "compiled_once.hpp"
#include "query.hpp"

namespace vesica::queries {

namespace {

struct OverlapOfPair {
  static constexpr Reversal reversal = Reversal::none;
  /// Every pair has its file in overlap/, whether its shapes have a form or not.
  template <class A, class B>
  static constexpr bool answers = true;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b) noexcept {
    return overlap_or_error(a, b);
  }
};

}  // namespace

// Batches of overlap have an engine of their own.
constinit const Query overlap{
    .doubles = pair_table<OverlapOfPair, double>(),
    .floats = pair_table<OverlapOfPair, float>(),
    .reversal = OverlapOfPair::reversal,
};

}  // namespace vesica::queries
