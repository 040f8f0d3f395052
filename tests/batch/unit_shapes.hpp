// SPDX-License-Identifier: Apache-2.0
/// Shapes of unit axes up to rounding, as the quicker filters take them, at contact to the last places, and odd ones.
#pragma once

#include <vesica.h>

#include <array>
#include <cmath>
#include <limits>

#include "batch/instruction_sets.hpp"
#include "batch/shapes.hpp"
#include "properties/random.hpp"

namespace batch_tests {

/// The changes made to some shapes of a block of unit axes.
enum class Odd {
  nothing,
  longer,      ///< the same set with an axis four times as long and sizes a quarter
  edge,        ///< an axis whose squared length is 1/2 or 2, the ends of the range for two rectangles
  just_off,    ///< an axis one place beyond such an end
  nearly,      ///< an axis a few places from unit length, about the ends of the range for the others
  thin,        ///< sizes at a ratio of 16, where an ellipse begins to be thin
  thinner,     ///< sizes at a ratio of 17.5
  outsized,    ///< a size about the ends of the range for ellipses
  enormous,    ///< an axis of 2^40
  subnormal,   ///< the smallest axis there is
  not_finite,  ///< an invalid shape
  negative,    ///< another
  no_axis,     ///< another
};
inline constexpr std::array all_odd{Odd::nothing,    Odd::longer,   Odd::edge,     Odd::just_off, Odd::nearly,
                                    Odd::thin,       Odd::thinner,  Odd::outsized, Odd::enormous, Odd::subnormal,
                                    Odd::not_finite, Odd::negative, Odd::no_axis};

template <class T>
Numbers<T> made_odd(Numbers<T> r, Odd odd, properties::Random& draw) {
  const bool coin = draw.chance(0.5);
  const T below_half = coin ? T(0.5) : T(1);  // components of an axis of squared length 1/2, or 2
  switch (odd) {
    case Odd::longer:
      return {r[0], r[1], r[2] * 4, r[3] * 4, r[4] / 4, r[5] / 4};
    case Odd::edge:
      return {r[0], r[1], below_half, -below_half, r[4], r[5]};
    case Odd::just_off:
      return {r[0], r[1], below_half, std::nextafter(below_half, coin ? T(0) : T(2)), r[4], r[5]};
    case Odd::nearly: {
      T x = 1;
      for (int i = draw.below(9); i > 0; --i) x = std::nextafter(x, coin ? T(0) : T(2));
      return {r[0], r[1], x, 0, r[4], r[5]};
    }
    case Odd::thin:
      return {r[0], r[1], r[2], r[3], r[4], coin ? r[4] / 16 : r[4] * 16};
    case Odd::thinner:
      return {r[0], r[1], r[2], r[3], r[4], coin ? r[4] / T(17.5) : r[4] * T(17.5)};
    case Odd::outsized: {
      const int range = sizeof(T) == sizeof(float) ? 1 : 8, places = draw.integer(-2, 2);
      T size = std::ldexp(T(1), (coin ? 10 : -6) * range);
      for (int i = 0; i < std::abs(places); ++i) size = std::nextafter(size, places < 0 ? T(0) : 2 * size);
      return {r[0], r[1], r[2], r[3], size, size};
    }
    case Odd::enormous:
      return {r[0], r[1], r[2] * T(0x1p40), r[3] * T(0x1p40), r[4], r[5]};
    case Odd::subnormal:
      return {r[0], r[1], std::numeric_limits<T>::denorm_min(), 0, r[4], r[5]};
    case Odd::not_finite:
      r[coin ? 0 : 4] = std::numeric_limits<T>::infinity();
      return r;
    case Odd::negative:
      r[coin ? 4 : 5] = -r[coin ? 4 : 5] - std::numeric_limits<T>::denorm_min();
      return r;
    case Odd::no_axis:
      return {r[0], r[1], 0, T(-0.0), r[4], r[5]};
    default:
      return r;
  }
}

inline bool has_axis(int kind) { return kind == VESICA_RECT || kind == VESICA_ELLIPSE; }

/// One of the two shapes made odd, one that has an axis.
template <class T>
void make_odd(const Case& kinds, Numbers<T>& a, Numbers<T>& b, Odd odd, properties::Random& draw) {
  Numbers<T>& shape = has_axis(kinds.kind_a) && draw.chance(0.5) ? a : b;
  shape = made_odd(shape, odd, draw);
}

/// A shape of unit axis up to rounding, its sizes of one of a few magnitudes.
inline properties::Numbers unit_shape(int kind, properties::Scalar scalar, properties::Random& draw) {
  const double longer = std::ldexp(draw.between(1, 2), draw.integer(-3, 0));
  const double x = draw.between(-1, 1), y = draw.between(-1, 1);
  if (kind == VESICA_CIRCLE) return properties::nearest_shape(scalar, kind, {x, y, longer});
  const double angle = draw.between(0, 6.2831853);
  const double shorter = std::ldexp(draw.between(1, 2), draw.integer(kind == VESICA_ELLIPSE ? -5 : -9, 0));
  return properties::nearest_shape(scalar, kind, {x, y, std::cos(angle), std::sin(angle), longer, shorter});
}

/// Moves b straight away from a to where they just touch; rounding and up to 16 places of one number then put some of
/// them apart and join others, all well within what the quick filter's bound must cover.
inline properties::Numbers brought_to_contact(properties::Scalar scalar, const Case& kinds,
                                              const properties::Numbers& a, properties::Numbers b,
                                              properties::Random& draw) {
  const double angle = draw.between(0, 6.2831853), x = b[0], y = b[1];
  double near = 0, far = 16;
  for (int i = 0; i < 60; ++i) {
    const double middle = (near + far) / 2;
    b[0] = x + middle * std::cos(angle), b[1] = y + middle * std::sin(angle);
    (vesica_overlap_f64(kinds.kind_a, a.data(), kinds.kind_b, b.data()) == 1 ? near : far) = middle;
  }
  double& number = b[static_cast<std::size_t>(draw.below(6))];
  const std::int64_t place = properties::ordinal(scalar, properties::nearest(scalar, number));
  number = properties::at_ordinal(scalar, place + draw.integer(-16, 16));
  return properties::nearest_shape(scalar, kinds.kind_b, b);
}

}  // namespace batch_tests
