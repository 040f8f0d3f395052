// SPDX-License-Identifier: Apache-2.0
#include "wkb.h"

#include <stdio.h>
#include <string.h>

struct reader {
  const unsigned char* at;
  int64_t left;
  int big;         // the byte of most weight is the first
  int dimensions;  // numbers of a position
};

enum { point = 1, line, polygon, points, lines, polygons, first_of_many = points };

static uint64_t take(struct reader* r, int bytes) {
  uint64_t bits = 0;
  for (int k = 0; k < bytes; k++) bits = bits << 8 | r->at[r->big ? k : bytes - 1 - k];
  r->at += bytes;
  r->left -= bytes;
  return bits;
}

// How many parts follow, of `least` bytes each or more. Returns -1 where these bytes are not there.
static int64_t take_count(struct reader* r, int64_t least) {
  const int64_t count = r->left < 4 ? -1 : (int64_t)take(r, 4);
  return count > r->left / least ? -1 : count;
}

static int take_positions(struct reader* r, int64_t count, struct vertices* vertices) {
  for (int64_t i = 0; i < count; i++) {
    double xy[2] = {0, 0};
    for (int axis = 0; axis < r->dimensions; axis++) {
      const uint64_t bits = take(r, 8);
      if (axis < 2) memcpy(&xy[axis], &bits, sizeof bits);
    }
    if (!add_vertex(vertices, xy[0], xy[1])) return 0;
  }
  return count == 0 || end_ring(vertices);
}

// The order of bytes, the type, and the reference system if there is one. Returns the type, or 0.
static int take_type(struct reader* r) {
  uint32_t type;
  if (r->left < 5 || r->at[0] > 1) return 0;
  r->big = r->at[0] == 0;
  r->at++, r->left--;
  type = (uint32_t)take(r, 4);
  r->dimensions = 2 + (int)(type >> 31) + (int)(type >> 30 & 1);
  if (type >> 29 & 1) {
    if (r->left < 4) return 0;
    take(r, 4);
  }
  type &= 0x1fffffff;
  if (type >= 4000) return 0;
  r->dimensions += type >= 3000 ? 2 : type >= 1000;
  return r->dimensions <= 4 ? (int)(type % 1000) : 0;
}

// Returns the type, or 0 where the bytes are none or memory is short.
static int take_geometry(struct reader* r, int is_part, struct vertices* vertices) {
  const int type = take_type(r);
  const int64_t position = 8 * r->dimensions;
  int64_t count;
  if (type < point || type > polygons || (is_part && type >= first_of_many)) return 0;
  if (type == point) return r->left >= position && take_positions(r, 1, vertices) ? type : 0;
  count = take_count(r, type == line ? position : 4);
  if (count < 0) return 0;
  if (type == line) return take_positions(r, count, vertices) ? type : 0;
  for (int64_t i = 0; i < count; i++) {
    if (type == polygon) {
      const int64_t of_ring = take_count(r, position);
      if (of_ring < 0 || !take_positions(r, of_ring, vertices)) return 0;
    } else if (take_geometry(r, 1, vertices) != type - first_of_many + point) {
      return 0;
    }
  }
  return type;
}

int parse_wkb(const unsigned char* bytes, int64_t count, struct vertices* vertices, int32_t* kind, double numbers[4],
              char fault[geometry_fault_room]) {
  static const char* const names[] = {"",           "Point",           "LineString",  "Polygon",
                                      "MultiPoint", "MultiLineString", "MultiPolygon"};
  struct reader r = {bytes, count, 0, 2};
  int type;
  clear_vertices(vertices);
  type = take_geometry(&r, 0, vertices);
  if (type == 0 || r.left != 0) {
    snprintf(fault, geometry_fault_room, "no well-known binary of points, lines or polygons");
    return 0;
  }
  if (vertices->count == 0) {
    snprintf(fault, geometry_fault_room, "an empty geometry");
    return 0;
  }
  return settle_geometry(find_geometry(names[type], strlen(names[type])), vertices, kind, numbers, fault);
}
