// SPDX-License-Identifier: Apache-2.0
#include <vesica/overlap.hpp>

#include "by_kind.hpp"
#include "vesica.h"

namespace {

/// The C structs and flat numbers are the core's shapes byte for byte, and are read in place.
template <class A, class B>
VESICA_INLINE int32_t overlap_at(const void* a, const void* b) noexcept {
  return vesica::overlap_or_error(*static_cast<const A*>(a), *static_cast<const B*>(b));
}

template <class A, class B>
VESICA_INLINE int32_t overlap_typed(const void* a, const void* b) noexcept {
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  return overlap_at<A, B>(a, b);
}

using Function = int32_t (*)(const void*, const void*) noexcept;

#define VESICA_FUNCTION(name, Name) overlap_at<A<T>, vesica::Name<T>>,
template <class T, template <class> class A>
inline constexpr Function row[vesica::kind_count] = {VESICA_EACH_SHAPE(VESICA_FUNCTION)};
#undef VESICA_FUNCTION

#define VESICA_ROW(name, Name) row<T, vesica::Name>,
template <class T>
inline constexpr const Function* table[vesica::kind_count] = {VESICA_EACH_SHAPE(VESICA_ROW)};
#undef VESICA_ROW

template <class T>
int32_t overlap_by_kind(int32_t kind_a, const T* a, int32_t kind_b, const T* b) noexcept {
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  if (!vesica::is_kind(kind_a) || !vesica::is_kind(kind_b)) return VESICA_E_KIND;
  return table<T>[kind_a][kind_b](a, b);
}

}  // namespace

int32_t vesica_overlap_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b) {
  return overlap_by_kind(kind_a, numbers_a, kind_b, numbers_b);
}
int32_t vesica_overlap_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b) {
  return overlap_by_kind(kind_a, numbers_a, kind_b, numbers_b);
}

#define VESICA_PAIR_OF(a, A, b, B, scalar, T)                                                                   \
  int32_t vesica_overlap_##a##_##b##_##scalar(const vesica_##a##_##scalar* s, const vesica_##b##_##scalar* t) { \
    return overlap_typed<vesica::A<T>, vesica::B<T>>(s, t);                                                     \
  }
#define VESICA_PAIR(a, A, b, B) VESICA_PAIR_OF(a, A, b, B, f64, double) VESICA_PAIR_OF(a, A, b, B, f32, float)

VESICA_EACH_PAIR(VESICA_PAIR)
