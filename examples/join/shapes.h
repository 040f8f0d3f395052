// SPDX-License-Identifier: Apache-2.0
/// The shapes of one file, kind by kind as the library takes them, each with its number in the file.
#ifndef SHAPES_H
#define SHAPES_H

#include <stdint.h>
#include <vesica.h>

#include "scene.h"

enum { kind_count = VESICA_POLYLINE + 1 };

/// The vertices and rings of polygons or polylines, one behind the other.
struct vertices {
  double* xy;
  int64_t count, room;  ///< vertices
  int32_t* rings;       ///< where each ring begins among the vertices; ring_count + 1 offsets, if there are any
  int64_t ring_count, ring_room;
};

struct shapes {
  int64_t count;             ///< shapes met so far, bad ones included: the number of the next
  int64_t used[kind_count];  ///< good ones of each kind
  int64_t room[kind_count];
  double* numbers[kind_count];           ///< records side by side
  struct vertices vertices[kind_count];  ///< of polygons and polylines, instead of records
  int32_t* parts[kind_count];            ///< where the rings of each begin: `used` + 1 offsets, if there are any
  int64_t* places[kind_count];           ///< the number in the file of each shape
};

/// True for polygons and polylines.
int has_vertices(int32_t kind);

/// Adds a vertex; end_ring() ends its ring. Returns 1, or 0 where memory is short or offsets are too large.
int add_vertex(struct vertices* vertices, double x, double y);
int end_ring(struct vertices* vertices);

/// Their struct.
vesica_polygon_f64 view_vertices(const struct vertices* vertices);

/// Takes in a valid shape as the next of the file; `vertices` are those of one that has some. Returns 1, or 0 where
/// memory is short.
int add_shape(struct shapes* shapes, const struct shape* shape, const struct vertices* vertices);

/// How many good ones there are.
int64_t good_shapes(const struct shapes* shapes);

/// The shapes as the library's sets, one a kind that occurs, and the number in the file of each item of an index over
/// them, of which `places` has room for good_shapes(). Returns how many sets.
int32_t view_shapes(const struct shapes* shapes, vesica_shapes_f64 sets[kind_count], int64_t* places);

void free_vertices(struct vertices* vertices);
void free_shapes(struct shapes* shapes);

#endif
