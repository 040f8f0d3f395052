// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "methods/method.hpp"

namespace vesica::bench::methods {

template <>
struct FormOf<vesica_turned_rect_f64> {
  static constexpr std::int32_t kind = VESICA_RECT;
  static vesica_turned_rect_f64 make(const Numbers& n) {
    return {n[0], n[1], std::atan2(n[3], n[2]), 2 * n[4], 2 * n[5]};
  }
};

namespace {

template <std::int32_t k>
std::int32_t sample_points(const vesica_rect_f64* a, const vesica_rect_f64* b) {
  return vesica_method_rect_rect_sample_points_f64(a, b, k);
}

vesica_rect_f64 rect_of(const vesica_turned_rect_f64& t) {
  vesica_rect_f64 rect{};
  vesica_rect_from_angle_f64(t.cx, t.cy, t.angle, t.width, t.height, &rect);
  return rect;
}

std::int32_t exact_of_turned(const vesica_turned_rect_f64* a, const vesica_turned_rect_f64* b) {
  const vesica_rect_f64 first = rect_of(*a), second = rect_of(*b);
  return vesica_overlap_rect_rect_f64(&first, &second);
}

}  // namespace

void add_rect_rect(std::vector<Method>& methods) {
  constexpr auto exact = vesica_overlap_rect_rect_f64;
  add<vesica_method_rect_rect_bounds_f64, exact>(methods, "rect_rect_bounds");
  add<sample_points<0>, exact>(methods, "rect_rect_sample_points, k = 0");
  add<sample_points<3>, exact>(methods, "rect_rect_sample_points, k = 3");
  add<sample_points<20>, exact>(methods, "rect_rect_sample_points, k = 20");
  add<vesica_method_rect_rect_separating_lines_f64, exact>(methods, "rect_rect_separating_lines");
  add<vesica_method_turned_rects_separating_lines_f64, exact_of_turned>(methods, "turned_rects_separating_lines");
  add<vesica_method_point_rect_frame_f64, vesica_overlap_point_rect_f64>(methods, "point_rect_frame");
  add<vesica_method_point_aabb_intervals_f64, vesica_overlap_point_aabb_f64>(methods, "point_aabb_intervals");
  add<vesica_method_aabb_aabb_intervals_f64, vesica_overlap_aabb_aabb_f64>(methods, "aabb_aabb_intervals");
}

}  // namespace vesica::bench::methods
