// SPDX-License-Identifier: Apache-2.0
#include "methods/gradient_descent/outline_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace outline_distance {
namespace {

/// How far the ellipse reaches from its centre along a unit vector.
double support(const vesica_ellipse_f64& e, double x, double y) {
  return std::hypot(e.a * (x * e.ux + y * e.uy), e.b * (y * e.ux - x * e.uy));
}

/// The maximum of a function that has one between two angles, by golden section.
template <class Function>
double maximum_between(const Function& function, double low, double high) {
  constexpr double part = 1 / std::numbers::phi;
  for (int i = 0; i < 60; ++i) {
    const double left = high - part * (high - low), right = low + part * (high - low);
    (function(left) < function(right) ? low : high) = function(left) < function(right) ? left : right;
  }
  return function((low + high) / 2);
}

/// The greatest of all local maxima over the circle that are a thousandth of it apart.
template <class Function>
double global_maximum(const Function& function) {
  constexpr int steps = 2000;
  constexpr double step = 2 * std::numbers::pi / steps;
  std::vector<double> values;
  for (int i = 0; i < steps; ++i) values.push_back(function(i * step));
  double greatest = -HUGE_VAL;
  for (int i = 0; i < steps; ++i) {
    const double here = values[static_cast<std::size_t>(i)];
    if (here < values[static_cast<std::size_t>((i + 1) % steps)]) continue;
    if (here < values[static_cast<std::size_t>((i + steps - 1) % steps)]) continue;
    greatest = std::max(greatest, maximum_between(function, (i - 1) * step, (i + 1) * step));
  }
  return greatest;
}

}  // namespace

double of_disjoint(const vesica_ellipse_f64& a, const vesica_ellipse_f64& b) {
  return global_maximum([&](double angle) {
    const double x = std::cos(angle), y = std::sin(angle);
    return x * (b.cx - a.cx) + y * (b.cy - a.cy) - support(a, x, y) - support(b, x, y);
  });
}

double of_nested(const vesica_ellipse_f64& inner, const vesica_ellipse_f64& outer) {
  return -global_maximum([&](double angle) {
    const double x = std::cos(angle), y = std::sin(angle);
    return x * (inner.cx - outer.cx) + y * (inner.cy - outer.cy) + support(inner, x, y) - support(outer, x, y);
  });
}

}  // namespace outline_distance
