// SPDX-License-Identifier: Apache-2.0
/// vesica_within in either scalar type, on numbers held as doubles.
#pragma once

#include <vesica.h>

#include <cstdint>

#include "properties/pair.hpp"

namespace within_test {

using properties::Pair;
using properties::Scalar;

inline std::int32_t within(Scalar scalar, const Pair& p, double distance) {
  if (scalar == Scalar::f64) return vesica_within_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), distance);
  const auto a = properties::narrow(p.a), b = properties::narrow(p.b);
  return vesica_within_f32(p.kind_a, a.data(), p.kind_b, b.data(), static_cast<float>(distance));
}

}  // namespace within_test
