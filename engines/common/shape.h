// SPDX-License-Identifier: Apache-2.0
/// A shape as a database holds it: its kind and its numbers, and the same in words, as `rect 0 0 0.8 0.6 2 1` or in
/// well-known text. Polygons and polylines have vertices, in memory that the caller keeps.
#ifndef VESICA_ENGINES_SHAPE_H
#define VESICA_ENGINES_SHAPE_H

#include <stddef.h>
#include <stdint.h>
#include <vesica.h>

#include "geometry.h"

/// Numbers of the shape that has most, a rounded rectangle.
enum { shape_numbers = 7 };

enum { shape_fault_room = geometry_fault_room };

struct shape {
  int32_t kind;
  double numbers[shape_numbers];  ///< in the order of vesica.h
  vesica_polygon_f64 path;        ///< of polygons and polylines, instead
};

/// True for polygons and polylines.
int shape_has_path(int32_t kind);

/// The pointer that the library's functions take beside the kind.
const void* shape_data(const struct shape* shape);

/// Reads a valid shape from words between spaces, tabs or commas, or from well-known text; vertices go to `vertices`.
/// Returns 1, or 0 with the reason in `fault`.
int shape_from_text(const char* text, struct vertices* vertices, struct shape* out, char fault[shape_fault_room]);

/// Reads a valid shape from well-known binary, the same way.
int shape_from_wkb(const unsigned char* bytes, int64_t count, struct vertices* vertices, struct shape* out,
                   char fault[shape_fault_room]);

/// Writes it in the same form, each number with the digits, 15 to 17, that give the same bits back.
void shape_to_text(const struct shape* shape, char* out);

/// The most bytes that this takes, its end included.
size_t shape_text_room(const struct shape* shape);

/// Reads it from bytes: one for the kind, then the numbers, 8 bytes each, least significant byte first; or, of polygons
/// and polylines, the number of rings and where each ends among the vertices, 4 bytes each, and the vertices. Whether
/// edges cross is not looked at. Returns 1, or 0 with the reason in `fault`.
int shape_from_blob(const unsigned char* blob, int64_t bytes, struct vertices* vertices, struct shape* out,
                    char fault[shape_fault_room]);

/// How many vertices and rings bytes of a polygon or a polyline have; 0 if they are of no such shape.
int shape_blob_counts(const unsigned char* blob, int64_t bytes, int64_t counts[2]);

/// Writes these bytes.
void shape_to_blob(const struct shape* shape, unsigned char* out);

/// How many they are.
size_t shape_blob_size(const struct shape* shape);

/// Takes a kind and its numbers. Returns 1, or 0 with the reason in `fault`.
int shape_from_numbers(int32_t kind, const double* numbers, struct shape* out, char fault[shape_fault_room]);

/// The name of a relation, VESICA_DISJOINT ... VESICA_EQUAL.
const char* relation_name(int32_t relation);

/// Bounds whose sides are floats, rounded outward; what is beyond the floats lies on their rim. This map is monotone,
/// so shapes whose bounds are disjoint are disjoint. Trees of boxes that keep floats, or that multiply sides, hold such
/// bounds without loss. Min may exceed neither max nor the rim.
void shape_bounds(const struct shape* shape, vesica_aabb_f64* out);

#endif
