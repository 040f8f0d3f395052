// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vesica/signed_distance.hpp>

#include "compiled_once.hpp"
#include "query.hpp"

namespace vesica::queries {

namespace {

struct SignedDistanceOfPair {
  static constexpr Reversal reversal = Reversal::none;
  template <class T>
  using Result = T;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return signed_distance_or_error(a, b, out);
  }
};

/// From the distance, which lanes know; NaN where that is an error.
std::int32_t derive(double distance, const ShapeOfKind& a, const ShapeOfKind& b, double& out) noexcept {
  if (distance > 0) {
    out = distance;
    return 0;
  }
  return signed_distance.doubles.of[a.kind][b.kind](a.numbers, b.numbers, &out);
}

}  // namespace

constinit const Query signed_distance{
    .doubles = pair_table<SignedDistanceOfPair, double>(),
    .floats = pair_table<SignedDistanceOfPair, float>(),
    .reversal = SignedDistanceOfPair::reversal,
    .paths = polygon::signed_distance,
    .numbers = 1,
    .is_length = true,
    .counts_zero = true,
    .asked_instead = &nearest,
    .derive = derive,
};

}  // namespace vesica::queries
