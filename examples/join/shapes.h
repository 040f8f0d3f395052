// SPDX-License-Identifier: Apache-2.0
/// The shapes of one file, kind by kind as the library takes them, each with its number in the file.
#ifndef SHAPES_H
#define SHAPES_H

#include <stdint.h>
#include <vesica.h>

#include "scene.h"
#include "vertices.h"

enum { kind_count = VESICA_POLYLINE + 1 };

struct shapes {
  int64_t count;             ///< shapes met so far, bad ones included: the number of the next
  int64_t used[kind_count];  ///< good ones of each kind
  int64_t room[kind_count];
  double* numbers[kind_count];           ///< records side by side
  struct vertices vertices[kind_count];  ///< of polygons and polylines, instead of records
  int32_t* parts[kind_count];            ///< where the rings of each begin: `used` + 1 offsets, if there are any
  int64_t* places[kind_count];           ///< the number in the file of each shape
};

/// The kind of that name if it is polygon or polyline, else a negative number.
int32_t path_kind(const char* name);

/// True for polygons and polylines.
int has_vertices(int32_t kind);

/// Takes in a valid shape as the next of the file; `vertices` are those of one that has some. Returns 1, or 0 where
/// memory is short.
int add_shape(struct shapes* shapes, const struct shape* shape, const struct vertices* vertices);

/// How many good ones there are.
int64_t good_shapes(const struct shapes* shapes);

/// The shapes as the library's sets, one a kind that occurs, and the number in the file of each item of an index over
/// them, of which `places` has room for good_shapes(). Returns how many sets.
int32_t view_shapes(const struct shapes* shapes, vesica_shapes_f64 sets[kind_count], int64_t* places);

void free_shapes(struct shapes* shapes);

#endif
