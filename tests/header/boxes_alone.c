/* SPDX-License-Identifier: Apache-2.0 */
/* vesica_boxes.h before anything else, compiled as every C and C++ it promises to be. It brings vesica.h with it. */
#include <vesica_boxes.h>

#if !defined(VESICA_H) || VESICA_ANGLE_REVERSED != 4
#error "vesica.h or the units of angles are missing"
#endif

int main(void) {
  const double box[5] = {0, 0, 2, 1, 90};
  vesica_rect_f64 rect;
  return vesica_rects_from_boxes_f64(box, 1, 0, VESICA_ANGLE_DEGREES, &rect) != 0 || rect.uy != 1;
}
