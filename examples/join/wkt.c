// SPDX-License-Identifier: Apache-2.0
#include "wkt.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <vesica.h>

#include "fields.h"

enum { box_positions = 5 };

static int take_mark(const char** text, char mark) {
  *text += strspn(*text, " \t");
  if (**text != mark) return 0;
  ++*text;
  return 1;
}

static int take_number(const char** text, double* out) {
  char* end;
  *out = strtod(*text, &end);
  if (end == *text) return 0;
  *text = end;
  return 1;
}

// Positions between parentheses, as a ring.
static int take_ring(const char** text, struct vertices* vertices, struct fault* fault) {
  static const char wanted[] = "not positions of two numbers in parentheses";
  if (!take_mark(text, '(')) return fail(fault, wanted);
  do {
    double x, y;
    if (!take_number(text, &x) || !take_number(text, &y)) return fail(fault, wanted);
    if (!add_vertex(vertices, x, y)) return fail(fault, "too many positions");
  } while (take_mark(text, ','));
  if (!take_mark(text, ')')) return fail(fault, wanted);
  return end_ring(vertices) || fail(fault, "too many rings");
}

// Rings, or parts with rings, between as many parentheses around each ring.
static int take_rings(const char** text, int depth, struct vertices* vertices, struct fault* fault) {
  if (depth == 0) return take_ring(text, vertices, fault);
  if (!take_mark(text, '(')) return fail(fault, "'(' is missing");
  do {
    if (!take_rings(text, depth - 1, vertices, fault)) return 0;
  } while (take_mark(text, ','));
  return take_mark(text, ')') || fail(fault, "')' is missing");
}

static int same(const double* p, int a, int b, int axis) { return p[2 * a + axis] == p[2 * b + axis]; }

// Its sides take turns in lying along the one axis and the other, beginning with `axis`.
static int turns(const double* p, int axis) {
  for (int i = 0; i + 1 < box_positions; i++) {
    if (!same(p, i, i + 1, (axis + i + 1) % 2)) return 0;
  }
  return 1;
}

static int take_box(const struct vertices* vertices, struct shape* shape) {
  const double* p = vertices->xy;
  if (vertices->ring_count != 1 || vertices->count != box_positions || !same(p, 0, 4, 0) || !same(p, 0, 4, 1)) return 0;
  if (!turns(p, 0) && !turns(p, 1)) return 0;
  shape->kind = VESICA_AABB;
  for (int axis = 0; axis < 2; axis++) {
    shape->numbers[axis] = fmin(p[axis], p[4 + axis]);
    shape->numbers[axis + 2] = fmax(p[axis], p[4 + axis]);
  }
  return 1;
}

static int take_name(const char** text, const char* name) {
  const size_t length = strlen(name);
  if (strncmp(*text, name, length) != 0) return 0;
  *text += length;
  return 1;
}

static const struct {
  const char* name;
  int32_t kind;
  int depth;  // parentheses around each ring
} forms[] = {{"POINT", VESICA_POINT, 0},
             {"LINESTRING", VESICA_POLYLINE, 0},
             {"MULTILINESTRING", VESICA_POLYLINE, 1},
             {"POLYGON", VESICA_POLYGON, 1},
             {"MULTIPOLYGON", VESICA_POLYGON, 2}};

int parse_wkt(const char* text, struct shape* shape, struct vertices* vertices, struct fault* fault) {
  size_t form = 0;
  const char* rest = text;
  vertices->count = vertices->ring_count = 0;
  while (form < sizeof forms / sizeof *forms && !take_name(&rest, forms[form].name)) form++;
  if (form == sizeof forms / sizeof *forms) return fail(fault, "'%.40s' is no POINT, LINESTRING or POLYGON", text);
  if (!take_rings(&rest, forms[form].depth, vertices, fault)) return 0;
  rest += strspn(rest, " \t");
  if (*rest) return fail(fault, "'%.40s' after the shape", rest);
  shape->kind = forms[form].kind;
  if (shape->kind == VESICA_POINT && vertices->count != 1)
    return fail(fault, "not 1 position of two numbers in parentheses");
  if (shape->kind == VESICA_POLYGON) take_box(vertices, shape);
  if (shape->kind == VESICA_POLYLINE && vertices->ring_count == 1 && vertices->count == 2) shape->kind = VESICA_SEGMENT;
  if (shape->kind == VESICA_POINT || shape->kind == VESICA_SEGMENT) {
    memcpy(shape->numbers, vertices->xy, 2 * sizeof(double) * (size_t)vertices->count);
  }
  return 1;
}
