// SPDX-License-Identifier: Apache-2.0
/// The structs and functions of vesica.h and the headers it includes by scalar type.
#pragma once

#include <vesica.h>

#include <cstdint>
#include <type_traits>

namespace capi_tests {

/// The output of vesica_crossings, for kinds whose outlines meet in at most 12 places; unused places are 0.
template <class T>
struct Crossings {
  std::int32_t count, shared;
  T x[12], y[12];
};

/// Calls vesica_crossings with room for all places. Writes nothing on error.
template <class T>
std::int32_t crossings(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b, Crossings<T>* out) {
  using Point = std::conditional_t<std::is_same_v<T, double>, vesica_point_f64, vesica_point_f32>;
  Point at[12];
  std::int32_t shared = 0;
  Point* const to = out == nullptr ? nullptr : at;
  std::int64_t count;
  if constexpr (std::is_same_v<T, double>) {
    count = vesica_crossings_f64(kind_a, a, kind_b, b, to, 12, &shared);
  } else {
    count = vesica_crossings_f32(kind_a, a, kind_b, b, to, 12, &shared);
  }
  if (count >= 0) {
    *out = {};
    out->count = static_cast<std::int32_t>(count);
    out->shared = shared;
    for (std::int64_t i = 0; i < count; ++i) out->x[i] = at[i].x, out->y[i] = at[i].y;
  }
  return static_cast<std::int32_t>(count);
}

/// Calls vesica_intersection with room for all vertices: x0 y0 x1 y1 ..., the rest of 16 numbers is 0. Writes nothing
/// on error.
template <class T>
std::int32_t intersection(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b, T* out) {
  using Point = std::conditional_t<std::is_same_v<T, double>, vesica_point_f64, vesica_point_f32>;
  Point at[8];
  Point* const to = out == nullptr ? nullptr : at;
  std::int64_t count;
  if constexpr (std::is_same_v<T, double>) {
    count = vesica_intersection_f64(kind_a, a, kind_b, b, to, 8);
  } else {
    count = vesica_intersection_f32(kind_a, a, kind_b, b, to, 8);
  }
  for (std::int64_t i = 0; count >= 0 && i < 8; ++i) {
    out[2 * i] = i < count ? at[i].x : 0;
    out[2 * i + 1] = i < count ? at[i].y : 0;
  }
  return static_cast<std::int32_t>(count);
}

template <class T>
struct Face;

template <>
struct Face<double> {
  using Points = vesica_closest_points_f64;
  using Penetration = vesica_penetration_f64;
  using Impact = vesica_impact_f64;
  using Turn = vesica_turn_f64;
  using Span = vesica_span_f64;
  using Crossings = capi_tests::Crossings<double>;
  using Point = vesica_point_f64;
  using Aabb = vesica_aabb_f64;
  using Rect = vesica_rect_f64;
  using Ellipse = vesica_ellipse_f64;
  using Shapes = vesica_shapes_f64;
  static constexpr auto check = vesica_check_f64;
  static constexpr auto overlap = vesica_overlap_f64;
  static constexpr auto interiors_overlap = vesica_interiors_overlap_f64;
  static constexpr auto relation = vesica_relation_f64;
  static constexpr auto contains = vesica_contains_f64;
  static constexpr auto nearest = vesica_nearest_f64;
  static constexpr auto boundary_distance = vesica_boundary_distance_f64;
  static constexpr auto depth = vesica_depth_f64;
  static constexpr auto area = vesica_area_f64;
  static constexpr auto iou = vesica_iou_f64;
  static constexpr auto crossings = capi_tests::crossings<double>;
  static constexpr auto crossings_in_room = vesica_crossings_f64;
  static constexpr auto shape_area = vesica_shape_area_f64;
  static constexpr auto bounds = vesica_bounds_f64;
  static constexpr auto from_records = vesica_shapes_from_records_f64;
  static constexpr auto bounds_many = vesica_bounds_many_f64;
  static constexpr auto shape_area_many = vesica_shape_area_many_f64;
  static constexpr auto rects_from_boxes = vesica_rects_from_boxes_f64;
  static constexpr auto ellipses_from_boxes = vesica_ellipses_from_boxes_f64;
  static constexpr auto rects_from_corners = vesica_rects_from_corners_f64;
  static constexpr auto rect_corners_misfit_many = vesica_rect_corners_misfit_many_f64;
  static constexpr auto boxes_from_shapes = vesica_boxes_from_shapes_f64;
  static constexpr auto corners_of_shapes = vesica_corners_of_shapes_f64;
  static constexpr auto overlap_many = vesica_overlap_many_f64;
  static constexpr auto interiors_overlap_many = vesica_interiors_overlap_many_f64;
  static constexpr auto overlap_matrix = vesica_overlap_matrix_f64;
  static constexpr auto interiors_overlap_matrix = vesica_interiors_overlap_matrix_f64;
  static constexpr auto overlap_select = vesica_overlap_select_f64;
  static constexpr auto interiors_overlap_select = vesica_interiors_overlap_select_f64;
  static constexpr auto relation_many = vesica_relation_many_f64;
  static constexpr auto relation_matrix = vesica_relation_matrix_f64;
  static constexpr auto contains_many = vesica_contains_many_f64;
  static constexpr auto contains_matrix = vesica_contains_matrix_f64;
  static constexpr auto nearest_many = vesica_nearest_many_f64;
  static constexpr auto boundary_distance_many = vesica_boundary_distance_many_f64;
  static constexpr auto depth_many = vesica_depth_many_f64;
  static constexpr auto area_many = vesica_area_many_f64;
  static constexpr auto area_matrix = vesica_area_matrix_f64;
  static constexpr auto iou_many = vesica_iou_many_f64;
  static constexpr auto iou_matrix = vesica_iou_matrix_f64;
  static constexpr auto ratio = vesica_ratio_f64;
  static constexpr auto ratio_many = vesica_ratio_many_f64;
  static constexpr auto ratio_matrix = vesica_ratio_matrix_f64;
  static constexpr auto gaussian_distance_many = vesica_gaussian_distance_many_f64;
  static constexpr auto gaussian_distance_matrix = vesica_gaussian_distance_matrix_f64;
  static constexpr auto volume_ratio_many = vesica_volume_ratio_many_f64;
  static constexpr auto volume_ratio_matrix = vesica_volume_ratio_matrix_f64;
  static constexpr auto nearest_matrix = vesica_nearest_matrix_f64;
  static constexpr auto boundary_distance_matrix = vesica_boundary_distance_matrix_f64;
  static constexpr auto depth_matrix = vesica_depth_matrix_f64;
  static constexpr auto signed_distance = vesica_signed_distance_f64;
  static constexpr auto signed_distance_many = vesica_signed_distance_many_f64;
  static constexpr auto signed_distance_matrix = vesica_signed_distance_matrix_f64;
  static constexpr auto de9im = vesica_de9im_f64;
  static constexpr auto intersection = capi_tests::intersection<double>;
  static constexpr auto intersection_in_room = vesica_intersection_f64;
  using Contacts = vesica_contacts_f64;
  static constexpr auto manifold = vesica_manifold_f64;
  static constexpr auto impact_time = vesica_impact_time_f64;
  static constexpr auto index_impact_time = vesica_index_impact_time_f64;
  static constexpr auto suppress_soft = vesica_suppress_soft_f64;
  static constexpr auto within = vesica_within_f64;
  static constexpr auto within_many = vesica_within_many_f64;
  static constexpr auto within_matrix = vesica_within_matrix_f64;
  static constexpr auto nms = vesica_nms_f64;
  static constexpr auto suppress = vesica_suppress_f64;
  static constexpr auto index_build = vesica_index_build_f64;
  static constexpr auto index_step = vesica_index_step_f64;
  static constexpr auto index_select = vesica_index_select_f64;
  static constexpr auto index_nearest = vesica_index_nearest_f64;
  static constexpr auto join = vesica_join_f64;
  static constexpr auto join_nearest = vesica_join_nearest_f64;
  static constexpr auto join_within = vesica_join_within_f64;
  static constexpr auto cast = vesica_cast_f64;
  static constexpr auto cast_many = vesica_cast_many_f64;
  static constexpr auto cast_first = vesica_cast_first_f64;
  static constexpr auto sweep_bounds = vesica_sweep_bounds_f64;
  static constexpr auto index_cast = vesica_index_cast_f64;
  static constexpr auto index_cast_first = vesica_index_cast_first_f64;
};

template <>
struct Face<float> {
  using Points = vesica_closest_points_f32;
  using Penetration = vesica_penetration_f32;
  using Impact = vesica_impact_f32;
  using Turn = vesica_turn_f32;
  using Span = vesica_span_f32;
  using Crossings = capi_tests::Crossings<float>;
  using Point = vesica_point_f32;
  using Aabb = vesica_aabb_f32;
  using Rect = vesica_rect_f32;
  using Ellipse = vesica_ellipse_f32;
  using Shapes = vesica_shapes_f32;
  static constexpr auto check = vesica_check_f32;
  static constexpr auto overlap = vesica_overlap_f32;
  static constexpr auto interiors_overlap = vesica_interiors_overlap_f32;
  static constexpr auto relation = vesica_relation_f32;
  static constexpr auto contains = vesica_contains_f32;
  static constexpr auto nearest = vesica_nearest_f32;
  static constexpr auto boundary_distance = vesica_boundary_distance_f32;
  static constexpr auto depth = vesica_depth_f32;
  static constexpr auto area = vesica_area_f32;
  static constexpr auto iou = vesica_iou_f32;
  static constexpr auto crossings = capi_tests::crossings<float>;
  static constexpr auto crossings_in_room = vesica_crossings_f32;
  static constexpr auto shape_area = vesica_shape_area_f32;
  static constexpr auto bounds = vesica_bounds_f32;
  static constexpr auto from_records = vesica_shapes_from_records_f32;
  static constexpr auto bounds_many = vesica_bounds_many_f32;
  static constexpr auto shape_area_many = vesica_shape_area_many_f32;
  static constexpr auto rects_from_boxes = vesica_rects_from_boxes_f32;
  static constexpr auto ellipses_from_boxes = vesica_ellipses_from_boxes_f32;
  static constexpr auto rects_from_corners = vesica_rects_from_corners_f32;
  static constexpr auto rect_corners_misfit_many = vesica_rect_corners_misfit_many_f32;
  static constexpr auto boxes_from_shapes = vesica_boxes_from_shapes_f32;
  static constexpr auto corners_of_shapes = vesica_corners_of_shapes_f32;
  static constexpr auto overlap_many = vesica_overlap_many_f32;
  static constexpr auto interiors_overlap_many = vesica_interiors_overlap_many_f32;
  static constexpr auto overlap_matrix = vesica_overlap_matrix_f32;
  static constexpr auto interiors_overlap_matrix = vesica_interiors_overlap_matrix_f32;
  static constexpr auto overlap_select = vesica_overlap_select_f32;
  static constexpr auto interiors_overlap_select = vesica_interiors_overlap_select_f32;
  static constexpr auto relation_many = vesica_relation_many_f32;
  static constexpr auto relation_matrix = vesica_relation_matrix_f32;
  static constexpr auto contains_many = vesica_contains_many_f32;
  static constexpr auto contains_matrix = vesica_contains_matrix_f32;
  static constexpr auto nearest_many = vesica_nearest_many_f32;
  static constexpr auto boundary_distance_many = vesica_boundary_distance_many_f32;
  static constexpr auto depth_many = vesica_depth_many_f32;
  static constexpr auto area_many = vesica_area_many_f32;
  static constexpr auto area_matrix = vesica_area_matrix_f32;
  static constexpr auto iou_many = vesica_iou_many_f32;
  static constexpr auto iou_matrix = vesica_iou_matrix_f32;
  static constexpr auto ratio = vesica_ratio_f32;
  static constexpr auto ratio_many = vesica_ratio_many_f32;
  static constexpr auto ratio_matrix = vesica_ratio_matrix_f32;
  static constexpr auto gaussian_distance_many = vesica_gaussian_distance_many_f32;
  static constexpr auto gaussian_distance_matrix = vesica_gaussian_distance_matrix_f32;
  static constexpr auto volume_ratio_many = vesica_volume_ratio_many_f32;
  static constexpr auto volume_ratio_matrix = vesica_volume_ratio_matrix_f32;
  static constexpr auto nearest_matrix = vesica_nearest_matrix_f32;
  static constexpr auto boundary_distance_matrix = vesica_boundary_distance_matrix_f32;
  static constexpr auto depth_matrix = vesica_depth_matrix_f32;
  static constexpr auto signed_distance = vesica_signed_distance_f32;
  static constexpr auto signed_distance_many = vesica_signed_distance_many_f32;
  static constexpr auto signed_distance_matrix = vesica_signed_distance_matrix_f32;
  static constexpr auto de9im = vesica_de9im_f32;
  static constexpr auto intersection = capi_tests::intersection<float>;
  static constexpr auto intersection_in_room = vesica_intersection_f32;
  using Contacts = vesica_contacts_f32;
  static constexpr auto manifold = vesica_manifold_f32;
  static constexpr auto impact_time = vesica_impact_time_f32;
  static constexpr auto index_impact_time = vesica_index_impact_time_f32;
  static constexpr auto suppress_soft = vesica_suppress_soft_f32;
  static constexpr auto within = vesica_within_f32;
  static constexpr auto within_many = vesica_within_many_f32;
  static constexpr auto within_matrix = vesica_within_matrix_f32;
  static constexpr auto nms = vesica_nms_f32;
  static constexpr auto suppress = vesica_suppress_f32;
  static constexpr auto index_build = vesica_index_build_f32;
  static constexpr auto index_step = vesica_index_step_f32;
  static constexpr auto index_select = vesica_index_select_f32;
  static constexpr auto index_nearest = vesica_index_nearest_f32;
  static constexpr auto join = vesica_join_f32;
  static constexpr auto join_nearest = vesica_join_nearest_f32;
  static constexpr auto join_within = vesica_join_within_f32;
  static constexpr auto cast = vesica_cast_f32;
  static constexpr auto cast_many = vesica_cast_many_f32;
  static constexpr auto cast_first = vesica_cast_first_f32;
  static constexpr auto sweep_bounds = vesica_sweep_bounds_f32;
  static constexpr auto index_cast = vesica_index_cast_f32;
  static constexpr auto index_cast_first = vesica_index_cast_first_f32;
};

}  // namespace capi_tests
