// SPDX-License-Identifier: Apache-2.0
// Queries of two kinds whose answer goes through a pointer: by table, as in pair_table.hpp.
#pragma once

#include "by_kind.hpp"
#include "vesica.h"

namespace vesica::capi {

/// Query::answer(a, b, out) for shapes read in place: the flat numbers are the core's shapes byte for byte.
template <class Query, class Out, class A, class B>
int32_t output_at(const void* a, const void* b, Out& out) noexcept {
  return Query::answer(*static_cast<const A*>(a), *static_cast<const B*>(b), out);
}

template <class Out>
using OutputFunction = int32_t (*)(const void*, const void*, Out&) noexcept;

#define VESICA_FUNCTION(name, Name) output_at<Query, Out, A<T>, vesica::Name<T>>,
template <class Query, class Out, class T, template <class> class A>
inline constexpr OutputFunction<Out> output_row[kind_count] = {VESICA_EACH_SHAPE(VESICA_FUNCTION)};
#undef VESICA_FUNCTION

#define VESICA_ROW(name, Name) output_row<Query, Out, T, vesica::Name>,
template <class Query, class Out, class T>
inline constexpr const OutputFunction<Out>* output_table[kind_count] = {VESICA_EACH_SHAPE(VESICA_ROW)};
#undef VESICA_ROW

/// 0 or more with the answer in *out, or the error that comes first of NULL, kind and whatever Query looks at.
template <class Query, class T, class Out>
int32_t output_by_kind(int32_t kind_a, const T* a, int32_t kind_b, const T* b, Out* out) noexcept {
  if (a == nullptr || b == nullptr || out == nullptr) return VESICA_E_NULL;
  if (!is_kind(kind_a) || !is_kind(kind_b)) return VESICA_E_KIND;
  return output_table<Query, Out, T>[kind_a][kind_b](a, b, *out);
}

}  // namespace vesica::capi
