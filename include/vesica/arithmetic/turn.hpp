// SPDX-License-Identifier: Apache-2.0
/// Angles in several units. Whole quarter turns are taken out first, without rounding, so that 90 degrees are a quarter
/// turn and not a number near it.
#pragma once

#include <cmath>
#include <vesica/arithmetic/angle.hpp>

namespace vesica {

/// Positive angles turn from +x towards +y: counter-clockwise where y points up. `clockwise` turns the other way.
struct AngleUnit {
  enum Measure { radians, degrees, quarters } measure;
  bool clockwise = false;
};

namespace detail::arithmetic {

struct Direction {
  double x, y;
};

/// pi / 180 as an unevaluated sum.
inline constexpr double degree_high = 0x1.1df46a2529d39p-6, degree_low = 0x1.5c1d8becdd291p-62;

/// Cosine and sine of turn * (high + low), at most an eighth of a turn; high + low is a unit of angle in radians. Each
/// is right to 1.1 units in its last place: the mathematics library's error, and one rounding.
inline Direction unit_vector(double turn, double high, double low) noexcept {
  const double angle = turn * high, rest = std::fma(turn, high, -angle) + turn * low;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {cosine - rest * sine, sine + rest * cosine};
}

/// The nearest double to sqrt(1/2): both components of the axis at an eighth turn. They are equal, so that turning by
/// an eighth one way or the other merely exchanges width and height.
inline constexpr double root_of_half = 0x1.6a09e667f3bcdp-1;

/// Turned by a whole number of quarter turns.
inline Direction turned(const Direction& d, int quarters) noexcept {
  switch (quarters & 3) {
    case 1:
      return {0 - d.y, d.x};
    case 2:
      return {0 - d.x, 0 - d.y};
    case 3:
      return {d.y, 0 - d.x};
    default:
      return d;
  }
}

/// The unit vector at an angle in radians, each component right to 1.1 units in its last place. The doubles nearest to
/// +-pi/4 and +-3pi/4 have components of one size, which costs 1.03 units at most.
inline Direction direction(double radians) noexcept {
  constexpr double eighth = right_angle / 2;
  const double cosine = std::cos(radians), sine = std::sin(radians);
  if (std::fabs(radians) == eighth || std::fabs(radians) == 3 * eighth)
    return {std::copysign(root_of_half, cosine), std::copysign(root_of_half, sine)};
  return {cosine, sine};
}

/// The unit vector at a finite angle. In degrees and quarter turns an angle and its complement have the same
/// components, exchanged: both leave the same rest, with the other sign.
inline Direction direction(double angle, AngleUnit unit) noexcept {
  if (unit.clockwise) angle = -angle;
  if (unit.measure == AngleUnit::radians) return direction(angle);
  const double quarter = unit.measure == AngleUnit::degrees ? 90 : 1;
  const double within = std::fmod(angle, 4 * quarter), quarters = std::nearbyint(within / quarter);
  const double rest = within - quarter * quarters;  // exact: both are within half of one another, or quarters is 0
  const bool by_degrees = unit.measure == AngleUnit::degrees, is_eighth = 2 * std::fabs(rest) == quarter;
  return turned(is_eighth    ? Direction{root_of_half, std::copysign(root_of_half, rest)}
                : by_degrees ? unit_vector(rest, degree_high, degree_low)
                             : unit_vector(rest, right_angle, right_angle_rest),
                static_cast<int>(quarters));
}

/// The angle of a vector that is not 0: from -180 to 180 degrees. The same bits on every system.
inline double angle(double x, double y, AngleUnit unit) noexcept {
  if (unit.clockwise) y = -y;
  const bool upright = std::fabs(y) > std::fabs(x);
  const int quarters = upright ? (y > 0 ? 1 : -1) : (x > 0 ? 0 : y < 0 ? -2 : 2);
  const Direction level = turned({x, y}, -quarters);
  const double rest = std::copysign(angle_of(level.x, std::fabs(level.y)), level.y);
  if (unit.measure == AngleUnit::radians) return right_angle * quarters + (rest + right_angle_rest * quarters);
  const double quarter = unit.measure == AngleUnit::degrees ? 90 : 1;
  return quarter * quarters + rest / right_angle * quarter;
}

}  // namespace detail::arithmetic
}  // namespace vesica
