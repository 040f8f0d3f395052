// SPDX-License-Identifier: Apache-2.0
#include <vesica/check.hpp>

#include "by_kind.hpp"
#include "environment.hpp"
#include "vesica.h"

namespace {

template <class T>
int32_t check_numbers(int32_t kind, const T* numbers) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(check_numbers<T>, kind, numbers);
  return vesica::with_shape(kind, numbers, [](const auto& shape) { return vesica::check(shape); });
}

}  // namespace

int32_t vesica_check_f64(int32_t kind, const double* numbers) { return check_numbers(kind, numbers); }
int32_t vesica_check_f32(int32_t kind, const float* numbers) { return check_numbers(kind, numbers); }
