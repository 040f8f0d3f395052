// SPDX-License-Identifier: Apache-2.0
// Calls about one pair of shapes that need not read the control register. Included once, by src/isa/<set>_calls.cpp,
// after a scalar whose operations do not depend on it.
#pragma once

#include <vesica/overlap.hpp>

#include "kernels/table.hpp"
#include "kernels/unit_rect_rect.hpp"

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

/// 1, 0, or -1 for undecided. In two ways, since either is the quicker one for some filters.
VESICA_INLINE std::int32_t answer_where(Bit keeps, const filter::Verdict<Bit>& v) noexcept {
  return detail::answer_of(filter::guarded(keeps, v.overlap, v.disjoint));
}
VESICA_INLINE std::int32_t answer_where(Bit keeps, const filter::DecidedVerdict<Bit>& v) noexcept {
  return both(keeps, v.decided) ? static_cast<std::int32_t>(v.overlap) : -1;
}

template <class A, class B>
VESICA_INLINE std::int32_t by_filter(Bit keeps, const A& a, const B& b) noexcept {
  return answer_where(keeps, detail::overlap::filter(a, b));
}
VESICA_INLINE std::int32_t by_filter(Bit keeps, const Rect<Steady>& a, const Rect<Steady>& b) noexcept {
  const auto box_a = filter::box(a), box_b = filter::box(b);
  if (filter::unit_box_box_usable(box_a, box_b)) [[likely]]
    return answer_where(keeps, filter::unit_box_box(box_a, box_b, filter::offset(filter::place(a), filter::place(b))));
  return by_filter<Rect<Steady>, Rect<Steady>>(keeps, a, b);
}

/// The pair's filter alone. What it leaves undecided is for the caller, in the default environment.
template <class A, class B>
VESICA_KERNEL std::int32_t call(const void* a, const void* b, RestOfCall rest) noexcept {
  const std::int32_t answer = by_filter(keeps_subnormals(), Read<A>::from(a), Read<B>::from(b));
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
