// SPDX-License-Identifier: Apache-2.0
// Calls about one pair of shapes that need not read the control register. Included once, by src/isa/<set>_calls.cpp,
// after Steady and Ordered, whose operations do not depend on it.
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

/// Filters choose this over filter::guarded(): one bit to test instead of two to combine. Where the pair is undecided
/// the other one means nothing.
inline filter::DecidedVerdict<Bit> guarded(Bit usable, const filter::Estimate<Steady>& gap) noexcept {
  return {gap.value < Steady(0.0), both(usable, abs(gap.value) > gap.error)};
}

VESICA_INLINE std::int32_t answer_of(const filter::Verdict<Bit>& v) noexcept { return detail::answer_of(v); }
VESICA_INLINE std::int32_t answer_of(const filter::DecidedVerdict<Bit>& v) noexcept {
  return v.decided ? static_cast<std::int32_t>(v.overlap) : -1;
}

template <class A, class B>
VESICA_INLINE std::int32_t by_filter(const A& a, const B& b) noexcept {
  return answer_of(detail::overlap::filter(a, b));
}
/// Rectangles have the filter of arrays where their axes are near unit length. It takes three quarters of the time, and
/// whether it serves can mostly be predicted.
VESICA_INLINE std::int32_t by_filter(const Rect<Steady>& a, const Rect<Steady>& b) noexcept {
  const auto box_a = filter::box(a), box_b = filter::box(b);
  if (filter::unit_box_box_usable(box_a, box_b)) [[likely]]
    return answer_of(filter::unit_box_box(box_a, box_b, filter::offset(filter::place(a), filter::place(b))));
  return by_filter<Rect<Steady>, Rect<Steady>>(a, b);
}

/// 1, 0, or -1 for what the caller shall decide.
template <class A, class B>
VESICA_INLINE std::int32_t decide_call(const void* a, const void* b) noexcept {
  if (!keeps_subnormals()) [[unlikely]]
    return -1;
  return by_filter(Read<A>::from(a), Read<B>::from(b));
}

/// Points and AABBs are compared as integers: even subnormals do not matter.
VESICA_INLINE std::int32_t compared(Both valid, Both overlap) noexcept {
  if ((_cvtmask8_u32(valid) & all_of_both) != all_of_both) [[unlikely]]
    return -1;
  return static_cast<std::int32_t>(_cvtmask8_u32(overlap) == all_of_both);
}
template <class T>
VESICA_INLINE std::int32_t by_order(const Point<T>& a, const Point<T>& b) noexcept {
  const Ordered<T> p(a.x), q(b.x);
  return compared(finite(p, q), p == q);
}
template <class T>
VESICA_INLINE std::int32_t by_order(const Point<T>& point, const Aabb<T>& box) noexcept {
  const Ordered<T> p(point.x), min(box.min_x), max(box.max_x);
  return compared(both_of(finite(p, min, max), min <= max), both_of(min <= p, p <= max));
}
template <class T>
VESICA_INLINE std::int32_t by_order(const Aabb<T>& a, const Aabb<T>& b) noexcept {
  const Ordered<T> min_a(a.min_x), max_a(a.max_x), min_b(b.min_x), max_b(b.max_x);
  return compared(both_of(finite(min_a, max_a, min_b, max_b), min_a <= max_a, min_b <= max_b),
                  both_of(min_a <= max_b, min_b <= max_a));
}
template <class A, class B>
requires requires(const A& a, const B& b) { by_order(a, b); }
VESICA_INLINE std::int32_t decide_call(const void* a, const void* b) noexcept {
  return by_order(*static_cast<const A*>(a), *static_cast<const B*>(b));
}

/// The pair's filter alone. What it leaves undecided is for rest(), which reads the register.
template <class A, class B>
VESICA_KERNEL std::int32_t call(const void* a, const void* b, RestOfCall rest) noexcept {
  const std::int32_t answer = decide_call<A, B>(a, b);
  if (answer >= 0) [[likely]]
    return answer;
  return rest(a, b);
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
