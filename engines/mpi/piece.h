// SPDX-License-Identifier: Apache-2.0
/// A rank's piece of a set of shapes: records, in memory and on the way, and the index over them.
#ifndef PIECE_H
#define PIECE_H

#include <stdint.h>
#include <vesica.h>

enum { kind_count = 8 };

/// A shape and its number in the file. What lies in a file is the part from `kind` on.
struct record {
  int64_t id, kind;
  double numbers[7];
};

struct piece {
  int64_t count;  ///< with those that are no shapes, which have no pairs
  struct record* records;
  vesica_shapes_f64 sets[kind_count];
  void* index;      ///< its item i is records[i]
  int64_t invalid;  ///< how many are left out of it
};

/// Memory aligned as the library wants it; ends the whole job where there is none.
void* memory(int64_t bytes);

/// Says why, and ends the whole job.
void give_up(const char* path, const char* reason);

/// Reads run `rank` of `rank_count` of an array of numpy's, of dtype [('kind', '<i8'), ('numbers', '<f8', (7,))].
struct piece read_run(const char* path, int rank, int rank_count);

/// Lays the records kind by kind and indexes them.
void index_piece(struct piece* piece);

void free_piece(struct piece* piece);

#endif
