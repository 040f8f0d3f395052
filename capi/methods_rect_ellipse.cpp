// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <vesica/methods/rect_ellipse_all_features.hpp>
#include <vesica/methods/rect_ellipse_closest_features.hpp>
#include <vesica/methods/rect_ellipse_minkowski_sum.hpp>
#include <vesica/methods/rect_ellipse_point_parallelogram_distance.hpp>

#include "methods.hpp"

namespace {

template <class T, class COut>
int32_t distance(const void* rect, const void* ellipse, COut* out) noexcept {
  static_assert(sizeof(COut) == sizeof(vesica::methods::MetricClosest<T>));
  VESICA_DEFAULT_ENVIRONMENT((distance<T, COut>), rect, ellipse, out);
  if (rect == nullptr || ellipse == nullptr || out == nullptr) return VESICA_E_NULL;
  vesica::methods::MetricClosest<T> closest;
  const int32_t answer = point_parallelogram_distance(vesica::shape_at<vesica::Rect<T>>(rect),
                                                      vesica::shape_at<vesica::Ellipse<T>>(ellipse), closest);
  if (answer >= 0) std::memcpy(out, &closest, sizeof closest);
  return answer;
}

}  // namespace

#define VESICA_METHODS(scalar, T)                                                                                      \
  VESICA_METHOD(rect_ellipse_all_features_##scalar, all_features, vesica_rect_##scalar, vesica::Rect<T>,               \
                vesica_ellipse_##scalar, vesica::Ellipse<T>)                                                           \
  VESICA_METHOD(rect_ellipse_closest_features_##scalar, closest_features, vesica_rect_##scalar, vesica::Rect<T>,       \
                vesica_ellipse_##scalar, vesica::Ellipse<T>)                                                           \
  VESICA_METHOD(rect_ellipse_minkowski_sum_##scalar, minkowski_sum, vesica_rect_##scalar, vesica::Rect<T>,             \
                vesica_ellipse_##scalar, vesica::Ellipse<T>)                                                           \
  int32_t vesica_method_rect_ellipse_point_parallelogram_distance_##scalar(                                            \
      const vesica_rect_##scalar* rect, const vesica_ellipse_##scalar* ellipse, vesica_metric_closest_##scalar* out) { \
    return distance<T>(rect, ellipse, out);                                                                            \
  }

VESICA_METHODS(f64, double)
VESICA_METHODS(f32, float)
#undef VESICA_METHODS
