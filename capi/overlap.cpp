// SPDX-License-Identifier: Apache-2.0
#include "queries/overlap.hpp"

#include "environment.hpp"
#include "query.hpp"
#include "vesica.h"

namespace {

/// The C structs are the core's shapes byte for byte, and are read in place.
template <class A, class B>
VESICA_INLINE int32_t overlap_typed(const void* a, const void* b) noexcept {
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  return vesica::answer_pair<vesica::queries::OverlapOfPair, A, B>(a, b, nullptr);
}

}  // namespace

int32_t vesica_overlap_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b) {
  VESICA_DEFAULT_ENVIRONMENT(vesica_overlap_f64, kind_a, numbers_a, kind_b, numbers_b);
  return vesica::ask(vesica::queries::overlap, kind_a, numbers_a, kind_b, numbers_b, nullptr);
}

int32_t vesica_overlap_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b) {
  VESICA_DEFAULT_ENVIRONMENT(vesica_overlap_f32, kind_a, numbers_a, kind_b, numbers_b);
  return vesica::ask(vesica::queries::overlap, kind_a, numbers_a, kind_b, numbers_b, nullptr);
}

#define VESICA_PAIR_OF(a, A, b, B, scalar, T)                                                                   \
  int32_t vesica_overlap_##a##_##b##_##scalar(const vesica_##a##_##scalar* s, const vesica_##b##_##scalar* t) { \
    VESICA_DEFAULT_ENVIRONMENT(vesica_overlap_##a##_##b##_##scalar, s, t);                                      \
    return overlap_typed<vesica::A<T>, vesica::B<T>>(s, t);                                                     \
  }
#define VESICA_PAIR(a, A, b, B) VESICA_PAIR_OF(a, A, b, B, f64, double) VESICA_PAIR_OF(a, A, b, B, f32, float)

VESICA_EACH_PAIR(VESICA_PAIR)
