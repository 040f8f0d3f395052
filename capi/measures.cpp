// SPDX-License-Identifier: Apache-2.0
// Ratios of shared area, and the matrices of queries that have more than one number.
#include "queries/ratio.hpp"
#include "query_calls.hpp"
#include "vesica_measures.h"

namespace {

using namespace vesica::capi;
using vesica::Ratio;
namespace queries = vesica::queries;

consteval bool is_code(Ratio ratio, int32_t code) { return static_cast<int32_t>(ratio) == code; }

// The core's ratios are the C interface's.
static_assert(is_code(Ratio::over_union, VESICA_RATIO_OVER_UNION));
static_assert(is_code(Ratio::over_first, VESICA_RATIO_OVER_FIRST));
static_assert(is_code(Ratio::over_second, VESICA_RATIO_OVER_SECOND));
static_assert(is_code(Ratio::over_smaller, VESICA_RATIO_OVER_SMALLER));
static_assert(is_code(Ratio::generalized, VESICA_RATIO_GENERALIZED));
static_assert(is_code(Ratio::distance, VESICA_RATIO_DISTANCE) && is_code(Ratio::complete, VESICA_RATIO_COMPLETE));

using vesica::is_ratio;

template <class T>
int32_t ratio_of(int32_t ratio, int32_t kind_a, const void* a, int32_t kind_b, const void* b, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(ratio_of<T>, ratio, kind_a, a, kind_b, b, out);
  if (a == nullptr || b == nullptr || out == nullptr) return VESICA_E_NULL;
  if (!vesica::has_core_or_path(kind_a) || !vesica::has_core_or_path(kind_b)) return VESICA_E_KIND;
  if (!is_ratio(ratio)) return VESICA_E_ARGUMENT;
  if (!vesica::is_row(kind_a) || !vesica::is_row(kind_b)) {
    return vesica::ask<T>(queries::ratio(static_cast<Ratio>(ratio)), kind_a, a, kind_b, b, out);
  }
  double first[vesica::max_fields], second[vesica::max_fields], result = 0;
  widen<T>(kind_a, a, first);
  widen<T>(kind_b, b, second);
  const int32_t error = queries::ratio_of_pair(static_cast<Ratio>(ratio), kind_a, first, kind_b, second, result);
  if (error == 0) *out = static_cast<T>(result);
  return error;
}

/// The result for arrays if the ratio is none.
template <class Shapes>
int64_t not_a_ratio(const Shapes* a, const Shapes* b, const void* out) noexcept {
  return first_error(check_call(a, b, out, anything(a, b), vesica::has_core_or_path), VESICA_E_ARGUMENT);
}

}  // namespace

#define VESICA_RATIO(scalar, T)                                                                                        \
  int32_t vesica_ratio_##scalar(int32_t ratio, int32_t kind_a, const void* a, int32_t kind_b, const void* b, T* out) { \
    return ratio_of(ratio, kind_a, a, kind_b, b, out);                                                                 \
  }                                                                                                                    \
  int64_t vesica_ratio_many_##scalar(int32_t ratio, const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b,  \
                                     T* out) {                                                                         \
    if (!is_ratio(ratio)) return not_a_ratio(a, b, out);                                                               \
    T* const columns[] = {out};                                                                                        \
    return many<T>(queries::ratio(static_cast<Ratio>(ratio)), a, b, columns);                                          \
  }                                                                                                                    \
  int64_t vesica_ratio_matrix_##scalar(int32_t ratio, const vesica_shapes_##scalar* a,                                 \
                                       const vesica_shapes_##scalar* b, T* out, ptrdiff_t row_stride) {                \
    if (!is_ratio(ratio)) return not_a_ratio(a, b, out);                                                               \
    return matrix<T>(queries::ratio(static_cast<Ratio>(ratio)), a, b, out, row_stride);                                \
  }

#define VESICA_MATRIX(name, scalar, T)                                                                              \
  int64_t vesica_##name##_matrix_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, T* out, \
                                          ptrdiff_t row_stride) {                                                   \
    return matrix<T>(queries::name, a, b, out, row_stride);                                                         \
  }

#define VESICA_MEASURES(scalar, T)            \
  VESICA_RATIO(scalar, T)                     \
  VESICA_MATRIX(nearest, scalar, T)           \
  VESICA_MATRIX(boundary_distance, scalar, T) \
  VESICA_MATRIX(depth, scalar, T)

VESICA_MEASURES(f64, double)
VESICA_MEASURES(f32, float)
