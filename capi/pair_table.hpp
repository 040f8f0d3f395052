// SPDX-License-Identifier: Apache-2.0
// From two kinds and flat numbers to the function of that pair, by table: each pair's code stays a function of its own.
#pragma once

#include "by_kind.hpp"
#include "vesica.h"

namespace vesica::capi {

using PairFunction = int32_t (*)(const void*, const void*) noexcept;

/// Query::answer(a, b) for shapes read in place: the flat numbers are the core's shapes byte for byte.
template <class Query, class A, class B>
int32_t answer_at(const void* a, const void* b) noexcept {
  return Query::answer(*static_cast<const A*>(a), *static_cast<const B*>(b));
}

#define VESICA_FUNCTION(name, Name) answer_at<Query, A<T>, vesica::Name<T>>,
template <class Query, class T, template <class> class A>
inline constexpr PairFunction row[kind_count] = {VESICA_EACH_SHAPE(VESICA_FUNCTION)};
#undef VESICA_FUNCTION

#define VESICA_ROW(name, Name) row<Query, T, vesica::Name>,
template <class Query, class T>
inline constexpr const PairFunction* table[kind_count] = {VESICA_EACH_SHAPE(VESICA_ROW)};
#undef VESICA_ROW

/// The answer, or the error that comes first of NULL, kind and whatever Query looks at.
template <class Query, class T>
int32_t answer_by_kind(int32_t kind_a, const T* a, int32_t kind_b, const T* b) noexcept {
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  if (!is_kind(kind_a) || !is_kind(kind_b)) return VESICA_E_KIND;
  return table<Query, T>[kind_a][kind_b](a, b);
}

}  // namespace vesica::capi
