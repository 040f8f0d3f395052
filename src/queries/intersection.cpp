// SPDX-License-Identifier: Apache-2.0
#include <vesica/intersection.hpp>

#include "compiled_once.hpp"
#include "topology.hpp"

namespace vesica::queries {

namespace {

struct IntersectionOfPair {
  static constexpr Reversal reversal = Reversal::none;
  template <class T>
  using Result = SharedRegion<T>;
  template <class A, class B>
  static constexpr bool answers = HasCore<A>&& HasCore<B>&& detail::intersection::answers<A, B>;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return intersection_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query intersection{
    .doubles = pair_table<IntersectionOfPair, double>(),
    .floats = pair_table<IntersectionOfPair, float>(),
    .reversal = IntersectionOfPair::reversal,
    .paths = polygon::intersection,
    .takes_path = polygon::has_intersection,
};

}  // namespace vesica::queries
