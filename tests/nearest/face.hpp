// SPDX-License-Identifier: Apache-2.0
/// vesica_nearest in either scalar type, on numbers held as doubles.
#pragma once

#include <vesica.h>

#include <array>
#include <cstdint>

#include "properties/pair.hpp"

namespace nearest_test {

using properties::Numbers;
using properties::Pair;
using properties::Scalar;

struct Answer {
  std::int32_t code;
  double distance, ax, ay, bx, by;
  bool operator==(const Answer&) const = default;
};

inline Answer nearest(Scalar scalar, const Pair& p) {
  if (scalar == Scalar::f64) {
    vesica_closest_points_f64 out{};
    const std::int32_t code = vesica_nearest_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out);
    return {code, out.distance, out.ax, out.ay, out.bx, out.by};
  }
  vesica_closest_points_f32 out{};
  const auto a = properties::narrow(p.a), b = properties::narrow(p.b);
  const std::int32_t code = vesica_nearest_f32(p.kind_a, a.data(), p.kind_b, b.data(), &out);
  const auto wide = [](float x) { return static_cast<double>(x); };
  return {code, wide(out.distance), wide(out.ax), wide(out.ay), wide(out.bx), wide(out.by)};
}

inline Answer exchanged(const Answer& r) { return {r.code, r.distance, r.bx, r.by, r.ax, r.ay}; }

}  // namespace nearest_test
