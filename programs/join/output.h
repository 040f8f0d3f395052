// SPDX-License-Identifier: Apache-2.0
/// Rows of output, which several threads make part by part, written in the order of the parts.
#ifndef OUTPUT_H
#define OUTPUT_H

#include <pthread.h>
#include <stdint.h>
#include <stdio.h>

#include "shapes.h"

struct bytes {
  char* at;
  size_t count, room;
  int ended;  ///< nothing more comes
};

struct output {
  FILE* file;
  const char* header;       ///< the first line, or NULL
  int binary;               ///< 8 bytes a number instead of text
  const struct id* ids[2];  ///< of the shapes of A and of B, or NULL to write their numbers
  pthread_mutex_t lock;
  pthread_cond_t turn;
  int64_t next;        ///< the part whose turn it is
  struct bytes* done;  ///< of parts that ended before their turn
  int64_t parts;
  size_t held;  ///< bytes of these
  int failed;   ///< the file cannot be written, or memory is short
};

/// Begins a number of parts; the members before the lock are set. Returns 1, or 0 where memory is short.
int begin_parts(struct output* output, int64_t parts);

/// Adds a row to a part: a shape of each file, and a distance or NULL. Now and then the rows so far are written, if it
/// is the part's turn; if they are very many they wait for it. Returns 0 where that fails.
int put_row(struct output* output, int64_t part, struct bytes* bytes, int64_t a, int64_t b, const double* distance);

/// Ends a part and frees its bytes.
void end_part(struct output* output, int64_t part, struct bytes* bytes);

/// Ends all parts; without rows there is the header alone.
void end_parts(struct output* output);

#endif
