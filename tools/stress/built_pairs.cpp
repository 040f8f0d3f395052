// SPDX-License-Identifier: Apache-2.0
#include "stress/built_pairs.hpp"

#include <vesica.h>

#include <cmath>
#include <limits>

#include "properties/shape_maker.hpp"

namespace stress {
namespace {

using properties::Random;
using properties::Vector;

/// A random number between 2^low and 2^(high + 1); one in three is a power of two.
double of_binades(Random& random, int low, int high) {
  const double mantissa = random.chance(0.3) ? 1 : 1 + random.unit();
  return std::ldexp(mantissa, random.integer(low, high));
}
double of_either_sign(Random& random, int low, int high) {
  const double size = of_binades(random, low, high);
  return random.sign() * size;
}
double small(Random& random) {
  if (random.chance(0.2)) return 0;
  return random.chance(0.6) ? of_either_sign(random, -140, -20) : of_either_sign(random, -30, -2);
}

/// A number, or one beside it: a few places, or a share of it, or a little.
double near_to(Random& random, double x) {
  const int how = random.below(5);
  if (how == 1) {
    const double to = random.sign() * std::numeric_limits<double>::infinity();
    for (int i = random.integer(1, 4); i > 0; --i) x = std::nextafter(x, to);
  }
  if (how == 2) x *= 1 + of_either_sign(random, -52, -1);
  if (how == 3) x += of_either_sign(random, -60, -1);
  if (how == 4) x *= 1 + of_binades(random, -20, -1);
  return x;
}

Vector any_axis(Random& random) {
  switch (random.below(6)) {
    case 0:
      return {1, 0};
    case 1:
      return {0, 1};
    case 2:
      return {3, 4};
    case 3:
      return {1, of_either_sign(random, -60, -1)};
    case 4:
      return {of_binades(random, -5, 5), 0};
    default: {
      const double angle = random.between(0, 7), length = of_binades(random, -6, 6);
      return {length * std::cos(angle), length * std::sin(angle)};
    }
  }
}

/// The other shape's centre, along the needle and across it.
Vector place_beside(Random& random, const Vector& needle, const Vector& other) {
  switch (random.below(7)) {
    case 0:
      return {near_to(random, needle.x + other.x), small(random)};
    case 1:
      return {near_to(random, needle.x - other.x), small(random)};
    case 2:
      return {small(random), near_to(random, needle.y + other.y)};
    case 3:
      return {random.between(-needle.x, needle.x), near_to(random, needle.y + other.y)};
    case 4:
      return {near_to(random, needle.x - other.x), near_to(random, needle.y - other.y)};
    case 5: {
      // Above a side, from all but touching to far.
      const double along = random.chance(0.5) ? random.between(-needle.x, needle.x) : near_to(random, needle.x);
      return {along, needle.y + of_binades(random, -50, 0)};
    }
    default: {
      // Off the outline along its normal.
      const double angle = random.between(0, 1.6), gap = of_binades(random, -50, -1);
      return {(needle.x + gap * needle.y) * std::cos(angle), (needle.y + gap * needle.x) * std::sin(angle)};
    }
  }
}

/// about: half lengths along the axis and across it.
properties::Numbers shape_about(int kind, const Vector& axis, const Vector& about, const Vector& centre) {
  const double length = std::hypot(axis.x, axis.y);
  const Vector unit{axis.x / length, axis.y / length};
  const double along = kind == VESICA_CAPSULE ? std::fmax(about.x - about.y, 0) : about.x;
  properties::Numbers n = properties::shape_at_origin(kind, unit, along, about.y, 1);
  // As it was drawn, rather than its direction times a length.
  if (properties::has_axis(kind)) n[2] = axis.x, n[3] = axis.y, n[4] = about.x / length, n[5] = about.y / length;
  return properties::moved(kind, n, centre);
}

}  // namespace

properties::Pair draw_needle_pair(Random& random) {
  const double longer = 1 + random.unit(), shorter = longer * of_binades(random, -80, -3);
  const Vector needle{longer, shorter}, axis = any_axis(random);
  const int kind = random.chance(0.75) ? VESICA_ELLIPSE : VESICA_RECT, other_kind = random.below(properties::kinds);
  Vector other{of_binades(random, -30, 1), 0};
  other.y = other.x * (other_kind == VESICA_CIRCLE ? 1 : of_binades(random, -80, 0));
  if (other_kind == VESICA_POINT) other = {0, 0};
  Vector beside = place_beside(random, needle, other);
  beside.x *= random.sign();
  Vector centre{0, 0};
  if (random.chance(0.2)) centre.x = random.between(-4, 4), centre.y = random.between(-4, 4);
  const double length = std::hypot(axis.x, axis.y), ux = axis.x / length, uy = axis.y / length;
  const Vector at{centre.x + beside.x * ux - beside.y * uy, centre.y + beside.x * uy + beside.y * ux};
  Vector other_axis = axis;
  const int turn = random.below(4);
  if (turn == 1) other_axis = {-axis.y, axis.x};
  if (turn == 2) other_axis.x += small(random), other_axis.y += small(random);
  if (turn == 3) other_axis = any_axis(random);
  return {kind, other_kind, shape_about(kind, axis, needle, centre), shape_about(other_kind, other_axis, other, at)};
}

properties::Pair draw_tie_pair(Random& random) {
  const Vector axis = any_axis(random);
  const auto round_or_thin = [&random] { return random.chance(0.5) ? 1 : of_binades(random, -50, 0); };
  Vector about{1 + random.unit(), 0}, centre{0, 0};
  about.y = about.x * round_or_thin();
  if (random.chance(0.5)) centre.x = random.between(-1, 1), centre.y = random.between(-1, 1);
  const double scale = random.chance(0.5)   ? 1
                       : random.chance(0.5) ? random.between(0.9, 1.1)
                                            : of_binades(random, -3, 3);
  Vector other_axis{near_to(random, axis.x), near_to(random, axis.y)};
  if (random.chance(0.2)) other_axis = {-axis.y, axis.x};
  const Vector other{scale * near_to(random, about.x), scale * near_to(random, about.y)};
  const Vector at{near_to(random, centre.x), near_to(random, centre.y)};
  const auto kind = [&random] {
    return random.chance(0.2) ? VESICA_CIRCLE : random.chance(0.4) ? VESICA_RECT : VESICA_ELLIPSE;
  };
  const int kind_a = kind(), kind_b = kind();
  return {kind_a, kind_b, shape_about(kind_a, axis, about, centre), shape_about(kind_b, other_axis, other, at)};
}

}  // namespace stress
