// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"
#include "environment.hpp"

namespace {

using namespace vesica::capi;
using vesica::Common;

template <class T>
int64_t overlap_many(Common common, const CShapesOf<T>* a, const CShapesOf<T>* b, uint8_t* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(overlap_many<T>, common, a, b, out);
  const int32_t error = check_call(a, b, out, anything(a, b), vesica::is_kind);
  if (error != 0) return error;
  const int64_t n = pairs_in_step(*a, *b);
  if (n < 0) return n;
  return result(vesica::batch::many<T>(vesica::kernels(), view<T>(*a), view<T>(*b), n, out, common));
}

template <class T>
int64_t overlap_matrix(Common common, const CShapesOf<T>* a, const CShapesOf<T>* b, uint8_t* out,
                       ptrdiff_t row_stride) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(overlap_matrix<T>, common, a, b, out, row_stride);
  const int32_t error = check_call(a, b, out, anything(a, b), vesica::is_kind);
  if (error != 0) return error;
  if (!rows_apart(a->count, b->count, row_stride, 1)) return VESICA_E_ARGUMENT;
  if (!anything(a, b)) return 0;
  return result(vesica::batch::matrix<T>(vesica::kernels(), view<T>(*a), view<T>(*b), out, row_stride, common));
}

template <class T>
int64_t overlap_select(Common common, const CShapesOf<T>* one, const CShapesOf<T>* many, int64_t* out,
                       int64_t capacity) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(overlap_select<T>, common, one, many, out, capacity);
  const int32_t error =
      check_call(one, many, capacity > 0 ? out : static_cast<const void*>(one), anything(one, many), vesica::is_kind);
  if (error != 0) return error;
  if (one->count != 1 || capacity < 0) return VESICA_E_ARGUMENT;
  const auto tally = vesica::batch::select<T>(vesica::kernels(), view<T>(*one), view<T>(*many), out, capacity, common);
  if (tally.overlaps < capacity && out != nullptr) out[tally.overlaps] = -1;
  return result(tally);
}

template <class T>
int32_t shapes_from_records(int32_t kind, int64_t count, const void* base, ptrdiff_t stride,
                            CShapesOf<T>* out) noexcept {
  if (out == nullptr || (base == nullptr && count != 0)) return VESICA_E_NULL;
  if (!vesica::is_kind(kind)) return VESICA_E_KIND;
  if (count < 0) return VESICA_E_ARGUMENT;
  *out = {.kind = kind,
          .reserved = 0,
          .count = count,
          .stride = stride,
          .field = {},
          .rings = nullptr,
          .polygons = nullptr,
          .each = 0};
  // Structs of polygons and polylines are themselves the array.
  const int fields = vesica::is_row(kind) ? vesica::field_count(kind) : 1;
  for (int k = 0; k < fields && base != nullptr; ++k) {
    out->field[k] =
        reinterpret_cast<const T*>(static_cast<const unsigned char*>(base) + static_cast<std::size_t>(k) * sizeof(T));
  }
  return 0;
}

}  // namespace

#define VESICA_ARRAYS(name, common, scalar, T)                                                                   \
  int64_t vesica_##name##_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b,        \
                                        uint8_t* out) {                                                          \
    return overlap_many<T>(common, a, b, out);                                                                   \
  }                                                                                                              \
  int64_t vesica_##name##_matrix_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b,      \
                                          uint8_t* out, ptrdiff_t row_stride) {                                  \
    return overlap_matrix<T>(common, a, b, out, row_stride);                                                     \
  }                                                                                                              \
  int64_t vesica_##name##_select_##scalar(const vesica_shapes_##scalar* one, const vesica_shapes_##scalar* many, \
                                          int64_t* out, int64_t capacity) {                                      \
    return overlap_select<T>(common, one, many, out, capacity);                                                  \
  }

#define VESICA_BATCH(scalar, T)                                                                                \
  int32_t vesica_shapes_from_records_##scalar(int32_t kind, int64_t count, const void* base, ptrdiff_t stride, \
                                              vesica_shapes_##scalar* out) {                                   \
    return shapes_from_records<T>(kind, count, base, stride, out);                                             \
  }                                                                                                            \
  VESICA_ARRAYS(overlap, Common::any, scalar, T)                                                               \
  VESICA_ARRAYS(interiors_overlap, Common::insides, scalar, T)

VESICA_BATCH(f64, double)
VESICA_BATCH(f32, float)

const char* vesica_isa_name(void) { return vesica::kernels().name; }
