// SPDX-License-Identifier: Apache-2.0
/// The header of a file of numpy's: what its rows are.
#ifndef NPY_HEADER_H
#define NPY_HEADER_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "scene.h"

/// The place of one number of a shape in a row.
struct npy_number {
  size_t offset;
  int bytes;  ///< 8 or 4
  int big;    ///< the byte of most weight is the first
};

struct npy_header {
  int64_t rows;
  size_t row_bytes;
  int32_t kind;
  struct npy_number numbers[most_numbers];
};

enum { most_row_bytes = 65536 };

/// Reads the header of a file; the rows follow it. `kind` is the kind of the shapes, or -1 to take it from the names of
/// the fields. Returns 1, or 0 with the reason in `fault`.
int read_npy_header(FILE* file, int32_t kind, struct npy_header* header, struct fault* fault);

#endif
