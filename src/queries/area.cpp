// SPDX-License-Identifier: Apache-2.0
#include <vesica/area.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct AreaOfPair {
  static constexpr Reversal reversal = Reversal::none;
  template <class T>
  using Result = T;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return area_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query area{
    .doubles = pair_table<AreaOfPair, double>(),
    .floats = pair_table<AreaOfPair, float>(),
    .reversal = AreaOfPair::reversal,
    .numbers = 1,
    .kernels = &QueryTable::area,
    .known = Known::reach,
};

}  // namespace vesica::queries
