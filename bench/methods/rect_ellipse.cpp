// SPDX-License-Identifier: Apache-2.0
#include "methods/method.hpp"

namespace vesica::bench::methods {
namespace {

std::int32_t point_parallelogram_distance(const vesica_rect_f64* rect, const vesica_ellipse_f64* ellipse) {
  vesica_metric_closest_f64 closest;
  return vesica_method_rect_ellipse_point_parallelogram_distance_f64(rect, ellipse, &closest);
}

constexpr auto exact = vesica_overlap_rect_ellipse_f64;

}  // namespace

void add_rect_ellipse(std::vector<Method>& methods) {
  add<vesica_method_rect_ellipse_all_features_f64, exact>(methods, "rect_ellipse_all_features");
  add<vesica_method_rect_ellipse_closest_features_f64, exact>(methods, "rect_ellipse_closest_features");
  add<point_parallelogram_distance, exact>(methods, "rect_ellipse_point_parallelogram_distance");
  add<vesica_method_rect_ellipse_minkowski_sum_f64, exact>(methods, "rect_ellipse_minkowski_sum");
}

}  // namespace vesica::bench::methods
