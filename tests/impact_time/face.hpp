// SPDX-License-Identifier: Apache-2.0
/// vesica_impact_time in either scalar type, on numbers held as doubles; and shapes in the middle of their motion.
#pragma once

#include <vesica.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace impact_time_test {

using properties::Numbers;
using properties::Pair;
using properties::Scalar;

struct Turn {
  double vx, vy, angle;
};

/// A pair, how both move, and how near is near.
struct Turning {
  Pair pair;
  Turn a, b;
  double tolerance;
};

struct Answer {
  std::int32_t code;
  double t, x, y, nx, ny, gap;
};

inline std::string describe(const Turning& s) {
  char text[200];
  std::snprintf(text, sizeof text, " a %a %a %a b %a %a %a tolerance %g", s.a.vx, s.a.vy, s.a.angle, s.b.vx, s.b.vy,
                s.b.angle, s.tolerance);
  return properties::describe(s.pair) + text;
}

inline Answer impact_time(Scalar scalar, const Turning& s) {
  const Pair& p = s.pair;
  if (scalar == Scalar::f64) {
    const vesica_turn_f64 a{s.a.vx, s.a.vy, s.a.angle}, b{s.b.vx, s.b.vy, s.b.angle};
    vesica_impact_f64 out{};
    double gap = 0;
    const std::int32_t code =
        vesica_impact_time_f64(p.kind_a, p.a.data(), &a, p.kind_b, p.b.data(), &b, s.tolerance, &out, &gap);
    return {code, out.t, out.x, out.y, out.nx, out.ny, gap};
  }
  const auto narrow = [](const Turn& t) {
    return vesica_turn_f32{static_cast<float>(t.vx), static_cast<float>(t.vy), static_cast<float>(t.angle)};
  };
  const vesica_turn_f32 turn_a = narrow(s.a), turn_b = narrow(s.b);
  const auto a = properties::narrow(p.a), b = properties::narrow(p.b);
  vesica_impact_f32 out{};
  float gap = 0;
  const std::int32_t code = vesica_impact_time_f32(p.kind_a, a.data(), &turn_a, p.kind_b, b.data(), &turn_b,
                                                   static_cast<float>(s.tolerance), &out, &gap);
  const auto wide = [](float x) { return static_cast<double>(x); };
  return {code, wide(out.t), wide(out.x), wide(out.y), wide(out.nx), wide(out.ny), wide(gap)};
}

/// A rectangle or an ellipse.
struct Placed {
  std::int32_t kind;
  Numbers numbers;
};

/// A shape's place at t, by the C library's sine and cosine in long double, with sizes times 1 + grown. Centre and
/// axis are right to some 2^-50 of the lengths; so with grown = -2^-40 the result lies inside the true shape, unless
/// that is a needle or a point, which is off by that rounding.
Placed placed_at(int kind, const Numbers& numbers, const Turn& turn, double t, double grown);

/// Do the shapes, both shrunk by 2^-40, overlap at t? Exactly, by vesica_overlap.
bool cores_overlap(const Turning& s, double t);

/// The kinds of scenes.
enum class Style { plain, needles, close, still };

/// About the origin, with lengths about 1; spins up to `spin` radians.
Turning draw(int kind_a, int kind_b, Style style, double spin, properties::Random& random);

}  // namespace impact_time_test
