/* SPDX-License-Identifier: Apache-2.0 */
#include <vesica.h>

/* Two circles that touch overlap. */
int main(void) {
  vesica_circle_f64 a = {0, 0, 1}, b = {2, 0, 1};
  return vesica_overlap_f64(VESICA_CIRCLE, &a, VESICA_CIRCLE, &b) == 1 ? 0 : 1;
}
