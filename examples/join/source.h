// SPDX-License-Identifier: Apache-2.0
/// A file of shapes: lines of text, or an array of numpy's.
#ifndef SOURCE_H
#define SOURCE_H

#include <stdio.h>

#include "shapes.h"

enum { any_kind = -1, most_complaints = 20 };

struct source {
  const char* path;
  char name;     ///< A or B, as complaints call its shapes
  int32_t kind;  ///< of all shapes, or any_kind where lines and fields tell
  FILE* file;
  int64_t bytes;   ///< of the file, or 0 where it has no length
  int64_t faults;  ///< bad shapes; the first most_complaints are named on standard error
  struct shapes shapes;
  struct vertices vertices;  ///< the vertices of the shape that is being read
};

/// Reads the file at source->path. Returns 1, or 0 after saying why it cannot be used: what is not a shape is not a
/// reason, but counted.
int read_source(struct source* source);

/// For readers: the next shape, at that line or row ("shapes.csv:3"), or the reason why it is none. If it has vertices,
/// they are in source->vertices. Returns 1, or 0 where memory is short, which is said.
int take_shape(struct source* source, const char* where, const struct shape* shape, const struct fault* fault);

/// For readers: says why the file cannot be used, and returns 0.
int refuse_source(const struct source* source, const char* reason);

/// For readers: how far the file has been read, on a terminal.
void show_reading(const struct source* source);

/// Reads shapes from text; read_source calls it.
int read_text(struct source* source);

/// Reads shapes from an array of numpy's; read_source calls it.
int read_npy(struct source* source);

#endif
