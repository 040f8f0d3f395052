// SPDX-License-Identifier: Apache-2.0
/// Shapes in an array of numpy's. Rows are read one by one, so that a header that lies cannot ask for memory.
#include <string.h>

#include "npy_header.h"
#include "source.h"

static int take_row(struct source* source, const struct npy_header* header, const unsigned char* row, int64_t at) {
  double values[most_numbers];
  struct shape shape;
  struct fault fault;
  int good;
  for (int i = 0; i < header->form->count; i++) values[i] = npy_number(row, &header->numbers[i]);
  make_shape(header->form, values, &shape);
  good = check_shape(&shape, &source->vertices, source->name, &fault);
  if (!good) complain_of_shape(source, &fault, ": row %lld", (long long)at);
  return take_shape(source, good ? &shape : NULL);
}

int read_npy(struct source* source, char* offsets) {
  static unsigned char row[most_row_bytes];
  struct npy_header header;
  struct fault fault;
  const int32_t kind = offsets ? VESICA_POLYGON : source->kind;
  if (!read_npy_header(source->file, source->columns, kind, &header, &fault)) return refuse_source(source, fault.text);
  if (header.each > 0 || has_vertices(kind)) return read_paths(source, &header, offsets);
  for (int64_t at = 0; at < header.rows; at++) {
    if (at % 1024 == 0) show_reading(source, at * (int64_t)header.row_bytes);
    if (fread(row, 1, header.row_bytes, source->file) != header.row_bytes) {
      fail(&fault, "ends in row %lld of %lld", (long long)at, (long long)header.rows);
      return ferror(source->file) || refuse_source(source, fault.text);
    }
    if (!take_row(source, &header, row, at)) return 0;
  }
  return 1;
}
