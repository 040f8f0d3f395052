// SPDX-License-Identifier: Apache-2.0
#include <vesica/boundary_distance.hpp>

#include "compiled_once.hpp"
#include "query.hpp"

namespace vesica::queries {

namespace {

struct BoundaryDistanceOfPair {
  static constexpr Reversal reversal = Reversal::points;
  template <class A, class B>
  static constexpr bool answers = HasCore<A>&& HasCore<B>;
  template <class T>
  using Result = ClosestPoints<T>;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return boundary_distance_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query boundary_distance{
    .doubles = pair_table<BoundaryDistanceOfPair, double>(),
    .floats = pair_table<BoundaryDistanceOfPair, float>(),
    .reversal = BoundaryDistanceOfPair::reversal,
    .paths = polygon::boundary_distance,
    .numbers = 5,
    .is_length = true,
    .counts_zero = true,
    .kernels = &QueryTable::boundary_distance,
    .known = Known::overlap,
};

}  // namespace vesica::queries
