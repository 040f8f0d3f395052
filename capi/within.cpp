// SPDX-License-Identifier: Apache-2.0
// Shapes at most a distance apart: two, and arrays of them.
#include "queries/within.hpp"

#include <cmath>
#include <vesica/within.hpp>

#include "arrays.hpp"
#include "environment.hpp"
#include "polygon/answers.hpp"
#include "vesica_measures.h"

namespace {

using namespace vesica::capi;
namespace queries = vesica::queries;

consteval bool is_code(vesica::Within answer, int32_t code) { return static_cast<int32_t>(answer) == code; }

// The core's answers are the C interface's.
static_assert(is_code(vesica::Within::no, VESICA_WITHIN_NO) && is_code(vesica::Within::yes, VESICA_WITHIN_YES));
static_assert(is_code(vesica::Within::nearly, VESICA_WITHIN_NEARLY));

template <class T>
int32_t within(int32_t kind_a, const void* a, int32_t kind_b, const void* b, T distance) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(within<T>, kind_a, a, kind_b, b, distance);
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  if (!(vesica::has_core_or_path(kind_a) && vesica::has_core_or_path(kind_b))) return VESICA_E_KIND;
  if (std::isnan(distance)) return VESICA_E_ARGUMENT;
  if (!vesica::is_row(kind_a) || !vesica::is_row(kind_b)) {
    constexpr bool is_float = std::is_same_v<T, float>;
    return vesica::polygon::within({kind_a, is_float, a}, {kind_b, is_float, b}, static_cast<double>(distance));
  }
  const queries::WithinOfPair pair = queries::within(kind_a, kind_b);
  if constexpr (std::is_same_v<T, double>) {
    return pair(static_cast<const double*>(a), static_cast<const double*>(b), distance);
  } else {
    double first[vesica::max_fields], second[vesica::max_fields];
    widen<T>(kind_a, a, first);
    widen<T>(kind_b, b, second);
    return pair(first, second, static_cast<double>(distance));
  }
}

int64_t result(const vesica::batch::WithinTally& tally) noexcept {
  return tally.error != 0 ? tally.error : tally.count;
}

template <class T>
int64_t within_many(const CShapesOf<T>* a, const CShapesOf<T>* b, T distance, uint8_t* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(within_many<T>, a, b, distance, out);
  const int32_t error = check_call(a, b, out, anything(a, b), vesica::has_core_or_path);
  if (error != 0) return error;
  const int64_t n = pairs_in_step(*a, *b);
  if (n < 0 || std::isnan(distance)) return VESICA_E_ARGUMENT;
  return result(vesica::batch::within_many<T>(view<T>(*a), view<T>(*b), n, static_cast<double>(distance), out));
}

template <class T>
int64_t within_matrix(const CShapesOf<T>* a, const CShapesOf<T>* b, T distance, uint8_t* out,
                      ptrdiff_t row_stride) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(within_matrix<T>, a, b, distance, out, row_stride);
  const int32_t error = check_call(a, b, out, anything(a, b), vesica::has_core_or_path);
  if (error != 0) return error;
  if (!rows_apart(a->count, b->count, row_stride, 1) || std::isnan(distance)) return VESICA_E_ARGUMENT;
  if (!anything(a, b)) return 0;
  return result(
      vesica::batch::within_matrix<T>(view<T>(*a), view<T>(*b), static_cast<double>(distance), out, row_stride));
}

}  // namespace

#define VESICA_WITHIN(scalar, T)                                                                                      \
  int32_t vesica_within_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b, T distance) {          \
    return within(kind_a, a, kind_b, b, distance);                                                                    \
  }                                                                                                                   \
  int64_t vesica_within_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, T distance,   \
                                      uint8_t* out) {                                                                 \
    return within_many<T>(a, b, distance, out);                                                                       \
  }                                                                                                                   \
  int64_t vesica_within_matrix_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, T distance, \
                                        uint8_t* out, ptrdiff_t row_stride) {                                         \
    return within_matrix<T>(a, b, distance, out, row_stride);                                                         \
  }

VESICA_WITHIN(f64, double)
VESICA_WITHIN(f32, float)
