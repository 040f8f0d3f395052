// SPDX-License-Identifier: Apache-2.0
// Convex hulls of points, and the smallest rectangles about them.
#include <limits>
#include <vesica/polygon/smallest_rect.hpp>

#include "arrays.hpp"
#include "environment.hpp"
#include "polygon/arrays.hpp"
#include "vesica_boxes.h"

namespace {

using vesica::LeastRect;

/// Invalid points are one error to callers. Any other result stays.
template <class Result>
Result with_points_error(Result result) noexcept {
  return result == vesica::error_rings || result == vesica::error_not_finite ? Result{VESICA_E_SHAPE} : result;
}

template <class T, class CPolygon, class CPoint>
int64_t convex_hull(const CPolygon* points, CPoint* out, int64_t capacity) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((convex_hull<T, CPolygon, CPoint>), points, out, capacity);
  static_assert(sizeof(vesica::Polygon<T>) == sizeof *points && sizeof(vesica::Point<T>) == sizeof *out);
  if (points == nullptr || out == nullptr) return VESICA_E_NULL;
  return with_points_error(vesica::convex_hull_or_error(vesica::load<vesica::Polygon<T>>(points),
                                                        reinterpret_cast<vesica::Point<T>*>(out), capacity));
}

template <class T, class CPolygon, class CRect>
int32_t smallest_rect(const CPolygon* points, LeastRect least, CRect* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((smallest_rect<T, CPolygon, CRect>), points, least, out);
  static_assert(sizeof(vesica::Polygon<T>) == sizeof *points && sizeof(vesica::Rect<T>) == sizeof *out);
  if (points == nullptr || out == nullptr) return VESICA_E_NULL;
  vesica::Rect<T> rect;
  const int error = vesica::smallest_rect(vesica::load<vesica::Polygon<T>>(points), least, rect);
  if (error == 0) std::memcpy(out, &rect, sizeof *out);
  return with_points_error(error);
}

template <class T, class CRect>
int64_t smallest_rect_many(const vesica::capi::CShapesOf<T>* points, LeastRect least, CRect* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((smallest_rect_many<T, CRect>), points, least, out);
  const int32_t error =
      vesica::capi::check_call(points, points, out, points != nullptr && points->count != 0, vesica::has_vertices);
  if (error != 0) return error;
  const auto view = vesica::capi::view<T>(*points);
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  int64_t result = 0;
  for (int64_t i = 0; i < view.count; ++i) {
    const vesica::batch::Element<T> element(view, i);
    CRect rect{nan, nan, nan, nan, nan, nan};
    const int32_t code =
        smallest_rect<T>(static_cast<const vesica::Polygon<T>*>(element.operand().shape), least, &rect);
    if (code != 0 && result != VESICA_E_SHAPE) result = code == VESICA_E_RANGE ? VESICA_E_RANGE : VESICA_E_SHAPE;
    out[i] = rect;
  }
  return result;
}

}  // namespace

#define VESICA_HULLS(scalar, T)                                                                                      \
  int64_t vesica_convex_hull_##scalar(const vesica_polygon_##scalar* points, vesica_point_##scalar* out,             \
                                      int64_t capacity) {                                                            \
    return convex_hull<T>(points, out, capacity);                                                                    \
  }                                                                                                                  \
  int32_t vesica_min_area_rect_##scalar(const vesica_polygon_##scalar* points, vesica_rect_##scalar* out) {          \
    return smallest_rect<T>(points, LeastRect::area, out);                                                           \
  }                                                                                                                  \
  int32_t vesica_min_perimeter_rect_##scalar(const vesica_polygon_##scalar* points, vesica_rect_##scalar* out) {     \
    return smallest_rect<T>(points, LeastRect::perimeter, out);                                                      \
  }                                                                                                                  \
  int64_t vesica_min_area_rect_many_##scalar(const vesica_shapes_##scalar* points, vesica_rect_##scalar* out) {      \
    return smallest_rect_many<T>(points, LeastRect::area, out);                                                      \
  }                                                                                                                  \
  int64_t vesica_min_perimeter_rect_many_##scalar(const vesica_shapes_##scalar* points, vesica_rect_##scalar* out) { \
    return smallest_rect_many<T>(points, LeastRect::perimeter, out);                                                 \
  }

VESICA_HULLS(f64, double)
VESICA_HULLS(f32, float)
