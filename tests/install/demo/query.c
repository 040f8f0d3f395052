// SPDX-License-Identifier: Apache-2.0
#include "query.h"

#include <string.h>
#include <vesica.h>

#include "scene.h"

static int32_t answer_overlap(const struct pair* pair, double* out) {
  const int32_t result = vesica_overlap_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers);
  if (result < 0) return result;
  *out = result;
  return 0;
}

static const struct query queries[] = {
    {"overlap", answer_overlap, 1}, {"relation", NULL, 0}, {"distance", NULL, 0}, {"area", NULL, 0}, {"iou", NULL, 0},
};

const struct query* find_query(const char* name) {
  for (size_t i = 0; i < sizeof queries / sizeof queries[0]; i++) {
    if (strcmp(queries[i].name, name) == 0) return &queries[i];
  }
  return NULL;
}
