/* SPDX-License-Identifier: Apache-2.0 */
/* A C program that uses a named method, and the library beside it. Exit status 0 when the answers are right. */
#include <vesica_methods.h>

int main(void) {
  const vesica_rect_f64 rect = {0, 0, 1, 0, 2, 1};
  const vesica_ellipse_f64 meeting = {2.5, 0.5, 1, 0, 1, 0.5}, apart = {4, 1, 1, 0, 1, 0.5};
  if (vesica_method_rect_ellipse_closest_features_f64(&rect, &meeting) != 1) return 1;
  if (vesica_method_rect_ellipse_closest_features_f64(&rect, &apart) != 0) return 2;
  return vesica_overlap_rect_ellipse_f64(&rect, &meeting) != 1;
}
