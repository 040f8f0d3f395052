// SPDX-License-Identifier: Apache-2.0
#include "area/hard_pairs.hpp"

#include <vesica.h>

#include <cmath>

namespace hard {
namespace {

using properties::Numbers;
using properties::Pair;
using properties::Random;

struct Vector {
  double x, y;
};

/// A shape about the origin: longer and shorter half size, and the direction of the first.
struct Body {
  int kind;
  double longer, shorter;
  Vector axis;
};

bool is_box(int kind) { return kind == VESICA_AABB || kind == VESICA_RECT; }

double power_of_ten(double low, double high, Random& random) { return std::pow(10, random.between(low, high)); }

Body body(int kind, double size, Random& random) {
  const double aspect = kind == VESICA_CIRCLE ? 1
                        : random.chance(0.3)  ? power_of_ten(0, 0.5, random)
                                              : power_of_ten(0, 4, random);
  const double angle = kind == VESICA_RECT || kind == VESICA_ELLIPSE ? random.between(0, 6.283185307179586)
                       : random.chance(0.5)                          ? 0
                                                                     : 1.5707963267948966;
  return {kind, size, size / aspect, {std::cos(angle), std::sin(angle)}};
}

Numbers numbers(const Body& s, const Vector& centre, Random& random) {
  const auto& [x, y] = centre;
  switch (s.kind) {
    case VESICA_CIRCLE:
      return {x, y, s.longer};
    case VESICA_AABB: {
      const bool upright = std::fabs(s.axis.y) > std::fabs(s.axis.x);
      const double hx = upright ? s.shorter : s.longer, hy = upright ? s.longer : s.shorter;
      return {x - hx, y - hy, x + hx, y + hy};
    }
    default: {
      const double unit = random.chance(0.5) ? 1 : random.between(0.3, 3);
      return {x, y, s.axis.x * unit, s.axis.y * unit, s.longer / unit, s.shorter / unit};
    }
  }
}

/// A point of the outline with its outward normal, and the radius of curvature there (0 at a corner or on an edge).
struct Outline {
  Vector point, normal;
  double radius;
};

Outline outline(const Body& s, Random& random) {
  const auto turned = [&](double along, double across) {
    return Vector{along * s.axis.x - across * s.axis.y, along * s.axis.y + across * s.axis.x};
  };
  if (is_box(s.kind)) {
    const double t = random.chance(0.3) ? 1 : random.between(-1, 1), side = random.sign();
    if (random.chance(0.5)) return {turned(side * s.longer, t * s.shorter), turned(side, 0), 0};
    return {turned(t * s.longer, side * s.shorter), turned(0, side), 0};
  }
  const double angle = random.chance(0.2) ? 1.5707963267948966 * random.below(4) : random.between(0, 6.283185307179586);
  const double c = std::cos(angle), q = std::sin(angle), a = s.longer, b = s.shorter;
  const double length = std::hypot(b * c, a * q);
  return {turned(a * c, b * q), turned(b * c / length, a * q / length), length * length * length / (a * b)};
}

/// s turned so that its outline's normal at p.normal's place becomes `normal`, as far as its kind can be turned.
void turn_to(Body& s, Outline& p, const Vector& normal) {
  if (s.kind == VESICA_AABB) return;
  const double c = p.normal.x * normal.x + p.normal.y * normal.y, q = p.normal.x * normal.y - p.normal.y * normal.x;
  const auto turned = [&](const Vector& v) { return Vector{c * v.x - q * v.y, q * v.x + c * v.y}; };
  s.axis = turned(s.axis);
  p = {turned(p.point), turned(p.normal), p.radius};
}

Pair contact(Case c, Body a, Body b, Random& random) {
  Outline p = outline(a, random), q = outline(b, random);
  if (c == Case::osculating && p.radius > 0 && q.radius > 0) {
    const double scale = p.radius / q.radius;
    b = {b.kind, b.longer * scale, b.shorter * scale, b.axis};
    q = {{q.point.x * scale, q.point.y * scale}, q.normal, p.radius};
  }
  const double side = c == Case::nearly_tangent ? -1 : 1;
  turn_to(b, q, {side * p.normal.x, side * p.normal.y});
  const double least = a.shorter < b.shorter ? a.shorter : b.shorter;
  const double push =
      (random.chance(0.2) ? 0 : power_of_ten(-17, -1, random)) * least * (side < 0 ? -1 : random.sign());
  const Vector centre{p.point.x - q.point.x + push * p.normal.x, p.point.y - q.point.y + push * p.normal.y};
  return {a.kind, b.kind, numbers(a, {0, 0}, random), numbers(b, centre, random)};
}

Pair identical(const Body& a, int kind_b, Random& random) {
  Body b = a;
  b.kind = kind_b;
  const double change = power_of_ten(-17, -2, random);
  const auto changed = [&](double x) { return x * (1 + change * random.between(-1, 1)); };
  const double turn = change * random.between(-1, 1) * a.shorter / a.longer;
  if (kind_b == VESICA_CIRCLE) b.longer = b.shorter = std::sqrt(a.longer * a.shorter);
  b = {kind_b, changed(b.longer), changed(b.shorter), {b.axis.x - turn * b.axis.y, b.axis.y + turn * b.axis.x}};
  const Vector off{a.shorter * change * random.between(-1, 1), a.shorter * change * random.between(-1, 1)};
  return {a.kind, kind_b, numbers(a, {0, 0}, random), numbers(b, off, random)};
}

Pair sharing_axes(const Body& a, Body b, Random& random) {
  const bool across = random.chance(0.5);
  b.axis = across ? Vector{-a.axis.y, a.axis.x} : a.axis;
  const double sum = across ? a.longer + b.shorter : a.longer + b.longer;
  const double difference = across ? a.longer - b.shorter : a.longer - b.longer;
  const double along = random.chance(0.3) ? 0 : random.chance(0.5) ? difference : random.between(0, 1) * sum;
  return {a.kind, b.kind, numbers(a, {0, 0}, random), numbers(b, {along * a.axis.x, along * a.axis.y}, random)};
}

Pair anywhere(const Body& a, const Body& b, Random& random) {
  Random& r = random;
  const double s = r.between(-1.2, 1.2), t = r.between(-1.2, 1.2), along = s * a.longer, across = t * a.shorter;
  const double ahead = s * b.longer, beside = t * b.shorter;
  const Vector centre{along * a.axis.x - across * a.axis.y + ahead * b.axis.x - beside * b.axis.y,
                      along * a.axis.y + across * a.axis.x + ahead * b.axis.y + beside * b.axis.x};
  return {a.kind, b.kind, numbers(a, {0, 0}, random), numbers(b, centre, random)};
}

}  // namespace

const char* name(Case c) {
  constexpr const char* names[] = {"anywhere",   "nearly tangent",   "nested tangent",
                                   "osculating", "nearly identical", "sharing axes"};
  return names[static_cast<int>(c)];
}

Pair draw(Case c, int kind_a, int kind_b, double most_ratio, Random& random) {
  const double ratio =
      random.chance(0.5) ? power_of_ten(-0.3, 0.3, random) : power_of_ten(-most_ratio, most_ratio, random);
  const Body a = body(kind_a, power_of_ten(-2, 2, random), random), b = body(kind_b, a.longer * ratio, random);
  switch (c) {
    case Case::anywhere:
      return anywhere(a, b, random);
    case Case::nearly_identical:
      return identical(a, kind_b, random);
    case Case::sharing_axes:
      return sharing_axes(a, b, random);
    default:
      return contact(c, a, b, random);
  }
}

}  // namespace hard
