// SPDX-License-Identifier: Apache-2.0
#include "batch.hpp"

#include "by_kind.hpp"
#include "vesica.h"

namespace {

template <class T>
struct CShapes;
template <>
struct CShapes<double> {
  using Type = vesica_shapes_f64;
};
template <>
struct CShapes<float> {
  using Type = vesica_shapes_f32;
};
template <class T>
using CShapesOf = typename CShapes<T>::Type;

/// count elements of `stride` bytes each, within the address space. The stride of a single one is not looked at.
bool addressable(int64_t count, ptrdiff_t stride) noexcept {
  ptrdiff_t extent;
  return count <= 1 || !__builtin_mul_overflow(count, stride, &extent);
}

/// What is wrong with an array, but for its pointers: 0, VESICA_E_KIND or VESICA_E_ARGUMENT.
template <class Array>
int32_t check_array(const Array& shapes) noexcept {
  if (!vesica::is_kind(shapes.kind)) return VESICA_E_KIND;
  const bool sound = shapes.reserved == 0 && shapes.count >= 0 && addressable(shapes.count, shapes.stride);
  return sound ? 0 : VESICA_E_ARGUMENT;
}

template <class Array>
bool has_null(const Array& shapes) noexcept {
  for (int k = 0; k < vesica::field_count(shapes.kind); ++k) {
    if (shapes.field[k] == nullptr) return true;
  }
  return false;
}

/// Checks both arrays and the output of a call with something to answer. The order of errors is NULL, kind, argument,
/// except that fields are looked at only once the kind tells how many there are.
template <class Array>
int32_t check_call(const Array* a, const Array* b, const void* out, bool anything) noexcept {
  if (a == nullptr || b == nullptr || (anything && out == nullptr)) return VESICA_E_NULL;
  const int32_t error_a = check_array(*a), error_b = check_array(*b);
  if (error_a == VESICA_E_KIND || error_b == VESICA_E_KIND) return VESICA_E_KIND;
  if (error_a != 0 || error_b != 0) return VESICA_E_ARGUMENT;
  return anything && (has_null(*a) || has_null(*b)) ? VESICA_E_NULL : 0;
}

template <class T>
vesica::batch::Shapes<T> view(const CShapesOf<T>& shapes) noexcept {
  vesica::batch::Shapes<T> v{shapes.kind, shapes.count, shapes.count == 1 ? 0 : shapes.stride, {}};
  for (int k = 0; k < vesica::field_count(shapes.kind); ++k) v.field[k] = shapes.field[k];
  return v;
}

int64_t result(const vesica::batch::Tally& tally) noexcept { return tally.invalid ? VESICA_E_SHAPE : tally.overlaps; }

template <class Array>
bool anything(const Array* a, const Array* b) noexcept {
  return a != nullptr && b != nullptr && a->count != 0 && b->count != 0;
}

template <class T>
int64_t overlap_many(const CShapesOf<T>* a, const CShapesOf<T>* b, uint8_t* out) noexcept {
  const int32_t error = check_call(a, b, out, anything(a, b));
  if (error != 0) return error;
  if (a->count != b->count && a->count != 1 && b->count != 1) return VESICA_E_ARGUMENT;
  const int64_t n = a->count == 1 ? b->count : a->count;
  return result(vesica::batch::many<T>(vesica::kernels(), view<T>(*a), view<T>(*b), n, out));
}

template <class T>
int64_t overlap_matrix(const CShapesOf<T>* a, const CShapesOf<T>* b, uint8_t* out, ptrdiff_t row_stride) noexcept {
  const int32_t error = check_call(a, b, out, anything(a, b));
  if (error != 0) return error;
  const bool apart = row_stride >= b->count || row_stride <= -b->count;
  if (a->count > 1 && (!apart || !addressable(a->count, row_stride))) return VESICA_E_ARGUMENT;
  return result(vesica::batch::matrix<T>(vesica::kernels(), view<T>(*a), view<T>(*b), out, row_stride));
}

template <class T>
int64_t overlap_select(const CShapesOf<T>* one, const CShapesOf<T>* many, int64_t* out, int64_t capacity) noexcept {
  const int32_t error = check_call(one, many, capacity > 0 ? out : static_cast<const void*>(one), anything(one, many));
  if (error != 0) return error;
  if (one->count != 1 || capacity < 0) return VESICA_E_ARGUMENT;
  const auto tally = vesica::batch::select<T>(vesica::kernels(), view<T>(*one), view<T>(*many), out, capacity);
  if (tally.overlaps < capacity && out != nullptr) out[tally.overlaps] = -1;
  return result(tally);
}

template <class T>
int32_t shapes_from_records(int32_t kind, int64_t count, const void* base, ptrdiff_t stride,
                            CShapesOf<T>* out) noexcept {
  if (out == nullptr || (base == nullptr && count != 0)) return VESICA_E_NULL;
  if (!vesica::is_kind(kind)) return VESICA_E_KIND;
  if (count < 0) return VESICA_E_ARGUMENT;
  *out = {kind, 0, count, stride, {}};
  for (int k = 0; k < vesica::field_count(kind) && base != nullptr; ++k) {
    out->field[k] = reinterpret_cast<const T*>(static_cast<const unsigned char*>(base) + k * sizeof(T));
  }
  return 0;
}

}  // namespace

#define VESICA_BATCH(scalar, T)                                                                                 \
  int32_t vesica_shapes_from_records_##scalar(int32_t kind, int64_t count, const void* base, ptrdiff_t stride,  \
                                              vesica_shapes_##scalar* out) {                                    \
    return shapes_from_records<T>(kind, count, base, stride, out);                                              \
  }                                                                                                             \
  int64_t vesica_overlap_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b,        \
                                       uint8_t* out) {                                                          \
    return overlap_many<T>(a, b, out);                                                                          \
  }                                                                                                             \
  int64_t vesica_overlap_matrix_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b,      \
                                         uint8_t* out, ptrdiff_t row_stride) {                                  \
    return overlap_matrix<T>(a, b, out, row_stride);                                                            \
  }                                                                                                             \
  int64_t vesica_overlap_select_##scalar(const vesica_shapes_##scalar* one, const vesica_shapes_##scalar* many, \
                                         int64_t* out, int64_t capacity) {                                      \
    return overlap_select<T>(one, many, out, capacity);                                                         \
  }

VESICA_BATCH(f64, double)
VESICA_BATCH(f32, float)

const char* vesica_isa_name(void) { return vesica::kernels().name; }
