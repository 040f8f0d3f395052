// SPDX-License-Identifier: Apache-2.0
/// The C interface of gradient descent in both scalars, and pairs to try it on.
#pragma once

#include <vesica_methods.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "methods/nineteen_ellipses.hpp"
#include "properties/random.hpp"

namespace descent {

template <class T>
struct Face;

template <>
struct Face<double> {
  using Ellipse = vesica_ellipse_f64;
  using Settings = vesica_descent_settings_f64;
  using Result = vesica_descent_result_f64;
  static constexpr auto run = vesica_method_ellipse_ellipse_distance_gradient_descent_f64;
  static constexpr auto defaults = vesica_method_descent_settings_f64;
};

template <>
struct Face<float> {
  using Ellipse = vesica_ellipse_f32;
  using Settings = vesica_descent_settings_f32;
  using Result = vesica_descent_result_f32;
  static constexpr auto run = vesica_method_ellipse_ellipse_distance_gradient_descent_f32;
  static constexpr auto defaults = vesica_method_descent_settings_f32;
};

template <class T>
typename Face<T>::Settings settings(std::int32_t schedule) {
  typename Face<T>::Settings s{};
  Face<T>::defaults(schedule, &s);
  return s;
}

template <class T>
typename Face<T>::Ellipse sample(const nineteen_ellipses::Sample& s) {
  const auto e = nineteen_ellipses::ellipse<T>(s);
  return {e.cx, e.cy, e.ux, e.uy, e.a, e.b};
}

/// An answer with its result.
template <class T>
struct Answer {
  std::int32_t code;
  typename Face<T>::Result result;
};

template <class Ellipse>
auto run(const Ellipse& a, const Ellipse& b, std::int32_t schedule = VESICA_SCHEDULE_SCALE_AWARE) {
  using T = decltype(a.cx + a.cx);
  Answer<T> answer{};
  const auto s = settings<T>(schedule);
  answer.code = Face<T>::run(&a, &b, &s, &answer.result, nullptr, 0);
  return answer;
}

/// Half lengths from 1/4 to 1 along and 1 to `aspect` times shorter across, in a square of half side `reach`.
inline vesica_ellipse_f64 random_ellipse(properties::Random& random, double aspect, double reach) {
  const double angle = random.between(0, 2 * std::numbers::pi), length = std::exp2(random.between(-2, 0));
  return {
      random.between(-reach, reach),           random.between(-reach, reach), std::cos(angle), std::sin(angle), length,
      length / std::pow(aspect, random.unit())};
}

inline vesica_ellipse_f64 scaled(vesica_ellipse_f64 e, double factor) {
  return {factor * e.cx, factor * e.cy, e.ux, e.uy, factor * e.a, factor * e.b};
}

}  // namespace descent
