// SPDX-License-Identifier: Apache-2.0
/// Shapes in text, one a line: `circle 0 0 1`, numbers alone where their kind is given, or well-known text.
#include <string.h>

#include "number.h"
#include "rows.h"

// Names of columns, which lines of numbers may begin with.
static int is_header(const char* text, int32_t kind) {
  static const char* const first[] = {"x", "x0", "cx", "min_x", "cx", "cx", "x0", "cx", "x", "x"};
  const char* name = kind == any_kind ? "kind" : first[kind];
  const size_t length = strcspn(text, " \t,");
  return length == strlen(name) && strncmp(text, name, length) == 0;
}

// Cuts off and returns the next word between spaces, tabs and commas; NULL at the end.
static char* take_word(char** rest) {
  char* const word = *rest + strspn(*rest, " \t,");
  char* const end = word + strcspn(word, " \t,");
  if (word == end) return NULL;
  *rest = *end ? end + 1 : end;
  *end = '\0';
  return word;
}

// The next word as a number; `which` of `count` is how a reason calls it.
static int take_number(char** rest, char name, int which, int count, double* out, struct fault* fault) {
  const char* const word = take_word(rest);
  const char* const end = word ? parse_decimal(word, out) : NULL;
  if (end && end > word && !*end) return 1;
  if (!word) return fail(fault, "shape %c, number %d of %d is missing", name, which, count);
  return fail(fault, "shape %c, number %d of %d: '%.40s' is not a number", name, which, count, word);
}

// x y x y ..., one ring.
static int parse_vertices(char** rest, struct vertices* vertices, struct fault* fault) {
  const char* word;
  clear_vertices(vertices);
  while ((word = take_word(rest))) {
    double xy[2];
    for (int axis = 0; axis < 2; axis++) {
      const char* const end = word ? parse_decimal(word, &xy[axis]) : NULL;
      if (!word) return fail(fault, "y is missing");
      if (end == word || *end) return fail(fault, "%c: '%.40s' is not a number", 'x' + axis, word);
      if (axis == 0) word = take_word(rest);
    }
    if (!add_vertex(vertices, xy[0], xy[1])) return fail(fault, "too many vertices");
  }
  if (vertices->count == 0) return fail(fault, "no vertices");
  return end_ring(vertices) || fail(fault, "too many vertices");
}

static int parse_words(char* rest, struct row* row) {
  const char name = row->source->name;
  struct shape* const shape = &row->shape;
  const char* word;
  int count;
  shape->kind = row->source->kind;
  if (shape->kind == any_kind) {
    word = take_word(&rest);
    shape->kind = find_kind(word ? word : "");
    if (shape->kind < 0) return fail(&row->fault, "shape %c: unknown kind '%.40s'", name, word ? word : "");
  }
  if (has_vertices(shape->kind)) return parse_vertices(&rest, row->vertices, &row->fault);
  count = vesica_field_count(shape->kind);
  for (int i = 0; i < count; i++) {
    if (!take_number(&rest, name, i + 1, count, &shape->numbers[i], &row->fault)) return 0;
  }
  word = take_word(&rest);
  return !word || fail(&row->fault, "'%.40s' after the shape", word);
}

static int is_empty_geometry(const char* text) {
  const char* const word = strpbrk(text, " \t");
  return word && strncmp(word + strspn(word, " \t"), "EMPTY", 5) == 0;
}

static enum meaning read_line(const void* context, struct row* row) {
  char* const comment = strchr(row->at, '#');
  char* const text = row->at + strspn(row->at, " \t");
  (void)context;
  if (comment) *comment = '\0';
  if (!*text || (row->is_first && is_header(text, row->source->kind))) return no_shape;
  if (strchr(text, '(') || is_empty_geometry(text)) return read_known_text(text, row);
  if (!parse_words(text, row)) return bad_shape;
  return check_shape(&row->shape, row->vertices, row->source->name, &row->fault) ? good_shape : bad_shape;
}

int read_lines(struct source* source) { return read_rows(source, 0, 1, 0, NULL, read_line); }
