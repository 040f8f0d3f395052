// SPDX-License-Identifier: Apache-2.0
/// All 21 typed overlap functions of a scalar type, in the order of shapes.
#pragma once

#include <array>

#include "capi/typed.hpp"

namespace capi {

template <class T>
struct TypedPair {
  std::int32_t kind_a, kind_b;
  std::int32_t (*overlap)(const T*, const T*);
};

template <auto... function>
constexpr auto typed_pairs_of() {
  using T = std::common_type_t<typename Typed<function>::Scalar...>;
  return std::array<TypedPair<T>, sizeof...(function)>{
      TypedPair<T>{Typed<function>::kind_a, Typed<function>::kind_b, Typed<function>::call}...};
}

inline constexpr auto typed_pairs_f64 =
    typed_pairs_of<vesica_overlap_point_point_f64, vesica_overlap_point_segment_f64, vesica_overlap_point_circle_f64,
                   vesica_overlap_point_aabb_f64, vesica_overlap_point_rect_f64, vesica_overlap_point_ellipse_f64,
                   vesica_overlap_segment_segment_f64, vesica_overlap_segment_circle_f64,
                   vesica_overlap_segment_aabb_f64, vesica_overlap_segment_rect_f64, vesica_overlap_segment_ellipse_f64,
                   vesica_overlap_circle_circle_f64, vesica_overlap_circle_aabb_f64, vesica_overlap_circle_rect_f64,
                   vesica_overlap_circle_ellipse_f64, vesica_overlap_aabb_aabb_f64, vesica_overlap_aabb_rect_f64,
                   vesica_overlap_aabb_ellipse_f64, vesica_overlap_rect_rect_f64, vesica_overlap_rect_ellipse_f64,
                   vesica_overlap_ellipse_ellipse_f64>();

inline constexpr auto typed_pairs_f32 =
    typed_pairs_of<vesica_overlap_point_point_f32, vesica_overlap_point_segment_f32, vesica_overlap_point_circle_f32,
                   vesica_overlap_point_aabb_f32, vesica_overlap_point_rect_f32, vesica_overlap_point_ellipse_f32,
                   vesica_overlap_segment_segment_f32, vesica_overlap_segment_circle_f32,
                   vesica_overlap_segment_aabb_f32, vesica_overlap_segment_rect_f32, vesica_overlap_segment_ellipse_f32,
                   vesica_overlap_circle_circle_f32, vesica_overlap_circle_aabb_f32, vesica_overlap_circle_rect_f32,
                   vesica_overlap_circle_ellipse_f32, vesica_overlap_aabb_aabb_f32, vesica_overlap_aabb_rect_f32,
                   vesica_overlap_aabb_ellipse_f32, vesica_overlap_rect_rect_f32, vesica_overlap_rect_ellipse_f32,
                   vesica_overlap_ellipse_ellipse_f32>();

/// The functions of one scalar type under one name each.
template <class T>
struct Api;

template <>
struct Api<double> {
  using Box = vesica_aabb_f64;
  static constexpr auto check = vesica_check_f64;
  static constexpr auto overlap = vesica_overlap_f64;
  static constexpr auto bounds = vesica_bounds_f64;
  static constexpr const auto& typed_pairs = typed_pairs_f64;
};
template <>
struct Api<float> {
  using Box = vesica_aabb_f32;
  static constexpr auto check = vesica_check_f32;
  static constexpr auto overlap = vesica_overlap_f32;
  static constexpr auto bounds = vesica_bounds_f32;
  static constexpr const auto& typed_pairs = typed_pairs_f32;
};

}  // namespace capi
