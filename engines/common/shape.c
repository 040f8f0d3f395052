// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "shape.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wkb.h"
#include "wkt.h"

__attribute__((format(printf, 2, 3))) static int fail(char* fault, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(fault, shape_fault_room, format, arguments);
  va_end(arguments);
  return 0;
}

// The next word, or NULL; `*rest` moves behind it.
static const char* take_word(const char** rest, size_t* length) {
  const char* word = *rest + strspn(*rest, " \t\r\n,");
  *length = strcspn(word, " \t\r\n,");
  *rest = word + *length;
  return *length > 0 ? word : NULL;
}

// A library that is newer than this file may know kinds with more numbers.
static int holds(int32_t kind) {
  const int32_t count = vesica_field_count(kind);
  return count > 0 && count <= shape_numbers;
}

static int32_t find_kind(const char* word, size_t length) {
  for (int32_t kind = VESICA_POINT; holds(kind); kind++) {
    const char* name = vesica_kind_name(kind);
    if (strlen(name) == length && strncmp(name, word, length) == 0) return kind;
  }
  return VESICA_E_KIND;
}

int shape_has_path(int32_t kind) { return kind == VESICA_POLYGON || kind == VESICA_POLYLINE; }

const void* shape_data(const struct shape* shape) {
  return shape_has_path(shape->kind) ? (const void*)&shape->path : shape->numbers;
}

static int take_geometry(int32_t kind, const double* numbers, const struct vertices* vertices, struct shape* out,
                         char* fault) {
  int32_t error;
  if (!shape_has_path(kind)) return shape_from_numbers(kind, numbers, out, fault);
  *out = (struct shape){.kind = kind, .path = view_vertices(vertices)};
  error = vesica_check_f64(kind, &out->path);
  return error == 0 || fail(fault, "invalid %s: %s", vesica_kind_name(kind), vesica_strerror(error));
}

static int parse_geometry(const char* text, struct vertices* vertices, struct shape* out, char* fault) {
  int32_t kind;
  double numbers[4];
  return parse_wkt(text, vertices, &kind, numbers, fault) && take_geometry(kind, numbers, vertices, out, fault);
}

int shape_from_wkb(const unsigned char* bytes, int64_t count, struct vertices* vertices, struct shape* out,
                   char fault[shape_fault_room]) {
  int32_t kind;
  double numbers[4];
  return parse_wkb(bytes, count, vertices, &kind, numbers, fault) && take_geometry(kind, numbers, vertices, out, fault);
}

static int parse_words(const char* text, struct shape* out, char* fault) {
  double numbers[shape_numbers];
  size_t length;
  const char* word = take_word(&text, &length);
  const int32_t kind = word ? find_kind(word, length) : VESICA_E_KIND;
  if (kind < 0)
    return fail(fault, "unknown kind '%.*s'", word ? (int)(length < 40 ? length : 40) : 0, word ? word : "");
  for (int i = 0; i < vesica_field_count(kind); i++) {
    char* end;
    word = take_word(&text, &length);
    if (!word)
      return fail(fault, "%s: number %d of %d is missing", vesica_kind_name(kind), i + 1, vesica_field_count(kind));
    numbers[i] = strtod(word, &end);
    if (end != word + length) return fail(fault, "'%.*s' is not a number", (int)(length < 40 ? length : 40), word);
  }
  word = take_word(&text, &length);
  if (word) return fail(fault, "'%.*s' after the shape", (int)(length < 40 ? length : 40), word);
  return shape_from_numbers(kind, numbers, out, fault);
}

// Numbers have a point, whatever the host program's locale is.
int shape_from_text(const char* text, struct vertices* vertices, struct shape* out, char fault[shape_fault_room]) {
  const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0), before = uselocale(plain);
  const int good = strchr(text, '(') ? parse_geometry(text, vertices, out, fault) : parse_words(text, out, fault);
  uselocale(before);
  freelocale(plain);
  return good;
}

int shape_from_numbers(int32_t kind, const double* numbers, struct shape* out, char fault[shape_fault_room]) {
  const int32_t error = holds(kind) ? vesica_check_f64(kind, numbers) : VESICA_E_KIND;
  if (error == VESICA_E_KIND) return fail(fault, "%s", vesica_strerror(error));
  if (error < 0) return fail(fault, "invalid %s: %s", vesica_kind_name(kind), vesica_strerror(error));
  *out = (struct shape){.kind = kind};
  memcpy(out->numbers, numbers, (size_t)vesica_field_count(kind) * sizeof *numbers);
  return 1;
}

enum { number_bytes = 8, offset_bytes = 4 };

static uint64_t get(const unsigned char* at, int bytes) {
  uint64_t bits = 0;
  for (int k = bytes - 1; k >= 0; k--) bits = bits << 8 | at[k];
  return bits;
}

static unsigned char* put(unsigned char* at, uint64_t bits, int bytes) {
  for (int k = 0; k < bytes; k++) *at++ = (unsigned char)(bits >> 8 * k);
  return at;
}

static double get_double(const unsigned char* at) {
  const uint64_t bits = get(at, number_bytes);
  double number;
  memcpy(&number, &bits, sizeof number);
  return number;
}

static unsigned char* put_double(unsigned char* at, double number) {
  uint64_t bits;
  memcpy(&bits, &number, sizeof bits);
  return put(at, bits, number_bytes);
}

// Rings that end one behind the other, and as many vertices.
int shape_blob_counts(const unsigned char* blob, int64_t bytes, int64_t counts[2]) {
  uint64_t room, rings, end = 0;
  if (bytes < 1 + offset_bytes || !shape_has_path(blob[0])) return 0;
  room = (uint64_t)bytes - 1;
  rings = get(blob + 1, offset_bytes);
  if (rings == 0 || room / offset_bytes < 1 + rings) return 0;
  for (uint64_t j = 1; j <= rings; j++) {
    const uint64_t begin = end;
    end = get(blob + 1 + offset_bytes * j, offset_bytes);
    if (end <= begin) return 0;
  }
  counts[0] = (int64_t)end;
  counts[1] = (int64_t)rings;
  return room == offset_bytes * (1 + rings) + 2 * number_bytes * end;
}

static int take_path(const unsigned char* blob, int64_t bytes, struct vertices* vertices) {
  const unsigned char* at = blob + 1 + offset_bytes;
  int64_t counts[2], i = 0;
  if (!shape_blob_counts(blob, bytes, counts)) return 0;
  clear_vertices(vertices);
  at += offset_bytes * counts[1];
  for (int64_t j = 1; j <= counts[1]; j++) {
    const int64_t end = (int64_t)get(blob + 1 + offset_bytes * j, offset_bytes);
    for (; i < end; i++, at += 2 * number_bytes) {
      if (!add_vertex(vertices, get_double(at), get_double(at + number_bytes))) return 0;
    }
    if (!end_ring(vertices)) return 0;
  }
  return 1;
}

int shape_from_blob(const unsigned char* blob, int64_t bytes, struct vertices* vertices, struct shape* out,
                    char fault[shape_fault_room]) {
  static const char none[] = "not a shape: a BLOB of vs_shape's, or words as 'circle 0 0 1'";
  const int32_t kind = bytes < 1 ? VESICA_E_KIND : blob[0];
  double numbers[shape_numbers];
  if (shape_has_path(kind)) {
    if (!take_path(blob, bytes, vertices)) return fail(fault, none);
    *out = (struct shape){.kind = kind, .path = view_vertices(vertices)};
    return 1;
  }
  if (!holds(kind) || bytes != 1 + vesica_field_count(kind) * number_bytes) return fail(fault, none);
  for (int i = 0; i < vesica_field_count(kind); i++) numbers[i] = get_double(blob + 1 + i * number_bytes);
  return shape_from_numbers(kind, numbers, out, fault);
}

size_t shape_blob_size(const struct shape* shape) {
  const vesica_polygon_f64* path = &shape->path;
  if (!shape_has_path(shape->kind)) return 1 + number_bytes * (size_t)vesica_field_count(shape->kind);
  return 1 + offset_bytes * (1 + (size_t)path->count) + 2 * number_bytes * (size_t)path->rings[path->count];
}

void shape_to_blob(const struct shape* shape, unsigned char* out) {
  const vesica_polygon_f64* path = &shape->path;
  *out++ = (unsigned char)shape->kind;
  if (!shape_has_path(shape->kind)) {
    for (int i = 0; i < vesica_field_count(shape->kind); i++) out = put_double(out, shape->numbers[i]);
    return;
  }
  out = put(out, (uint64_t)path->count, offset_bytes);
  for (int64_t j = 1; j <= path->count; j++) out = put(out, (uint64_t)path->rings[j], offset_bytes);
  for (int64_t i = 0; i < 2 * (int64_t)path->rings[path->count]; i++) out = put_double(out, path->x[i]);
}

enum { digits_room = 32, name_room = 32 };

static char* put_number(char* out, double number) {
  int length = 0;
  for (int digits = 15; digits <= 17; digits++) {
    length = snprintf(out, digits_room, "%.*g", digits, number);
    if (strtod(out, NULL) == number) break;
  }
  return out + length;
}

// Well-known text. By the even-odd rule the rings of a MULTIPOLYGON mean the same as those of a POLYGON.
static void put_path(const struct shape* shape, char* out) {
  const vesica_polygon_f64* path = &shape->path;
  const int points = path->rings[path->count] == path->count;
  const int lines = shape->kind == VESICA_POLYLINE && path->count > 1;
  const int wraps = lines || shape->kind == VESICA_POLYGON;
  out += snprintf(out, name_room, "%s",
                  shape->kind == VESICA_POLYGON ? "POLYGON ("
                  : lines && points             ? "MULTIPOINT ("
                  : lines                       ? "MULTILINESTRING ("
                                                : "LINESTRING ");
  for (int64_t j = 0; j < path->count; j++) {
    if (j > 0) *out++ = ',', *out++ = ' ';
    for (int64_t i = path->rings[j]; i < path->rings[j + 1]; i++) {
      *out++ = i == path->rings[j] ? '(' : ',';
      if (i > path->rings[j]) *out++ = ' ';
      out = put_number(out, path->x[2 * i]);
      *out++ = ' ';
      out = put_number(out, path->x[2 * i + 1]);
    }
    *out++ = ')';
  }
  if (wraps) *out++ = ')';
  *out = '\0';
}

static void put_words(const struct shape* shape, char* out) {
  out += snprintf(out, name_room, "%s", vesica_kind_name(shape->kind));
  for (int i = 0; i < vesica_field_count(shape->kind); i++) {
    *out++ = ' ';
    out = put_number(out, shape->numbers[i]);
  }
}

size_t shape_text_room(const struct shape* shape) {
  const vesica_polygon_f64* path = &shape->path;
  if (!shape_has_path(shape->kind)) return name_room + digits_room * shape_numbers;
  return name_room + 4 * (size_t)path->count + 2 * digits_room * (size_t)path->rings[path->count];
}

void shape_to_text(const struct shape* shape, char* out) {
  const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0), before = uselocale(plain);
  if (shape_has_path(shape->kind))
    put_path(shape, out);
  else
    put_words(shape, out);
  uselocale(before);
  freelocale(plain);
}

const char* relation_name(int32_t relation) {
  static const char* const names[] = {"disjoint",     "touch",    "cross",          "inside",
                                      "inside touch", "contains", "contains touch", "equal"};
  return names[relation];
}

static double float_below(double x) {
  float f;
  if (x >= (double)FLT_MAX) return (double)FLT_MAX;
  if (x <= -(double)FLT_MAX) return -(double)FLT_MAX;
  f = (float)x;
  return (double)((double)f > x ? nextafterf(f, -FLT_MAX) : f);
}

void shape_bounds(const struct shape* shape, vesica_aabb_f64* out) {
  const vesica_aabb_f64 all = {-DBL_MAX, -DBL_MAX, DBL_MAX, DBL_MAX};
  vesica_aabb_f64 box;
  if (vesica_bounds_f64(shape->kind, shape_data(shape), &box) < 0) box = all;  // a side is beyond the finite numbers
  out->min_x = float_below(box.min_x);
  out->min_y = float_below(box.min_y);
  out->max_x = -float_below(-box.max_x);
  out->max_y = -float_below(-box.max_y);
}
