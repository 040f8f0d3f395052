// SPDX-License-Identifier: Apache-2.0
/// Vesica's questions as functions of SQL, for SQLite. A shape is a BLOB, or its words as text. README.md lists all.
#include <sqlite3ext.h>
#include <string.h>

#include "shape.h"
SQLITE_EXTENSION_INIT1

// ---- Arguments: 1 for a shape, 0 for NULL, -1 with the reason in `fault` ----

static int read_shape(sqlite3_value* value, struct vertices* vertices, struct shape* out,
                      char fault[shape_fault_room]) {
  switch (sqlite3_value_type(value)) {
    case SQLITE_NULL:
      return 0;
    case SQLITE_BLOB:
      return shape_from_blob(sqlite3_value_blob(value), sqlite3_value_bytes(value), vertices, out, fault) ? 1 : -1;
    case SQLITE_TEXT: {
      const char* text = (const char*)sqlite3_value_text(value);
      if (!text) break;
      return shape_from_text(text, vertices, out, fault) ? 1 : -1;
    }
    default:
      break;
  }
  return shape_from_blob(NULL, 0, vertices, out, fault) - 1;
}

static void return_shape(sqlite3_context* context, const struct shape* shape) {
  const size_t bytes = shape_blob_size(shape);
  unsigned char* blob = sqlite3_malloc64(bytes);
  if (!blob) {
    sqlite3_result_error_nomem(context);
    return;
  }
  shape_to_blob(shape, blob);
  sqlite3_result_blob64(context, blob, bytes, sqlite3_free);
}

/// The shapes of a call, whose vertices must be freed.
struct arguments {
  struct shape s[2];
  struct vertices vertices[2];
};

// All of them, or 0 where the answer is NULL or an error, which it then is.
static int take_shapes(sqlite3_context* context, int count, sqlite3_value** values, struct arguments* out) {
  char fault[shape_fault_room];
  int good = 1;
  memset(out->vertices, 0, sizeof out->vertices);
  for (int i = 0; i < count; i++) {
    const int read = read_shape(values[i], &out->vertices[i], &out->s[i], fault);
    if (read < 0) {
      sqlite3_result_error(context, fault, -1);
      return 0;
    }
    good &= read;
  }
  return good;
}

static void free_shapes(struct arguments* arguments) {
  for (int i = 0; i < 2; i++) free_vertices(&arguments->vertices[i]);
}

static int failed(sqlite3_context* context, int32_t code) {
  if (code < 0) sqlite3_result_error(context, vesica_strerror(code), -1);
  return code < 0;
}

// ---- Shapes in and out ----

static void to_shape(sqlite3_context* context, int count, sqlite3_value** values) {
  struct arguments taken;
  if (take_shapes(context, count, values, &taken)) return_shape(context, &taken.s[0]);
  free_shapes(&taken);
}

static void from_wkb(sqlite3_context* context, int count, sqlite3_value** values) {
  struct shape shape;
  struct vertices vertices = {0};
  char fault[shape_fault_room];
  (void)count;
  if (sqlite3_value_type(values[0]) == SQLITE_NULL) return;
  if (shape_from_wkb(sqlite3_value_blob(values[0]), sqlite3_value_bytes(values[0]), &vertices, &shape, fault))
    return_shape(context, &shape);
  else
    sqlite3_result_error(context, fault, -1);
  free_vertices(&vertices);
}

static void to_text(sqlite3_context* context, int count, sqlite3_value** values) {
  struct arguments taken;
  if (take_shapes(context, count, values, &taken)) {
    char* text = sqlite3_malloc64(shape_text_room(&taken.s[0]));
    if (text) {
      shape_to_text(&taken.s[0], text);
      sqlite3_result_text(context, text, -1, sqlite3_free);
    } else {
      sqlite3_result_error_nomem(context);
    }
  }
  free_shapes(&taken);
}

static void is_valid(sqlite3_context* context, int count, sqlite3_value** values) {
  struct shape shape;
  struct vertices vertices = {0};
  char fault[shape_fault_room];
  const int read = read_shape(values[0], &vertices, &shape, fault);
  (void)count;
  if (read) sqlite3_result_int(context, read > 0 && vesica_check_f64(shape.kind, shape_data(&shape)) == 0);
  free_vertices(&vertices);
}

// vs_point, vs_segment ...: the kind is the function's own.
static void from_numbers(sqlite3_context* context, int count, sqlite3_value** values) {
  const int32_t* kind = sqlite3_user_data(context);
  double numbers[shape_numbers];
  struct shape shape;
  char fault[shape_fault_room];
  for (int i = 0; i < count; i++) {
    const int type = sqlite3_value_numeric_type(values[i]);
    if (type == SQLITE_NULL) return;
    if (type != SQLITE_INTEGER && type != SQLITE_FLOAT) {
      sqlite3_result_error(context, "not a number", -1);
      return;
    }
    numbers[i] = sqlite3_value_double(values[i]);
  }
  if (shape_from_numbers(*kind, numbers, &shape, fault))
    return_shape(context, &shape);
  else
    sqlite3_result_error(context, fault, -1);
}

// ---- Questions ----

typedef int32_t decide(int32_t kind_a, const void* a, int32_t kind_b, const void* b);

#define A t.s[0].kind, shape_data(&t.s[0])
#define B t.s[1].kind, shape_data(&t.s[1])

static int ask(sqlite3_context* context, sqlite3_value** values, decide* question, int32_t* answer) {
  struct arguments t;
  int good = take_shapes(context, 2, values, &t);
  if (good) {
    *answer = question(A, B);
    good = !failed(context, *answer);
  }
  free_shapes(&t);
  return good;
}

static void overlap(sqlite3_context* context, int count, sqlite3_value** values) {
  int32_t answer;
  (void)count;
  if (ask(context, values, vesica_overlap_f64, &answer)) sqlite3_result_int(context, answer);
}

static void contains(sqlite3_context* context, int count, sqlite3_value** values) {
  int32_t answer;
  (void)count;
  if (ask(context, values, vesica_contains_f64, &answer)) sqlite3_result_int(context, answer);
}

static void relation(sqlite3_context* context, int count, sqlite3_value** values) {
  int32_t answer;
  (void)count;
  if (ask(context, values, vesica_relation_f64, &answer))
    sqlite3_result_text(context, relation_name(answer), -1, SQLITE_STATIC);
}

static void distance(sqlite3_context* context, int count, sqlite3_value** values) {
  struct arguments t;
  vesica_closest_points_f64 closest;
  if (take_shapes(context, count, values, &t) && !failed(context, vesica_nearest_f64(A, B, &closest)))
    sqlite3_result_double(context, closest.distance);
  free_shapes(&t);
}

static void area(sqlite3_context* context, int count, sqlite3_value** values) {
  struct arguments t;
  double out;
  if (take_shapes(context, count, values, &t) &&
      !failed(context, count == 1 ? vesica_shape_area_f64(A, &out) : vesica_area_f64(A, B, &out)))
    sqlite3_result_double(context, out);
  free_shapes(&t);
}

// Two shapes without area have no ratio: NULL.
static void iou(sqlite3_context* context, int count, sqlite3_value** values) {
  struct arguments t;
  double out;
  if (take_shapes(context, count, values, &t)) {
    const int32_t code = vesica_iou_f64(A, B, &out);
    if (code != VESICA_E_ARGUMENT && !failed(context, code)) sqlite3_result_double(context, out);
  }
  free_shapes(&t);
}

// vs_min_x ... vs_max_y: the side is the function's own.
static void bound(sqlite3_context* context, int count, sqlite3_value** values) {
  const size_t* side = sqlite3_user_data(context);
  struct arguments t;
  vesica_aabb_f64 box;
  double sides[4];
  if (take_shapes(context, count, values, &t)) {
    shape_bounds(&t.s[0], &box);
    memcpy(sides, &box, sizeof sides);
    sqlite3_result_double(context, sides[*side]);
  }
  free_shapes(&t);
}

typedef void function(sqlite3_context* context, int count, sqlite3_value** values);

static int add(sqlite3* db, const char* name, int count, void* user, function* body) {
  const int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS;
  return sqlite3_create_function_v2(db, name, count, flags, user, body, NULL, NULL, NULL);
}

static int add_constructors(sqlite3* db) {
  static int32_t kinds[] = {VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE,  VESICA_AABB,
                            VESICA_RECT,  VESICA_ELLIPSE, VESICA_CAPSULE, VESICA_ROUND_RECT};
  int code = SQLITE_OK;
  for (size_t i = 0; code == SQLITE_OK && i < sizeof kinds / sizeof *kinds; i++) {
    char name[32];
    sqlite3_snprintf(sizeof name, name, "vs_%s", vesica_kind_name(kinds[i]));
    code = add(db, name, vesica_field_count(kinds[i]), &kinds[i], from_numbers);
  }
  return code;
}

__attribute__((visibility("default"))) int sqlite3_vesicasqlite_init(sqlite3* db, char** error,
                                                                     const sqlite3_api_routines* api);

int sqlite3_vesicasqlite_init(sqlite3* db, char** error, const sqlite3_api_routines* api) {
  static size_t sides[] = {0, 1, 2, 3};
  static const struct {
    const char* name;
    int count;
    void* user;
    function* body;
  } functions[] = {
      {"vs_from_wkb", 1, NULL, from_wkb}, {"vs_shape", 1, NULL, to_shape},    {"vs_text", 1, NULL, to_text},
      {"vs_valid", 1, NULL, is_valid},    {"vs_overlap", 2, NULL, overlap},   {"vs_contains", 2, NULL, contains},
      {"vs_relation", 2, NULL, relation}, {"vs_distance", 2, NULL, distance}, {"vs_area", 1, NULL, area},
      {"vs_area", 2, NULL, area},         {"vs_iou", 2, NULL, iou},           {"vs_min_x", 1, &sides[0], bound},
      {"vs_min_y", 1, &sides[1], bound},  {"vs_max_x", 1, &sides[2], bound},  {"vs_max_y", 1, &sides[3], bound},
  };
  int code;
  SQLITE_EXTENSION_INIT2(api);
  if (vesica_version() < VESICA_VERSION) {
    *error =
        sqlite3_mprintf("libvesica %d is older than this extension, which needs %d", vesica_version(), VESICA_VERSION);
    return SQLITE_ERROR;
  }
  code = add_constructors(db);
  for (size_t i = 0; code == SQLITE_OK && i < sizeof functions / sizeof *functions; i++)
    code = add(db, functions[i].name, functions[i].count, functions[i].user, functions[i].body);
  return code;
}
