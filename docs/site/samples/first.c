#include <stdio.h>
#include <vesica.h>

int main(void) {
  /* centre, axis (cosine and sine of the angle), half sizes */
  vesica_rect_f64 car = {0.0, 0.0, 0.8, 0.6, 2.0, 1.0};
  vesica_ellipse_f64 person = {1.5, 1.0, 1.0, 0.0, 1.0, 0.5};
  vesica_circle_f64 post = {5.0, 0.0, 0.5};
  vesica_closest_points_f64 gap;
  double iou;

  int32_t hit = vesica_overlap(&car, &person);
  int32_t near = vesica_nearest(&car, &post, &gap);
  int32_t both = vesica_iou(&car, &person, &iou);
  if (hit < 0 || near < 0 || both < 0) return 1; /* vesica_strerror(hit) says why */

  printf("overlap %d, distance %.3f, IoU %.3f\n", hit, gap.distance, iou);
  return 0;
}
