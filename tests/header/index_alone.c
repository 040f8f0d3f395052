/* SPDX-License-Identifier: Apache-2.0 */
/* vesica_index.h before anything else, compiled as every C and C++ it promises to be. It brings vesica.h with it. */
#include <vesica_index.h>

#if !defined(VESICA_H) || VESICA_JOIN_INSIDE != 3 || VESICA_JOIN_INTERIORS != 4
#error "vesica.h or the constants of joins are missing"
#endif

int main(void) {
  vesica_aabb_f64 bounds;
  const double number = 0;
  vesica_shapes_f64 one;
  if (vesica_shapes_from_records_f64(VESICA_POINT, 0, &number, 0, &one) != 0) return 1;
  if (vesica_index_size(one.count) <= 0) return 1;
  return vesica_index_bounds(&number, &bounds) != VESICA_E_ARGUMENT;
}
