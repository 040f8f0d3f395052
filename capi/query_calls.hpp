// SPDX-License-Identifier: Apache-2.0
// Calls of the C interface that ask a query, of two shapes or of arrays.
#pragma once

#include "arrays.hpp"
#include "environment.hpp"
#include "queries.hpp"

namespace vesica::capi {

using batch::QueryTally;

/// The result is written in place: a C struct is the core's byte for byte.
template <class T, class Out>
int32_t answer(const Query& query, int32_t kind_a, const void* a, int32_t kind_b, const void* b, Out* out) noexcept {
  return out == nullptr ? VESICA_E_NULL : vesica::ask<T>(query, kind_a, a, kind_b, b, out);
}

/// Checks a call about two shapes whose result has any length; the first `capacity` items are written.
inline int32_t check_room(const Query& query, int32_t kind_a, const void* a, int32_t kind_b, const void* b,
                          const void* out, int64_t capacity) noexcept {
  if (a == nullptr || b == nullptr || (capacity > 0 && out == nullptr)) return VESICA_E_NULL;
  const bool known = is_kind(kind_a) && is_kind(kind_b) && query.answers(kind_a, kind_b);
  if (!known) return VESICA_E_KIND;
  return capacity < 0 ? VESICA_E_ARGUMENT : 0;
}

inline int64_t result(const QueryTally& tally) noexcept { return tally.error != 0 ? tally.error : tally.count; }

/// Columns may be null, but not all of them.
template <class T, class Out>
int64_t many(const Query& query, const CShapesOf<T>* a, const CShapesOf<T>* b, Out* const* columns) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((many<T, Out>), query, a, b, columns);
  const void* some = nullptr;
  for (int k = 0; k < query.columns(); ++k) some = columns[k] != nullptr ? columns[k] : some;
  const int32_t error = check_call(a, b, some, anything(a, b), is_kind);
  if (error != 0) return error;
  if (!query.answers(a->kind, b->kind)) return VESICA_E_KIND;
  const int64_t n = pairs_in_step(*a, *b);
  if (n < 0) return n;
  return result(vesica::batch::query_many(query, vesica::kernels(), view<T>(*a), view<T>(*b), n, columns));
}

template <class T, class Out>
int64_t matrix(const Query& query, const CShapesOf<T>* a, const CShapesOf<T>* b, Out* out,
               ptrdiff_t row_stride) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((matrix<T, Out>), query, a, b, out, row_stride);
  const int32_t error = check_call(a, b, out, anything(a, b), is_kind);
  if (error != 0) return error;
  if (!query.answers(a->kind, b->kind)) return VESICA_E_KIND;
  if (!rows_apart(a->count, b->count, row_stride, sizeof(Out))) return VESICA_E_ARGUMENT;
  if (!anything(a, b)) return 0;
  return result(vesica::batch::query_matrix(query, vesica::kernels(), view<T>(*a), view<T>(*b), out, row_stride));
}

}  // namespace vesica::capi
