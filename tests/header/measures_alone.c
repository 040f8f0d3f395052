/* SPDX-License-Identifier: Apache-2.0 */
/* vesica_measures.h before anything else, compiled as every C and C++ it promises to be. It brings vesica.h with it. */
#include <vesica_measures.h>

#if !defined(VESICA_H) || VESICA_RATIO_COMPLETE != 6
#error "vesica.h or the constants of ratios are missing"
#endif

int main(void) {
  const double box[4] = {0, 0, 1, 1};
  double out;
  return vesica_ratio_f64(VESICA_RATIO_OVER_FIRST, VESICA_AABB, box, VESICA_AABB, box, &out);
}
