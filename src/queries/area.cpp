// SPDX-License-Identifier: Apache-2.0
#include <vesica/area.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct AreaOfPair {
  using Result = double;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return area_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query area{
    .pairs = pairs_in_order<AreaOfPair>(),
    .numbers = 1,
    .kernels = &QueryTable::area,
    .known = Known::reach,
};

}  // namespace vesica::queries
