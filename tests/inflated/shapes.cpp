// SPDX-License-Identifier: Apache-2.0
#include "inflated/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace inflated {

using properties::Random;

Shape shape(std::int32_t kind, Random& random) {
  const double x = random.between(-3, 3), y = random.between(-3, 3), turn = random.between(-4, 4);
  const double ux = std::cos(turn), uy = std::sin(turn), a = random.unit(), b = random.unit(), r = random.unit();
  switch (kind) {
    case VESICA_POINT:
      return {kind, {x, y}};
    case VESICA_SEGMENT:
      return {kind, {x, y, x + 2 * a * ux, y + 2 * a * uy}};
    case VESICA_CIRCLE:
      return {kind, {x, y, r}};
    case VESICA_AABB:
      return {kind, {x, y, x + 2 * a, y + 2 * b}};
    case VESICA_CAPSULE:
      return {kind, {x, y, x + 2 * a * ux, y + 2 * a * uy, r}};
    default:
      return {kind, {x, y, ux, uy, a, b, kind == VESICA_ROUND_RECT ? r : 0}};
  }
}

Shape any_shape(Random& random, int count) { return shape(random.below(count), random); }
Shape inflated_shape(Random& random) { return shape(kinds[static_cast<std::size_t>(random.below(2))], random); }

Shape lattice_shape(Random& random) {
  constexpr double axes[][2] = {{1, 0}, {0, 1}, {-1, 0}, {3, 4}, {-4, 3}, {1, 1}, {2, 1}};
  constexpr double sizes[] = {0, 0.5, 1, 1.5, 2};
  const auto& axis = axes[random.below(7)];
  const auto size = [&] { return sizes[random.below(5)] / (axis[0] * axis[1] == 0 ? 1 : 4); };
  const double x = random.integer(-3, 3), y = random.integer(-3, 3), a = size(), b = size();
  const double r = 0.5 * random.integer(random.below(4) == 0 ? 0 : 1, 5);
  const std::int32_t kind = std::array{0, 1, 2, 3, 4, 6, 6, 7, 7}[static_cast<std::size_t>(random.below(9))];
  switch (kind) {
    case VESICA_POINT:
      return {kind, {x, y}};
    case VESICA_CIRCLE:
      return {kind, {x, y, r}};
    case VESICA_AABB:
      return {kind, {x - a, y - b, x + a, y + b}};
    case VESICA_SEGMENT:
    case VESICA_CAPSULE:
      return {kind, {x, y, x + 2 * a * axis[0], y + 2 * a * axis[1], kind == VESICA_CAPSULE ? r : 0}};
    default:
      return {kind, {x, y, axis[0], axis[1], a, b, kind == VESICA_ROUND_RECT ? r : 0}};
  }
}

bool is_inflated(const Shape& s) { return s.kind == VESICA_CAPSULE || s.kind == VESICA_ROUND_RECT; }

std::string described(const Shape& s) {
  std::string text = vesica_kind_name(s.kind);
  for (int i = 0; i < vesica_field_count(s.kind); ++i) {
    char number[40];
    std::snprintf(number, sizeof number, " %.17g", s.number[static_cast<std::size_t>(i)]);
    text += number;
  }
  return text;
}

Shape moved(Shape s, double dx) {
  s.number[0] += dx;
  if (s.kind == VESICA_SEGMENT || s.kind == VESICA_AABB || s.kind == VESICA_CAPSULE) s.number[2] += dx;
  return s;
}

Shape times(Shape s, double k) {
  const bool has_axis = s.kind == VESICA_RECT || s.kind == VESICA_ELLIPSE || s.kind == VESICA_ROUND_RECT;
  for (std::size_t i = 0; i < s.number.size(); ++i) {
    if (!has_axis || i < 4 || i == 6) s.number[i] *= k;
  }
  return s;
}

double scale(const Shape& a, const Shape& b) {
  double most = 0;
  for (const Shape* s : {&a, &b}) {
    const auto& n = s->number;
    const bool has_axis = s->kind == VESICA_RECT || s->kind == VESICA_ELLIPSE || s->kind == VESICA_ROUND_RECT;
    most = std::max({most, std::fabs(n[0]), std::fabs(n[1]), radius(*s)});
    if (has_axis) most = std::max(most, std::max(n[4], n[5]) * std::hypot(n[2], n[3]));
    if (s->kind == VESICA_SEGMENT || s->kind == VESICA_AABB || s->kind == VESICA_CAPSULE)
      most = std::max({most, std::fabs(n[2]), std::fabs(n[3])});
  }
  return most;
}

double radius(const Shape& s) {
  return s.kind == VESICA_CIRCLE       ? s.number[2]
         : s.kind == VESICA_CAPSULE    ? s.number[4]
         : s.kind == VESICA_ROUND_RECT ? s.number[6]
                                       : 0;
}

Shape core(const Shape& s) {
  const Numbers& n = s.number;
  if (s.kind == VESICA_CIRCLE) return {VESICA_POINT, {n[0], n[1]}};
  if (s.kind == VESICA_CAPSULE) return {VESICA_SEGMENT, {n[0], n[1], n[2], n[3]}};
  if (s.kind == VESICA_ROUND_RECT) return {VESICA_RECT, {n[0], n[1], n[2], n[3], n[4], n[5]}};
  return s;
}

template <class T>
Columns<T>::Columns(std::int32_t of, int count, Random& random) : kind(of) {
  for (int i = 0; i < count; ++i) {
    const Shape s = shape(of, random);
    for (std::size_t k = 0; k < column.size(); ++k) column[k].push_back(static_cast<T>(s.number[k]));
  }
}

template <class T>
Shape Columns<T>::at(std::size_t i) const {
  Shape s{kind, {}};
  for (std::size_t k = 0; k < column.size(); ++k) s.number[k] = static_cast<double>(column[k][i]);
  return s;
}

template struct Columns<double>;
template struct Columns<float>;

namespace {

template <class Array, class T>
Array array_of(const Columns<T>& c) {
  Array a{};
  a.kind = c.kind;
  a.count = static_cast<std::int64_t>(c.column[0].size());
  a.stride = sizeof(T);
  for (int k = 0; k < vesica_field_count(c.kind); ++k) a.field[k] = c.column[static_cast<std::size_t>(k)].data();
  return a;
}

}  // namespace

vesica_shapes_f64 array(const Columns<double>& c) { return array_of<vesica_shapes_f64>(c); }
vesica_shapes_f32 array(const Columns<float>& c) { return array_of<vesica_shapes_f32>(c); }

}  // namespace inflated
