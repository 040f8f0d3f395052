// SPDX-License-Identifier: Apache-2.0
#include "wkt.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <vesica.h>

#include "fields.h"

enum { box_positions = 5, most_positions = 5 };

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

// How many positions stand between parentheses, or 0 where that is not so or they are too many.
static int take_positions(const char** text, double out[most_positions][2]) {
  int count = 0;
  if (!take_mark(text, '(')) return 0;
  do {
    if (count == most_positions || !take_number(text, &out[count][0]) || !take_number(text, &out[count][1])) return 0;
    count++;
  } while (take_mark(text, ','));
  return take_mark(text, ')') ? count : 0;
}

static int same(const double a[2], const double b[2], int axis) { return a[axis] == b[axis]; }

// Its sides take turns in lying along the one axis and the other, beginning with `axis`.
static int turns(double p[most_positions][2], int axis) {
  for (int i = 0; i + 1 < box_positions; i++) {
    if (!same(p[i], p[i + 1], (axis + i + 1) % 2)) return 0;
  }
  return 1;
}

static int box_of(double p[most_positions][2], int count, struct shape* shape) {
  if (count != box_positions || !same(p[0], p[4], 0) || !same(p[0], p[4], 1)) return 0;
  if (!turns(p, 0) && !turns(p, 1)) return 0;
  for (int axis = 0; axis < 2; axis++) {
    shape->numbers[axis] = fmin(p[0][axis], p[2][axis]);
    shape->numbers[axis + 2] = fmax(p[0][axis], p[2][axis]);
  }
  return 1;
}

static int take_name(const char** text, const char* name) {
  const size_t length = strlen(name);
  if (strncmp(*text, name, length) != 0) return 0;
  *text += length;
  return 1;
}

static int parse_polygon(const char* text, struct shape* shape, struct fault* fault) {
  double p[most_positions][2];
  int count;
  shape->kind = VESICA_AABB;
  if (!take_mark(&text, '(')) return fail(fault, "'(' is missing");
  count = take_positions(&text, p);
  if (!box_of(p, count, shape)) return fail(fault, "a POLYGON here is a box along the axes, one ring of 5 positions");
  return (take_mark(&text, ')') && !*text) || fail(fault, "'%.40s' after the ring of a box", text);
}

int parse_wkt(const char* text, struct shape* shape, struct fault* fault) {
  double p[most_positions][2];
  int wanted;
  if (take_name(&text, "POLYGON")) return parse_polygon(text, shape, fault);
  if (take_name(&text, "POINT")) {
    shape->kind = VESICA_POINT;
  } else if (take_name(&text, "LINESTRING")) {
    shape->kind = VESICA_SEGMENT;
  } else {
    return fail(fault, "'%.40s' is no POINT, LINESTRING or POLYGON", text);
  }
  wanted = shape->kind == VESICA_POINT ? 1 : 2;
  if (take_positions(&text, p) != wanted)
    return fail(fault, "not %d position%s of two numbers in parentheses", wanted, wanted == 1 ? "" : "s");
  text += strspn(text, " \t");
  if (*text) return fail(fault, "'%.40s' after the shape", text);
  memcpy(shape->numbers, p, sizeof p[0] * (size_t)wanted);
  return 1;
}
