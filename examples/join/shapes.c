// SPDX-License-Identifier: Apache-2.0
#include "shapes.h"

#include <stdlib.h>
#include <string.h>

int32_t path_kind(const char* name) {
  for (int32_t kind = VESICA_POLYGON; kind <= VESICA_POLYLINE; kind++) {
    if (strcmp(name, vesica_kind_name(kind)) == 0) return kind;
  }
  return VESICA_E_KIND;
}

int has_vertices(int32_t kind) { return kind == VESICA_POLYGON || kind == VESICA_POLYLINE; }

static int add_vertices(struct shapes* shapes, int32_t kind, const struct vertices* vertices) {
  struct vertices* all = &shapes->vertices[kind];
  for (int64_t j = 0; j < vertices->ring_count; j++) {
    for (int64_t i = vertices->rings[j]; i < vertices->rings[j + 1]; i++) {
      if (!add_vertex(all, vertices->xy[2 * i], vertices->xy[2 * i + 1])) return 0;
    }
    if (!end_ring(all)) return 0;
  }
  shapes->parts[kind][0] = 0;
  shapes->parts[kind][shapes->used[kind] + 1] = (int32_t)all->ring_count;
  return 1;
}

static int make_room(struct shapes* shapes, int32_t kind) {
  const int64_t room = shapes->room[kind] < 64 ? 64 : shapes->room[kind] * 2;
  void* grown = realloc(shapes->places[kind], (size_t)room * sizeof(int64_t));
  if (!grown) return 0;
  shapes->places[kind] = grown;
  if (has_vertices(kind)) {
    grown = realloc(shapes->parts[kind], (size_t)(room + 1) * sizeof(int32_t));
    if (!grown) return 0;
    shapes->parts[kind] = grown;
  } else {
    grown = realloc(shapes->numbers[kind], (size_t)room * (size_t)vesica_field_count(kind) * sizeof(double));
    if (!grown) return 0;
    shapes->numbers[kind] = grown;
  }
  shapes->room[kind] = room;
  return 1;
}

int add_shape(struct shapes* shapes, const struct shape* shape, const struct vertices* vertices) {
  const int32_t kind = shape->kind;
  const int64_t at = shapes->used[kind];
  if (at == shapes->room[kind] && !make_room(shapes, kind)) return 0;
  if (has_vertices(kind)) {
    if (!add_vertices(shapes, kind, vertices)) return 0;
  } else {
    const size_t fields = (size_t)vesica_field_count(kind);
    memcpy(shapes->numbers[kind] + (size_t)at * fields, shape->numbers, fields * sizeof(double));
  }
  shapes->places[kind][at] = shapes->count++;
  shapes->used[kind]++;
  return 1;
}

int64_t good_shapes(const struct shapes* shapes) {
  int64_t count = 0;
  for (int32_t kind = 0; kind < kind_count; kind++) count += shapes->used[kind];
  return count;
}

static void view_all(const struct shapes* shapes, int32_t kind, vesica_shapes_f64* set) {
  const struct vertices* vertices = &shapes->vertices[kind];
  const vesica_shapes_f64 all = {.kind = kind,
                                 .count = shapes->used[kind],
                                 .stride = 2 * sizeof(double),
                                 .field = {vertices->xy, vertices->xy + 1},
                                 .rings = vertices->rings,
                                 .polygons = shapes->parts[kind],
                                 .each = vertices->count};
  *set = all;
}

int32_t view_shapes(const struct shapes* shapes, vesica_shapes_f64 sets[kind_count], int64_t* places) {
  int32_t count = 0;
  for (int32_t kind = 0; kind < kind_count; kind++) {
    const int64_t used = shapes->used[kind];
    const ptrdiff_t record = vesica_field_count(kind) * (ptrdiff_t)sizeof(double);
    if (used == 0) continue;
    if (has_vertices(kind)) {
      view_all(shapes, kind, &sets[count++]);
    } else {
      vesica_shapes_from_records_f64(kind, used, shapes->numbers[kind], record, &sets[count++]);
    }
    memcpy(places, shapes->places[kind], (size_t)used * sizeof(int64_t));
    places += used;
  }
  return count;
}

void free_shapes(struct shapes* shapes) {
  for (int32_t kind = 0; kind < kind_count; kind++) {
    free(shapes->numbers[kind]);
    free(shapes->parts[kind]);
    free(shapes->places[kind]);
    free_vertices(&shapes->vertices[kind]);
  }
}
