// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/own_area.hpp>

#include "by_kind.hpp"
#include "compiled_once.hpp"
#include "environment.hpp"
#include "vesica.h"

namespace {

template <class T>
int32_t shape_area_by_kind(int32_t kind, const void* shape, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(shape_area_by_kind<T>, kind, shape, out);
  if (out == nullptr) return VESICA_E_NULL;
  return vesica::with_shape<T>(kind, shape,
                               [&](const vesica::CoreOrPath auto& s) { return vesica::shape_area_or_error(s, *out); });
}

}  // namespace

int32_t vesica_shape_area_f64(int32_t kind, const void* shape, double* out) {
  return shape_area_by_kind(kind, shape, out);
}
int32_t vesica_shape_area_f32(int32_t kind, const void* shape, float* out) {
  return shape_area_by_kind(kind, shape, out);
}
