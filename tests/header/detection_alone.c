/* SPDX-License-Identifier: Apache-2.0 */
/* vesica_detection.h before anything else, compiled as every C and C++ it promises to be. It brings vesica.h. */
#include <vesica_detection.h>

#if !defined(VESICA_H) || !defined(VESICA_INDEX_H) || VESICA_RATIO_OVER_FIRST != 1
#error "vesica.h, vesica_index.h or the constants of ratios are missing"
#endif

int main(void) {
  const double box[4] = {0, 0, 1, 1};
  double out;
  return vesica_gaussian_distance_f64(VESICA_GAUSSIAN_HELLINGER, VESICA_AABB, box, VESICA_AABB, box, &out);
}
