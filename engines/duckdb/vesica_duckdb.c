// SPDX-License-Identifier: Apache-2.0
/// Vesica's questions as functions of SQL, for DuckDB, by its C interface for extensions. A shape is a BLOB; README.md
/// lists all functions. A call answers a whole vector of rows.
#define DUCKDB_EXTENSION_NAME vesica
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "duckdb_extension.h"
#include "shape.h"

enum { most_arguments = shape_numbers };

union value {
  struct shape shape;
  double number;
  struct {
    const char* data;
    size_t length;
  } text;
};

/// Bytes of the last answer or words, in memory that grows.
struct bytes {
  char* data;
  size_t length, room;
};

struct result {
  bool truth;
  double number;
  struct bytes bytes;  // of a shape, or words
};

/// Memory that the rows of a call use one after the other.
struct memory {
  struct vertices vertices[2];
  struct bytes words;
  struct result result;
};

enum outcome { failed, null, good };

/// A function of SQL: what it takes and gives, and its answer for one row.
struct function {
  const char* name;
  int arguments;
  duckdb_type takes, gives;  // BLOB: shapes
  enum outcome (*answer)(const struct function* self, const union value* arguments, struct memory* memory, char* fault);
  int32_t which;  // a kind or a side
};

static enum outcome checked(int32_t code, char* fault) {
  if (code >= 0) return good;
  snprintf(fault, shape_fault_room, "%s", vesica_strerror(code));
  return failed;
}

// Returns room for this number of bytes, or NULL.
static char* room_of(struct bytes* bytes, size_t length) {
  if (length > bytes->room) {
    char* data = realloc(bytes->data, 2 * length);
    if (!data) return NULL;
    bytes->data = data;
    bytes->room = 2 * length;
  }
  bytes->length = length;
  return bytes->data;
}

static enum outcome no_memory(char* fault) {
  snprintf(fault, shape_fault_room, "out of memory");
  return failed;
}

// ---- Answers for one row ----

static enum outcome put_shape(int read, const struct shape* shape, struct result* out, char* fault) {
  char* bytes;
  if (!read) return failed;
  bytes = room_of(&out->bytes, shape_blob_size(shape));
  if (!bytes) return no_memory(fault);
  shape_to_blob(shape, (unsigned char*)bytes);
  return good;
}

// Words with a byte 0 are none.
static int read_words(const union value* v, struct memory* m, struct shape* out, char* fault) {
  char* words = room_of(&m->words, v->text.length + 1);
  if (!words) return no_memory(fault) == good;
  memcpy(words, v->text.data, v->text.length);
  words[v->text.length] = '\0';
  if (strlen(words) < v->text.length) words[0] = '\0';
  return shape_from_text(words, &m->vertices[0], out, fault);
}

static enum outcome from_words(const struct function* self, const union value* v, struct memory* m, char* fault) {
  struct shape shape;
  (void)self;
  return put_shape(read_words(v, m, &shape, fault), &shape, &m->result, fault);
}

static enum outcome from_wkb(const struct function* self, const union value* v, struct memory* m, char* fault) {
  struct shape shape;
  (void)self;
  return put_shape(
      shape_from_wkb((const unsigned char*)v[0].text.data, (int64_t)v[0].text.length, &m->vertices[0], &shape, fault),
      &shape, &m->result, fault);
}

static enum outcome from_numbers(const struct function* self, const union value* v, struct memory* m, char* fault) {
  double numbers[shape_numbers];
  struct shape shape;
  for (int i = 0; i < self->arguments; i++) numbers[i] = v[i].number;
  return put_shape(shape_from_numbers(self->which, numbers, &shape, fault), &shape, &m->result, fault);
}

static enum outcome valid(const struct function* self, const union value* v, struct memory* m, char* fault) {
  struct shape shape;
  (void)self;
  m->result.truth = read_words(v, m, &shape, fault);
  return good;
}

static enum outcome to_words(const struct function* self, const union value* v, struct memory* m, char* fault) {
  char* words = room_of(&m->result.bytes, shape_text_room(&v[0].shape));
  (void)self;
  if (!words) return no_memory(fault);
  shape_to_text(&v[0].shape, words);
  m->result.bytes.length = strlen(words);
  return good;
}

#define A v[0].shape.kind, shape_data(&v[0].shape)
#define B v[1].shape.kind, shape_data(&v[1].shape)

static enum outcome overlap(const struct function* self, const union value* v, struct memory* m, char* fault) {
  const int32_t answer = vesica_overlap_f64(A, B);
  (void)self;
  m->result.truth = answer > 0;
  return checked(answer, fault);
}

static enum outcome contains(const struct function* self, const union value* v, struct memory* m, char* fault) {
  const int32_t answer = vesica_contains_f64(A, B);
  (void)self;
  m->result.truth = answer > 0;
  return checked(answer, fault);
}

static enum outcome relation(const struct function* self, const union value* v, struct memory* m, char* fault) {
  const int32_t answer = vesica_relation_f64(A, B);
  (void)self;
  if (answer >= 0) {
    const char* name = relation_name(answer);
    char* words = room_of(&m->result.bytes, strlen(name));
    if (!words) return no_memory(fault);
    memcpy(words, name, strlen(name));
  }
  return checked(answer, fault);
}

static enum outcome distance(const struct function* self, const union value* v, struct memory* m, char* fault) {
  vesica_closest_points_f64 closest = {0, 0, 0, 0, 0};
  const int32_t code = vesica_nearest_f64(A, B, &closest);
  (void)self;
  m->result.number = closest.distance;
  return checked(code, fault);
}

static enum outcome shape_area(const struct function* self, const union value* v, struct memory* m, char* fault) {
  (void)self;
  return checked(vesica_shape_area_f64(A, &m->result.number), fault);
}

static enum outcome shared_area(const struct function* self, const union value* v, struct memory* m, char* fault) {
  (void)self;
  return checked(vesica_area_f64(A, B, &m->result.number), fault);
}

// Two shapes without area have no ratio.
static enum outcome iou(const struct function* self, const union value* v, struct memory* m, char* fault) {
  const int32_t code = vesica_iou_f64(A, B, &m->result.number);
  (void)self;
  return code == VESICA_E_ARGUMENT ? null : checked(code, fault);
}

static enum outcome bound(const struct function* self, const union value* v, struct memory* m, char* fault) {
  vesica_aabb_f64 box;
  double sides[4];
  (void)fault;
  shape_bounds(&v[0].shape, &box);
  memcpy(sides, &box, sizeof sides);
  m->result.number = sides[self->which];
  return good;
}

// ---- Vectors ----

DUCKDB_EXTENSION_EXTERN

static int read_value(const struct function* f, duckdb_vector vector, idx_t row, struct vertices* vertices,
                      union value* out, char* fault) {
  void* data = duckdb_vector_get_data(vector);
  duckdb_string_t* string = (duckdb_string_t*)data + row;
  if (f->takes == DUCKDB_TYPE_DOUBLE) {
    out->number = ((double*)data)[row];
    return 1;
  }
  if (f->takes == DUCKDB_TYPE_BLOB && f->answer != from_wkb)
    return shape_from_blob((const unsigned char*)duckdb_string_t_data(string), duckdb_string_t_length(*string),
                           vertices, &out->shape, fault);
  out->text.data = duckdb_string_t_data(string);
  out->text.length = duckdb_string_t_length(*string);
  return 1;
}

static void write_result(const struct function* f, const struct result* result, duckdb_vector out, idx_t row) {
  void* data = duckdb_vector_get_data(out);
  if (f->gives == DUCKDB_TYPE_DOUBLE) {
    ((double*)data)[row] = result->number;
  } else if (f->gives == DUCKDB_TYPE_BOOLEAN) {
    ((bool*)data)[row] = result->truth;
  } else {
    duckdb_vector_assign_string_element_len(out, row, result->bytes.data, (idx_t)result->bytes.length);
  }
}

static enum outcome answer_row(const struct function* f, duckdb_data_chunk input, idx_t row, struct memory* memory,
                               char* fault) {
  union value values[most_arguments];
  for (int i = 0; i < f->arguments; i++) {
    duckdb_vector vector = duckdb_data_chunk_get_vector(input, (idx_t)i);
    uint64_t* validity = duckdb_vector_get_validity(vector);
    if (validity && !duckdb_validity_row_is_valid(validity, row)) return null;
    if (!read_value(f, vector, row, &memory->vertices[i % 2], &values[i], fault)) return failed;
  }
  return f->answer(f, values, memory, fault);
}

static void answer_chunk(duckdb_function_info info, duckdb_data_chunk input, duckdb_vector out, struct memory* memory) {
  const struct function* f = duckdb_scalar_function_get_extra_info(info);
  const idx_t rows = duckdb_data_chunk_get_size(input);
  for (idx_t row = 0; row < rows; row++) {
    char fault[shape_fault_room] = "";
    switch (answer_row(f, input, row, memory, fault)) {
      case failed:
        duckdb_scalar_function_set_error(info, fault);
        return;
      case null:
        duckdb_vector_ensure_validity_writable(out);
        duckdb_validity_set_row_invalid(duckdb_vector_get_validity(out), row);
        break;
      case good:
        write_result(f, &memory->result, out, row);
    }
  }
}

static void answer_rows(duckdb_function_info info, duckdb_data_chunk input, duckdb_vector out) {
  struct memory memory = {0};
  answer_chunk(info, input, out, &memory);
  for (int i = 0; i < 2; i++) free_vertices(&memory.vertices[i]);
  free(memory.words.data);
  free(memory.result.bytes.data);
}

// ---- Registration ----

static bool add(duckdb_connection connection, const struct function* f) {
  duckdb_scalar_function function = duckdb_create_scalar_function();
  duckdb_logical_type takes = duckdb_create_logical_type(f->takes), gives = duckdb_create_logical_type(f->gives);
  bool added;
  duckdb_scalar_function_set_name(function, f->name);
  for (int i = 0; i < f->arguments; i++) duckdb_scalar_function_add_parameter(function, takes);
  duckdb_scalar_function_set_return_type(function, gives);
  duckdb_scalar_function_set_special_handling(function);  // NULL is looked at here
  duckdb_scalar_function_set_extra_info(function, (void*)f, NULL);
  duckdb_scalar_function_set_function(function, answer_rows);
  added = duckdb_register_scalar_function(connection, function) == DuckDBSuccess;
  duckdb_destroy_scalar_function(&function);
  duckdb_destroy_logical_type(&takes);
  duckdb_destroy_logical_type(&gives);
  return added;
}

static const struct function functions[] = {
    {"vs_shape", 1, DUCKDB_TYPE_VARCHAR, DUCKDB_TYPE_BLOB, from_words, 0},
    {"vs_from_wkb", 1, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_BLOB, from_wkb, 0},
    {"vs_valid", 1, DUCKDB_TYPE_VARCHAR, DUCKDB_TYPE_BOOLEAN, valid, 0},
    {"vs_text", 1, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_VARCHAR, to_words, 0},
    {"vs_point", 2, DUCKDB_TYPE_DOUBLE, DUCKDB_TYPE_BLOB, from_numbers, VESICA_POINT},
    {"vs_segment", 4, DUCKDB_TYPE_DOUBLE, DUCKDB_TYPE_BLOB, from_numbers, VESICA_SEGMENT},
    {"vs_circle", 3, DUCKDB_TYPE_DOUBLE, DUCKDB_TYPE_BLOB, from_numbers, VESICA_CIRCLE},
    {"vs_aabb", 4, DUCKDB_TYPE_DOUBLE, DUCKDB_TYPE_BLOB, from_numbers, VESICA_AABB},
    {"vs_rect", 6, DUCKDB_TYPE_DOUBLE, DUCKDB_TYPE_BLOB, from_numbers, VESICA_RECT},
    {"vs_ellipse", 6, DUCKDB_TYPE_DOUBLE, DUCKDB_TYPE_BLOB, from_numbers, VESICA_ELLIPSE},
    {"vs_capsule", 5, DUCKDB_TYPE_DOUBLE, DUCKDB_TYPE_BLOB, from_numbers, VESICA_CAPSULE},
    {"vs_round_rect", 7, DUCKDB_TYPE_DOUBLE, DUCKDB_TYPE_BLOB, from_numbers, VESICA_ROUND_RECT},
    {"vs_overlap", 2, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_BOOLEAN, overlap, 0},
    {"vs_contains", 2, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_BOOLEAN, contains, 0},
    {"vs_relation", 2, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_VARCHAR, relation, 0},
    {"vs_distance", 2, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_DOUBLE, distance, 0},
    {"vs_area", 1, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_DOUBLE, shape_area, 0},
    {"vs_shared_area", 2, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_DOUBLE, shared_area, 0},
    {"vs_iou", 2, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_DOUBLE, iou, 0},
    {"vs_min_x", 1, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_DOUBLE, bound, 0},
    {"vs_min_y", 1, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_DOUBLE, bound, 1},
    {"vs_max_x", 1, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_DOUBLE, bound, 2},
    {"vs_max_y", 1, DUCKDB_TYPE_BLOB, DUCKDB_TYPE_DOUBLE, bound, 3},
};

DUCKDB_EXTENSION_ENTRYPOINT(duckdb_connection connection, duckdb_extension_info info,
                            struct duckdb_extension_access* access) {
  bool added = true;
  if (vesica_version() < VESICA_VERSION) {
    access->set_error(info, "libvesica is older than this extension");
    return false;
  }
  for (size_t i = 0; added && i < sizeof functions / sizeof *functions; i++) added = add(connection, &functions[i]);
  if (!added) access->set_error(info, "vesica: a function cannot be registered");
  return added;
}
