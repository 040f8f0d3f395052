// SPDX-License-Identifier: Apache-2.0
#include "properties/exact_changes.hpp"

#include <vesica.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "properties/shape_maker.hpp"

namespace properties {
namespace {

using Number = std::optional<double>;

/// a + b when no bit is lost (Knuth's two-sum).
Number sum(const Number& a, const Number& b, Scalar scalar) {
  if (!a || !b) return {};
  const double s = *a + *b, rest = s - *a;
  const double error = (*a - (s - rest)) + (*b - rest);
  return representable(scalar, s) && error == 0 ? Number(s) : Number();
}

/// a * b when no bit is lost. Beneath 2^-900 the error itself might be, so nothing is claimed there.
Number product(double a, double b, Scalar scalar) {
  const double p = a * b;
  if (a == 0 || b == 0) return 0;
  const bool exact = std::fabs(p) >= 0x1p-900 && representable(scalar, p) && std::fma(a, b, -p) == 0;
  return exact ? Number(p) : Number();
}

Number negated(const Number& x) { return x ? Number(-*x) : Number(); }

/// x / 2 when no bit is lost.
Number half(const Number& x, Scalar scalar) {
  return x && representable(scalar, *x / 2) && *x / 2 * 2 == *x ? Number(*x / 2) : Number();
}

/// The shape with the given numbers, if all exist.
std::optional<Shape> shape_of(int kind, const std::vector<Number>& numbers) {
  Shape result{kind, {}};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i]) return {};
    result.numbers[i] = *numbers[i];
  }
  return result;
}

/// Corners C + s p + t q, s and t in {-1, 1}; nothing for one that rounds.
std::array<std::optional<Shape>, 4> corners(const Numbers& n, Scalar scalar) {
  const Number px = product(n[4], n[2], scalar), py = product(n[4], n[3], scalar);
  const Number qx = product(n[5], -n[3], scalar), qy = product(n[5], n[2], scalar);
  std::array<std::optional<Shape>, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool minus_p = i == 0 || i == 3, minus_q = i < 2;
    const Number x = sum(sum(n[0], minus_p ? negated(px) : px, scalar), minus_q ? negated(qx) : qx, scalar);
    const Number y = sum(sum(n[1], minus_p ? negated(py) : py, scalar), minus_q ? negated(qy) : qy, scalar);
    result[i] = shape_of(VESICA_POINT, {x, y});
  }
  return result;
}

std::optional<Shape> box_as_rect(const Numbers& n, Scalar scalar) {
  const Number cx = half(sum(n[0], n[2], scalar), scalar), cy = half(sum(n[1], n[3], scalar), scalar);
  const Number hx = half(sum(n[2], -n[0], scalar), scalar), hy = half(sum(n[3], -n[1], scalar), scalar);
  return shape_of(VESICA_RECT, {cx, cy, 1.0, 0.0, hx, hy});
}

std::vector<std::optional<Shape>> point_as_others(const Numbers& n) {
  return {Shape{VESICA_SEGMENT, {n[0], n[1], n[0], n[1]}},       Shape{VESICA_CIRCLE, {n[0], n[1], 0}},
          Shape{VESICA_AABB, {n[0], n[1], n[0], n[1]}},          Shape{VESICA_RECT, {n[0], n[1], 3, -1, 0, 0}},
          Shape{VESICA_ELLIPSE, {n[0], n[1], -2, 5, 0, 0}},      Shape{VESICA_CAPSULE, {n[0], n[1], n[0], n[1], 0}},
          Shape{VESICA_ROUND_RECT, {n[0], n[1], 3, -1, 0, 0, 0}}};
}

/// A rectangle with a radius of 0.
std::optional<Shape> as_round_rect(const std::optional<Shape>& rect) {
  return rect ? std::optional(Shape{VESICA_ROUND_RECT, rect->numbers}) : rect;
}

std::vector<std::optional<Shape>> circle_as_others(double x, double y, double r) {
  return {Shape{VESICA_CIRCLE, {x, y, r}}, Shape{VESICA_ELLIPSE, {x, y, 0, -1, r, r}},
          Shape{VESICA_CAPSULE, {x, y, x, y, r}}, Shape{VESICA_ROUND_RECT, {x, y, 3, -1, 0, 0, r}}};
}

std::vector<std::optional<Shape>> capsule_as_others(const Numbers& n, Scalar scalar) {
  if (n[0] == n[2] && n[1] == n[3]) return circle_as_others(n[0], n[1], n[4]);
  std::vector<std::optional<Shape>> result;
  if (n[4] == 0) result.push_back(Shape{VESICA_SEGMENT, {n[0], n[1], n[2], n[3]}});
  const Number cx = half(sum(n[0], n[2], scalar), scalar), cy = half(sum(n[1], n[3], scalar), scalar);
  const Number ux = half(sum(n[2], -n[0], scalar), scalar), uy = half(sum(n[3], -n[1], scalar), scalar);
  result.push_back(shape_of(VESICA_ROUND_RECT, {cx, cy, ux, uy, 1.0, 0.0, n[4]}));
  return result;
}

std::vector<std::optional<Shape>> rect_as_others(const Numbers& n, Scalar scalar) {
  std::vector<std::optional<Shape>> result;
  const auto corner = corners(n, scalar);
  if (n[4] == 0 || n[5] == 0) result.push_back(Shape{VESICA_ELLIPSE, n});
  result.push_back(Shape{VESICA_ROUND_RECT, n});
  if ((n[4] == 0 || n[5] == 0) && corner[0] && corner[2]) {
    const Numbers &low = corner[0]->numbers, &high = corner[2]->numbers;
    result.push_back(Shape{VESICA_SEGMENT, {low[0], low[1], high[0], high[1]}});
  }
  if ((n[2] == 0 || n[3] == 0) && corner[0] && corner[2]) {
    const auto [low_x, high_x] = std::minmax(corner[0]->numbers[0], corner[2]->numbers[0]);
    const auto [low_y, high_y] = std::minmax(corner[0]->numbers[1], corner[2]->numbers[1]);
    result.push_back(Shape{VESICA_AABB, {low_x, low_y, high_x, high_y}});
  }
  return result;
}

std::vector<std::optional<Shape>> round_rect_as_others(const Numbers& n, Scalar scalar) {
  if (n[4] == 0 && n[5] == 0) return circle_as_others(n[0], n[1], n[6]);
  std::vector<std::optional<Shape>> result;
  if (n[6] == 0) result.push_back(Shape{VESICA_RECT, n});
  const auto corner = corners(n, scalar);
  if ((n[4] == 0 || n[5] == 0) && corner[0] && corner[2]) {
    const Numbers &low = corner[0]->numbers, &high = corner[2]->numbers;
    result.push_back(Shape{VESICA_CAPSULE, {low[0], low[1], high[0], high[1], n[6]}});
  }
  return result;
}

std::vector<std::optional<Shape>> segment_as_others(const Numbers& n) {
  std::vector<std::optional<Shape>> result{Shape{VESICA_CAPSULE, n}};
  if (n[0] != n[2] && n[1] != n[3]) return result;
  const auto [low_x, high_x] = std::minmax(n[0], n[2]);
  const auto [low_y, high_y] = std::minmax(n[1], n[3]);
  result.push_back(Shape{VESICA_AABB, {low_x, low_y, high_x, high_y}});
  return result;
}

std::vector<std::optional<Shape>> others(const Shape& shape, Scalar scalar) {
  const Numbers& n = shape.numbers;
  switch (shape.kind) {
    case VESICA_POINT:
      return point_as_others(n);
    case VESICA_SEGMENT:
      return segment_as_others(n);
    case VESICA_CIRCLE:
      return circle_as_others(n[0], n[1], n[2]);
    case VESICA_AABB: {
      const auto rect = box_as_rect(n, scalar);
      if (n[0] == n[2] || n[1] == n[3]) return {Shape{VESICA_SEGMENT, n}, rect, as_round_rect(rect)};
      return {rect, as_round_rect(rect)};
    }
    case VESICA_CAPSULE:
      return capsule_as_others(n, scalar);
    case VESICA_ROUND_RECT:
      return round_rect_as_others(n, scalar);
    case VESICA_RECT:
      return rect_as_others(n, scalar);
    default: {
      if (n[4] == 0 || n[5] == 0) return {Shape{VESICA_RECT, n}};
      if (n[4] != n[5] || (n[2] != 0 && n[3] != 0)) return {};
      return {shape_of(VESICA_CIRCLE, {n[0], n[1], product(n[4], std::fabs(n[2] + n[3]), scalar)})};
    }
  }
}

}  // namespace

int random_exponent(Scalar scalar, Random& random) {
  const int many = scalar == Scalar::f32 ? 60 : 600;
  const int reach = random.chance(0.5) ? 4 : many;
  return random.integer(-reach, reach);
}

Shape mirrored(const Shape& shape) {
  Numbers n = shape.numbers;
  n[0] = -n[0];
  if (role(shape.kind, 2) != Role::radius) n[2] = -n[2];
  if (shape.kind == VESICA_AABB) std::swap(n[0], n[2]);
  return {shape.kind, n};
}

Shape turned(const Shape& shape) {
  const Numbers& n = shape.numbers;
  if (shape.kind == VESICA_AABB) return {shape.kind, {-n[3], n[0], -n[1], n[2]}};
  if (shape.kind == VESICA_CIRCLE) return {shape.kind, {-n[1], n[0], n[2]}};
  return {shape.kind, {-n[1], n[0], -n[3], n[2], n[4], n[5], n[6]}};
}

std::optional<Shape> scaled_exactly(const Shape& shape, Scalar scalar, int exponent, bool scale_axis) {
  const Numbers n = scaled(shape.kind, shape.numbers, exponent, scale_axis);
  if (!std::ranges::all_of(n, [&](double x) { return representable(scalar, x); })) return {};
  if (scaled(shape.kind, n, -exponent, scale_axis) != shape.numbers) return {};
  return Shape{shape.kind, n};
}

std::optional<Shape> with_negated_axis(const Shape& shape) {
  if (!has_axis(shape.kind)) return {};
  const Numbers& n = shape.numbers;
  return Shape{shape.kind, {n[0], n[1], -n[2], -n[3], n[4], n[5], n[6]}};
}

std::optional<Shape> with_turned_axis(const Shape& shape) {
  if (!has_axis(shape.kind)) return {};
  const Numbers& n = shape.numbers;
  return Shape{shape.kind, {n[0], n[1], -n[3], n[2], n[5], n[4], n[6]}};
}

std::optional<Shape> with_scaled_axis(const Shape& shape, Scalar scalar, int exponent) {
  if (!has_axis(shape.kind)) return {};
  Numbers n = shape.numbers;
  for (std::size_t i = 2; i < 6; ++i) {
    const int by = i < 4 ? exponent : -exponent;
    const double old = n[i];
    n[i] = std::ldexp(old, by);
    if (!representable(scalar, n[i]) || std::ldexp(n[i], -by) != old) return {};
  }
  return Shape{shape.kind, n};
}

std::optional<Shape> with_ends_exchanged(const Shape& shape) {
  if (shape.kind != VESICA_SEGMENT && shape.kind != VESICA_CAPSULE) return {};
  const Numbers& n = shape.numbers;
  return Shape{shape.kind, {n[2], n[3], n[0], n[1], n[4]}};
}

std::vector<Shape> as_other_kinds(const Shape& shape, Scalar scalar) {
  std::vector<Shape> result;
  for (const std::optional<Shape>& other : others(shape, scalar)) {
    if (other && other->kind != shape.kind) result.push_back(*other);
  }
  return result;
}

std::optional<Shape> grown(const Shape& shape, Scalar scalar, Random& random) {
  if (shape.kind == VESICA_POINT || shape.kind == VESICA_SEGMENT) return {};
  Numbers n = shape.numbers;
  const bool box = shape.kind == VESICA_AABB;
  const int first = shape.kind == VESICA_CIRCLE ? 2 : box ? 0 : 4;
  const int field = random.integer(first, field_count(shape.kind) - 1);
  double& x = n[static_cast<std::size_t>(field)];
  const bool downward = box && field < 2;
  const double much = nearest(scalar, x + (downward ? -std::fabs(x) : std::fabs(x)) / 2);
  x = random.chance(0.5) ? much : at_ordinal(scalar, ordinal(scalar, x) + (downward ? -1 : 1));
  return Shape{shape.kind, n};
}

std::vector<Shape> own_points(const Shape& shape, Scalar scalar) {
  const Numbers& n = shape.numbers;
  std::vector<std::optional<Shape>> points{Shape{VESICA_POINT, {n[0], n[1]}}};
  const auto add = [&](const Number& x, const Number& y) { points.push_back(shape_of(VESICA_POINT, {x, y})); };
  if (role(shape.kind, 2) == Role::x) add(n[2], n[3]);
  if (shape.kind == VESICA_AABB) {
    add(n[0], n[3]);
    add(n[2], n[1]);
  }
  if (shape.kind == VESICA_CIRCLE) {
    add(sum(n[0], n[2], scalar), n[1]);
    add(n[0], sum(n[1], -n[2], scalar));
  }
  if (shape.kind == VESICA_CAPSULE) {
    add(sum(n[0], n[4], scalar), n[1]);
    add(n[2], sum(n[3], -n[4], scalar));
  }
  if (shape.kind == VESICA_RECT || shape.kind == VESICA_ROUND_RECT) {
    for (const auto& corner : corners(n, scalar)) {
      points.push_back(corner);
      if (shape.kind == VESICA_ROUND_RECT && corner) add(sum(corner->numbers[0], n[6], scalar), corner->numbers[1]);
    }
  }
  if (shape.kind == VESICA_ELLIPSE) {
    // Vertices are the corners of the segments that the two axes are.
    for (const auto& end : corners({n[0], n[1], n[2], n[3], n[4], 0}, scalar)) points.push_back(end);
    for (const auto& end : corners({n[0], n[1], n[2], n[3], 0, n[5]}, scalar)) points.push_back(end);
  }
  std::vector<Shape> result;
  for (const std::optional<Shape>& point : points) {
    if (point) result.push_back(*point);
  }
  return result;
}

}  // namespace properties
