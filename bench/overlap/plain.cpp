// SPDX-License-Identifier: Apache-2.0
// Pairs without a yardstick or targets. The three others have a file each.
#include <vesica/each_shape.hpp>

#include "pair.hpp"

namespace vesica::bench {
namespace {

constexpr bool has_own_file(std::int32_t kind) { return kind == VESICA_RECT || kind == VESICA_ELLIPSE; }

template <auto f64, auto f32>
bool add() {
  using Typed = TypedPasses<f64, nullptr>;
  if constexpr (has_own_file(kind_of<typename Typed::A>) && has_own_file(kind_of<typename Typed::B>)) {
    return true;
  } else {
    return add_plain_rows<f64, f32>();
  }
}

#define VESICA_ADD(a, A, b, B) add<vesica_overlap_##a##_##b##_f64, vesica_overlap_##a##_##b##_f32>()&&
const bool added = VESICA_EACH_PAIR(VESICA_ADD) true;
#undef VESICA_ADD

}  // namespace
}  // namespace vesica::bench
