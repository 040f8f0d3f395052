// SPDX-License-Identifier: Apache-2.0
#include "overlap_calls.hpp"

int32_t vesica_overlap_f64(int32_t kind_a, const void* a, int32_t kind_b, const void* b) {
  return vesica::capi::overlap_by_kind<double, vesica::Common::any>(kind_a, a, kind_b, b);
}

int32_t vesica_overlap_f32(int32_t kind_a, const void* a, int32_t kind_b, const void* b) {
  return vesica::capi::overlap_by_kind<float, vesica::Common::any>(kind_a, a, kind_b, b);
}

#define VESICA_PAIR_OF(a, A, b, B, scalar, T)                                                                   \
  int32_t vesica_overlap_##a##_##b##_##scalar(const vesica_##a##_##scalar* s, const vesica_##b##_##scalar* t) { \
    return vesica::capi::overlap_typed<vesica::A<T>, vesica::B<T>>(s, t);                                       \
  }
#define VESICA_PAIR(a, A, b, B) VESICA_PAIR_OF(a, A, b, B, f64, double) VESICA_PAIR_OF(a, A, b, B, f32, float)

VESICA_EACH_PAIR_OF_FORMS(VESICA_PAIR)
