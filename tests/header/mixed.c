/* SPDX-License-Identifier: Apache-2.0 */
/* Must not compile in C11: vesica_overlap takes two shapes of one scalar type. Compiles with SAME defined. */
#include <vesica.h>

#ifdef SAME
typedef vesica_circle_f64 second_shape;
#else
typedef vesica_circle_f32 second_shape;
#endif

int main(void) {
  const vesica_circle_f64 a = {0, 0, 1};
  const second_shape b = {0, 0, 1};
  return vesica_overlap(&a, &b);
}
