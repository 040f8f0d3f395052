// SPDX-License-Identifier: Apache-2.0
// From two kinds to the function that answers a query for that pair.
#pragma once

#include <utility>
#include <vesica/each_shape.hpp>
#include <vesica/shapes.hpp>

namespace vesica {

/// Answers a query for two shapes whose numbers lie side by side. Writes the result, if it is more than a code, to out.
/// Returns 0 or more, or an error; out is then untouched.
using PairFunction = std::int32_t (*)(const void* a, const void* b, void* out) noexcept;

/// Indexed by the two kinds.
struct PairTable {
  PairFunction of[kind_count][kind_count];
};

/// How the result for (b, a) becomes the one for (a, b).
enum class Reversal {
  none,       // they are the same
  points,     // (distance, ax, ay, bx, by): the points are exchanged
  direction,  // (depth, x, y): the direction is turned round
  converse,   // a relation's code
  unknown,    // it does not: the query answers each pair in both orders
};

/// Numbers of a result of (b, a), as those of (a, b).
template <class T>
void reverse(Reversal reversal, T* numbers) noexcept {
  if (reversal == Reversal::points) {
    std::swap(numbers[1], numbers[3]);
    std::swap(numbers[2], numbers[4]);
  } else if (reversal == Reversal::direction) {
    numbers[1] = 0 - numbers[1];  // no -0
    numbers[2] = 0 - numbers[2];
  }
}

/// A query whose result is more than the returned code.
template <class Query, class T>
concept HasResult = requires {
  typename Query::template Result<T>;
};

/// Query::answer for shapes read, and a result written, in place: flat numbers and the C structs are the core's shapes
/// and results byte for byte. Never inlined, so that the code of a pair exists once.
template <class Query, class A, class B>
[[gnu::noinline]] std::int32_t answer_pair(const void* a, const void* b, [[maybe_unused]] void* out) noexcept {
  const A& first = *static_cast<const A*>(a);
  const B& second = *static_cast<const B*>(b);
  using T = typename ShapeTraits<A>::Scalar;
  if constexpr (HasResult<Query, T>) {
    return Query::answer(first, second, *static_cast<typename Query::template Result<T>*>(out));
  } else {
    return Query::answer(first, second);
  }
}

/// A pair in the other order. Where the answer is a code there is little to do, so the core is asked in that order; the
/// longer ways to a result are there in one order only.
template <class Query, class A, class B>
std::int32_t answer_reversed(const void* a, const void* b, void* out) noexcept {
  using T = typename ShapeTraits<A>::Scalar;
  if constexpr (!HasResult<Query, T> || Query::reversal == Reversal::unknown) {
    return answer_pair<Query, A, B>(a, b, out);
  } else {
    const std::int32_t code = answer_pair<Query, B, A>(b, a, out);
    if (code >= 0) reverse(Query::reversal, static_cast<T*>(out));
    return code;
  }
}

/// Every two kinds in either order.
template <class Query, class T>
consteval PairTable pair_table() noexcept {
  PairTable table{};
  // Of two shapes of one kind the second line overwrites the first.
#define VESICA_ENTRY(a, A, b, B)                                                                       \
  table.of[static_cast<int>(Kind::b)][static_cast<int>(Kind::a)] = answer_reversed<Query, B<T>, A<T>>; \
  table.of[static_cast<int>(Kind::a)][static_cast<int>(Kind::b)] = answer_pair<Query, A<T>, B<T>>;
  VESICA_EACH_PAIR(VESICA_ENTRY)
#undef VESICA_ENTRY
  return table;
}

}  // namespace vesica
