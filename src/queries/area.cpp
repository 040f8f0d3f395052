// SPDX-License-Identifier: Apache-2.0
#include <vesica/area.hpp>

#include "compiled_once.hpp"
#include "polygon/areas.hpp"
#include "query.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_SHARES(template, A, B)
VESICA_EACH_PAIR_OF_FORMS(VESICA_DEFINE)
#undef VESICA_DEFINE

VESICA_EACH_SHAPE_WITH_AREA(VESICA_SHAPE_MEASURE, template)

}  // namespace vesica

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
    .paths = polygon::area,
    .of_shares = polygon::area_of_shares,
    .is_none_of_none = true,
    .numbers = 1,
    .kernels = &QueryTable::area,
    .known = Known::radius,
};

}  // namespace vesica::queries
