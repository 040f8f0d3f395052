// SPDX-License-Identifier: Apache-2.0
#include <vesica/overlap.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct Overlap {
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b) noexcept {
    return overlap_or_error(a, b);
  }
};

}  // namespace

// Batches of overlap have an engine of their own.
constinit const Query overlap{.pairs = pairs_in_order<Overlap>()};
constinit const PairTable overlap_of_floats = pairs_in_order<Overlap, float>();

}  // namespace vesica::queries
