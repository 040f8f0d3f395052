/* SPDX-License-Identifier: Apache-2.0 */
/* vesica_index.h before anything else, compiled as every C and C++ it promises to be. It brings vesica.h with it. */
#include <vesica_index.h>

#if !defined(VESICA_H) || VESICA_JOIN_INSIDE != 3
#error "vesica.h or the constants of joins are missing"
#endif

int main(void) {
  const vesica_shapes_f64 none = {VESICA_CIRCLE, 0, 0, 0, {0, 0, 0, 0, 0, 0}};
  if (vesica_index_size(none.count) <= 0) return 1;
  return vesica_index_build_f64(&none, 1, 0, 0, 0, 0) != VESICA_E_NULL;
}
