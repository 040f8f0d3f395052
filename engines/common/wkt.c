// SPDX-License-Identifier: Apache-2.0
#include "wkt.h"

#include <stdio.h>
#include <string.h>

#include "number.h"

static const char spaces[] = " \t\r\n";

static int fail(char* fault, const char* reason) {
  snprintf(fault, geometry_fault_room, "%s", reason);
  return 0;
}

static int take_mark(const char** text, char mark) {
  *text += strspn(*text, spaces);
  if (**text != mark) return 0;
  ++*text;
  return 1;
}

static int take_number(const char** text, double* out) {
  const char* const end = parse_decimal(*text, out);
  if (end == *text) return 0;
  *text = end;
  return 1;
}

// Positions between parentheses, as a ring.
static int take_ring(const char** text, struct vertices* vertices, char* fault) {
  static const char wanted[] = "not positions of two numbers in parentheses";
  if (!take_mark(text, '(')) return fail(fault, wanted);
  do {
    double x, y, more;
    if (!take_number(text, &x) || !take_number(text, &y)) return fail(fault, wanted);
    if (!add_vertex(vertices, x, y)) return fail(fault, "too many positions");
    while (take_number(text, &more)) continue;
  } while (take_mark(text, ','));
  if (!take_mark(text, ')')) return fail(fault, wanted);
  return end_ring(vertices) || fail(fault, "too many rings");
}

// Rings, or parts with rings, between as many parentheses around each ring.
static int take_rings(const char** text, int depth, struct vertices* vertices, char* fault) {
  if (depth == 0) return take_ring(text, vertices, fault);
  if (!take_mark(text, '(')) return fail(fault, "'(' is missing");
  do {
    if (!take_rings(text, depth - 1, vertices, fault)) return 0;
  } while (take_mark(text, ','));
  return take_mark(text, ')') || fail(fault, "')' is missing");
}

// Points of a MULTIPOINT need no parentheses of their own.
static int depth_of(const struct geometry* geometry, const char* text) {
  if (geometry->brackets != 2) return geometry->parentheses;
  return take_mark(&text, '(') && take_mark(&text, '(');
}

int parse_wkt(const char* text, struct vertices* vertices, int32_t* kind, double numbers[4],
              char fault[geometry_fault_room]) {
  const char* rest = text + strspn(text, spaces);
  const size_t name = strcspn(rest, " \t\r\n(");
  const struct geometry* geometry = find_geometry(rest, name);
  clear_vertices(vertices);
  if (!geometry) {
    snprintf(fault, geometry_fault_room, "'%.40s' is no POINT, LINESTRING or POLYGON", text);
    return 0;
  }
  rest += name;
  rest += strspn(rest, spaces);
  rest += strspn(rest, "ZMzm");
  if (!take_rings(&rest, depth_of(geometry, rest), vertices, fault)) return 0;
  rest += strspn(rest, spaces);
  if (*rest) {
    snprintf(fault, geometry_fault_room, "'%.40s' after the shape", rest);
    return 0;
  }
  return settle_geometry(geometry, vertices, kind, numbers, fault);
}
