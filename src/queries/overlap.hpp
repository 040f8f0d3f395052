// SPDX-License-Identifier: Apache-2.0
// The functions that answer overlap for a pair of kinds. The typed functions of the C face call them too.
#pragma once

#include "compiled_once.hpp"
#include "pair_table.hpp"

namespace vesica {

namespace queries {

struct OverlapOfPair {
  static constexpr Reversal reversal = Reversal::none;
  /// Every pair has its file in overlap/, whether its shapes have a form or not.
  template <class A, class B>
  static constexpr bool answers = true;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b) noexcept {
    return overlap_or_error(a, b);
  }
};

}  // namespace queries

#define VESICA_OVERLAP(keyword, A, B)                                                                      \
  keyword std::int32_t answer_pair<queries::OverlapOfPair, A<double>, B<double>>(const void*, const void*, \
                                                                                 void*) noexcept;          \
  keyword std::int32_t answer_pair<queries::OverlapOfPair, A<float>, B<float>>(const void*, const void*,   \
                                                                               void*) noexcept;

#define VESICA_DECLARE(a, A, b, B) VESICA_OVERLAP(extern template, A, B)
VESICA_EACH_PAIR(VESICA_DECLARE)
#undef VESICA_DECLARE

}  // namespace vesica
