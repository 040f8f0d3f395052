/* SPDX-License-Identifier: Apache-2.0 */
/* vesica_methods.h before anything else, compiled as every C and C++ it promises to be. */
#include <vesica_methods.h>

typedef char metric_closest_f64_is_flat[sizeof(vesica_metric_closest_f64) == 3 * sizeof(double) ? 1 : -1];
typedef char turned_rect_f64_is_flat[sizeof(vesica_turned_rect_f64) == 5 * sizeof(double) ? 1 : -1];
typedef char radius_vector_ellipse_f64_is_flat[sizeof(vesica_radius_vector_ellipse_f64) == 5 * sizeof(double) ? 1 : -1];
typedef char metric_closest_f32_is_flat[sizeof(vesica_metric_closest_f32) == 3 * sizeof(float) ? 1 : -1];
typedef char turned_rect_f32_is_flat[sizeof(vesica_turned_rect_f32) == 5 * sizeof(float) ? 1 : -1];
typedef char radius_vector_ellipse_f32_is_flat[sizeof(vesica_radius_vector_ellipse_f32) == 5 * sizeof(float) ? 1 : -1];
/* Numbers of two types, and still no padding. */
typedef char approximation_f64_has_no_padding[sizeof(vesica_approximation_f64) == sizeof(double) + 8 ? 1 : -1];
typedef char approximation_f32_has_no_padding[sizeof(vesica_approximation_f32) == sizeof(float) + 4 ? 1 : -1];

int main(void) {
  const vesica_circle_f64 disc = {0, 0, 1};
  const vesica_ellipse_f64 ellipse = {0, 0, 1, 0, 2, 1};
  vesica_approximation_f64 reached;
  if (vesica_method_circle_ellipse_closed_form_f64(&disc, &ellipse) != VESICA_YES) return 1;
  return vesica_method_circle_ellipse_polygonal_sandwich_f64(&disc, &ellipse, 3, &reached) != VESICA_YES;
}
