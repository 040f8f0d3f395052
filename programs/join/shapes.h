// SPDX-License-Identifier: Apache-2.0
/// The shapes of one file, kind by kind as the library takes them, each with its number in the file and its id.
#ifndef SHAPES_H
#define SHAPES_H

#include <stdint.h>
#include <vesica.h>

#include "fault.h"
#include "vertices.h"

enum { kind_count = VESICA_POLYLINE + 1, most_numbers = 7 };

struct shape {
  int32_t kind;
  double numbers[most_numbers];  ///< in the order of vesica.h; of polygons and polylines none
};

struct id {
  const char* at;  ///< in the text of the file, or NULL
  int64_t length;
};

struct shapes {
  int64_t count;             ///< shapes met so far, bad ones included: the number of the next
  int64_t used[kind_count];  ///< good ones of each kind
  int64_t room[kind_count];
  double* numbers[kind_count];           ///< records side by side
  struct vertices vertices[kind_count];  ///< of polygons and polylines, instead of records
  int32_t* parts[kind_count];            ///< where the rings of each begin: `used` + 1 offsets, if there are any
  int64_t* places[kind_count];           ///< the number in the file of each shape
  struct id* ids;                        ///< of each number in the file; NULL without ids
  int64_t id_room;
};

/// The kind of that name, or a negative number.
int32_t find_kind(const char* name);

/// True for polygons and polylines.
int has_vertices(int32_t kind);

/// Is the shape valid? Those with vertices have them in `vertices`. `name` is A or B. Returns 1, or 0 with the reason.
int check_shape(const struct shape* shape, const struct vertices* vertices, char name, struct fault* fault);

/// Takes in a valid shape as the next of the file. Returns 1, or 0 where memory is short or vertices are too many.
int add_shape(struct shapes* shapes, const struct shape* shape, const struct vertices* vertices);

/// Gives an id to the shapes from number `first` on. Returns 1, or 0 where memory is short.
int set_ids(struct shapes* shapes, int64_t first, struct id id);

/// Makes one of the pieces of a file, in their order, and frees these. Begin with {0}. Returns as add_shape().
int join_pieces(struct shapes* all, struct shapes* const pieces[], int64_t count, int threads);

/// How many good ones there are.
int64_t good_shapes(const struct shapes* shapes);

/// The shapes as the library's sets, one a kind that occurs, and the number in the file of each item of an index over
/// them, of which `places` has room for good_shapes(). Returns how many sets.
int32_t view_shapes(const struct shapes* shapes, vesica_shapes_f64 sets[kind_count], int64_t* places);

void free_shapes(struct shapes* shapes);

#endif
