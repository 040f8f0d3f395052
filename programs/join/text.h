// SPDX-License-Identifier: Apache-2.0
/// A file in memory.
#ifndef TEXT_H
#define TEXT_H

#include <stdint.h>
#include <stdio.h>

struct text {
  char* at;  ///< memory of malloc; a NUL follows the last byte
  int64_t size;
};

/// Reads a file, of which nothing has been read, or one byte that was put back. Regular files are read on several
/// threads. Returns 1, or 0 with errno.
int load_text(FILE* file, const char* path, int threads, struct text* text);

#endif
