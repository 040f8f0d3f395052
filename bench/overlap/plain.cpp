// SPDX-License-Identifier: Apache-2.0
// The pairs that have no file of their own: shares that overlap, beside a yardstick each.
#include "textbook/plain.hpp"

#include <vesica/each_shape.hpp>

#include "pair.hpp"

namespace vesica::bench {
namespace {

constexpr bool has_own_file(std::int32_t kind) { return kind == VESICA_RECT || kind == VESICA_ELLIPSE; }

/// textbook::overlap under the type of one pair.
template <auto library>
constexpr auto yardstick = [](const typename Arguments<decltype(library)>::A& a,
                              const typename Arguments<decltype(library)>::B& b) { return textbook::overlap(a, b); };

template <auto f64, auto f32>
bool add() {
  using Typed = TypedPasses<f64, nullptr>;
  constexpr std::int32_t a = kind_of<typename Typed::A>, b = kind_of<typename Typed::B>;
  if constexpr (has_own_file(a) && has_own_file(b)) {
    return true;
  } else {
    const bool is_round = a == VESICA_CIRCLE && b == VESICA_ELLIPSE;
    return add_rates<f64, yardstick<f64>, f32, yardstick<f32>>(is_round ? ratio_at_most(0.6)
                                                                        : nanoseconds_above(2.5)) &&
           add_rows<f64>(
               {{Workload::incident, nanoseconds_at_most(40)}, {Workload::few_digits, nanoseconds_at_most(40)}}) &&
           (b == VESICA_ELLIPSE || add_rows<f64>({{Workload::last_ulp, nanoseconds_at_most(40)}}));
  }
}

#define VESICA_ADD(a, A, b, B) add<vesica_overlap_##a##_##b##_f64, vesica_overlap_##a##_##b##_f32>()&&
const bool added = VESICA_EACH_PAIR_OF_FORMS(VESICA_ADD) true;
#undef VESICA_ADD

}  // namespace
}  // namespace vesica::bench
