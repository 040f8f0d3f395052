// SPDX-License-Identifier: Apache-2.0
/// Reading a text file line by line, whatever bytes it holds.
#ifndef LINE_H
#define LINE_H

#include <stdio.h>

enum { line_limit = 4095 };

/// One line of a file, without its line end (LF or CR LF; optional in the last line).
struct line {
  long number;        ///< from 1
  const char* fault;  ///< why the line cannot be used, or NULL
  char* text;         ///< memory of line_limit + 2 bytes; if it grows, NULL or memory of malloc, which the caller frees
  int grows;          ///< lines may be longer than line_limit
  size_t room;        ///< the bytes of text, if it grows
};

/// Reads the next line into `line`, whose number must be 0 before the first. Returns 1, or 0 at the end of the file
/// or on a read error (see ferror).
int read_line(FILE* file, struct line* line);

/// Writes at most `limit` characters of `text`, anything but printable ASCII as '?'.
void put_printable(FILE* file, const char* text, int limit);

#endif
