// SPDX-License-Identifier: Apache-2.0
#include "shapes.h"

#include <stdlib.h>
#include <string.h>

#include "work.h"

int32_t find_kind(const char* name) {
  for (int32_t kind = VESICA_POINT; kind < kind_count; kind++) {
    if (strcmp(name, vesica_kind_name(kind)) == 0) return kind;
  }
  return VESICA_E_KIND;
}

int has_vertices(int32_t kind) { return kind == VESICA_POLYGON || kind == VESICA_POLYLINE; }

int check_shape(const struct shape* shape, const struct vertices* vertices, char name, struct fault* fault) {
  const vesica_polygon_f64 path = view_vertices(vertices);
  const int32_t error =
      vesica_check_f64(shape->kind, has_vertices(shape->kind) ? (const void*)&path : (const void*)shape->numbers);
  return error == 0 ||
         fail(fault, "shape %c (%s) is invalid: %s", name, vesica_kind_name(shape->kind), vesica_strerror(error));
}

static int add_vertices(struct shapes* shapes, int32_t kind, const struct vertices* vertices) {
  struct vertices* all = &shapes->vertices[kind];
  for (int64_t j = 0; j < vertices->ring_count; j++) {
    for (int64_t i = vertices->rings[j]; i < vertices->rings[j + 1]; i++) {
      if (!add_vertex(all, vertices->xy[2 * i], vertices->xy[2 * i + 1])) return 0;
    }
    if (!end_ring(all)) return 0;
  }
  shapes->parts[kind][0] = 0;
  shapes->parts[kind][shapes->used[kind] + 1] = (int32_t)all->ring_count;
  return 1;
}

// Room for so many shapes of a kind.
static int make_room(struct shapes* shapes, int32_t kind, int64_t room) {
  const size_t count = (size_t)room;
  void* grown = realloc(shapes->places[kind], count * sizeof(int64_t));
  if (!grown) return 0;
  shapes->places[kind] = grown;
  if (has_vertices(kind)) {
    grown = realloc(shapes->parts[kind], (count + 1) * sizeof(int32_t));
    if (!grown) return 0;
    shapes->parts[kind] = grown;
  } else {
    grown = realloc(shapes->numbers[kind], count * (size_t)vesica_field_count(kind) * sizeof(double));
    if (!grown) return 0;
    shapes->numbers[kind] = grown;
  }
  shapes->room[kind] = room;
  return 1;
}

int add_shape(struct shapes* shapes, const struct shape* shape, const struct vertices* vertices) {
  const int32_t kind = shape->kind;
  const int64_t at = shapes->used[kind];
  if (at == shapes->room[kind] && !make_room(shapes, kind, at < 64 ? 64 : 2 * at)) return 0;
  if (has_vertices(kind)) {
    if (!add_vertices(shapes, kind, vertices)) return 0;
  } else {
    const size_t fields = (size_t)vesica_field_count(kind);
    memcpy(shapes->numbers[kind] + (size_t)at * fields, shape->numbers, fields * sizeof(double));
  }
  shapes->places[kind][at] = shapes->count++;
  shapes->used[kind]++;
  return 1;
}

static int make_id_room(struct shapes* shapes, int64_t room) {
  void* const grown = realloc(shapes->ids, (size_t)room * sizeof *shapes->ids);
  if (!grown) return 0;
  shapes->ids = grown;
  shapes->id_room = room;
  return 1;
}

int set_ids(struct shapes* shapes, int64_t first, struct id id) {
  const int64_t room = shapes->id_room;
  if (shapes->count > room && !make_id_room(shapes, shapes->count < 2 * room ? 2 * room : shapes->count + 64)) return 0;
  for (int64_t i = first; i < shapes->count; i++) shapes->ids[i] = id;
  return 1;
}

// ---- Pieces of a file ----

struct appending {
  struct shapes *all, *const *pieces;
  struct shapes* begins;  // for each piece the counts before it; nothing else of them is used
};

static void append_vertices(struct shapes* all, const struct shapes* begin, const struct shapes* piece, int32_t kind) {
  const struct vertices *from = &piece->vertices[kind], *before = &begin->vertices[kind];
  struct vertices* to = &all->vertices[kind];
  if (piece->used[kind] == 0) return;
  memcpy(to->xy + 2 * before->count, from->xy, 2 * sizeof(double) * (size_t)from->count);
  for (int64_t i = 1; i <= from->ring_count; i++) {
    to->rings[before->ring_count + i] = (int32_t)(before->count + from->rings[i]);
  }
  for (int64_t i = 1; i <= piece->used[kind]; i++) {
    all->parts[kind][begin->used[kind] + i] = (int32_t)(before->ring_count + piece->parts[kind][i]);
  }
}

static void append_piece(void* context, int64_t number) {
  const struct appending* const appending = context;
  struct shapes *const all = appending->all, *const piece = appending->pieces[number];
  const struct shapes* const begin = &appending->begins[number];
  for (int32_t kind = 0; kind < kind_count; kind++) {
    const int64_t used = piece->used[kind];
    if (has_vertices(kind)) {
      append_vertices(all, begin, piece, kind);
    } else if (used > 0) {
      const size_t fields = (size_t)vesica_field_count(kind);
      memcpy(all->numbers[kind] + (size_t)begin->used[kind] * fields, piece->numbers[kind],
             (size_t)used * fields * sizeof(double));
    }
    for (int64_t i = 0; i < used; i++) {
      all->places[kind][begin->used[kind] + i] = begin->count + piece->places[kind][i];
    }
  }
  if (piece->ids) memcpy(all->ids + begin->count, piece->ids, (size_t)piece->count * sizeof *piece->ids);
  free_shapes(piece);
}

// Room for the vertices of all pieces.
static int make_vertex_room(struct vertices* vertices) {
  if (vertices->count > INT32_MAX || vertices->ring_count > INT32_MAX) return 0;
  vertices->xy = malloc(2 * sizeof(double) * (size_t)vertices->count + 1);
  vertices->rings = malloc(sizeof(int32_t) * (size_t)(vertices->ring_count + 1));
  if (!vertices->xy || !vertices->rings) return 0;
  vertices->rings[0] = 0;
  return 1;
}

static void count_piece(struct shapes* all, const struct shapes* piece) {
  all->count += piece->count;
  for (int32_t kind = 0; kind < kind_count; kind++) {
    all->used[kind] += piece->used[kind];
    all->vertices[kind].count += piece->vertices[kind].count;
    all->vertices[kind].ring_count += piece->vertices[kind].ring_count;
  }
}

static int make_all_room(struct shapes* all, int with_ids) {
  for (int32_t kind = 0; kind < kind_count; kind++) {
    if (all->used[kind] == 0) continue;
    if (!make_room(all, kind, all->used[kind])) return 0;
    if (!has_vertices(kind)) continue;
    if (!make_vertex_room(&all->vertices[kind])) return 0;
    all->parts[kind][0] = 0;
  }
  return !with_ids || all->count == 0 || make_id_room(all, all->count);
}

int join_pieces(struct shapes* all, struct shapes* const pieces[], int64_t count, int threads) {
  struct appending appending = {all, pieces, malloc((size_t)(count + 1) * sizeof(struct shapes))};
  int with_ids = 0, good;
  if (!appending.begins) return 0;
  for (int64_t i = 0; i < count; i++) {
    appending.begins[i] = *all;
    count_piece(all, pieces[i]);
    with_ids |= pieces[i]->ids != NULL;
  }
  good = make_all_room(all, with_ids);
  if (good) run_parts(threads, "reading", count, append_piece, &appending);
  free(appending.begins);
  return good;
}

int64_t good_shapes(const struct shapes* shapes) {
  int64_t count = 0;
  for (int32_t kind = 0; kind < kind_count; kind++) count += shapes->used[kind];
  return count;
}

static void view_all(const struct shapes* shapes, int32_t kind, vesica_shapes_f64* set) {
  const struct vertices* vertices = &shapes->vertices[kind];
  const vesica_shapes_f64 all = {.kind = kind,
                                 .count = shapes->used[kind],
                                 .stride = 2 * sizeof(double),
                                 .field = {vertices->xy, vertices->xy + 1},
                                 .rings = vertices->rings,
                                 .polygons = shapes->parts[kind],
                                 .each = vertices->count};
  *set = all;
}

int32_t view_shapes(const struct shapes* shapes, vesica_shapes_f64 sets[kind_count], int64_t* places) {
  int32_t count = 0;
  for (int32_t kind = 0; kind < kind_count; kind++) {
    const int64_t used = shapes->used[kind];
    const ptrdiff_t record = vesica_field_count(kind) * (ptrdiff_t)sizeof(double);
    if (used == 0) continue;
    if (has_vertices(kind)) {
      view_all(shapes, kind, &sets[count++]);
    } else {
      vesica_shapes_from_records_f64(kind, used, shapes->numbers[kind], record, &sets[count++]);
    }
    memcpy(places, shapes->places[kind], (size_t)used * sizeof(int64_t));
    places += used;
  }
  return count;
}

void free_shapes(struct shapes* shapes) {
  for (int32_t kind = 0; kind < kind_count; kind++) {
    free(shapes->numbers[kind]);
    free(shapes->parts[kind]);
    free(shapes->places[kind]);
    free_vertices(&shapes->vertices[kind]);
  }
  free(shapes->ids);
  memset(shapes, 0, sizeof *shapes);
}
