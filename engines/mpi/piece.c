// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "piece.h"

#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void give_up(const char* path, const char* reason) {
  fprintf(stderr, "join_mpi: %s: %s\n", path, reason);
  MPI_Abort(MPI_COMM_WORLD, 2);
}

void* memory(int64_t bytes) {
  void* block = NULL;
  if (bytes < 0 || posix_memalign(&block, 64, (size_t)bytes + 1) != 0) give_up("memory", "not enough of it");
  return block;
}

// ---- Reading ----

enum { file_record = sizeof(struct record) - sizeof(int64_t) };

// Returns the offset of the first record.
static long read_header(FILE* file, const char* path) {
  static const char type[] = "'descr': [('kind', '<i8'), ('numbers', '<f8', (7,))], 'fortran_order': False";
  unsigned char start[10];
  static char text[65536];
  size_t length;
  if (fread(start, 1, 10, file) != 10 || memcmp(start, "\x93NUMPY\1", 7) != 0)
    give_up(path, "not an array of numpy's, of version 1");
  length = start[8] + 256u * start[9];
  if (fread(text, 1, length, file) != length || !strstr(text, type))
    give_up(path, "not an array of [('kind', '<i8'), ('numbers', '<f8', (7,))]");
  return 10 + (long)length;
}

struct piece read_run(const char* path, int rank, int rank_count) {
  struct piece piece = {.count = 0};
  FILE* file = fopen(path, "rb");
  long begin, end = -1;
  int64_t total, first;
  if (!file) give_up(path, "cannot be read");
  begin = read_header(file, path);
  if (fseek(file, 0, SEEK_END) != 0 || (end = ftell(file)) < begin) give_up(path, "cannot be read");
  if ((end - begin) % file_record != 0) give_up(path, "is cut off");
  total = (end - begin) / file_record;
  first = total * rank / rank_count;
  piece.count = total * (rank + 1) / rank_count - first;
  piece.records = memory(piece.count * (int64_t)sizeof *piece.records);
  if (fseek(file, begin + first * file_record, SEEK_SET) != 0) give_up(path, "cannot be read");
  for (int64_t i = 0; i < piece.count; i++) {
    piece.records[i].id = first + i;
    if (fread(&piece.records[i].kind, file_record, 1, file) != 1) give_up(path, "cannot be read");
  }
  fclose(file);
  return piece;
}

// ---- Indexing ----

static int kind_of(const struct record* record) {
  return record->kind >= 0 && record->kind < kind_count ? (int)record->kind : kind_count;
}

static void sort_by_kind(struct piece* piece, int64_t used[kind_count + 1]) {
  struct record* sorted = memory(piece->count * (int64_t)sizeof *sorted);
  int64_t place[kind_count + 1] = {0};
  for (int64_t i = 0; i < piece->count; i++) used[kind_of(&piece->records[i])]++;
  for (int kind = 0; kind < kind_count; kind++) place[kind + 1] = place[kind] + used[kind];
  for (int64_t i = 0; i < piece->count; i++) sorted[place[kind_of(&piece->records[i])]++] = piece->records[i];
  free(piece->records);
  piece->records = sorted;
}

void index_piece(struct piece* piece) {
  int64_t used[kind_count + 1] = {0}, items = 0, size, scratch_size;
  void* scratch;
  sort_by_kind(piece, used);
  for (int kind = 0; kind < kind_count; kind++) {
    vesica_shapes_from_records_f64(kind, used[kind], piece->records[items].numbers, sizeof *piece->records,
                                   &piece->sets[kind]);
    items += used[kind];
  }
  size = vesica_index_size(items);
  scratch_size = vesica_index_scratch(items);
  piece->index = memory(size);
  scratch = memory(scratch_size);
  vesica_index_build_f64(piece->sets, kind_count, piece->index, size, scratch, scratch_size);
  free(scratch);
  piece->invalid = piece->count - vesica_index_order(piece->index, NULL, 0);
}

void free_piece(struct piece* piece) {
  free(piece->records);
  free(piece->index);
}
