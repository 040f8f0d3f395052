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
  static const char* const first[] = {"x", "x0", "cx", "min_x", "cx", "cx", "x0", "cx"};
  const char* name = kind == any_kind ? "kind" : first[kind];
  const size_t length = strcspn(text, " \t,");
  return length == strlen(name) && strncmp(text, name, length) == 0;
}

static int parse_words(char** rest, const struct source* source, struct shape* shape, struct fault* fault) {
  const char* junk;
  if (source->kind == any_kind) {
    if (!parse_shape(take_word(rest), rest, source->name, shape, fault)) return 0;
  } else {
    shape->kind = source->kind;
    if (!parse_numbers(rest, source->name, shape, fault)) return 0;
  }
  junk = take_word(rest);
  return !junk || fail(fault, "'%.40s' after the shape", junk);
}

static int is_valid(const struct source* source, const struct shape* shape, struct fault* fault) {
  if (!has_vertices(shape->kind)) return check_shape(shape, source->name, fault);
  const vesica_polygon_f64 polygon = view_vertices(&source->vertices);
  const int32_t error = vesica_check_f64(shape->kind, &polygon);
  return error == 0 || fail(fault, "shape %c: %s", source->name, vesica_strerror(error));
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
  parsed =
      strchr(text, '(') ? parse_wkt(text, shape, &source->vertices, fault) : parse_words(&text, source, shape, fault);
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
