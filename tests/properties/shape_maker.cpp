// SPDX-License-Identifier: Apache-2.0
#include "properties/shape_maker.hpp"

#include <vesica.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace properties {
namespace {

constexpr double pi = 3.141592653589793;

/// Mostly any direction, sometimes along an axis or a diagonal.
Vector random_direction(Random& random) {
  if (random.chance(0.125)) return random.chance(0.5) ? Vector{random.sign(), 0} : Vector{0, random.sign()};
  if (random.chance(0.0625)) return {random.sign() * std::sqrt(0.5), random.sign() * std::sqrt(0.5)};
  const double angle = random.between(-pi, pi);
  return {std::cos(angle), std::sin(angle)};
}

/// Half axes p and q about the centre c, for every kind: all that placing needs.
struct Frame {
  Vector c, p, q;
};

Vector times(double factor, Vector v) { return {factor * v.x, factor * v.y}; }

/// The vector made longer by r; if it is zero, along the other direction.
Vector longer(Vector v, double r, Vector otherwise) {
  const double length = std::hypot(v.x, v.y);
  return length > 0 ? times(length + r, {v.x / length, v.y / length}) : times(r, otherwise);
}

Frame frame(int kind, const Numbers& n) {
  switch (kind) {
    case VESICA_POINT:
      return {{n[0], n[1]}, {0, 0}, {0, 0}};
    case VESICA_CIRCLE:
      return {{n[0], n[1]}, {n[2], 0}, {0, n[2]}};
    case VESICA_SEGMENT:
      return {{n[0] / 2 + n[2] / 2, n[1] / 2 + n[3] / 2}, {n[2] / 2 - n[0] / 2, n[3] / 2 - n[1] / 2}, {0, 0}};
    case VESICA_AABB:
      return {{n[0] / 2 + n[2] / 2, n[1] / 2 + n[3] / 2}, {n[2] / 2 - n[0] / 2, 0}, {0, n[3] / 2 - n[1] / 2}};
    case VESICA_CAPSULE: {
      const Frame core = frame(VESICA_SEGMENT, n);
      const Vector p = longer(core.p, n[4], {1, 0});
      const double length = std::hypot(p.x, p.y);
      return {core.c, p, length > 0 ? times(n[4], {-p.y / length, p.x / length}) : p};
    }
    case VESICA_ROUND_RECT: {
      const Frame core = frame(VESICA_RECT, n);
      const double length = std::hypot(n[2], n[3]);
      const Vector u{n[2] / length, n[3] / length};
      return {core.c, longer(core.p, n[6], u), longer(core.q, n[6], {-u.y, u.x})};
    }
    default:
      return {{n[0], n[1]}, {n[4] * n[2], n[4] * n[3]}, {-n[5] * n[3], n[5] * n[2]}};
  }
}

Vector at(const Frame& f, double s, double t) { return {f.c.x + s * f.p.x + t * f.q.x, f.c.y + s * f.p.y + t * f.q.y}; }

}  // namespace

Numbers shape_at_origin(int kind, Vector u, double along, double across, double axis_length) {
  switch (kind) {
    case VESICA_POINT:
      return {0, 0};
    case VESICA_SEGMENT:
      return {-along * u.x, -along * u.y, along * u.x, along * u.y};
    case VESICA_CIRCLE:
      return {0, 0, along};
    case VESICA_AABB:
      return {-along, -across, along, across};
    case VESICA_CAPSULE:
      return {-along * u.x, -along * u.y, along * u.x, along * u.y, across};
    case VESICA_ROUND_RECT:
      return {0, 0, axis_length * u.x, axis_length * u.y, along / axis_length, across / axis_length, across / 2};
    default:
      return {0, 0, axis_length * u.x, axis_length * u.y, along / axis_length, across / axis_length};
  }
}

Numbers shape_at_origin(int kind, Random& random, const Proportions& proportions) {
  const Vector u = random_direction(random);
  double first = proportions.longer, second = proportions.shorter;
  if (random.chance(0.5)) std::swap(first, second);
  Numbers n = shape_at_origin(kind, u, first, second, proportions.axis_length);
  if (kind == VESICA_ROUND_RECT) n[6] *= random.between(0, 3);
  return n;
}

Numbers integer_shape(int kind, Random& random) {
  const auto size = [&] { return random.chance(0.2) ? 0.0 : random.integer(1, 3); };
  switch (kind) {
    case VESICA_POINT:
      return {0, 0};
    case VESICA_SEGMENT:
      return {size() * random.sign(), size() * random.sign(), size() * random.sign(), size() * random.sign()};
    case VESICA_CIRCLE:
      return {0, 0, size() + size()};
    case VESICA_AABB:
      return {-size(), -size(), size(), size()};
    case VESICA_CAPSULE: {
      Numbers n = integer_shape(VESICA_SEGMENT, random);
      n[4] = size();
      return n;
    }
    case VESICA_ROUND_RECT: {
      Numbers n = integer_shape(VESICA_RECT, random);
      n[6] = size();
      return n;
    }
    default: {
      Numbers n{0, 0, 0, 0, size(), size()};
      while (n[2] == 0 && n[3] == 0) {
        n[2] = random.integer(-2, 2);
        n[3] = random.integer(-2, 2);
      }
      return n;
    }
  }
}

Vector random_point(int kind, const Numbers& numbers, Random& random, double reach) {
  double s = random.between(-reach, reach), t = random.between(-reach, reach);
  const bool round = is_round(kind);
  while (round && s * s + t * t > reach * reach) {
    s = random.between(-reach, reach);
    t = random.between(-reach, reach);
  }
  if (random.chance(0.2)) {
    // Just inside a tip or a side's middle, where a thin shape's small cross product is all rounding error.
    const double sign = random.sign();
    const int near = random.integer(0, 50);
    s = sign * (1 - std::ldexp(random.unit(), -near));
    t = 0;
    if (random.chance(0.5)) std::swap(s, t);
  }
  return at(frame(kind, numbers), s, t);
}

Vector special_point(int kind, const Numbers& numbers, Random& random) {
  const bool round = is_round(kind);
  double s = random.sign(), t = random.sign();
  if (round) (random.chance(0.5) ? s : t) = 0;
  if (round && random.chance(0.2)) s = t = 0;
  if (is_inflated(kind)) {
    // An end or a corner of the core, or where the outline is farthest along an axis.
    if (random.chance(0.5))
      return special_point(kind == VESICA_CAPSULE ? VESICA_SEGMENT : VESICA_RECT, numbers, random);
    (random.chance(0.5) ? s : t) = 0;
  }
  return at(frame(kind, numbers), s, t);
}

Numbers moved(int kind, Numbers numbers, Vector by) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Role r = role(kind, static_cast<int>(i));
    if (r == Role::x) numbers[i] += by.x;
    if (r == Role::y) numbers[i] += by.y;
  }
  return numbers;
}

Numbers collapsed(int kind, Numbers n, Random& random) {
  const bool first = random.chance(0.5), second = random.chance(0.5);
  if (kind == VESICA_SEGMENT && first) n = {n[0], n[1], n[0], n[1]};
  if (kind == VESICA_CIRCLE && first) n[2] = 0;
  if (kind == VESICA_CAPSULE && first) n = {n[0], n[1], n[0], n[1], n[4]};
  if (kind == VESICA_CAPSULE && second) n[4] = 0;
  if (kind == VESICA_ROUND_RECT && random.chance(0.5)) n[6] = 0;
  if (kind == VESICA_AABB && first) n[2] = n[0];
  if (kind == VESICA_AABB && second) n[3] = n[1];
  if (has_axis(kind) && first) n[4] = 0;
  if (has_axis(kind) && second) n[5] = 0;
  return n;
}

Numbers scaled(int kind, Numbers numbers, int exponent, bool scale_axis) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Role r = role(kind, static_cast<int>(i));
    const bool skip = has_axis(kind) && r == (scale_axis ? Role::size : Role::axis);
    if (!skip) numbers[i] = std::ldexp(numbers[i], exponent);
  }
  return numbers;
}

}  // namespace properties
