// SPDX-License-Identifier: Apache-2.0
// Common code of the C interface of the named methods.
#pragma once

#include "environment.hpp"
#include "vesica_methods.h"

namespace vesica {

/// The C structs are the core's shapes byte for byte, and are read in place.
template <class Shape>
const Shape& shape_at(const void* s) noexcept {
  return *static_cast<const Shape*>(s);
}

}  // namespace vesica

/// Defines vesica_method_<name>(const CA* a, const CB* b) as the core's method of the shapes A and B.
#define VESICA_METHOD(name, method, CA, A, CB, B)                                   \
  int32_t vesica_method_##name(const CA* a, const CB* b) {                          \
    VESICA_DEFAULT_ENVIRONMENT(vesica_method_##name, a, b);                         \
    if (a == nullptr || b == nullptr) return VESICA_E_NULL;                         \
    return vesica::methods::method(vesica::shape_at<A>(a), vesica::shape_at<B>(b)); \
  }
