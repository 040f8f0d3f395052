// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <vesica/methods/aabb_intervals.hpp>
#include <vesica/methods/point_rect_frame.hpp>
#include <vesica/methods/rect_corners.hpp>
#include <vesica/methods/rect_rect_bounds.hpp>
#include <vesica/methods/rect_rect_sample_points.hpp>
#include <vesica/methods/rect_rect_separating_lines.hpp>

#include "methods.hpp"

static_assert(vesica::methods::most_sample_points == VESICA_MOST_SAMPLE_POINTS);
static_assert(sizeof(vesica::methods::TurnedRect<double>) == sizeof(vesica_turned_rect_f64));
static_assert(sizeof(vesica::methods::TurnedRect<float>) == sizeof(vesica_turned_rect_f32));

namespace {

template <class T>
int32_t corners(const void* rect, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(corners<T>, rect, out);
  if (rect == nullptr || out == nullptr) return VESICA_E_NULL;
  T result[8];
  const int32_t error = vesica::methods::rect_corners(vesica::shape_at<vesica::Rect<T>>(rect), result);
  if (error == 0) std::memcpy(out, result, sizeof result);
  return error;
}

template <class T>
int32_t sample_points(const void* a, const void* b, int32_t k) noexcept {
  using Rect = vesica::Rect<T>;
  VESICA_DEFAULT_ENVIRONMENT(sample_points<T>, a, b, k);
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  return vesica::methods::sample_points(vesica::shape_at<Rect>(a), vesica::shape_at<Rect>(b), k);
}

}  // namespace

#define VESICA_METHODS(scalar, T)                                                                                      \
  VESICA_METHOD(rect_rect_bounds_##scalar, bounds, vesica_rect_##scalar, vesica::Rect<T>, vesica_rect_##scalar,        \
                vesica::Rect<T>)                                                                                       \
  VESICA_METHOD(rect_rect_separating_lines_##scalar, separating_lines, vesica_rect_##scalar, vesica::Rect<T>,          \
                vesica_rect_##scalar, vesica::Rect<T>)                                                                 \
  VESICA_METHOD(turned_rects_separating_lines_##scalar, separating_lines, vesica_turned_rect_##scalar,                 \
                vesica::methods::TurnedRect<T>, vesica_turned_rect_##scalar, vesica::methods::TurnedRect<T>)           \
  VESICA_METHOD(point_rect_frame_##scalar, point_in_rect, vesica_point_##scalar, vesica::Point<T>,                     \
                vesica_rect_##scalar, vesica::Rect<T>)                                                                 \
  VESICA_METHOD(point_aabb_intervals_##scalar, point_in_aabb, vesica_point_##scalar, vesica::Point<T>,                 \
                vesica_aabb_##scalar, vesica::Aabb<T>)                                                                 \
  VESICA_METHOD(aabb_aabb_intervals_##scalar, aabbs_meet, vesica_aabb_##scalar, vesica::Aabb<T>, vesica_aabb_##scalar, \
                vesica::Aabb<T>)                                                                                       \
  int32_t vesica_method_rect_corners_##scalar(const vesica_rect_##scalar* rect, T out[8]) {                            \
    return corners<T>(rect, out);                                                                                      \
  }                                                                                                                    \
  int32_t vesica_method_rect_rect_sample_points_##scalar(const vesica_rect_##scalar* a, const vesica_rect_##scalar* b, \
                                                         int32_t k) {                                                  \
    return sample_points<T>(a, b, k);                                                                                  \
  }

VESICA_METHODS(f64, double)
VESICA_METHODS(f32, float)
#undef VESICA_METHODS
