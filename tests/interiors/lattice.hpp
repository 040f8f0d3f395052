// SPDX-License-Identifier: Apache-2.0
/// Shapes of all eight kinds on a small lattice, where two often touch, at any scale.
#pragma once

#include <vesica.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "properties/random.hpp"

namespace interiors {

using properties::Random;

inline constexpr int kind_count = 8;

struct Shape {
  std::int32_t kind;
  std::array<double, 7> number;
};

/// A valid shape; sizes may be 0. Lengths are small integers times 2^exponent, and an axis is a short vector.
inline Shape shape(std::int32_t kind, int exponent, Random& random) {
  constexpr std::array<std::array<double, 2>, 6> axes{{{1, 0}, {0, -2}, {3, 4}, {1, 1}, {-2, 1}, {0.5, 0}}};
  const auto length = [&](int low, int high) { return std::ldexp(random.integer(low, high), exponent); };
  const double x = length(-6, 6), y = length(-6, 6);
  const auto& [ux, uy] = axes[static_cast<std::size_t>(random.below(axes.size()))];
  switch (kind) {
    case VESICA_POINT:
      return {kind, {x, y}};
    case VESICA_CIRCLE:
      return {kind, {x, y, length(0, 5)}};
    case VESICA_SEGMENT:
      return {kind, {x, y, length(-6, 6), length(-6, 6)}};
    case VESICA_CAPSULE:
      return {kind, {x, y, length(-6, 6), length(-6, 6), length(0, 5)}};
    case VESICA_AABB:
      return {kind, {x, y, x + length(0, 4), y + length(0, 4)}};
    case VESICA_ELLIPSE:
      if (random.chance(0.5)) {  // a circle: it touches others at whole numbers
        const double r = length(0, 2);
        return {kind, {x, y, ux, uy, r, r}};
      }
      [[fallthrough]];
    case VESICA_RECT:
      return {kind, {x, y, ux, uy, length(0, 3), length(0, 3)}};
    default:
      return {kind, {x, y, ux, uy, length(0, 3), length(0, 3), length(0, 5)}};
  }
}

/// With one number that is not 0 moved up or down by a place.
inline Shape moved_by_a_place(Shape s, Random& random) {
  double& x = s.number[static_cast<std::size_t>(random.below(vesica_field_count(s.kind)))];
  if (x != 0) x = std::nextafter(x, random.chance(0.5) ? 1e308 : -1e308);
  return s;
}

inline std::int32_t overlap(const Shape& a, const Shape& b) {
  return vesica_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data());
}
inline std::int32_t interiors_overlap(const Shape& a, const Shape& b) {
  return vesica_interiors_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data());
}

}  // namespace interiors
