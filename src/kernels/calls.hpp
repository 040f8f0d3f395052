// SPDX-License-Identifier: Apache-2.0
// Calls about one pair of shapes that need not read the control register. Included once, by src/isa/<set>_calls.cpp,
// after a scalar whose operations do not depend on it.
#pragma once

#include <vesica/overlap.hpp>

#include "kernels/filters.hpp"
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

template <class Mask>
VESICA_INLINE filter::Verdict<Mask> verdict(const filter::Verdict<Mask>& v) noexcept {
  return v;
}
template <class Mask>
VESICA_INLINE filter::Verdict<Mask> verdict(const filter::DecidedVerdict<Mask>& v) noexcept {
  return {v.overlap, and_not(v.decided, v.overlap)};
}

template <class A, class B>
VESICA_INLINE auto filter_call(const A& a, const B& b) noexcept {
  return detail::overlap::filter(a, b);
}
VESICA_INLINE auto filter_call(const Rect<Steady>& a, const Rect<Steady>& b) noexcept {
  if (filter::unit_box_box_usable(filter::box(a), filter::box(b))) [[likely]]
    return verdict(UnitAxes::filter(a, b));
  return detail::overlap::filter(a, b);
}

/// The pair's filter alone. What it leaves undecided is for the caller, in the default environment.
template <class A, class B>
VESICA_KERNEL std::int32_t call(const void* a, const void* b, RestOfCall rest) noexcept {
  const auto keeps = keeps_subnormals();
  const auto verdict = filter_call(Read<A>::from(a), Read<B>::from(b));
  const std::int32_t answer = detail::answer_of(filter::guarded(keeps, verdict.overlap, verdict.disjoint));
  return answer >= 0 ? answer : rest(a, b);
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
