// SPDX-License-Identifier: Apache-2.0
/// The header of a file of numpy's: what its rows are.
#ifndef NPY_HEADER_H
#define NPY_HEADER_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "layout.h"

/// The place of one number of a shape in a row.
struct npy_number {
  size_t offset;
  int bytes;  ///< 8 or 4
  int big;    ///< the byte of most weight is the first
  int is_unsigned;
};

struct npy_header {
  int64_t rows;
  int64_t each;  ///< 0; in an array of rows of positions, how many a row has, and each position counts as a row
  size_t row_bytes;
  const struct form* form;  ///< of a row
  struct npy_number numbers[most_numbers];
};

enum { most_row_bytes = 65536 };

/// Reads the header of a file; the rows follow it. `columns` is NULL or the option --shape. `kind` is the kind of the
/// shapes, or -1; rows of polygons and polylines are points. Returns 1, or 0 with the reason in `fault`.
int read_npy_header(FILE* file, const char* columns, int32_t kind, struct npy_header* header, struct fault* fault);

/// The same for an array of integers of 4 or 8 bytes, in one dimension.
int read_npy_integers_header(FILE* file, struct npy_header* header, struct fault* fault);

/// A number of a row.
double npy_number(const unsigned char* row, const struct npy_number* number);
int64_t npy_integer(const unsigned char* row, const struct npy_number* number);

#endif
