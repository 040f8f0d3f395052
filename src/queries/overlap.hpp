// SPDX-License-Identifier: Apache-2.0
// The functions that answer overlap, or overlap of insides, for a pair of kinds. The C interface calls them too.
#pragma once

#include "compiled_once.hpp"
#include "pair_table.hpp"

namespace vesica {

/// Not inlined, so that the code of a pair exists once for both questions.
template <class A, class B>
[[gnu::noinline]] std::int32_t overlap_of_pair(const void* a, const void* b, Common common) noexcept {
  const A& first = *static_cast<const A*>(a);
  const B& second = *static_cast<const B*>(b);
  if (detail::overlap::has_insides_filter<A, B>() && common == Common::insides) {
    return interiors_overlap_or_error(first, second);
  }
  const std::int32_t answer = detail::decide_by_filter(widen(first), widen(second));
  if (answer >= 0) [[likely]]
    return answer;
  return detail::decide_undecided(first, second, common);
}

namespace queries {

struct OverlapOfPair {
  static constexpr Reversal reversal = Reversal::none;
  /// Every pair has its file in overlap/, whether its shapes have a form or not.
  template <class A, class B>
  static constexpr bool answers = true;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b) noexcept {
    return overlap_of_pair<A, B>(&a, &b, Common::any);
  }
};

/// For two shapes in double whose kinds are in order.
using OverlapFunction = std::int32_t (*)(const void* a, const void* b, Common common) noexcept;
struct OverlapTable {
  OverlapFunction of[kind_count][kind_count];
};
extern const OverlapTable overlap_in_order;

}  // namespace queries

#define VESICA_OVERLAP(keyword, A, B)                                                                           \
  keyword std::int32_t overlap_of_pair<A<double>, B<double>>(const void*, const void*, Common common) noexcept; \
  keyword std::int32_t overlap_of_pair<A<float>, B<float>>(const void*, const void*, Common common) noexcept;

#define VESICA_DECLARE(a, A, b, B) VESICA_OVERLAP(extern template, A, B)
VESICA_EACH_PAIR(VESICA_DECLARE)
#undef VESICA_DECLARE

}  // namespace vesica
