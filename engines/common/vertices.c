// SPDX-License-Identifier: Apache-2.0
#include "vertices.h"

#include <stdlib.h>

// Doubles the room of an array of `size` bytes each until it holds `wanted`.
static int grow(void* array, int64_t* room, int64_t wanted, size_t size) {
  void** const at = array;
  int64_t larger = *room < 64 ? 64 : *room;
  void* grown;
  if (wanted <= *room) return 1;
  while (larger < wanted) larger *= 2;
  grown = realloc(*at, (size_t)larger * size);
  if (!grown) return 0;
  *at = grown;
  *room = larger;
  return 1;
}

int add_vertex(struct vertices* vertices, double x, double y) {
  void* xy = vertices->xy;
  if (vertices->count == INT32_MAX || !grow(&xy, &vertices->room, vertices->count + 1, 2 * sizeof(double))) return 0;
  vertices->xy = xy;
  vertices->xy[2 * vertices->count] = x;
  vertices->xy[2 * vertices->count + 1] = y;
  vertices->count++;
  return 1;
}

int end_ring(struct vertices* vertices) {
  void* rings = vertices->rings;
  if (vertices->ring_count == INT32_MAX ||
      !grow(&rings, &vertices->ring_room, vertices->ring_count + 2, sizeof(int32_t)))
    return 0;
  vertices->rings = rings;
  vertices->rings[0] = 0;
  vertices->rings[++vertices->ring_count] = (int32_t)vertices->count;
  return 1;
}

void clear_vertices(struct vertices* vertices) { vertices->count = vertices->ring_count = 0; }

int part_vertices(struct vertices* vertices) {
  const int64_t count = vertices->count;
  vertices->ring_count = 0;
  for (vertices->count = 1; vertices->count <= count; vertices->count++) {
    if (!end_ring(vertices)) return 0;
  }
  vertices->count = count;
  return 1;
}

vesica_polygon_f64 view_vertices(const struct vertices* vertices) {
  const vesica_polygon_f64 polygon = {vertices->xy, vertices->xy + 1, 2 * sizeof(double), vertices->rings,
                                      vertices->ring_count};
  return polygon;
}

void free_vertices(struct vertices* vertices) {
  free(vertices->xy);
  free(vertices->rings);
}
