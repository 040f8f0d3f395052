// SPDX-License-Identifier: Apache-2.0
/// Random shapes, and the core and the radius of each.
#pragma once

#include <vesica.h>
#include <vesica_index.h>
#include <vesica_measures.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "properties/random.hpp"

namespace inflated {

using Numbers = std::array<double, 7>;

struct Shape {
  std::int32_t kind;
  Numbers number;
};

/// The kinds that every test here asks about.
inline constexpr std::array<std::int32_t, 2> kinds{VESICA_CAPSULE, VESICA_ROUND_RECT};

/// A valid shape of a size of about 1 near the origin.
Shape shape(std::int32_t kind, properties::Random& random);
/// One of a random kind; `count` of the first kinds are drawn.
Shape any_shape(properties::Random& random, int count = 8);
/// One with a core and a radius.
Shape inflated_shape(properties::Random& random);

/// One of any kind but ellipses, of few digits, so that two often touch or share a stretch.
Shape lattice_shape(properties::Random& random);

bool is_inflated(const Shape& s);
std::string described(const Shape& s);
/// Moved along x.
Shape moved(Shape s, double dx);
/// Lengths times k.
Shape times(Shape s, double k);
/// The greatest coordinate and size of two shapes.
double scale(const Shape& a, const Shape& b);

/// The core, and its radius: 0 for shapes without one.
Shape core(const Shape& s);
double radius(const Shape& s);

/// Some shapes of one kind as columns, and the array of them.
template <class T>
struct Columns {
  std::array<std::vector<T>, 7> column;

  Columns(std::int32_t kind, int count, properties::Random& random);
  Shape at(std::size_t i) const;
  std::int32_t kind;
};
vesica_shapes_f64 array(const Columns<double>& c);
vesica_shapes_f32 array(const Columns<float>& c);

}  // namespace inflated
