// SPDX-License-Identifier: Apache-2.0
/// Bounds and constructors of the C interface by scalar type, so that one test body can serve both.
#pragma once

#include <vesica.h>

namespace capi {

struct F64 {
  using Scalar = double;
  using Aabb = vesica_aabb_f64;
  using Rect = vesica_rect_f64;
  using Ellipse = vesica_ellipse_f64;
  using Capsule = vesica_capsule_f64;
  using RoundRect = vesica_round_rect_f64;
  static constexpr auto* bounds = vesica_bounds_f64;
  static constexpr auto* check = vesica_check_f64;
  static constexpr auto* aabb_from_corners = vesica_aabb_from_corners_f64;
  static constexpr auto* rect_from_angle = vesica_rect_from_angle_f64;
  static constexpr auto* rect_from_corners = vesica_rect_from_corners_f64;
  static constexpr auto* rect_corners_misfit = vesica_rect_corners_misfit_f64;
  static constexpr auto* round_rect_from_angle = vesica_round_rect_from_angle_f64;
  static constexpr auto* capsule_from_angle = vesica_capsule_from_angle_f64;
  static constexpr auto* capsule_from_width = vesica_capsule_from_width_f64;
  static constexpr auto* ellipse_from_angle = vesica_ellipse_from_angle_f64;
  static constexpr auto* ellipse_from_radius_vector = vesica_ellipse_from_radius_vector_f64;
  static constexpr auto* ellipse_from_covariance = vesica_ellipse_from_covariance_f64;
  static constexpr auto* ellipse_from_matrix = vesica_ellipse_from_matrix_f64;
};

struct F32 {
  using Scalar = float;
  using Aabb = vesica_aabb_f32;
  using Rect = vesica_rect_f32;
  using Ellipse = vesica_ellipse_f32;
  using Capsule = vesica_capsule_f32;
  using RoundRect = vesica_round_rect_f32;
  static constexpr auto* bounds = vesica_bounds_f32;
  static constexpr auto* check = vesica_check_f32;
  static constexpr auto* aabb_from_corners = vesica_aabb_from_corners_f32;
  static constexpr auto* rect_from_angle = vesica_rect_from_angle_f32;
  static constexpr auto* rect_from_corners = vesica_rect_from_corners_f32;
  static constexpr auto* rect_corners_misfit = vesica_rect_corners_misfit_f32;
  static constexpr auto* round_rect_from_angle = vesica_round_rect_from_angle_f32;
  static constexpr auto* capsule_from_angle = vesica_capsule_from_angle_f32;
  static constexpr auto* capsule_from_width = vesica_capsule_from_width_f32;
  static constexpr auto* ellipse_from_angle = vesica_ellipse_from_angle_f32;
  static constexpr auto* ellipse_from_radius_vector = vesica_ellipse_from_radius_vector_f32;
  static constexpr auto* ellipse_from_covariance = vesica_ellipse_from_covariance_f32;
  static constexpr auto* ellipse_from_matrix = vesica_ellipse_from_matrix_f32;
};

}  // namespace capi
