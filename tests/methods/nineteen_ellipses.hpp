// SPDX-License-Identifier: Apache-2.0
/// The nineteen sample pairs of "Minimum Distance Between Ellipses" (2021): one ellipse, and
/// nineteen others that equal it, touch it from inside, cross it, lie apart from it or lie inside it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vesica/shapes.hpp>

namespace nineteen_ellipses {

/// Centre, full width and height, and the angle of the width in degrees.
struct Sample {
  double cx, cy, width, height, degrees;
};

inline constexpr Sample first{0, 0, 6, 10, 15};

inline constexpr std::array<Sample, 19> others{{
    {0, 0, 6, 10, 15},     // equal
    {0, 0, 6, 10, 195},    // equal, half a turn round
    {0, 0, 6, 9, 15},      // inside, touching at both ends of the width
    {0, 0, 6, 9, 195},     //
    {0, 0, 5, 10, 15},     // inside, touching at both ends of the height
    {0, 0, 5, 10, 195},    //
    {0, 0, 6, 10, -15},    // four crossings
    {0, 0, 6, 10, 165},    //
    {7, 7, 5, 9, 15},      // apart, from here on
    {7, 7, 5, 9, 195},     //
    {-7, -7, 7, 4, 0},     //
    {-7, -7, 7, 4, 180},   //
    {-7, 7, 10, 4, 0},     //
    {-7, 7, 10, 4, 180},   //
    {7, -7, 4, 6, 45},     //
    {7, -7, 4, 6, 225},    //
    {-8, 0, 4, 4, 0},      // circles
    {-8, 0, 4, 4, 15},     //
    {0.5, -0.5, 2, 4, 0},  // inside
}};

/// The distances of outlines to 1e-13, by search over all directions of parallel tangents.
inline constexpr std::array<double, 19> distances{0,
                                                  0,
                                                  0,
                                                  0,
                                                  0,
                                                  0,
                                                  0,
                                                  0,  //
                                                  3.7075573888756,
                                                  3.7075573888756,
                                                  3.4542878144335,
                                                  3.4542878144335,
                                                  1.6401059177260,
                                                  1.6401059177260,
                                                  2.4981753376659,
                                                  2.4981753376659,
                                                  2.8916462699459,
                                                  2.8916462699459,
                                                  1.5498764578216};

/// The ellipses whose outlines share a point, up to the rounding of the axes: the distance of outlines is 0.
constexpr bool touches_or_crosses(std::size_t i) { return i < 8; }

template <class T>
vesica::Ellipse<T> ellipse(const Sample& s) {
  const double angle = s.degrees * (std::numbers::pi / 180);
  return {static_cast<T>(s.cx),
          static_cast<T>(s.cy),
          std::cos(static_cast<T>(angle)),
          std::sin(static_cast<T>(angle)),
          static_cast<T>(s.width / 2),
          static_cast<T>(s.height / 2)};
}

}  // namespace nineteen_ellipses
