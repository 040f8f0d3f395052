// SPDX-License-Identifier: Apache-2.0
#include "impact_time/face.hpp"

#include <algorithm>

#include "properties/shape_maker.hpp"

namespace impact_time_test {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A length that needles make small.
double length(Style style, properties::Random& random) {
  const double x = random.between(0.1, 1);
  if (style != Style::needles) return x;
  return random.chance(0.2) ? 0 : x * std::pow(10, -random.between(0, 13));
}

Numbers draw_shape(int kind, Style style, properties::Random& random) {
  const double x = random.between(-3, 3), y = random.between(-3, 3), angle = random.between(0, 2 * pi);
  const double a = random.between(0.1, 1), b = length(style, random);
  const Numbers there = properties::shape_at_origin(kind, {std::cos(angle), std::sin(angle)}, a, b, 3);
  return properties::moved(kind, there, {x, y});
}

}  // namespace

Placed placed_at(int kind, const Numbers& n, const Turn& turn, double t, double grown) {
  const bool is_line = kind == VESICA_SEGMENT || kind == VESICA_CAPSULE, corners = is_line || kind == VESICA_AABB;
  const double x = corners ? 0.5 * (n[0] + n[2]) : n[0], y = corners ? 0.5 * (n[1] + n[3]) : n[1];
  double ux = 1, uy = 0, hx = 0, hy = 0;
  if (is_line) {
    ux = n[2] - n[0], uy = n[3] - n[1], hx = 0.5;
  } else if (kind == VESICA_CIRCLE) {
    hx = hy = n[2];
  } else if (kind == VESICA_AABB) {
    hx = 0.5 * (n[2] - n[0]), hy = 0.5 * (n[3] - n[1]);
  } else if (kind >= VESICA_RECT) {
    ux = n[2], uy = n[3], hx = n[4], hy = n[5];
  }
  const long double angle = static_cast<long double>(turn.angle) * static_cast<long double>(t);
  const double c = static_cast<double>(std::cos(angle)), s = static_cast<double>(std::sin(angle));
  const bool inflated = properties::is_inflated(kind);
  return {properties::is_round(kind) ? VESICA_ELLIPSE
          : inflated                 ? VESICA_ROUND_RECT
                                     : VESICA_RECT,
          {std::fma(t, turn.vx, x), std::fma(t, turn.vy, y), c * ux - s * uy, s * ux + c * uy, hx * (1 + grown),
           hy * (1 + grown), inflated ? properties::radius(kind, n) * (1 + grown) : 0}};
}

bool cores_overlap(const Turning& s, double t) {
  const Placed a = placed_at(s.pair.kind_a, s.pair.a, s.a, t, -0x1p-40),
               b = placed_at(s.pair.kind_b, s.pair.b, s.b, t, -0x1p-40);
  return vesica_overlap_f64(a.kind, a.numbers.data(), b.kind, b.numbers.data()) == 1;
}

Turning draw(int kind_a, int kind_b, Style style, double spin, properties::Random& random) {
  Turning s{{kind_a, kind_b, draw_shape(kind_a, style, random), draw_shape(kind_b, style, random)}, {}, {}, 0};
  vesica_closest_points_f64 c{};
  vesica_nearest_f64(kind_a, s.pair.a.data(), kind_b, s.pair.b.data(), &c);
  if (style == Style::close && c.distance > 0) {
    // Nearly all of the way towards the other, a little turned: some come to overlap.
    const double share = 1 - std::pow(10, -random.between(1, 14));
    s.pair.b = properties::moved(kind_b, s.pair.b, {share * (c.ax - c.bx), share * (c.ay - c.by)});
  }
  s.b = {random.between(-8, 8), random.between(-8, 8), random.between(-spin, spin)};
  if (random.chance(0.6)) s.b.vx = 1.5 * (c.ax - c.bx) + random.between(-1, 1), s.b.vy = 1.5 * (c.ay - c.by);
  if (random.chance(0.6)) s.a = {random.between(-2, 2), random.between(-2, 2), random.between(-spin, spin)};
  if (style == Style::still) {
    s.b.vx = s.a.vx;
    s.b.vy = s.a.vy;
  }
  s.tolerance = std::pow(10, -random.between(1, 11));
  return s;
}

}  // namespace impact_time_test
