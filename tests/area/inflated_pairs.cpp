// SPDX-License-Identifier: Apache-2.0
#include "area/inflated_pairs.hpp"

#include <cmath>

namespace hard {
namespace {

using inflated::Shape;
using properties::Random;

struct Vector {
  double x, y;
};

/// A core with a radius about the origin, and the direction of its longer half size.
struct Body {
  int kind;
  double hx, hy, r;
  Vector axis;

  double longer() const { return hx + r; }
  double shorter() const { return hy + r; }
  Vector turned(double along, double across) const {
    return {along * axis.x - across * axis.y, along * axis.y + across * axis.x};
  }
};

double power_of_ten(double low, double high, Random& random) { return std::pow(10, random.between(low, high)); }

Body body(int kind, double size, Random& random) {
  const double aspect = random.chance(0.3) ? power_of_ten(0, 0.5, random) : power_of_ten(0, 4, random);
  const double shorter = size / aspect, angle = random.between(0, 6.283185307179586);
  const double share = random.chance(0.3) ? power_of_ten(-6, 0, random) : random.between(0.01, 1);
  const double r = kind == VESICA_CIRCLE       ? size
                   : kind == VESICA_CAPSULE    ? shorter
                   : kind == VESICA_ROUND_RECT ? shorter * share
                                               : 0;
  if (kind == VESICA_CIRCLE) return {kind, 0, 0, r, {1, 0}};
  if (kind == VESICA_AABB) return {kind, size, shorter, 0, {1, 0}};
  if (kind == VESICA_ELLIPSE) return {kind, size, shorter, 0, {std::cos(angle), std::sin(angle)}};
  return {kind, size - r, kind == VESICA_CAPSULE ? 0 : shorter - r, r, {std::cos(angle), std::sin(angle)}};
}

Shape shape(const Body& s, const Vector& centre, Random& random) {
  const auto& [x, y] = centre;
  const Vector end = s.turned(s.hx, 0);
  const double unit = random.chance(0.5) ? 1 : random.between(0.3, 3);
  switch (s.kind) {
    case VESICA_CIRCLE:
      return {s.kind, {x, y, s.r}};
    case VESICA_AABB:
      return {s.kind, {x - s.hx, y - s.hy, x + s.hx, y + s.hy}};
    case VESICA_CAPSULE:
      return {s.kind, {x - end.x, y - end.y, x + end.x, y + end.y, s.r}};
    default:
      return {s.kind, {x, y, s.axis.x * unit, s.axis.y * unit, s.hx / unit, s.hy / unit, s.r}};
  }
}

/// A point of the outline with its outward normal, and the radius of curvature there (0 on an edge).
struct Outline {
  Vector point, normal;
  double radius;
};

Outline outline(const Body& s, Random& random) {
  const double t = random.chance(0.3) ? random.sign() : random.between(-1, 1), side = random.sign();
  if (s.kind == VESICA_ELLIPSE) {
    const double angle =
        random.chance(0.2) ? 1.5707963267948966 * random.below(4) : random.between(0, 6.283185307179586);
    const double c = std::cos(angle), q = std::sin(angle), length = std::hypot(s.hy * c, s.hx * q);
    return {s.turned(s.hx * c, s.hy * q), s.turned(s.hy * c / length, s.hx * q / length),
            length * length * length / (s.hx * s.hy)};
  }
  if (s.r == 0 || random.chance(0.4)) {
    if (random.chance(0.5)) return {s.turned(side * s.longer(), t * s.hy), s.turned(side, 0), 0};
    return {s.turned(t * s.hx, side * s.shorter()), s.turned(0, side), 0};
  }
  const double angle = random.between(0, 6.283185307179586), c = std::cos(angle), q = std::sin(angle);
  return {s.turned(std::copysign(s.hx, c) + s.r * c, std::copysign(s.hy, q) + s.r * q), s.turned(c, q), s.r};
}

void turn_to(Body& s, Outline& p, const Vector& normal) {
  if (s.kind == VESICA_AABB) return;
  const double c = p.normal.x * normal.x + p.normal.y * normal.y, q = p.normal.x * normal.y - p.normal.y * normal.x;
  const auto turned = [&](const Vector& v) { return Vector{c * v.x - q * v.y, q * v.x + c * v.y}; };
  s.axis = turned(s.axis);
  p = {turned(p.point), turned(p.normal), p.radius};
}

InflatedPair contact(Case c, const Body& a, Body b, Random& random) {
  Outline p = outline(a, random), q = outline(b, random);
  if (c == Case::osculating && p.radius > 0 && q.radius > 0) {
    const double scale = p.radius / q.radius;
    b = {b.kind, b.hx * scale, b.hy * scale, b.r * scale, b.axis};
    q = {{q.point.x * scale, q.point.y * scale}, q.normal, p.radius};
  }
  const double side = c == Case::nearly_tangent ? -1 : 1;
  turn_to(b, q, {side * p.normal.x, side * p.normal.y});
  const double least = a.shorter() < b.shorter() ? a.shorter() : b.shorter();
  const double push =
      (random.chance(0.2) ? 0 : power_of_ten(-17, -1, random)) * least * (side < 0 ? -1 : random.sign());
  const Vector centre{p.point.x - q.point.x + push * p.normal.x, p.point.y - q.point.y + push * p.normal.y};
  return {shape(a, {0, 0}, random), shape(b, centre, random)};
}

/// The same body, as another kind where that can be, with each number changed a little.
InflatedPair identical(const Body& a, int kind_b, Random& random) {
  const double change = random.chance(0.2) ? 0 : power_of_ten(-17, -2, random);
  const auto changed = [&](double x) { return x * (1 + change * random.between(-1, 1)); };
  const double turn = change * random.between(-1, 1) * a.shorter() / a.longer();
  Body b{kind_b, changed(a.hx), changed(a.hy), changed(a.r), {a.axis.x - turn * a.axis.y, a.axis.y + turn * a.axis.x}};
  if (kind_b == VESICA_CIRCLE) b = {kind_b, 0, 0, a.shorter(), {1, 0}};
  if (kind_b == VESICA_AABB || kind_b == VESICA_RECT || kind_b == VESICA_ELLIPSE)
    b = {kind_b, b.longer(), b.shorter(), 0, b.axis};
  if (kind_b == VESICA_AABB) b.axis = {1, 0};
  if (kind_b == VESICA_CAPSULE) b = {kind_b, b.longer() - b.shorter(), 0, b.shorter(), b.axis};
  if (kind_b == VESICA_ROUND_RECT && b.r == 0) b.r = 0.5 * b.shorter(), b.hx -= b.r, b.hy -= b.r;
  const Vector off{a.shorter() * change * random.between(-1, 1), a.shorter() * change * random.between(-1, 1)};
  return {shape(a, {0, 0}, random), shape(b, off, random)};
}

InflatedPair sharing_axes(const Body& a, Body b, Random& random) {
  const bool across = random.chance(0.5);
  if (b.kind != VESICA_AABB) b.axis = across ? Vector{-a.axis.y, a.axis.x} : a.axis;
  const double other = across ? b.shorter() : b.longer(), sum = a.longer() + other, difference = a.longer() - other;
  const double along = random.chance(0.3) ? 0 : random.chance(0.5) ? difference : random.between(0, 1) * sum;
  return {shape(a, {0, 0}, random), shape(b, a.turned(along, 0), random)};
}

InflatedPair anywhere(const Body& a, const Body& b, Random& random) {
  const Vector p = a.turned(random.between(-1.2, 1.2) * a.longer(), random.between(-1.2, 1.2) * a.shorter());
  const Vector q = b.turned(random.between(-1.2, 1.2) * b.longer(), random.between(-1.2, 1.2) * b.shorter());
  return {shape(a, {0, 0}, random), shape(b, {p.x + q.x, p.y + q.y}, random)};
}

}  // namespace

InflatedPair draw_inflated(Case c, int kind_a, int kind_b, double most_ratio, Random& random) {
  const double ratio =
      random.chance(0.5) ? power_of_ten(-0.3, 0.3, random) : power_of_ten(-most_ratio, most_ratio, random);
  const Body a = body(kind_a, power_of_ten(-2, 2, random), random), b = body(kind_b, a.longer() * ratio, random);
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
