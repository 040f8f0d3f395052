// SPDX-License-Identifier: Apache-2.0
/// Shapes in text, one a line: `circle 0 0 1`, numbers alone where their kind is given, or well-known text.
#include <stdlib.h>
#include <string.h>

#include "fields.h"
#include "line.h"
#include "source.h"
#include "wkt.h"

enum meaning { no_shape, good_shape, bad_shape };

// Names of columns, which a table may begin with.
static int is_header(const char* text, int32_t kind) {
  static const char* const first[] = {"x", "x0", "cx", "min_x", "cx", "cx", "x0", "cx", "x", "x"};
  const char* name = kind == any_kind ? "kind" : first[kind];
  const size_t length = strcspn(text, " \t,");
  return length == strlen(name) && strncmp(text, name, length) == 0;
}

// x y x y ..., one ring.
static int parse_vertices(char** rest, struct vertices* vertices, struct fault* fault) {
  const char* word;
  clear_vertices(vertices);
  while ((word = take_word(rest))) {
    double x, y;
    if (!parse_number(word, "x", &x, fault)) return 0;
    word = take_word(rest);
    if (!parse_number(word ? word : "", "y", &y, fault)) return 0;
    if (!add_vertex(vertices, x, y)) return fail(fault, "too many vertices");
  }
  if (vertices->count == 0) return fail(fault, "no vertices");
  return end_ring(vertices) || fail(fault, "too many vertices");
}

static int parse_words(char** rest, struct source* source, struct shape* shape, struct fault* fault) {
  const char *word = source->kind == any_kind ? take_word(rest) : NULL, *junk;
  shape->kind = word ? path_kind(word) : source->kind;
  if (has_vertices(shape->kind)) return parse_vertices(rest, &source->vertices, fault);
  if (!(source->kind == any_kind ? parse_shape(word, rest, source->name, shape, fault)
                                 : parse_numbers(rest, source->name, shape, fault)))
    return 0;
  junk = take_word(rest);
  return !junk || fail(fault, "'%.40s' after the shape", junk);
}

static int parse_geometry(const char* text, struct source* source, struct shape* shape, struct fault* fault) {
  char reason[geometry_fault_room];
  return parse_wkt(text, &source->vertices, &shape->kind, shape->numbers, reason) || fail(fault, "%s", reason);
}

static enum meaning parse_text(struct line* line, struct source* source, struct shape* shape, struct fault* fault) {
  char* rest = line->text;
  char* text;
  int parsed;
  if (line->fault) {
    fail(fault, "%s", line->fault);
    return bad_shape;
  }
  text = take_field(&rest, '#');
  if (!*text || (line->number == 1 && is_header(text, source->kind))) return no_shape;
  parsed = strchr(text, '(') ? parse_geometry(text, source, shape, fault) : parse_words(&text, source, shape, fault);
  return parsed && is_valid(source, shape, fault) ? good_shape : bad_shape;
}

int read_text(struct source* source) {
  struct line line = {.grows = 1};
  int good = 1;
  while (good && read_line(source->file, &line)) {
    char where[4096];
    struct shape shape;
    struct fault fault;
    const enum meaning meaning = parse_text(&line, source, &shape, &fault);
    if (line.number % 1024 == 0) show_reading(source);
    if (meaning == no_shape) continue;
    if (meaning == bad_shape) snprintf(where, sizeof where, "%s:%ld", source->path, line.number);
    good = take_shape(source, where, meaning == good_shape ? &shape : NULL, &fault);
  }
  free(line.text);
  return good;
}
