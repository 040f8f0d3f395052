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

static int parse(const char* text, struct shape* out, char* fault) {
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
int shape_from_text(const char* text, struct shape* out, char fault[shape_fault_room]) {
  const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0), before = uselocale(plain);
  const int good = parse(text, out, fault);
  uselocale(before);
  freelocale(plain);
  return good;
}

int shape_from_numbers(int32_t kind, const double* numbers, struct shape* out, char fault[shape_fault_room]) {
  const int32_t error = holds(kind) ? vesica_check_f64(kind, numbers) : VESICA_E_KIND;
  if (error == VESICA_E_KIND) return fail(fault, "%s", vesica_strerror(error));
  if (error < 0) return fail(fault, "invalid %s: %s", vesica_kind_name(kind), vesica_strerror(error));
  memset(out, 0, sizeof *out);
  out->kind = kind;
  memcpy(out->numbers, numbers, (size_t)vesica_field_count(kind) * sizeof *numbers);
  return 1;
}

enum { number_bytes = 8 };

int shape_from_blob(const unsigned char* blob, int bytes, struct shape* out, char fault[shape_fault_room]) {
  const int32_t kind = bytes < 1 ? VESICA_E_KIND : blob[0];
  const int count = vesica_field_count(kind);
  double numbers[shape_numbers];
  if (!holds(kind) || bytes != 1 + count * number_bytes)
    return fail(fault, "not a shape: a BLOB of vs_shape's, or words as 'circle 0 0 1'");
  for (int i = 0; i < count; i++) {
    uint64_t bits = 0;
    for (int k = number_bytes - 1; k >= 0; k--) bits = bits << 8 | blob[1 + i * number_bytes + k];
    memcpy(&numbers[i], &bits, sizeof bits);
  }
  return shape_from_numbers(kind, numbers, out, fault);
}

int shape_to_blob(const struct shape* shape, unsigned char out[shape_blob_room]) {
  unsigned char* at = out;
  *at++ = (unsigned char)shape->kind;
  for (int i = 0; i < vesica_field_count(shape->kind); i++) {
    uint64_t bits;
    memcpy(&bits, &shape->numbers[i], sizeof bits);
    for (int k = 0; k < number_bytes; k++) *at++ = (unsigned char)(bits >> 8 * k);
  }
  return (int)(at - out);
}

static int put_number(char* out, double number) {
  int length = 0;
  for (int digits = 15; digits <= 17; digits++) {
    length = snprintf(out, 32, " %.*g", digits, number);
    if (strtod(out, NULL) == number) break;
  }
  return length;
}

void shape_to_text(const struct shape* shape, char out[shape_text_room]) {
  const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0), before = uselocale(plain);
  out += snprintf(out, 16, "%s", vesica_kind_name(shape->kind));
  for (int i = 0; i < vesica_field_count(shape->kind); i++) out += put_number(out, shape->numbers[i]);
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
  if (vesica_bounds_f64(shape->kind, shape->numbers, &box) < 0) box = all;  // a side is beyond the finite numbers
  out->min_x = float_below(box.min_x);
  out->min_y = float_below(box.min_y);
  out->max_x = -float_below(-box.max_x);
  out->max_y = -float_below(-box.max_y);
}
