// SPDX-License-Identifier: Apache-2.0
#include <vesica/nearest.hpp>

#include "compiled_once.hpp"
#include "query.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_NEAREST(template, A, B)
VESICA_EACH_PAIR_OF_FORMS(VESICA_DEFINE)
VESICA_EACH_PAIR_INFLATED(VESICA_DEFINE)
#undef VESICA_DEFINE

}  // namespace vesica

namespace vesica::queries {

namespace {

struct NearestOfPair {
  static constexpr Reversal reversal = Reversal::points;
  template <class T>
  using Result = ClosestPoints<T>;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return nearest_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query nearest{
    .doubles = pair_table<NearestOfPair, double>(),
    .floats = pair_table<NearestOfPair, float>(),
    .reversal = NearestOfPair::reversal,
    .paths = polygon::nearest,
    .numbers = 5,
    .is_length = true,
    .counts_zero = true,
    .kernels = &QueryTable::nearest,
    .known = Known::overlap,
};

}  // namespace vesica::queries
