// SPDX-License-Identifier: Apache-2.0
#include "cast/motions.hpp"

#include <algorithm>
#include <numeric>

namespace cast_test {
namespace {

/// A place near the shape: a corner or the centre.
std::array<double, 2> some_place(int kind, const Numbers& n, properties::Random& random) {
  const bool corners = kind == VESICA_SEGMENT || kind == VESICA_AABB;
  const bool second = corners && random.chance(0.5);
  return {n[second ? 2 : 0], n[second ? 3 : 1]};
}

/// The number that a place among a moving pair's numbers names: velocity, end, or a coordinate.
double* number(Moving& m, int which) {
  if (which == 0) return &m.motion.vx;
  if (which == 1) return &m.motion.vy;
  if (which == 2) return &m.motion.end;
  return which % 2 == 1 ? &m.pair.b[0] : &m.pair.b[1];
}

bool touches(const Moving& m, Scalar scalar) { return cast(scalar, m.pair, m.motion).code > 0; }
bool is_valid(const Moving& m) { return properties::valid(m.pair.kind_b, m.pair.b); }

}  // namespace

Motion draw_motion(const Pair& pair, Scalar scalar, properties::Random& random) {
  const auto from = some_place(pair.kind_b, pair.b, random), to = some_place(pair.kind_a, pair.a, random);
  const double dx = 0.5 * to[0] - 0.5 * from[0], dy = 0.5 * to[1] - 0.5 * from[1];
  double size = std::max(std::fabs(dx), std::fabs(dy));
  if (size == 0) size = 1;
  double vx = dx, vy = dy;
  const int mode = random.below(8);
  if (mode == 0) {
    vx = size * random.between(-1, 1);
    vy = size * random.between(-1, 1);
  } else if (mode == 1) {
    vx = random.integer(-4, 4);
    vy = random.integer(-4, 4);
  } else if (mode == 2) {
    vx = random.chance(0.5) ? vx : 0;
    vy = vx == 0 ? vy : 0;
  } else if (mode == 3) {
    const int exponent = scalar == Scalar::f64 ? random.integer(-900, 900) : random.integer(-100, 100);
    vx = std::ldexp(vx / size, exponent);
    vy = std::ldexp(vy / size, exponent);
  } else if (mode < 6) {
    vx += 0.2 * size * random.between(-1, 1);
    vy += 0.2 * size * random.between(-1, 1);
  }
  const int end = random.below(4);
  const double t_end = end == 0 ? 1 : end == 1 ? random.between(0, 4) : end == 2 ? random.integer(0, 6) : infinity;
  return {properties::nearest(scalar, vx), properties::nearest(scalar, vy),
          end == 3 ? infinity : properties::nearest(scalar, t_end)};
}

std::vector<Moving> about_grazing(const Moving& hit, Scalar scalar, properties::Random& random, int places) {
  const int which = random.below(5);
  Moving m = hit;
  double& x = *number(m, which);
  if (which == 2 && std::isinf(x)) x = std::max(1.0, cast(scalar, m.pair, m.motion).t);
  if (!std::isfinite(x) || !properties::representable(scalar, x)) return {};
  const std::int64_t lowest = which == 2 ? 0 : properties::ordinal(scalar, -1e30),
                     highest = properties::ordinal(scalar, 1e30);
  std::int64_t yes = properties::ordinal(scalar, x);
  std::int64_t no = which == 2 ? 0 : yes + static_cast<std::int64_t>(random.sign()) * (yes / 64 + 2000);
  no = std::clamp(no, lowest, highest);
  x = properties::at_ordinal(scalar, no);
  if (touches(m, scalar)) no = random.chance(0.5) ? lowest : highest;
  x = properties::at_ordinal(scalar, no);
  if (touches(m, scalar)) return {};
  // Of opposite signs their difference may be too long.
  for (std::int64_t middle = std::midpoint(yes, no); middle != yes && middle != no; middle = std::midpoint(yes, no)) {
    x = properties::at_ordinal(scalar, middle);
    (touches(m, scalar) ? yes : no) = middle;
  }
  std::vector<Moving> found;
  for (std::int64_t at = yes - places; at <= yes + places; ++at) {
    x = properties::at_ordinal(scalar, std::max(at, lowest));
    if (is_valid(m)) found.push_back(m);
  }
  return found;
}

}  // namespace cast_test
