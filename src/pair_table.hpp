// SPDX-License-Identifier: Apache-2.0
// From two kinds to the function that answers a query for that pair.
#pragma once

#include <cstring>
#include <vesica/each_shape.hpp>
#include <vesica/shapes.hpp>

namespace vesica {

/// Answers a query for two shapes whose numbers lie side by side. Writes the numbers of the result, if it has any, to
/// out. Returns 0 or more, or an error; out is then untouched.
using PairFunction = std::int32_t (*)(const void* a, const void* b, void* out) noexcept;

/// Indexed by the two kinds; null for a pair that the query answers in the other order.
struct PairTable {
  PairFunction of[kind_count][kind_count];
};

/// A query that has a result beside the returned code.
template <class Query>
concept HasResult = requires {
  typename Query::Result;
};

/// Query::answer for shapes read in place: flat numbers are the core's shapes byte for byte.
template <class Query, class A, class B>
std::int32_t answer_pair(const void* a, const void* b, [[maybe_unused]] void* out) noexcept {
  const A& first = *static_cast<const A*>(a);
  const B& second = *static_cast<const B*>(b);
  if constexpr (HasResult<Query>) {
    typename Query::Result result{};
    const std::int32_t code = Query::answer(first, second, result);
    if (code >= 0) std::memcpy(out, &result, sizeof result);
    return code;
  } else {
    return Query::answer(first, second);
  }
}

/// Each pair once, the lower kind first.
template <class Query, class T = double>
consteval PairTable pairs_in_order() noexcept {
  PairTable table{};
#define VESICA_ENTRY(a, A, b, B) \
  table.of[static_cast<int>(Kind::a)][static_cast<int>(Kind::b)] = answer_pair<Query, A<T>, B<T>>;
  VESICA_EACH_PAIR(VESICA_ENTRY)
#undef VESICA_ENTRY
  return table;
}

/// Each pair in both orders: for queries whose results for (b, a) do not tell those for (a, b).
template <class Query, class T = double>
consteval PairTable pairs_in_both_orders() noexcept {
  PairTable table{};
#define VESICA_ENTRY(a, A, b, B)                                                                   \
  table.of[static_cast<int>(Kind::a)][static_cast<int>(Kind::b)] = answer_pair<Query, A<T>, B<T>>; \
  table.of[static_cast<int>(Kind::b)][static_cast<int>(Kind::a)] = answer_pair<Query, B<T>, A<T>>;
  VESICA_EACH_PAIR(VESICA_ENTRY)
#undef VESICA_ENTRY
  return table;
}

}  // namespace vesica
