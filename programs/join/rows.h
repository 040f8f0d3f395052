// SPDX-License-Identifier: Apache-2.0
/// Shapes in the lines of a text, which all threads read, each some pieces of the text.
#ifndef ROWS_H
#define ROWS_H

#include "source.h"

enum meaning { no_shape, empty_shape, good_shape, bad_shape };  ///< an empty one has a number and is none

/// One line, without its line end; a NUL follows it. The reader puts the shape here, its vertices into `vertices`, its
/// id if ids are asked for, and into `fault` the reason why a shape is bad.
struct row {
  char *at, *end;
  int is_first;
  const struct source* source;
  struct vertices* vertices;
  struct shape shape;
  struct id id;
  struct fault fault;
};

/// Reads the lines of source->text from the byte `begin` on, in the line `line`. With quotes a line ends outside them.
/// Returns 1, or 0 after saying why.
int read_rows(struct source* source, int64_t begin, int64_t line, int quotes, const void* context,
              enum meaning (*read)(const void* context, struct row* row));

/// For readers of lines: takes well-known text as the row's shape. Nothing, and geometries that are EMPTY, are empty.
enum meaning read_known_text(char* text, struct row* row);

/// The end of the line that begins there: its line feed, or the end of the text. With quotes it lies outside them;
/// *lines grows by the line feeds and 1.
char* find_row_end(char* at, char* end, int quotes, int64_t* lines);

#endif
