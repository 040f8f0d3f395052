// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <vesica/bounds.hpp>
#include <vesica/construct.hpp>
#include <vesica/polygon/bounds.hpp>

#include "by_kind.hpp"
#include "environment.hpp"
#include "vesica.h"

namespace {

/// Calls make(result), a constructor of the core, and copies the result to the caller if it succeeds.
template <class Shape, class CShape, class Make>
int32_t construct(CShape* out, Make make) noexcept {
  static_assert(sizeof(Shape) == sizeof(CShape));
  if (out == nullptr) return VESICA_E_NULL;
  Shape result;
  const int error = make(result);
  if (error == 0) std::memcpy(out, &result, sizeof result);
  return error;
}

template <class T, class CShape>
int32_t bounds(int32_t kind, const void* shape, CShape* out) noexcept {
  if (out == nullptr) return VESICA_E_NULL;
  return construct<vesica::Aabb<T>>(out, [&](auto& box) {
    return vesica::with_shape<T>(kind, shape, [&](const vesica::CoreOrPath auto& s) { return vesica::bounds(s, box); });
  });
}

template <class T, class CShape>
int32_t rect_from_corners(const T* corners, CShape* out) noexcept {
  if (corners == nullptr) return VESICA_E_NULL;
  T aligned[8];
  std::memcpy(aligned, corners, sizeof aligned);
  return construct<vesica::Rect<T>>(out, [&](auto& rect) { return vesica::rect_from_corners(aligned, rect); });
}

template <class T, class CShape>
int32_t rect_corners_misfit(const T* corners, const CShape* r, T* misfit) noexcept {
  static_assert(sizeof(vesica::Rect<T>) == sizeof *r);
  if (corners == nullptr || r == nullptr) return VESICA_E_NULL;
  T aligned[8];
  std::memcpy(aligned, corners, sizeof aligned);
  vesica::Rect<T> rect;
  std::memcpy(&rect, r, sizeof rect);
  return construct<T>(misfit, [&](T& result) { return vesica::rect_corners_misfit(aligned, rect, result); });
}

}  // namespace

// X(suffix, T): the functions of one scalar type.
#define VESICA_CONSTRUCTORS(suffix, T)                                                                                 \
  int32_t vesica_bounds_##suffix(int32_t kind, const void* shape, vesica_aabb_##suffix* out) {                         \
    VESICA_DEFAULT_ENVIRONMENT(vesica_bounds_##suffix, kind, shape, out);                                              \
    return bounds<T>(kind, shape, out);                                                                                \
  }                                                                                                                    \
  int32_t vesica_aabb_from_corners_##suffix(T x0, T y0, T x1, T y1, vesica_aabb_##suffix* out) {                       \
    VESICA_DEFAULT_ENVIRONMENT(vesica_aabb_from_corners_##suffix, x0, y0, x1, y1, out);                                \
    return construct<vesica::Aabb<T>>(out, [=](auto& s) { return vesica::aabb_from_corners(x0, y0, x1, y1, s); });     \
  }                                                                                                                    \
  int32_t vesica_rect_from_angle_##suffix(T cx, T cy, T angle, T width, T height, vesica_rect_##suffix* out) {         \
    VESICA_DEFAULT_ENVIRONMENT(vesica_rect_from_angle_##suffix, cx, cy, angle, width, height, out);                    \
    return construct<vesica::Rect<T>>(                                                                                 \
        out, [=](auto& s) { return vesica::rect_from_angle(cx, cy, angle, width, height, s); });                       \
  }                                                                                                                    \
  int32_t vesica_rect_from_corners_##suffix(const T corners[8], vesica_rect_##suffix* out) {                           \
    VESICA_DEFAULT_ENVIRONMENT(vesica_rect_from_corners_##suffix, corners, out);                                       \
    return rect_from_corners(corners, out);                                                                            \
  }                                                                                                                    \
  int32_t vesica_rect_corners_misfit_##suffix(const T corners[8], const vesica_rect_##suffix* r, T* misfit) {          \
    VESICA_DEFAULT_ENVIRONMENT(vesica_rect_corners_misfit_##suffix, corners, r, misfit);                               \
    return rect_corners_misfit(corners, r, misfit);                                                                    \
  }                                                                                                                    \
  int32_t vesica_round_rect_from_angle_##suffix(T cx, T cy, T angle, T width, T height, T radius,                      \
                                                vesica_round_rect_##suffix* out) {                                     \
    VESICA_DEFAULT_ENVIRONMENT(vesica_round_rect_from_angle_##suffix, cx, cy, angle, width, height, radius, out);      \
    return construct<vesica::RoundRect<T>>(                                                                            \
        out, [=](auto& s) { return vesica::round_rect_from_angle(cx, cy, angle, width, height, radius, s); });         \
  }                                                                                                                    \
  int32_t vesica_capsule_from_angle_##suffix(T cx, T cy, T angle, T length, T radius, vesica_capsule_##suffix* out) {  \
    VESICA_DEFAULT_ENVIRONMENT(vesica_capsule_from_angle_##suffix, cx, cy, angle, length, radius, out);                \
    return construct<vesica::Capsule<T>>(                                                                              \
        out, [=](auto& s) { return vesica::capsule_from_angle(cx, cy, angle, length, radius, s); });                   \
  }                                                                                                                    \
  int32_t vesica_capsule_from_width_##suffix(T x0, T y0, T x1, T y1, T width, vesica_capsule_##suffix* out) {          \
    VESICA_DEFAULT_ENVIRONMENT(vesica_capsule_from_width_##suffix, x0, y0, x1, y1, width, out);                        \
    return construct<vesica::Capsule<T>>(                                                                              \
        out, [=](auto& s) { return vesica::capsule_from_width(x0, y0, x1, y1, width, s); });                           \
  }                                                                                                                    \
  int32_t vesica_ellipse_from_angle_##suffix(T cx, T cy, T angle, T a, T b, vesica_ellipse_##suffix* out) {            \
    VESICA_DEFAULT_ENVIRONMENT(vesica_ellipse_from_angle_##suffix, cx, cy, angle, a, b, out);                          \
    return construct<vesica::Ellipse<T>>(out,                                                                          \
                                         [=](auto& s) { return vesica::ellipse_from_angle(cx, cy, angle, a, b, s); }); \
  }                                                                                                                    \
  int32_t vesica_ellipse_from_radius_vector_##suffix(T cx, T cy, T wx, T wy, T ratio, vesica_ellipse_##suffix* out) {  \
    VESICA_DEFAULT_ENVIRONMENT(vesica_ellipse_from_radius_vector_##suffix, cx, cy, wx, wy, ratio, out);                \
    return construct<vesica::Ellipse<T>>(                                                                              \
        out, [=](auto& s) { return vesica::ellipse_from_radius_vector(cx, cy, wx, wy, ratio, s); });                   \
  }                                                                                                                    \
  int32_t vesica_ellipse_from_covariance_##suffix(T mean_x, T mean_y, T cxx, T cxy, T cyy, T k,                        \
                                                  vesica_ellipse_##suffix* out) {                                      \
    VESICA_DEFAULT_ENVIRONMENT(vesica_ellipse_from_covariance_##suffix, mean_x, mean_y, cxx, cxy, cyy, k, out);        \
    return construct<vesica::Ellipse<T>>(                                                                              \
        out, [=](auto& s) { return vesica::ellipse_from_covariance(mean_x, mean_y, cxx, cxy, cyy, k, s); });           \
  }                                                                                                                    \
  int32_t vesica_ellipse_from_matrix_##suffix(T cx, T cy, T mxx, T mxy, T myy, vesica_ellipse_##suffix* out) {         \
    VESICA_DEFAULT_ENVIRONMENT(vesica_ellipse_from_matrix_##suffix, cx, cy, mxx, mxy, myy, out);                       \
    return construct<vesica::Ellipse<T>>(                                                                              \
        out, [=](auto& s) { return vesica::ellipse_from_matrix(cx, cy, mxx, mxy, myy, s); });                          \
  }

VESICA_CONSTRUCTORS(f64, double)
VESICA_CONSTRUCTORS(f32, float)
#undef VESICA_CONSTRUCTORS
