// SPDX-License-Identifier: Apache-2.0
#include "nearest/contestant.hpp"

#include <numbers>
#include <utility>

namespace vesica::bench {

std::vector<Contestant>& contestants() {
  static std::vector<Contestant> all;
  return all;
}

bool add_contestant(Contestant contestant) {
  contestants().push_back(std::move(contestant));
  return true;
}

std::vector<PlanePoint> outline_of(std::int32_t kind, const Numbers& shape) {
  const bool circle = kind == VESICA_CIRCLE;
  const double ux = circle ? 1 : shape[2], uy = circle ? 0 : shape[3];
  const double a = circle ? shape[2] : shape[4], b = circle ? shape[2] : shape[5];
  const auto at = [&](double s, double t) {
    return PlanePoint{shape[0] + s * ux - t * uy, shape[1] + s * uy + t * ux};
  };
  if (kind == VESICA_RECT) return {at(-a, -b), at(a, -b), at(a, b), at(-a, b)};
  std::vector<PlanePoint> polygon;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::numbers::pi * i / 64;
    polygon.push_back(at(a * std::cos(angle), b * std::sin(angle)));
  }
  return polygon;
}

}  // namespace vesica::bench
