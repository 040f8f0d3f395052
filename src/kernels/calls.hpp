// SPDX-License-Identifier: Apache-2.0
// Calls about one pair of shapes that need not read the control register. Included once, by src/isa/<set>_calls.cpp,
// after a scalar whose operations do not depend on it.
#pragma once

#include <vesica/overlap.hpp>

#include "kernels/table.hpp"

namespace vesica {

/// Comparisons of this scalar are no masks: it can jump.
template <>
inline constexpr bool filter::looks<Steady> = true;

namespace {

template <class Shape>
struct Read;
template <template <class> class Shape, class T>
struct Read<Shape<T>> {
  VESICA_INLINE static Shape<Steady> from(const void* numbers) noexcept {
    return detail::with_numbers(*static_cast<const Shape<T>*>(numbers),
                                [](const auto&... x) { return Shape<Steady>{Steady::load(x)...}; });
  }
};

/// The pair's filter alone. What it leaves undecided is for the caller, in the default environment.
template <class A, class B>
VESICA_KERNEL std::int32_t call(const void* a, const void* b, RestOfCall rest) noexcept {
  if (!keeps_subnormals()) [[unlikely]]
    return rest(a, b, false);
  const std::int32_t answer = detail::answer_of(detail::overlap::filter(Read<A>::from(a), Read<B>::from(b)));
  if (answer < 0) [[unlikely]]
    return rest(a, b, true);
  return answer;
}

template <template <class> class A, template <class> class B>
consteval void enter_call(CallTable& calls) noexcept {
  calls.f32[static_cast<int>(kind_of<A>)][static_cast<int>(kind_of<B>)] = call<A<float>, B<float>>;
  calls.f64[static_cast<int>(kind_of<A>)][static_cast<int>(kind_of<B>)] = call<A<double>, B<double>>;
}

consteval CallTable make_calls() noexcept {
  CallTable calls{};
#define VESICA_ENTER(a, A, b, B) enter_call<A, B>(calls);
  VESICA_EACH_PAIR(VESICA_ENTER)
#undef VESICA_ENTER
  return calls;
}

}  // namespace
}  // namespace vesica
