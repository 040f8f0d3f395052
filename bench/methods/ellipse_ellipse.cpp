// SPDX-License-Identifier: Apache-2.0
#include "methods/method.hpp"

namespace vesica::bench::methods {

template <>
struct FormOf<vesica_radius_vector_ellipse_f64> {
  static constexpr std::int32_t kind = VESICA_ELLIPSE;
  static vesica_radius_vector_ellipse_f64 make(const Numbers& n) {
    return {n[0], n[1], n[4] * n[2], n[4] * n[3], n[5] / n[4]};
  }
};

namespace {

template <std::int32_t n>
std::int32_t parallel_axes(const vesica_ellipse_f64* a, const vesica_ellipse_f64* b) {
  vesica_approximation_f64 reached;
  return vesica_method_ellipse_ellipse_parallel_axes_f64(a, b, n, &reached);
}

template <std::int32_t n>
std::int32_t any_axes(const vesica_ellipse_f64* a, const vesica_ellipse_f64* b) {
  vesica_approximation_f64 reached;
  return vesica_method_ellipse_ellipse_any_axes_f64(a, b, n, &reached);
}

template <std::int32_t n>
std::int32_t radius_vectors(const vesica_radius_vector_ellipse_f64* a, const vesica_radius_vector_ellipse_f64* b) {
  vesica_approximation_f64 reached;
  return vesica_method_radius_vector_ellipses_any_axes_f64(a, b, n, &reached);
}

vesica_ellipse_f64 ellipse_of(const vesica_radius_vector_ellipse_f64& r) {
  vesica_ellipse_f64 ellipse{};
  vesica_ellipse_from_radius_vector_f64(r.cx, r.cy, r.wx, r.wy, r.ratio, &ellipse);
  return ellipse;
}

std::int32_t exact_of_radius_vectors(const vesica_radius_vector_ellipse_f64* a,
                                     const vesica_radius_vector_ellipse_f64* b) {
  const vesica_ellipse_f64 first = ellipse_of(*a), second = ellipse_of(*b);
  return vesica_overlap_ellipse_ellipse_f64(&first, &second);
}

}  // namespace

void add_ellipse_ellipse(std::vector<Method>& methods) {
  constexpr auto exact = vesica_overlap_ellipse_ellipse_f64;
  add<any_axes<3>, exact>(methods, "ellipse_ellipse_any_axes, n = 3");
  add<any_axes<10>, exact>(methods, "ellipse_ellipse_any_axes, n = 10");
  add<any_axes<20>, exact>(methods, "ellipse_ellipse_any_axes, n = 20");
  add<radius_vectors<10>, exact_of_radius_vectors>(methods, "radius_vector_ellipses_any_axes, n = 10");
  add<parallel_axes<3>, exact>(methods, "ellipse_ellipse_parallel_axes, n = 3", Axes::parallel);
  add<parallel_axes<10>, exact>(methods, "ellipse_ellipse_parallel_axes, n = 10", Axes::parallel);
  add<parallel_axes<20>, exact>(methods, "ellipse_ellipse_parallel_axes, n = 20", Axes::parallel);
}

}  // namespace vesica::bench::methods
