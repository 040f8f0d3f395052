// SPDX-License-Identifier: Apache-2.0
/// The vertices of polygons and polylines, in memory that grows.
#ifndef VERTICES_H
#define VERTICES_H

#include <stdint.h>
#include <vesica.h>

/// The vertices and rings of one or more shapes, one behind the other. Begin with {0}.
struct vertices {
  double* xy;
  int64_t count, room;  ///< vertices
  int32_t* rings;       ///< where each ring begins among the vertices; ring_count + 1 offsets, if there are any
  int64_t ring_count, ring_room;
};

/// Adds a vertex; end_ring() ends its ring. Returns 1, or 0 where memory is short or offsets are too large.
int add_vertex(struct vertices* vertices, double x, double y);
int end_ring(struct vertices* vertices);

/// Makes each vertex a ring. Returns as add_vertex().
int part_vertices(struct vertices* vertices);

/// Takes all out and keeps the memory.
void clear_vertices(struct vertices* vertices);

/// All of them as one shape.
vesica_polygon_f64 view_vertices(const struct vertices* vertices);

void free_vertices(struct vertices* vertices);

#endif
