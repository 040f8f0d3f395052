// SPDX-License-Identifier: Apache-2.0
#include <vesica/de9im.hpp>

#include "compiled_once.hpp"
#include "topology.hpp"

namespace vesica::queries {

namespace {

struct De9imOfPair {
  static constexpr Reversal reversal = Reversal::unknown;  // its result is no list of numbers
  template <class T>
  using Result = NineIntersections;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return de9im_or_error(a, b, out);
  }
};

}  // namespace

constinit const Query de9im{
    .doubles = pair_table<De9imOfPair, double>(),
    .floats = pair_table<De9imOfPair, float>(),
    .reversal = De9imOfPair::reversal,
    .paths = polygon::de9im,
};

}  // namespace vesica::queries
