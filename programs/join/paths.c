// SPDX-License-Identifier: Apache-2.0
/// Polygons and polylines in numpy's arrays: (n, k, 2), or (n, 2) with arrays of offsets, as GeoArrow has them.
#include <stdlib.h>
#include <string.h>

#include "npy_header.h"
#include "source.h"

enum { most_levels = 3 };

struct offsets {
  int64_t* at;
  int64_t count;  // one more than what they divide
};

static int refuse(char* path, const char* reason) {
  const struct source other = {.path = path};
  return refuse_source(&other, reason);
}

// They ascend from 0 or more on.
static int take_offsets(FILE* file, char* path, const struct npy_header* header, struct offsets* out) {
  unsigned char bytes[8];
  int64_t room = 0;
  for (out->count = 0; out->count < header->rows; out->count++) {
    int64_t* const at = out->at;
    if (out->count == room) {
      room = room < 1024 ? 1024 : 2 * room;
      out->at = realloc(at, (size_t)room * sizeof *at);
      if (!out->at) {
        out->at = at;
        return refuse(path, "out of memory");
      }
    }
    if (fread(bytes, 1, header->row_bytes, file) != header->row_bytes) return refuse(path, "ends too early");
    out->at[out->count] = npy_integer(bytes, &header->numbers[0]);
    if (out->at[out->count] < (out->count > 0 ? out->at[out->count - 1] : 0)) {
      struct fault fault;
      fail(&fault, "offset %lld is negative or less than the one before", (long long)out->count);
      return refuse(path, fault.text);
    }
  }
  return out->count > 0 || refuse(path, "no offset: there is one more than there are shapes");
}

static int read_offsets(char* path, struct offsets* out) {
  struct npy_header header;
  struct fault fault;
  FILE* file = fopen(path, "rb");
  int good;
  if (!file) return refuse(path, "cannot read");
  good = read_npy_integers_header(file, &header, &fault) || refuse(path, fault.text);
  good = good && take_offsets(file, path, &header, out);
  fclose(file);
  return good;
}

// Offsets between commas, from the innermost on. Returns how many arrays, or 0.
static int read_levels(char* paths, struct offsets levels[most_levels]) {
  int count = 0;
  while (*paths) {
    char* const path = paths;
    const size_t length = strcspn(paths, ",");
    paths += length + (paths[length] == ',');
    path[length] = '\0';
    if (count == most_levels) return refuse(path, "more than three arrays of offsets");
    if (!read_offsets(path, &levels[count])) return 0;
    if (count > 0 && levels[count].at[levels[count].count - 1] >= levels[count - 1].count) {
      return refuse(path, "an offset is beyond the array before it");
    }
    count++;
  }
  return count;
}

struct coordinates {
  struct source* source;
  struct npy_header header;  // a row is a vertex
  int64_t at;                // rows read
};

static int skip_to(struct coordinates* c, int64_t row, double xy[2]) {
  static unsigned char bytes[16];
  while (c->at <= row) {
    if (fread(bytes, 1, c->header.row_bytes, c->source->file) != c->header.row_bytes) {
      struct fault fault;
      fail(&fault, "ends in vertex %lld of %lld", (long long)c->at, (long long)c->header.rows);
      return refuse_source(c->source, fault.text);
    }
    c->at++;
  }
  for (int axis = 0; axis < 2; axis++) xy[axis] = npy_number(bytes, &c->header.numbers[axis]);
  return 1;
}

static int take_ring(struct coordinates* c, int64_t begin, int64_t end) {
  struct vertices* vertices = &c->source->vertices;
  double xy[2] = {0, 0};
  for (int64_t i = begin; i < end; i++) {
    if (!skip_to(c, i, xy)) return 0;
    if (!add_vertex(vertices, xy[0], xy[1])) return refuse_source(c->source, "too many vertices");
  }
  return end_ring(vertices) || refuse_source(c->source, "too many rings");
}

static int end_path(struct coordinates* c) {
  struct source* source = c->source;
  struct shape shape = {.kind = source->kind == VESICA_POLYLINE ? VESICA_POLYLINE : VESICA_POLYGON};
  struct fault fault;
  const int good = check_shape(&shape, &source->vertices, source->name, &fault);
  if (!good) complain_of_shape(source, &fault, ": shape %lld", (long long)source->shapes.count);
  if (source->shapes.count % 1024 == 0) show_reading(source, c->at * (int64_t)c->header.row_bytes);
  return take_shape(source, good ? &shape : NULL);
}

static int take_equal_paths(struct coordinates* c, int64_t count, int64_t each) {
  for (int64_t i = 0; i < count; i++) {
    clear_vertices(&c->source->vertices);
    if (!take_ring(c, i * each, (i + 1) * each) || !end_path(c)) return 0;
  }
  return 1;
}

static int take_paths(struct coordinates* c, const struct offsets levels[], int level_count) {
  const struct offsets* outer = &levels[level_count - 1];
  if (levels[0].at[levels[0].count - 1] > c->header.rows)
    return refuse_source(c->source, "has fewer vertices than offsets say");
  for (int64_t i = 0; i + 1 < outer->count; i++) {
    int64_t begin = i, end = i + 1;
    for (int level = level_count - 1; level > 0; level--) {
      begin = levels[level].at[begin];
      end = levels[level].at[end];
    }
    clear_vertices(&c->source->vertices);
    for (int64_t j = begin; j < end; j++) {
      if (!take_ring(c, levels[0].at[j], levels[0].at[j + 1])) return 0;
    }
    if (!end_path(c)) return 0;
  }
  return 1;
}

int read_paths(struct source* source, const struct npy_header* header, char* offsets) {
  struct offsets levels[most_levels] = {{NULL, 0}};
  struct coordinates c = {source, *header, 0};
  int good = 0, level_count;
  if (header->each > 0 && offsets) return refuse_source(source, "an array of three dimensions needs no offsets");
  if (header->each > 0) return take_equal_paths(&c, header->rows / header->each, header->each);
  if (!offsets) return refuse_source(source, "an array of vertices: offsets tell which are of one shape (--help)");
  level_count = read_levels(offsets, levels);
  if (level_count > 0) good = take_paths(&c, levels, level_count);
  for (int level = 0; level < most_levels; level++) free(levels[level].at);
  return good;
}
