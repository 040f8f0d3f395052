// SPDX-License-Identifier: Apache-2.0
/// Geometries as well-known text and GeoJSON name them.
#ifndef GEOMETRY_H
#define GEOMETRY_H

#include <stddef.h>

#include "vertices.h"

enum { geometry_fault_room = 160 };

struct geometry {
  const char* name;
  int32_t kind;
  int parentheses;  ///< around each ring, in well-known text
  int brackets;     ///< around each number, in GeoJSON
};

/// The geometry of that name, in upper or lower case, or NULL.
const struct geometry* find_geometry(const char* name, size_t length);

/// Takes the vertices of a geometry as the simplest kind: two positions of a line as a segment, a box along the axes as
/// an AABB. Points, segments and AABBs get their numbers, all others keep their vertices. Several points are a polyline
/// of chains of one vertex. Returns 1, or 0 with the reason in `fault`.
int settle_geometry(const struct geometry* geometry, struct vertices* vertices, int32_t* kind, double numbers[4],
                    char fault[geometry_fault_room]);

#endif
