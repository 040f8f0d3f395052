// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "geometry.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { box_positions = 5 };

static const struct geometry geometries[] = {
    {"Point", VESICA_POINT, 0, 1},         {"MultiPoint", VESICA_POLYLINE, 1, 2},
    {"LineString", VESICA_POLYLINE, 0, 2}, {"MultiLineString", VESICA_POLYLINE, 1, 3},
    {"Polygon", VESICA_POLYGON, 1, 3},     {"MultiPolygon", VESICA_POLYGON, 2, 4}};

const struct geometry* find_geometry(const char* name, size_t length) {
  for (size_t i = 0; i < sizeof geometries / sizeof *geometries; i++) {
    const char* own = geometries[i].name;
    if (strlen(own) == length && strncasecmp(own, name, length) == 0) return &geometries[i];
  }
  return NULL;
}

static int same(const double* p, int a, int b, int axis) { return p[2 * a + axis] == p[2 * b + axis]; }

// Its sides take turns in lying along the one axis and the other, beginning with `axis`.
static int turns(const double* p, int axis) {
  for (int i = 0; i + 1 < box_positions; i++) {
    if (!same(p, i, i + 1, (axis + i + 1) % 2)) return 0;
  }
  return 1;
}

static int take_box(const struct vertices* vertices, double numbers[4]) {
  const double* p = vertices->xy;
  if (vertices->ring_count != 1 || vertices->count != box_positions || !same(p, 0, 4, 0) || !same(p, 0, 4, 1)) return 0;
  if (!turns(p, 0) && !turns(p, 1)) return 0;
  for (int axis = 0; axis < 2; axis++) {
    numbers[axis] = fmin(p[axis], p[4 + axis]);
    numbers[axis + 2] = fmax(p[axis], p[4 + axis]);
  }
  return 1;
}

int settle_geometry(const struct geometry* geometry, struct vertices* vertices, int32_t* kind, double numbers[4],
                    char fault[geometry_fault_room]) {
  *kind = geometry->kind;
  if (*kind == VESICA_POINT && vertices->count != 1) {
    snprintf(fault, geometry_fault_room, "a point with %lld positions", (long long)vertices->count);
    return 0;
  }
  if (geometry->brackets == 2 && geometry->parentheses == 1 && !part_vertices(vertices)) {
    snprintf(fault, geometry_fault_room, "too many points");
    return 0;
  }
  if (*kind == VESICA_POLYGON && take_box(vertices, numbers)) *kind = VESICA_AABB;
  if (*kind == VESICA_POLYLINE && vertices->ring_count == 1 && vertices->count == 2) *kind = VESICA_SEGMENT;
  if (*kind == VESICA_POLYLINE && vertices->count == 1) *kind = VESICA_POINT;
  if (*kind == VESICA_POINT || *kind == VESICA_SEGMENT) {
    memcpy(numbers, vertices->xy, 2 * sizeof(double) * (size_t)vertices->count);
  }
  return 1;
}
