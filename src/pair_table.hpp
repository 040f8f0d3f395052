// SPDX-License-Identifier: Apache-2.0
// From two kinds to the function that answers a query for that pair.
#pragma once

#include <utility>
#include <vesica/each_shape.hpp>
#include <vesica/shapes.hpp>

#include "by_kind.hpp"

namespace vesica {

/// Answers a query for two shapes whose numbers lie side by side. Writes the result, if it is more than a code, to out.
/// Returns 0 or more, or an error; out is then untouched.
using PairFunction = std::int32_t (*)(const void* a, const void* b, void* out) noexcept;

#define VESICA_COUNT(a, A, b, B) +1
static_assert(VESICA_EACH_PAIR(VESICA_COUNT) == kind_count * (kind_count + 1) / 2, "a pair of kinds is not listed");
#undef VESICA_COUNT

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

/// Numbers of a result of (b, a), as those of (a, b): of points, or of a direction.
template <class T>
void reverse(Reversal reversal, T* numbers) noexcept {
  if (reversal == Reversal::points) {
    std::swap(numbers[1], numbers[3]);
    std::swap(numbers[2], numbers[4]);
  } else {
    numbers[1] = 0 - numbers[1];  // no -0
    numbers[2] = 0 - numbers[2];
  }
}

/// A query whose result is more than the returned code.
template <class Query, class T>
concept HasResult = requires {
  typename Query::template Result<T>;
};

/// The pairs that a query answers: those of shapes with a core, unless it has an `answers` of its own.
template <class Query, class A, class B>
consteval bool answers() noexcept {
  if constexpr (requires { Query::template answers<A, B>; }) {
    return Query::template answers<A, B>;
  } else {
    return HasCore<A> && HasCore<B>;
  }
}

/// The table's entry for a pair that the query does not answer.
inline std::int32_t unknown_pair(const void*, const void*, void*) noexcept { return error_kind; }

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

/// A float direction must be reversed before it is rounded: a component that rounds to 0 would lose its sign.
template <class Query, class Scalar>
inline constexpr bool can_be_reversed =
    Query::reversal != Reversal::unknown && !(Query::reversal == Reversal::direction && std::is_same_v<Scalar, float>);

/// A pair in the other order. Relations are compiled in both orders, because converting a code takes longer; the other
/// queries that can be reversed are compiled in one order only.
template <class Query, class A, class B>
std::int32_t answer_reversed(const void* a, const void* b, void* out) noexcept {
  using T = typename ShapeTraits<A>::Scalar;
  if constexpr (!can_be_reversed<Query, T> || Query::reversal == Reversal::converse) {
    return answer_pair<Query, A, B>(a, b, out);
  } else {
    const std::int32_t code = answer_pair<Query, B, A>(b, a, out);
    if constexpr (Query::reversal != Reversal::none) {
      if (code >= 0) reverse(Query::reversal, static_cast<T*>(out));
    }
    return code;
  }
}

/// A pair in both orders.
template <class Query, class A, class B>
consteval void enter_pair(PairTable& table) noexcept {
  PairFunction& in_order = table.of[static_cast<int>(ShapeTraits<A>::kind)][static_cast<int>(ShapeTraits<B>::kind)];
  PairFunction& reversed = table.of[static_cast<int>(ShapeTraits<B>::kind)][static_cast<int>(ShapeTraits<A>::kind)];
  if constexpr (answers<Query, A, B>()) {
    reversed = answer_reversed<Query, B, A>;
    in_order = answer_pair<Query, A, B>;  // of two shapes of one kind this is the one that stays
  } else {
    reversed = in_order = unknown_pair;
  }
}

/// Every two kinds in either order.
template <class Query, class T>
consteval PairTable pair_table() noexcept {
  PairTable table{};
#define VESICA_ENTRY(a, A, b, B) enter_pair<Query, A<T>, B<T>>(table);
  VESICA_EACH_PAIR(VESICA_ENTRY)
#undef VESICA_ENTRY
  return table;
}

}  // namespace vesica
