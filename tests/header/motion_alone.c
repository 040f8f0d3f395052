/* SPDX-License-Identifier: Apache-2.0 */
/* vesica_motion.h before anything else, compiled as every C and C++ it promises to be. It brings vesica.h with it. */
#include <vesica_motion.h>

#if !defined(VESICA_H) || !defined(VESICA_INDEX_H) || VESICA_CAST_START != 2
#error "vesica.h, vesica_index.h or the constants of casts are missing"
#endif

int main(void) {
  const double point[2] = {0, 0}, circle[3] = {3, 0, 1};
  vesica_impact_f64 impact;
  return vesica_cast_f64(VESICA_CIRCLE, circle, VESICA_POINT, point, 1, 0, 5, &impact) != VESICA_CAST_HIT;
}
