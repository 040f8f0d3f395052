// SPDX-License-Identifier: Apache-2.0
#include "fields.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vesica.h>

#include "query.h"

int fail(struct fault* fault, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(fault->text, sizeof fault->text, format, arguments);
  va_end(arguments);
  for (char* c = fault->text; *c; c++) {
    if (*c < ' ' || *c > '~') *c = '?';
  }
  return 0;
}

static int is_space(char c) { return c == ' ' || c == '\t'; }

char* take_field(char** rest, char separator) {
  char *field = *rest, *next, *end;
  if (!field) return NULL;
  next = strchr(field, separator);
  end = next ? next : field + strlen(field);
  *rest = next ? next + 1 : NULL;
  while (end > field && is_space(end[-1])) end--;
  *end = '\0';
  while (is_space(*field)) field++;
  return field;
}

char* take_word(char** rest) {
  char* word = *rest + strspn(*rest, " \t,");
  char* end = word + strcspn(word, " \t,");
  if (word == end) return NULL;
  *rest = *end ? end + 1 : end;
  *end = '\0';
  return word;
}

int32_t find_kind(const char* name) {
  // A newer library may know kinds with more numbers.
  for (int32_t kind = VESICA_POINT; kind <= VESICA_ROUND_RECT; kind++) {
    if (strcmp(vesica_kind_name(kind), name) == 0) return kind;
  }
  return VESICA_E_KIND;
}

int parse_number(const char* text, const char* name, double* out, struct fault* fault) {
  char* end;
  if (!*text) return fail(fault, "%s is missing", name);
  *out = strtod(text, &end);
  if (end == text || *end) return fail(fault, "%s: '%.40s' is not a number", name, text);
  return 1;
}

int parse_numbers(char** rest, char name, struct shape* shape, struct fault* fault) {
  char which[48];
  const int count = vesica_field_count(shape->kind);
  for (int i = 0; i < count; i++) {
    const char* word = take_word(rest);
    snprintf(which, sizeof which, "shape %c, number %d of %d", name, i + 1, count);
    if (!parse_number(word ? word : "", which, &shape->numbers[i], fault)) return 0;
  }
  return 1;
}

int parse_shape(const char* kind, char** rest, char name, struct shape* shape, struct fault* fault) {
  if (!kind) return fail(fault, "shape %c is missing", name);
  shape->kind = find_kind(kind);
  if (shape->kind < 0) return fail(fault, "shape %c: unknown kind '%.40s'", name, kind);
  return parse_numbers(rest, name, shape, fault);
}

int parse_known(const char* text, struct pair* pair, struct fault* fault) {
  if (pair->query->yes_no && strcmp(text, "0") != 0 && strcmp(text, "1") != 0) {
    return fail(fault, "known answer '%.40s' is not 0 or 1", text);
  }
  if (!parse_number(text, "known answer", &pair->known, fault)) return 0;
  if (!isfinite(pair->known)) return fail(fault, "known answer '%.40s' is not finite", text);
  pair->has_known = 1;
  return 1;
}

int check_shape(const struct shape* shape, char name, struct fault* fault) {
  const int32_t reason = vesica_check_f64(shape->kind, shape->numbers);
  if (reason == 0) return 1;
  return fail(fault, "shape %c (%s) is invalid: %s", name, vesica_kind_name(shape->kind), vesica_strerror(reason));
}
