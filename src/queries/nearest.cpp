// SPDX-License-Identifier: Apache-2.0
#include <vesica/nearest.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct NearestOfPair {
  using Result = ClosestPoints<double>;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return nearest_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query nearest{
    .pairs = pairs_in_order<NearestOfPair>(),
    .reversal = Reversal::points,
    .numbers = 5,
    .is_length = true,
    .counts_zero = true,
    .kernels = &QueryTable::nearest,
    .known = Known::overlap,
};

}  // namespace vesica::queries
