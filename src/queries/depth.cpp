// SPDX-License-Identifier: Apache-2.0
#include <vesica/depth.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct DepthOfPair {
  using Result = Penetration<double>;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return depth_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query depth{
    .pairs = pairs_in_order<DepthOfPair>(),
    .reversal = Reversal::direction,
    .numbers = 3,
    .is_length = true,
    .kernels = &QueryTable::depth,
    .known = Known::overlap,
};

}  // namespace vesica::queries
