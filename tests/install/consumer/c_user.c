/* SPDX-License-Identifier: Apache-2.0 */
/* A C program that uses the library. Exit status 0 when the answers are right. */
#include <vesica.h>

int main(void) {
  /* The corner (2, 1) of the rectangle touches the ellipse's end. */
  const vesica_rect_f64 rect = {0, 0, 1, 0, 2, 1};
  const vesica_ellipse_f64 touching = {3, 1, 1, 0, 1, 0.5}, apart = {3.125, 1, 1, 0, 1, 0.5};
  if (vesica_version() != VESICA_VERSION) return 1;
  if (vesica_overlap_rect_ellipse_f64(&rect, &touching) != 1) return 2;
  if (vesica_overlap_rect_ellipse_f64(&rect, &apart) != 0) return 3;
  return 0;
}
