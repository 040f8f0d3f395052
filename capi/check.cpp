// SPDX-License-Identifier: Apache-2.0
#include <vesica/check.hpp>
#include <vesica/polygon/simple.hpp>

#include "by_kind.hpp"
#include "environment.hpp"
#include "vesica.h"

namespace {

template <class T>
int32_t check_shape(int32_t kind, const void* shape) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(check_shape<T>, kind, shape);
  return vesica::with_shape<T>(kind, shape, [](const auto& s) {
    if constexpr (vesica::Path<std::remove_cvref_t<decltype(s)>>) {
      return vesica::check_simple(s);
    } else {
      return vesica::check(s);
    }
  });
}

}  // namespace

int32_t vesica_check_f64(int32_t kind, const void* shape) { return check_shape<double>(kind, shape); }
int32_t vesica_check_f32(int32_t kind, const void* shape) { return check_shape<float>(kind, shape); }
