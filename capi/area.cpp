// SPDX-License-Identifier: Apache-2.0
#include <vesica/iou.hpp>
#include <vesica/shape_area.hpp>

#include "pair_output.hpp"
#include "vesica.h"

namespace {

struct AreaQuery {
  template <class A, class B, class T>
  static int32_t answer(const A& a, const B& b, T& out) noexcept {
    return vesica::area_or_error(a, b, out);
  }
};

struct IouQuery {
  template <class A, class B, class T>
  static int32_t answer(const A& a, const B& b, T& out) noexcept {
    return vesica::iou_or_error(a, b, out);
  }
};

template <class T>
int32_t shape_area_by_kind(int32_t kind, const T* numbers, T* out) noexcept {
  if (out == nullptr) return VESICA_E_NULL;
  return vesica::with_shape(kind, numbers, [&](const auto& shape) { return vesica::shape_area_or_error(shape, *out); });
}

}  // namespace

int32_t vesica_area_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b, double* out) {
  return vesica::capi::output_by_kind<AreaQuery>(kind_a, numbers_a, kind_b, numbers_b, out);
}
int32_t vesica_area_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b, float* out) {
  return vesica::capi::output_by_kind<AreaQuery>(kind_a, numbers_a, kind_b, numbers_b, out);
}

int32_t vesica_iou_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b, double* out) {
  return vesica::capi::output_by_kind<IouQuery>(kind_a, numbers_a, kind_b, numbers_b, out);
}
int32_t vesica_iou_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b, float* out) {
  return vesica::capi::output_by_kind<IouQuery>(kind_a, numbers_a, kind_b, numbers_b, out);
}

int32_t vesica_shape_area_f64(int32_t kind, const double* numbers, double* out) {
  return shape_area_by_kind(kind, numbers, out);
}
int32_t vesica_shape_area_f32(int32_t kind, const float* numbers, float* out) {
  return shape_area_by_kind(kind, numbers, out);
}
