// SPDX-License-Identifier: Apache-2.0
#include "shapes.h"

#include <stdlib.h>
#include <string.h>

static int make_room(struct shapes* shapes, int32_t kind) {
  const int64_t room = shapes->room[kind] < 64 ? 64 : shapes->room[kind] * 2;
  const size_t record = (size_t)vesica_field_count(kind) * sizeof(double);
  void* grown = realloc(shapes->numbers[kind], (size_t)room * record);
  if (!grown) return 0;
  shapes->numbers[kind] = grown;
  grown = realloc(shapes->places[kind], (size_t)room * sizeof(int64_t));
  if (!grown) return 0;
  shapes->places[kind] = grown;
  shapes->room[kind] = room;
  return 1;
}

int add_shape(struct shapes* shapes, const struct shape* shape) {
  const int32_t kind = shape->kind;
  const int64_t at = shapes->used[kind];
  const size_t fields = (size_t)vesica_field_count(kind);
  if (at == shapes->room[kind] && !make_room(shapes, kind)) return 0;
  memcpy(shapes->numbers[kind] + (size_t)at * fields, shape->numbers, fields * sizeof(double));
  shapes->places[kind][at] = shapes->count++;
  shapes->used[kind]++;
  return 1;
}

int64_t good_shapes(const struct shapes* shapes) {
  int64_t count = 0;
  for (int32_t kind = 0; kind < kind_count; kind++) count += shapes->used[kind];
  return count;
}

int32_t view_shapes(const struct shapes* shapes, vesica_shapes_f64 sets[kind_count], int64_t* places) {
  int32_t count = 0;
  for (int32_t kind = 0; kind < kind_count; kind++) {
    const int64_t used = shapes->used[kind];
    const ptrdiff_t record = vesica_field_count(kind) * (ptrdiff_t)sizeof(double);
    if (used == 0) continue;
    vesica_shapes_from_records_f64(kind, used, shapes->numbers[kind], record, &sets[count++]);
    memcpy(places, shapes->places[kind], (size_t)used * sizeof(int64_t));
    places += used;
  }
  return count;
}

void free_shapes(struct shapes* shapes) {
  for (int32_t kind = 0; kind < kind_count; kind++) {
    free(shapes->numbers[kind]);
    free(shapes->places[kind]);
  }
}
