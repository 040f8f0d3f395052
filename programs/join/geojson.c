// SPDX-License-Identifier: Apache-2.0
/// Geometries in GeoJSON: a document of any kind, or one after the other, as lines or sequences have them. Each
/// geometry is a shape; one that is null or has no coordinates keeps its number. Shapes have the id of their feature:
/// its member of that name, or the one in its properties.
#include <stdlib.h>
#include <string.h>

#include "geometry.h"
#include "number.h"
#include "source.h"

enum { most_depth = 64, word_room = 32, literal_room = 512 };

struct reader {
  struct source* source;
  char *at, *end;
  int next;         // the character there, or EOF
  long line;        // that it is on
  int64_t feature;  // its number in a collection, or -1
};

struct object {
  char type[word_room];
  long line;
  int brackets;  // around its coordinates' numbers; 0 without numbers, -1 without coordinates
  int children;
  struct fault fault;  // of its coordinates, or empty
  int64_t first;       // the number of its first shape
  struct id id;
};

static void advance(struct reader* r) {
  if (r->next == '\n') r->line++;
  r->at++;
  r->next = r->at < r->end ? (unsigned char)*r->at : EOF;
}

static void jump(struct reader* r, const char* at) {
  r->at += at - r->at;
  r->next = r->at < r->end ? (unsigned char)*r->at : EOF;
}

// Text that is no JSON ends the reading.
static int stop(const struct reader* r, const char* reason) {
  struct fault fault;
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
static size_t take_literal(struct reader* r, char out[literal_room]) {
  size_t length = 0;
  while ((r->next >= '0' && r->next <= '9') || (r->next >= 'a' && r->next <= 'z') || r->next == '-' || r->next == '+' ||
         r->next == '.' || r->next == 'E') {
    if (length + 1 < literal_room) out[length++] = (char)r->next;
    advance(r);
  }
  out[length] = '\0';
  return length;
}

// A value of any kind. Whether brackets suit each other is not looked at.
static int skip_value(struct reader* r) {
  char word[word_room], literal[literal_room];
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

// Moves behind a number; what else it may be is not looked at.
static int take_number(struct reader* r, double* out) {
  const char* end;
  if (r->next != '-' && (r->next < '0' || r->next > '9')) return 0;
  end = parse_decimal(r->at, out);
  if (end == r->at || (*end >= 'a' && *end <= 'z')) return 0;
  jump(r, end);
  return 1;
}

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

static void add_number(struct object* o, double number, int depth, struct position* position) {
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
    char literal[literal_room];
    double number;
    if (take_mark(r, '[')) {
      depth++;
    } else if (depth > 0 && r->next == ']') {
      close_bracket(o, vertices, depth--, &position);
      advance(r);
    } else if (depth > 0 && r->next == ',') {
      advance(r);
    } else if (depth > 0 && take_number(r, &number)) {
      add_number(o, number, depth, &position);
    } else if (depth > 0 && r->next != '"' && r->next != '{') {
      if (take_literal(r, literal) == 0) return stop(r, "coordinates without end");
      note(o, "coordinates are not numbers");
      add_number(o, 0, depth, &position);
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
  return check_shape(shape, &r->source->vertices, r->source->name, &o->fault);
}

// Gives its shapes the feature's id.
static int end_feature(struct reader* r, const struct object* o) {
  struct source* const source = r->source;
  if (!source->id_name || source->shapes.count == o->first) return 1;
  return set_ids(&source->shapes, o->first, o->id) || refuse_source(source, "out of memory");
}

static void complain(struct reader* r, const struct object* o) {
  if (r->feature < 0) complain_of_shape(r->source, &o->fault, ":%ld", o->line);
  if (r->feature >= 0) complain_of_shape(r->source, &o->fault, ":%ld: feature %lld", o->line, (long long)r->feature);
}

static int end_object(struct reader* r, struct object* o) {
  struct source* const source = r->source;
  struct shape shape;
  int good;
  if (strcmp(o->type, "Feature") == 0 && o->brackets < 0) return end_feature(r, o);
  if (o->brackets < 0 && o->children) return 1;
  if (o->children) note(o, "coordinates beside other geometries");
  good = settle(r, o, &shape);
  if (!good) complain(r, o);
  if (source->shapes.count % 1024 == 0) show_reading(source, r->at - source->text.at);
  if (!take_shape(source, good && o->brackets > 0 ? &shape : NULL)) return 0;
  return !source->id_name || set_ids(&source->shapes, source->shapes.count - 1, (struct id){NULL, 0}) ||
         refuse_source(source, "out of memory");
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

// ---- Ids ----

static char* put_utf8(char* out, unsigned long code) {
  if (code < 0x80) {
    *out++ = (char)code;
    return out;
  }
  if (code < 0x800) {
    *out++ = (char)(0xc0 | code >> 6);
  } else {
    if (code < 0x10000) {
      *out++ = (char)(0xe0 | code >> 12);
    } else {
      *out++ = (char)(0xf0 | code >> 18);
      *out++ = (char)(0x80 | (code >> 12 & 0x3f));
    }
    *out++ = (char)(0x80 | (code >> 6 & 0x3f));
  }
  *out++ = (char)(0x80 | (code & 0x3f));
  return out;
}

// Four hexadecimal digits, or -1.
static long take_code(const char* at, const char* end) {
  char digits[5] = "", *stop;
  if (end - at < 4) return -1;
  memcpy(digits, at, 4);
  if (strspn(digits, "0123456789abcdefABCDEF") != 4) return -1;
  return strtol(digits, &stop, 16);
}

// Writes what the escapes mean in their place, which is never longer. Returns the end; wrong ones stay.
static char* unescape(char* at, char* end) {
  static const char marks[] = "bfnrt", meanings[] = "\b\f\n\r\t";
  char* out = at;
  while (at < end) {
    const char* mark;
    if (*at != '\\' || at + 1 == end) {
      *out++ = *at++;
      continue;
    }
    mark = strchr(marks, at[1]);
    if (at[1] == 'u') {
      const long high = take_code(at + 2, end);
      const long low = end - at >= 12 && at[6] == '\\' && at[7] == 'u' ? take_code(at + 8, end) : -1;
      const int is_pair = high >= 0xd800 && high < 0xdc00 && low >= 0xdc00 && low < 0xe000;
      out = put_utf8(out, is_pair ? 0x10000ul + ((unsigned long)(high - 0xd800) << 10) + (unsigned long)(low - 0xdc00)
                          : high < 0 ? (unsigned long)'?'
                                     : (unsigned long)high);
      at += is_pair ? 12 : high < 0 ? 2 : 6;
    } else {
      *out++ = mark && *mark ? meanings[mark - marks] : at[1];
      at += 2;
    }
  }
  return out;
}

// A string without its quotes, or any other value as it is written.
static int take_id(struct reader* r, struct object* o) {
  char word[word_room], *begin;
  skip_space(r);
  begin = r->at;
  if (r->next != '"') {
    if (!skip_value(r)) return 0;
    o->id = (struct id){begin, r->at - begin};
    return 1;
  }
  if (!take_string(r, word)) return 0;
  o->id = (struct id){begin + 1, unescape(begin + 1, r->at - 1) - (begin + 1)};
  return 1;
}

// Is the string that begins there this name?
static int is_name(const struct reader* r, const char* name) {
  const size_t length = strlen(name);
  return (size_t)(r->end - r->at) > length + 1 && memcmp(r->at + 1, name, length) == 0 && r->at[1 + length] == '"';
}

static int take_properties(struct reader* r, struct object* o) {
  char name[word_room];
  if (!take_mark(r, '{')) return skip_value(r);
  if (take_mark(r, '}')) return 1;
  do {
    int is_id;
    skip_space(r);
    is_id = !o->id.at && is_name(r, r->source->id_name);
    if (!take_string(r, name)) return 0;
    if (!take_mark(r, ':')) return stop(r, "':' is missing");
    if (!(is_id ? take_id(r, o) : skip_value(r))) return 0;
  } while (take_mark(r, ','));
  return take_mark(r, '}') || stop(r, "',' or '}' is missing");
}

// ---- Members ----

static int take_member(struct reader* r, struct object* o, int depth) {
  char name[word_room];
  int features, is_id;
  skip_space(r);
  is_id = r->source->id_name && strcmp(r->source->id_name, "id") == 0 && is_name(r, "id");
  if (!take_string(r, name)) return 0;
  if (!take_mark(r, ':')) return stop(r, "':' is missing");
  skip_space(r);
  if (is_id) return take_id(r, o);
  if (r->source->id_name && strcmp(name, "properties") == 0) return take_properties(r, o);
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
  struct object o = {.brackets = -1, .line = r->line, .first = r->source->shapes.count};
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
  struct reader r = {source, source->text.at, source->text.at + source->text.size, '\0', 1, -1};
  int good = 1;
  jump(&r, r.at);
  skip_space(&r);
  while (good && r.next != EOF) {
    good = take_object(&r, 0);
    skip_space(&r);
  }
  // Geometries without a feature, and features without the id, have none.
  for (int64_t i = 0; good && source->id_name && i < source->shapes.count; i++) {
    if (i < source->shapes.id_room && source->shapes.ids[i].at) continue;
    struct fault fault;
    fail(&fault, "shape %lld: no '%.40s' in its feature", (long long)i, source->id_name);
    good = refuse_source(source, fault.text);
  }
  return good;
}
