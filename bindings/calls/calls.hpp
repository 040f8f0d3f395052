// SPDX-License-Identifier: Apache-2.0
/// The C functions by one name for both scalars, and the shapes that the calls are about.
#pragma once

#include <vesica.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

namespace call {
#define VESICA_BOTH_SCALARS(name)                                                                  \
  struct Name_##name {                                                                             \
    auto operator()(double, auto... arguments) const { return vesica_##name##_f64(arguments...); } \
    auto operator()(float, auto... arguments) const { return vesica_##name##_f32(arguments...); }  \
  };                                                                                               \
  inline constexpr Name_##name name;
VESICA_BOTH_SCALARS(check)
VESICA_BOTH_SCALARS(overlap)
VESICA_BOTH_SCALARS(interiors_overlap)
VESICA_BOTH_SCALARS(relation)
VESICA_BOTH_SCALARS(contains)
VESICA_BOTH_SCALARS(crossings)
VESICA_BOTH_SCALARS(nearest)
VESICA_BOTH_SCALARS(boundary_distance)
VESICA_BOTH_SCALARS(depth)
VESICA_BOTH_SCALARS(area)
VESICA_BOTH_SCALARS(iou)
VESICA_BOTH_SCALARS(shape_area)
VESICA_BOTH_SCALARS(bounds)
VESICA_BOTH_SCALARS(aabb_from_corners)
VESICA_BOTH_SCALARS(rect_from_angle)
VESICA_BOTH_SCALARS(rect_from_corners)
VESICA_BOTH_SCALARS(rect_corners_misfit)
VESICA_BOTH_SCALARS(round_rect_from_angle)
VESICA_BOTH_SCALARS(capsule_from_angle)
VESICA_BOTH_SCALARS(capsule_from_width)
VESICA_BOTH_SCALARS(ellipse_from_angle)
VESICA_BOTH_SCALARS(ellipse_from_radius_vector)
VESICA_BOTH_SCALARS(ellipse_from_covariance)
VESICA_BOTH_SCALARS(ellipse_from_matrix)
VESICA_BOTH_SCALARS(shapes_from_records)
VESICA_BOTH_SCALARS(overlap_many)
VESICA_BOTH_SCALARS(interiors_overlap_many)
VESICA_BOTH_SCALARS(relation_many)
VESICA_BOTH_SCALARS(contains_many)
VESICA_BOTH_SCALARS(nearest_many)
VESICA_BOTH_SCALARS(boundary_distance_many)
VESICA_BOTH_SCALARS(depth_many)
VESICA_BOTH_SCALARS(area_many)
VESICA_BOTH_SCALARS(iou_many)
VESICA_BOTH_SCALARS(overlap_matrix)
VESICA_BOTH_SCALARS(interiors_overlap_matrix)
VESICA_BOTH_SCALARS(relation_matrix)
VESICA_BOTH_SCALARS(contains_matrix)
VESICA_BOTH_SCALARS(area_matrix)
VESICA_BOTH_SCALARS(iou_matrix)
VESICA_BOTH_SCALARS(overlap_select)
VESICA_BOTH_SCALARS(interiors_overlap_select)
VESICA_BOTH_SCALARS(nms)
VESICA_BOTH_SCALARS(index_build)
VESICA_BOTH_SCALARS(index_select)
VESICA_BOTH_SCALARS(index_nearest)
VESICA_BOTH_SCALARS(join)
VESICA_BOTH_SCALARS(join_nearest)
VESICA_BOTH_SCALARS(ratio)
VESICA_BOTH_SCALARS(ratio_many)
VESICA_BOTH_SCALARS(ratio_matrix)
VESICA_BOTH_SCALARS(nearest_matrix)
VESICA_BOTH_SCALARS(boundary_distance_matrix)
VESICA_BOTH_SCALARS(depth_matrix)
VESICA_BOTH_SCALARS(suppress)
VESICA_BOTH_SCALARS(rects_from_boxes)
VESICA_BOTH_SCALARS(ellipses_from_boxes)
VESICA_BOTH_SCALARS(boxes_from_shapes)
VESICA_BOTH_SCALARS(corners_of_shapes)
VESICA_BOTH_SCALARS(bounds_many)
VESICA_BOTH_SCALARS(cast)
VESICA_BOTH_SCALARS(cast_many)
VESICA_BOTH_SCALARS(cast_first)
VESICA_BOTH_SCALARS(sweep_bounds)
VESICA_BOTH_SCALARS(index_cast)
VESICA_BOTH_SCALARS(index_cast_first)
VESICA_BOTH_SCALARS(impact_time)
VESICA_BOTH_SCALARS(within)
VESICA_BOTH_SCALARS(within_many)
VESICA_BOTH_SCALARS(within_matrix)
VESICA_BOTH_SCALARS(join_within)
VESICA_BOTH_SCALARS(signed_distance)
VESICA_BOTH_SCALARS(signed_distance_many)
VESICA_BOTH_SCALARS(signed_distance_matrix)
VESICA_BOTH_SCALARS(de9im)
VESICA_BOTH_SCALARS(intersection)
VESICA_BOTH_SCALARS(suppress_soft)
#undef VESICA_BOTH_SCALARS
}  // namespace call

template <class T>
struct Structs;
#define VESICA_STRUCTS(scalar, suffix)                    \
  template <>                                             \
  struct Structs<scalar> {                                \
    using Point = vesica_point_##suffix;                  \
    using Aabb = vesica_aabb_##suffix;                    \
    using Rect = vesica_rect_##suffix;                    \
    using Ellipse = vesica_ellipse_##suffix;              \
    using Capsule = vesica_capsule_##suffix;              \
    using RoundRect = vesica_round_rect_##suffix;         \
    using ClosestPoints = vesica_closest_points_##suffix; \
    using Penetration = vesica_penetration_##suffix;      \
    using Impact = vesica_impact_##suffix;                \
    using Turn = vesica_turn_##suffix;                    \
    using Shapes = vesica_shapes_##suffix;                \
  };
VESICA_STRUCTS(double, f64)
VESICA_STRUCTS(float, f32)
#undef VESICA_STRUCTS

/// Shapes of one kind, shape after shape.
template <class T>
struct Array {
  int kind;
  std::vector<T> numbers;

  [[nodiscard]] const T* data() const { return numbers.data(); }
  [[nodiscard]] std::size_t fields() const { return static_cast<std::size_t>(vesica_field_count(kind)); }
  [[nodiscard]] std::size_t count() const { return numbers.size() / fields(); }
  [[nodiscard]] typename Structs<T>::Shapes view() const {
    typename Structs<T>::Shapes view{};
    call::shapes_from_records(T{}, kind, static_cast<std::int64_t>(count()), static_cast<const void*>(data()),
                              static_cast<std::ptrdiff_t>(fields() * sizeof(T)), &view);
    return view;
  }
};

/// A shape of each kind, moved by (dx, dy).
template <class T>
Array<T> sample(int kind, double dx, double dy) {
  static constexpr std::array<std::array<double, 6>, 6> samples{{{0.25, 0.5},
                                                                 {-1.5, -0.75, 1.5, 0.75},
                                                                 {0, 0, 1.3},
                                                                 {-1.75, -0.5, 1.75, 0.625},
                                                                 {0, 0, 0.8, 0.6, 2.1, 1.1},
                                                                 {0, 0, -0.6, 0.8, 1.7, 0.4}}};
  Array<T> shape{kind, {}};
  const auto& numbers = samples[static_cast<std::size_t>(kind)];
  for (std::size_t i = 0; i < shape.fields(); ++i) {
    const bool is_place = i < 2 || kind == VESICA_SEGMENT || kind == VESICA_AABB;
    const double move = !is_place ? 0 : i % 2 == 0 ? dx : dy;
    shape.numbers.push_back(static_cast<T>(numbers[i] + move));
  }
  return shape;
}

/// Some shapes of a kind, further apart from one to the next.
template <class T>
Array<T> series(int kind, int count) {
  Array<T> shapes{kind, {}};
  for (int i = 0; i < count; ++i) {
    const auto shape = sample<T>(kind, 0.375 * i * i, 0.25 * (i % 3));
    shapes.numbers.insert(shapes.numbers.end(), shape.numbers.begin(), shape.numbers.end());
  }
  return shapes;
}

/// The same with the second shape no longer a number.
template <class T>
Array<T> with_invalid(Array<T> shapes) {
  shapes.numbers[shapes.fields()] = std::numeric_limits<T>::quiet_NaN();
  return shapes;
}

/// A shape of each kind that breaks a rule.
template <class T>
Array<T> invalid(int kind) {
  Array<T> shape = sample<T>(kind, 0, 0);
  switch (kind) {
    case VESICA_POINT:
      shape.numbers[1] = std::numeric_limits<T>::infinity();
      break;
    case VESICA_SEGMENT:
      shape.numbers[3] = std::numeric_limits<T>::quiet_NaN();
      break;
    case VESICA_CIRCLE:
      shape.numbers[2] = -1;
      break;
    case VESICA_AABB:
      shape.numbers[2] = -8;
      break;
    case VESICA_RECT:
      shape.numbers[2] = shape.numbers[3] = 0;
      break;
    default:
      shape.numbers[5] = T(-0.5);
      break;
  }
  return shape;
}

/// Memory as an index wants it.
class Lines {
 public:
  explicit Lines(std::int64_t size) : lines_(static_cast<std::size_t>(size) / 64 + 1) {}
  [[nodiscard]] void* data() { return lines_.data(); }
  [[nodiscard]] const void* data() const { return lines_.data(); }
  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(lines_.size()) * 64; }

 private:
  struct alignas(64) Line {
    unsigned char bytes[64];
  };
  std::vector<Line> lines_;
};

/// An index and the sets it is of.
template <class T>
struct Built {
  std::vector<Array<T>> sets;
  std::vector<typename Structs<T>::Shapes> views;
  std::size_t count = 0;
  Lines index{0};

  explicit Built(std::vector<Array<T>> of) : sets(std::move(of)) {
    for (const auto& set : sets) views.push_back(set.view()), count += set.count();
    const auto items = static_cast<std::int64_t>(count);
    index = Lines(vesica_index_size(items));
    Lines scratch(vesica_index_scratch(items));
    call::index_build(T{}, views.data(), set_count(), index.data(), index.size(), scratch.data(), scratch.size());
  }
  [[nodiscard]] std::int32_t set_count() const { return static_cast<std::int32_t>(views.size()); }
};
