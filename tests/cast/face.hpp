// SPDX-License-Identifier: Apache-2.0
/// vesica_cast in either scalar type, on numbers held as doubles.
#pragma once

#include <vesica.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

#include "properties/pair.hpp"

namespace cast_test {

using properties::Numbers;
using properties::Pair;
using properties::Scalar;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct Motion {
  double vx, vy, end;
};

struct Answer {
  std::int32_t code;
  double t, x, y, nx, ny;
};

/// Both shapes and the motion with hexadecimal numbers.
inline std::string describe(const Pair& p, const Motion& m) {
  char text[100];
  std::snprintf(text, sizeof text, " v %a %a end %g", m.vx, m.vy, m.end);
  return properties::describe(p) + text;
}

inline Answer cast(Scalar scalar, const Pair& p, const Motion& m) {
  if (scalar == Scalar::f64) {
    vesica_impact_f64 out{};
    const std::int32_t code = vesica_cast_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), m.vx, m.vy, m.end, &out);
    return {code, out.t, out.x, out.y, out.nx, out.ny};
  }
  vesica_impact_f32 out{};
  const auto a = properties::narrow(p.a), b = properties::narrow(p.b);
  const std::int32_t code = vesica_cast_f32(p.kind_a, a.data(), p.kind_b, b.data(), static_cast<float>(m.vx),
                                            static_cast<float>(m.vy), static_cast<float>(m.end), &out);
  const auto wide = [](float x) { return static_cast<double>(x); };
  return {code, wide(out.t), wide(out.x), wide(out.y), wide(out.nx), wide(out.ny)};
}

}  // namespace cast_test
