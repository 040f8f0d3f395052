// SPDX-License-Identifier: Apache-2.0
/// Shapes of every kind whose numbers are multiples of a step, as pixels, halves or hundredths are: two of them often
/// touch exactly, and where a number is moved by a place, nearly.
#pragma once

#include <vesica.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "by_kind.hpp"
#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace properties {

struct Lattice {
  double step;
  int lengths, axes;  ///< exponents of two that lengths and, against sizes, axes are multiplied by
};

/// A shape of a kind other than ellipse, valid unless it leaves the range.
template <class T>
NumbersOf<T> lattice_shape(int kind, const Lattice& lattice, Random& random) {
  constexpr std::array<std::array<double, 2>, 7> axes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {3, -4}, {0.6, 0.8}}};
  const auto steps = [&](int low, int high) { return lattice.step * random.integer(low, high); };
  Numbers n{};
  const std::size_t fields = static_cast<std::size_t>(vesica::field_count(kind));
  for (std::size_t k = 0; k < fields; ++k) n[k] = steps(-4, 4);
  if (kind == VESICA_CIRCLE) n[2] = std::fabs(n[2]);
  if (kind == VESICA_CAPSULE) n[4] = std::fabs(n[4]);
  if (kind == VESICA_AABB) {
    n[2] = n[0] + steps(0, 4);
    n[3] = n[1] + steps(0, 4);
  }
  if (has_axis(kind)) {
    const double r = std::fabs(n[6]);
    const auto& axis = axes[static_cast<std::size_t>(random.below(axes.size()))];
    n = {n[0],
         n[1],
         std::ldexp(axis[0], lattice.axes),
         std::ldexp(axis[1], lattice.axes),
         std::ldexp(steps(0, 4), -lattice.axes),
         std::ldexp(steps(0, 4), -lattice.axes),
         r};
  }
  NumbersOf<T> shape{};
  for (std::size_t k = 0; k < fields; ++k) {
    const bool is_length = role(kind, static_cast<int>(k)) != Role::size;
    shape[k] = static_cast<T>(std::ldexp(n[k], is_length ? lattice.lengths : 0));
  }
  return shape;
}

/// One of its numbers, up or down by a place.
template <class T>
void move_by_a_place(int kind, NumbersOf<T>& shape, Random& random) {
  T& x = shape[static_cast<std::size_t>(random.below(vesica::field_count(kind)))];
  const T infinite = std::numeric_limits<T>::infinity();
  x = std::nextafter(x, random.chance(0.5) ? infinite : -infinite);
}

}  // namespace properties
