// SPDX-License-Identifier: Apache-2.0
/// Counts the people in each zone: joins an index of polygons with an index of points. Prints `zone 0: 2`, `zone 1: 2`.
#include <stdio.h>
#include <stdlib.h>
#include <vesica.h>

enum { people = 5, zones = 2 };

/* The first zone has a hole; the second overlaps it. */
static const double corners[] = {0,        0, 20, 0, 20, 20, 0,  20, /* */ 4, 4, 8, 4, 8, 8, 4, 8,
                                 /* */ 12, 5, 40, 5, 40, 18, 12, 18};
static const int32_t ring_begins[] = {0, 4, 8, 12}, zone_begins[] = {0, 2, 3};
static const vesica_point_f64 feet[people] = {{5, 5}, {2, 5}, {15, 10}, {39, 6}, {60, 6}};

/* Memory for an index or for scratch. */
static void* memory(int64_t bytes) {
  void* const room = aligned_alloc(64, (size_t)(bytes + 63) / 64 * 64);
  if (room == NULL) exit(1);
  return room;
}

static void* index_of(const vesica_shapes_f64* shapes) {
  const int64_t size = vesica_index_size(shapes->count), scratch_size = vesica_index_scratch(shapes->count);
  void *const index = memory(size), *const scratch = memory(scratch_size);
  if (vesica_index_build_f64(shapes, 1, index, size, scratch, scratch_size) < 0) exit(1);
  free(scratch);
  return index;
}

int main(void) {
  vesica_shapes_f64 areas = {.kind = VESICA_POLYGON,
                             .count = zones,
                             .stride = 2 * sizeof(double),
                             .rings = ring_begins,
                             .polygons = zone_begins,
                             .each = sizeof corners / sizeof corners[0] / 2};
  areas.field[0] = corners, areas.field[1] = corners + 1;
  vesica_shapes_f64 places;
  vesica_shapes_from_records_f64(VESICA_POINT, people, feet, sizeof feet[0], &places);

  void *const of_areas = index_of(&areas), *const of_places = index_of(&places);
  const int64_t scratch_size = vesica_join_scratch();
  void* const scratch = memory(scratch_size);
  int64_t zone[4], person[4], state[4] = {0}, inside[zones] = {0};
  while (state[0] != -1) { /* four pairs at a time */
    const int64_t n = vesica_join_f64(VESICA_JOIN_OVERLAP, of_areas, &areas, 1, of_places, &places, 1, 0, 1, scratch,
                                      scratch_size, zone, person, 4, state);
    if (n < 0) return 1; /* vesica_strerror((int32_t)n) says why */
    for (int64_t i = 0; i < n; i++) inside[zone[i]]++;
  }
  for (int i = 0; i < zones; i++) printf("zone %d: %d\n", i, (int)inside[i]);
  free(of_areas), free(of_places), free(scratch);
  return 0;
}
