// SPDX-License-Identifier: Apache-2.0
#include "methods/method.hpp"

namespace vesica::bench::methods {
namespace {

template <std::int32_t n>
std::int32_t polygonal_sandwich(const vesica_circle_f64* circle, const vesica_ellipse_f64* ellipse) {
  vesica_approximation_f64 reached;
  return vesica_method_circle_ellipse_polygonal_sandwich_f64(circle, ellipse, n, &reached);
}

template <std::int32_t n>
std::int32_t circle_approximation(const vesica_circle_f64* circle, const vesica_ellipse_f64* ellipse) {
  vesica_approximation_f64 reached;
  return vesica_method_circle_ellipse_circle_approximation_f64(circle, ellipse, n, &reached);
}

}  // namespace

void add_circle_ellipse(std::vector<Method>& methods) {
  constexpr auto exact = vesica_overlap_circle_ellipse_f64;
  add<vesica_method_circle_ellipse_closed_form_f64, exact>(methods, "circle_ellipse_closed_form");
  add<polygonal_sandwich<3>, exact>(methods, "circle_ellipse_polygonal_sandwich, n = 3");
  add<polygonal_sandwich<10>, exact>(methods, "circle_ellipse_polygonal_sandwich, n = 10");
  add<polygonal_sandwich<20>, exact>(methods, "circle_ellipse_polygonal_sandwich, n = 20");
  add<circle_approximation<3>, exact>(methods, "circle_ellipse_circle_approximation, n = 3");
  add<circle_approximation<10>, exact>(methods, "circle_ellipse_circle_approximation, n = 10");
}

}  // namespace vesica::bench::methods
