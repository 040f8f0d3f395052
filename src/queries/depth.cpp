// SPDX-License-Identifier: Apache-2.0
#include <vesica/depth.hpp>

#include "compiled_once.hpp"
#include "query.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_DEPTH_IN_ORDER(template, A, B)
VESICA_EACH_PAIR_OF_FORMS(VESICA_DEFINE)
VESICA_EACH_PAIR_INFLATED(VESICA_DEFINE)
#undef VESICA_DEFINE

}  // namespace vesica

namespace vesica::queries {

namespace {

struct DepthOfPair {
  static constexpr Reversal reversal = Reversal::direction;
  template <class T>
  using Result = Penetration<T>;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return depth_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query depth{
    .doubles = pair_table<DepthOfPair, double>(),
    .floats = pair_table<DepthOfPair, float>(),
    .reversal = DepthOfPair::reversal,
    .paths = polygon::depth,
    .numbers = 3,
    .is_length = true,
    .kernels = &QueryTable::depth,
    .known = Known::overlap,
};

}  // namespace vesica::queries
