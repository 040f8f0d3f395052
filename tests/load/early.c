// SPDX-License-Identifier: Apache-2.0
// A library that the tested one is linked to, and that calls it: its constructor runs first, whatever the loader.
#include <vesica.h>

int64_t early_hits = -1;
const char* early_isa = "";

static void __attribute__((constructor)) call_before_constructors(void) {
  static const double x[3] = {0.0, 2.0, 3.0}, y[3] = {0.0, 0.0, 0.0};
  static const double disc[3] = {0.0, 0.0, 2.0};
  const vesica_shapes_f64 points = {VESICA_POINT, 0, 3, sizeof x[0], {x, y}, NULL, NULL, 0};
  const vesica_shapes_f64 circle = {VESICA_CIRCLE, 0, 1, 0, {disc, disc + 1, disc + 2}, NULL, NULL, 0};
  uint8_t out[3];
  early_hits = vesica_overlap_many_f64(&circle, &points, out);
  early_isa = vesica_isa_name();
}
