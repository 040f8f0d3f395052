// SPDX-License-Identifier: Apache-2.0
#include <vesica/boundary_distance.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct BoundaryDistanceOfPair {
  using Result = ClosestPoints<double>;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return boundary_distance_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query boundary_distance{
    .pairs = pairs_in_order<BoundaryDistanceOfPair>(),
    .reversal = Reversal::points,
    .numbers = 5,
    .is_length = true,
    .counts_zero = true,
    .kernels = &QueryTable::boundary_distance,
    .known = Known::overlap,
};

}  // namespace vesica::queries
