/* SPDX-License-Identifier: Apache-2.0 */
/* vesica_topology.h before anything else, compiled as every C and C++ it promises to be. It brings vesica.h with it. */
#include <vesica_topology.h>

#if !defined(VESICA_H) || VESICA_DE9IM_SIZE != 10
#error "vesica.h or the constants of topology are missing"
#endif

int main(void) {
  const double point[2] = {0, 0}, box[4] = {0, 0, 1, 1};
  char matrix[10];
  return vesica_de9im_f64(VESICA_POINT, point, VESICA_AABB, box, matrix) != 0 || vesica_de9im_match(matrix, "F0F******") != 1;
}
