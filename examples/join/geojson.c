// SPDX-License-Identifier: Apache-2.0
/// Geometries in GeoJSON: a document of any kind, or one after the other, as lines or sequences have them. The file is
/// read once, and nothing but the geometry at hand is kept. Each geometry is a shape; one that is null or has no
/// coordinates keeps its number.
#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>
#include <string.h>

#include "fields.h"
#include "geometry.h"
#include "source.h"

enum { most_depth = 64, word_room = 32, number_room = 512 };

struct reader {
  struct source* source;
  int next;         // character, or EOF
  long line;        // that it is on
  int64_t feature;  // its number in a collection, or -1
};

struct object {
  char type[word_room];
  long line;
  int brackets;  // around its coordinates' numbers; 0 without numbers, -1 without coordinates
  int children;
  struct fault fault;  // of its coordinates, or empty
};

static void advance(struct reader* r) {
  if (r->next == '\n') r->line++;
  r->next = getc_unlocked(r->source->file);
}

// Text that is no JSON ends the reading.
static int stop(const struct reader* r, const char* reason) {
  struct fault fault;
  if (ferror(r->source->file)) return 0;
  fail(&fault, "line %ld: %s%s", r->line, r->next == EOF ? "ends here: " : "", reason);
  return refuse_source(r->source, fault.text);
}

static void skip_space(struct reader* r) {
  while (r->next == ' ' || r->next == '\t' || r->next == '\n' || r->next == '\r' || r->next == record_separator) {
    advance(r);
  }
}

static int take_mark(struct reader* r, int mark) {
  skip_space(r);
  if (r->next != mark) return 0;
  advance(r);
  return 1;
}

// As it is written, with escapes; cut off to fit.
static int take_string(struct reader* r, char out[word_room]) {
  size_t length = 0;
  if (!take_mark(r, '"')) return stop(r, "a string is missing");
  while (r->next != '"') {
    const int escape = r->next == '\\';
    if (length + 1 < word_room) out[length++] = (char)r->next;
    if (escape) advance(r);
    if (r->next == EOF) return stop(r, "a string without end");
    advance(r);
  }
  out[length] = '\0';
  advance(r);
  return 1;
}

// A number, true, false or null; cut off to fit.
static size_t take_literal(struct reader* r, char out[number_room]) {
  size_t length = 0;
  while ((r->next >= '0' && r->next <= '9') || (r->next >= 'a' && r->next <= 'z') || r->next == '-' || r->next == '+' ||
         r->next == '.' || r->next == 'E') {
    if (length + 1 < number_room) out[length++] = (char)r->next;
    advance(r);
  }
  out[length] = '\0';
  return length;
}

// A value of any kind. Whether brackets suit each other is not looked at.
static int skip_value(struct reader* r) {
  char word[word_room], literal[number_room];
  int depth = 0;
  do {
    skip_space(r);
    if (r->next == '"') {
      if (!take_string(r, word)) return 0;
    } else if (r->next == '{' || r->next == '[') {
      depth++;
      advance(r);
    } else if (depth > 0 && strchr("}],:", r->next) && r->next != EOF) {
      depth -= r->next == '}' || r->next == ']';
      advance(r);
    } else if (take_literal(r, literal) == 0) {
      return stop(r, "a value is missing");
    }
  } while (depth > 0);
  return 1;
}

// ---- Coordinates ----

// Notes the first fault of an object.
static void note(struct object* o, const char* reason) {
  if (!o->fault.text[0]) fail(&o->fault, "%s", reason);
}

struct position {
  double xy[2];
  int numbers;
};

static void end_position(struct object* o, struct vertices* vertices, struct position* position) {
  if (position->numbers < 2) {
    note(o, "not positions of two numbers");
  } else if (!add_vertex(vertices, position->xy[0], position->xy[1])) {
    note(o, "too many positions");
  }
  position->numbers = 0;
}

static void close_ring(struct object* o, struct vertices* vertices) {
  const int64_t begin = vertices->ring_count > 0 ? vertices->rings[vertices->ring_count] : 0;
  if (vertices->count > begin && !end_ring(vertices)) note(o, "too many rings");
}

static void add_number(struct object* o, const char* text, int depth, struct position* position) {
  char* end;
  const double number = strtod(text, &end);
  if (end == text || *end || (*text != '-' && (*text < '0' || *text > '9'))) note(o, "coordinates are not numbers");
  if (o->brackets == 0) o->brackets = depth;
  if (o->brackets != depth) note(o, "positions at unlike depths");
  if (position->numbers < 2) position->xy[position->numbers++] = number;
}

static void close_bracket(struct object* o, struct vertices* vertices, int depth, struct position* position) {
  if (o->brackets == 0) return;
  if (depth == o->brackets) end_position(o, vertices, position);
  if (depth == o->brackets - 1 || o->brackets == 1) close_ring(o, vertices);
}

// Arrays of arrays of numbers. How deep they are says later, beside the type, whether they are good.
static int take_coordinates(struct reader* r, struct object* o) {
  struct vertices* vertices = &r->source->vertices;
  struct position position = {{0, 0}, 0};
  int depth = 0;
  clear_vertices(vertices);
  o->brackets = 0;
  do {
    char literal[number_room];
    if (take_mark(r, '[')) {
      depth++;
    } else if (depth > 0 && r->next == ']') {
      close_bracket(o, vertices, depth--, &position);
      advance(r);
    } else if (depth > 0 && r->next == ',') {
      advance(r);
    } else if (depth > 0 && r->next != '"' && r->next != '{') {
      if (take_literal(r, literal) == 0) return stop(r, "coordinates without end");
      add_number(o, literal, depth, &position);
    } else {
      note(o, "coordinates are not numbers");
      if (!skip_value(r)) return 0;
    }
  } while (depth > 0);
  return 1;
}

// ---- Objects ----

static int settle(struct reader* r, struct object* o, struct shape* shape) {
  const struct geometry* geometry = find_geometry(o->type, strlen(o->type));
  char reason[geometry_fault_room];
  if (!geometry) return fail(&o->fault, "'%s' is no Point, LineString or Polygon", o->type);
  if (o->brackets < 0) return fail(&o->fault, "a %s without coordinates", o->type);
  if (o->fault.text[0]) return 0;
  if (o->brackets == 0) return 1;
  if (o->brackets != geometry->brackets) return fail(&o->fault, "coordinates of no %s", o->type);
  if (!settle_geometry(geometry, &r->source->vertices, &shape->kind, shape->numbers, reason)) {
    return fail(&o->fault, "%s", reason);
  }
  return is_valid(r->source, shape, &o->fault);
}

static int end_object(struct reader* r, struct object* o) {
  struct source* source = r->source;
  struct shape shape;
  char where[4096];
  int good;
  if (o->brackets < 0 && (o->children || strcmp(o->type, "Feature") == 0)) return 1;
  if (o->children) note(o, "coordinates beside other geometries");
  good = settle(r, o, &shape);
  if (good && o->brackets == 0) {
    source->shapes.count++;
    return 1;
  }
  snprintf(where, sizeof where, "%s:%ld", source->path, o->line);
  if (r->feature >= 0) {
    const size_t length = strlen(where);
    snprintf(where + length, sizeof where - length, ": feature %lld", (long long)r->feature);
  }
  if (source->shapes.count % 1024 == 0) show_reading(source);
  return take_shape(source, where, good ? &shape : NULL, &o->fault);
}

static int take_object(struct reader* r, int depth);

static int take_geometry(struct reader* r, int depth) {
  skip_space(r);
  if (r->next == '{') return take_object(r, depth + 1);
  r->source->shapes.count++;  // null
  return skip_value(r);
}

static int take_array(struct reader* r, int are_features, int depth) {
  int64_t number = 0;
  if (!take_mark(r, '[')) return stop(r, "'[' is missing");
  if (take_mark(r, ']')) return 1;
  do {
    if (are_features) r->feature = number++;
    if (!take_object(r, depth + 1)) return 0;
  } while (take_mark(r, ','));
  if (are_features) r->feature = -1;
  return take_mark(r, ']') || stop(r, "',' or ']' is missing");
}

static int take_member(struct reader* r, struct object* o, int depth) {
  char name[word_room];
  int features;
  if (!take_string(r, name)) return 0;
  if (!take_mark(r, ':')) return stop(r, "':' is missing");
  skip_space(r);
  if (strcmp(name, "type") == 0 && r->next == '"') return take_string(r, o->type);
  if (strcmp(name, "coordinates") == 0) return take_coordinates(r, o);
  features = strcmp(name, "features") == 0;
  if (features || strcmp(name, "geometries") == 0) {
    o->children = 1;
    return take_array(r, features, depth);
  }
  if (strcmp(name, "geometry") != 0) return skip_value(r);
  o->children = 1;
  return take_geometry(r, depth);
}

static int take_object(struct reader* r, int depth) {
  struct object o = {.brackets = -1, .line = r->line};
  if (depth == most_depth) return stop(r, "objects in more than 64 objects");
  if (!take_mark(r, '{')) return stop(r, "'{' is missing");
  if (!take_mark(r, '}')) {
    do {
      if (!take_member(r, &o, depth)) return 0;
    } while (take_mark(r, ','));
    if (!take_mark(r, '}')) return stop(r, "',' or '}' is missing");
  }
  return end_object(r, &o);
}

int read_geojson(struct source* source) {
  struct reader r = {source, '\0', 1, -1};
  advance(&r);
  skip_space(&r);
  while (r.next != EOF) {
    if (!take_object(&r, 0)) return ferror(source->file) != 0;
    skip_space(&r);
  }
  return 1;
}
