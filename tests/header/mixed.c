/* SPDX-License-Identifier: Apache-2.0 */
/* A C11 macro, CALL, on shapes and results of double and of OTHER: compiles for f64, and must not for f32. */
#include <vesica.h>

#define OF_(name, scalar) vesica_##name##_##scalar
#define OF(name, scalar) OF_(name, scalar)
typedef double f64;
typedef float f32;

int main(void) {
  const vesica_circle_f64 a = {0, 0, 1};
  const OF(circle, OTHER) b = {0, 0, 1};
  OF(closest_points, OTHER) points = {0, 0, 0, 0, 0};
  OF(aabb, OTHER) box = {0, 0, 0, 0};
  OF(impact, OTHER) impact = {0, 0, 0, 0, 0};
  OF(turn, OTHER) turn = {0, 0, 0};
  OTHER number = 0;
  (void)&a, (void)&b, (void)&points, (void)&box, (void)&impact, (void)&turn, (void)&number;
  return CALL;
}
