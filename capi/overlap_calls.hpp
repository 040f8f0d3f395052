// SPDX-License-Identifier: Apache-2.0
// Calls of overlap, and of overlap of insides, by the kinds of two shapes.
#pragma once

#include "environment.hpp"
#include "polygon/topology.hpp"
#include "queries/overlap.hpp"
#include "query.hpp"
#include "vesica.h"

namespace vesica::capi {

/// For a caller in another environment than the default: the filter too is run in the default one.
template <class A, class B>
[[gnu::noinline, gnu::cold]] int32_t overlap_elsewhere(const void* a, const void* b, Common common) noexcept {
  return call_in_default_environment(overlap_of_pair<A, B>, a, b, common);
}

/// For pairs that the first filter left undecided in the caller's environment. Called last, so that the callers save no
/// registers.
template <class A, class B>
[[gnu::noinline]] int32_t overlap_undecided(const void* a, const void* b, Common common) noexcept {
  const int32_t answer =
      detail::decide_by_second_filter(widen(*static_cast<const A*>(a)), widen(*static_cast<const B*>(b)));
  if (answer >= 0) return answer;
  if (!in_default_environment()) return overlap_elsewhere<A, B>(a, b, common);
  return detail::decide_undecided(*static_cast<const A*>(a), *static_cast<const B*>(b), common);
}

/// The filter's decisions are right in any rounding mode, so no control register is read before it has failed. The C
/// structs are the core's shapes byte for byte, and are read in place.
template <class A, class B>
int32_t overlap_of(const void* a, const void* b, Common common) noexcept {
  if (!keeps_subnormals()) [[unlikely]]
    return overlap_elsewhere<A, B>(a, b, common);
  if (detail::overlap::has_insides_filter<A, B>() && common == Common::insides) {
    const int32_t answer =
        detail::decide_by_filter<Common::insides>(widen(*static_cast<const A*>(a)), widen(*static_cast<const B*>(b)));
    return answer >= 0 ? answer : overlap_undecided<A, B>(a, b, common);
  }
  const int32_t answer =
      detail::decide_by_first_filter(widen(*static_cast<const A*>(a)), widen(*static_cast<const B*>(b)));
  if (answer >= 0) [[likely]]
    return answer;
  return overlap_undecided<A, B>(a, b, common);
}

/// By the two kinds in the order of shapes.
struct Overlaps {
  int32_t (*of[kind_count][kind_count])(const void*, const void*, Common) noexcept;
};
template <class T>
consteval Overlaps overlaps_by_kind() noexcept {
  Overlaps overlaps{};
#define VESICA_ENTER(a, A, b, B)                                                                      \
  overlaps.of[static_cast<int>(ShapeTraits<A<T>>::kind)][static_cast<int>(ShapeTraits<B<T>>::kind)] = \
      overlap_of<A<T>, B<T>>;
  VESICA_EACH_PAIR(VESICA_ENTER)
#undef VESICA_ENTER
  return overlaps;
}
template <class T>
inline constinit const Overlaps overlaps = overlaps_by_kind<T>();

template <class A, class B>
VESICA_INLINE int32_t overlap_typed(const void* a, const void* b) noexcept {
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  return overlap_of<A, B>(a, b, Common::any);
}

/// With a polygon or a polyline. By what counts, so that a program of one question has no code of the other.
template <class T, Common common>
[[gnu::noinline]] int32_t overlap_of_paths(int32_t kind_a, const void* a, int32_t kind_b, const void* b) noexcept {
  constexpr bool is_float = std::is_same_v<T, float>;
  const Operand first{kind_a, is_float, a}, second{kind_b, is_float, b};
  if (keeps_subnormals()) {
    const int32_t answer = polygon::convex_overlap(first, second);
    if (answer >= 0) return answer;
  }
  VESICA_DEFAULT_ENVIRONMENT((overlap_of_paths<T, common>), kind_a, a, kind_b, b);
  if (!is_kind(kind_a) || !is_kind(kind_b)) return VESICA_E_KIND;
  return polygon::overlap_by_edges(common, first, second);
}

template <class T, Common common>
VESICA_INLINE int32_t overlap_by_kind(int32_t kind_a, const void* a, int32_t kind_b, const void* b) noexcept {
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  if (!is_row(kind_a) || !is_row(kind_b)) [[unlikely]]
    return overlap_of_paths<T, common>(kind_a, a, kind_b, b);
  return kind_a <= kind_b ? overlaps<T>.of[kind_a][kind_b](a, b, common) : overlaps<T>.of[kind_b][kind_a](b, a, common);
}

}  // namespace vesica::capi
