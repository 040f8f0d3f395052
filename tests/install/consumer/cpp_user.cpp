// SPDX-License-Identifier: Apache-2.0
// A C++ program that uses the library. Exit status 0 when the answers are right.
#include <vesica.h>

int main() {
  // Discs of radius 2 and 3 with centres 5 apart.
  const float disc[] = {0, 0, 2}, touching[] = {3, 4, 3}, apart[] = {3, 4.0625f, 3};
  if (vesica_version() != VESICA_VERSION) return 1;
  if (vesica_overlap_f32(VESICA_CIRCLE, disc, VESICA_CIRCLE, touching) != 1) return 2;
  if (vesica_overlap_f32(VESICA_CIRCLE, disc, VESICA_CIRCLE, apart) != 0) return 3;
  return 0;
}
