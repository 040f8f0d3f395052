// SPDX-License-Identifier: Apache-2.0
/// The library's answers about relation and containment, in either scalar type.
#pragma once

#include <vesica.h>

#include <cstdint>

#include "properties/pair.hpp"

namespace relations {

inline std::int32_t relation(properties::Scalar scalar, const properties::Pair& p) {
  if (scalar == properties::Scalar::f64) return vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  return vesica_relation_f32(p.kind_a, properties::narrow(p.a).data(), p.kind_b, properties::narrow(p.b).data());
}

inline std::int32_t contains(properties::Scalar scalar, const properties::Pair& p) {
  if (scalar == properties::Scalar::f64) return vesica_contains_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  return vesica_contains_f32(p.kind_a, properties::narrow(p.a).data(), p.kind_b, properties::narrow(p.b).data());
}

inline std::int32_t converse(std::int32_t code) {
  switch (code) {
    case VESICA_INSIDE:
      return VESICA_CONTAINS;
    case VESICA_INSIDE_TOUCH:
      return VESICA_CONTAINS_TOUCH;
    case VESICA_CONTAINS:
      return VESICA_INSIDE;
    case VESICA_CONTAINS_TOUCH:
      return VESICA_INSIDE_TOUCH;
    default:
      return code;
  }
}

/// True if the relation says that a contains b.
inline std::int32_t says_contains(std::int32_t code) { return code >= VESICA_CONTAINS ? 1 : 0; }

}  // namespace relations
