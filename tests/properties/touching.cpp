// SPDX-License-Identifier: Apache-2.0
#include <vesica.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "properties/generators.hpp"
#include "properties/shape_maker.hpp"

namespace properties {
namespace {

struct Triple {
  int leg, other_leg, hypotenuse;
};

/// Directions of rational length: legs of a Pythagorean triple, sometimes along an axis.
constexpr std::array<Triple, 5> triples{{{1, 0, 1}, {3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {15, 8, 17}}};

struct Direction {
  double x, y, length;
};

Direction rational_direction(Random& random) {
  const Triple t = triples[static_cast<std::size_t>(random.below(5))];
  const double x = t.leg * random.sign(), y = t.other_leg * random.sign();
  return random.chance(0.5) ? Direction{x, y, double(t.hypotenuse)} : Direction{y, x, double(t.hypotenuse)};
}

/// A shape about the origin and a point of it that lies farthest along a direction.
struct Supported {
  Numbers numbers;
  Vector support;
};

double sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

Supported segment_along(Random& random, const Direction& n) {
  Vector d{double(random.integer(-9, 9)), double(random.integer(-9, 9))};
  if (d.x * n.x + d.y * n.y > 0) d = {-d.x, -d.y};
  if (random.chance(0.5)) return {{0, 0, d.x, d.y}, {0, 0}};
  return {{d.x, d.y, 0, 0}, {0, 0}};
}

/// A point s u + t perp(u) of a rectangle; where n is parallel to a side, any point of that side is farthest.
Supported rect_along(Random& random, const Direction& n, Vector u) {
  const double hx = random.integer(0, 4), hy = random.integer(0, 4);
  const double along = sign_of(u.x * n.x + u.y * n.y), across = sign_of(u.x * n.y - u.y * n.x);
  const double s = along != 0 ? along * hx : random.sign() * hx;
  const double t = across != 0 ? across * hy : random.sign() * hy;
  return {{0, 0, u.x, u.y, hx, hy}, {s * u.x - t * u.y, s * u.y + t * u.x}};
}

/// The point of an ellipse farthest along n is (a^2 c u + b^2 s perp(u)) / sqrt((a c)^2 + (b s)^2) with c = u.n and
/// s = u x n: rational when a c and b s are legs of a Pythagorean triple, so a and b are chosen that they are.
Supported ellipse_along(Random& random, const Direction& n, Vector u) {
  const double c = u.x * n.x + u.y * n.y, s = u.x * n.y - u.y * n.x;
  const Triple t = triples[static_cast<std::size_t>(random.integer(1, 4))];
  double a = t.leg * std::fabs(s) * t.hypotenuse, b = t.other_leg * std::fabs(c) * t.hypotenuse;
  double along = a * t.leg * sign_of(c) / t.hypotenuse, across = b * t.other_leg * sign_of(s) / t.hypotenuse;
  if (c == 0 || s == 0 || random.chance(0.1)) {
    // Along an axis any half lengths will do, and with one of them zero any direction.
    a = random.integer(0, 9);
    b = c == 0 || s == 0 ? random.integer(0, 9) : 0;
    along = a * sign_of(c);
    across = b * sign_of(s);
  }
  return {{0, 0, u.x, u.y, a, b}, {along * u.x - across * u.y, along * u.y + across * u.x}};
}

/// The core made larger by a radius of whole lengths.
Supported inflated(Supported core, int radius_field, Random& random, const Direction& n) {
  const double times = random.integer(0, 4);
  core.numbers[static_cast<std::size_t>(radius_field)] = times * n.length;
  core.support = {core.support.x + times * n.x, core.support.y + times * n.y};
  return core;
}

Supported supported(int kind, Random& random, const Direction& n) {
  Vector u{0, 0};
  while (u.x == 0 && u.y == 0) u = {double(random.integer(-3, 3)), double(random.integer(-3, 3))};
  switch (kind) {
    case VESICA_POINT:
      return {{0, 0}, {0, 0}};
    case VESICA_SEGMENT:
      return segment_along(random, n);
    case VESICA_CIRCLE: {
      const double times = random.integer(0, 4);
      return {{0, 0, times * n.length}, {times * n.x, times * n.y}};
    }
    case VESICA_AABB: {
      const Supported box = rect_along(random, n, {1, 0});
      return {{-box.numbers[4], -box.numbers[5], box.numbers[4], box.numbers[5]}, box.support};
    }
    case VESICA_RECT:
      return rect_along(random, n, u);
    case VESICA_CAPSULE:
      return inflated(segment_along(random, n), 4, random, n);
    case VESICA_ROUND_RECT:
      return inflated(rect_along(random, n, u), 6, random, n);
    default:
      return ellipse_along(random, n, u);
  }
}

/// Shapes whose points farthest along a direction each are the same.
Pair at_one_point(int kind_a, const Direction& of_a, int kind_b, const Direction& of_b, Random& random) {
  const Supported a = supported(kind_a, random, of_a);
  const Supported b = supported(kind_b, random, of_b);
  const Vector place{double(random.integer(-9, 9)), double(random.integer(-9, 9))};
  const Vector apart{place.x + a.support.x - b.support.x, place.y + a.support.y - b.support.y};
  return {kind_a, kind_b, moved(kind_a, a.numbers, place), moved(kind_b, b.numbers, apart)};
}

}  // namespace

Contact touching(int kind_a, int kind_b, Random& random) {
  const Direction n = rational_direction(random);
  return {at_one_point(kind_a, n, kind_b, {-n.x, -n.y, n.length}, random), n.x, n.y};
}

Pair touching_from_one_side(int kind_a, int kind_b, Random& random) {
  const Direction n = rational_direction(random);
  return at_one_point(kind_a, n, kind_b, n, random);
}

}  // namespace properties
