// SPDX-License-Identifier: Apache-2.0
/// A shape as a database holds it: its kind and its numbers, and the same in words, as `rect 0 0 0.8 0.6 2 1`.
#ifndef VESICA_ENGINES_SHAPE_H
#define VESICA_ENGINES_SHAPE_H

#include <stddef.h>
#include <stdint.h>
#include <vesica.h>

/// Numbers of the shape that has most, a rounded rectangle.
enum { shape_numbers = 7 };

enum { shape_text_room = 224, shape_fault_room = 160, shape_blob_room = 1 + 8 * shape_numbers };

struct shape {
  int32_t kind;
  int32_t reserved;               ///< 0, so that equal shapes have equal bytes
  double numbers[shape_numbers];  ///< in the order of vesica.h; those beyond the kind's are 0
};

/// Reads a valid shape from words between spaces, tabs or commas. Returns 1, or 0 with the reason in `fault`.
int shape_from_text(const char* text, struct shape* out, char fault[shape_fault_room]);

/// Writes it as words, each number with the digits, 15 to 17, that give the same bits back.
void shape_to_text(const struct shape* shape, char out[shape_text_room]);

/// Reads it from bytes: one for the kind, then the numbers, 8 bytes each, least significant byte first. Returns 1, or 0
/// with the reason in `fault`.
int shape_from_blob(const unsigned char* blob, int bytes, struct shape* out, char fault[shape_fault_room]);

/// Writes these bytes. Returns how many they are.
int shape_to_blob(const struct shape* shape, unsigned char out[shape_blob_room]);

/// Takes a kind and its numbers. Returns 1, or 0 with the reason in `fault`.
int shape_from_numbers(int32_t kind, const double* numbers, struct shape* out, char fault[shape_fault_room]);

/// The name of a relation, VESICA_DISJOINT ... VESICA_EQUAL.
const char* relation_name(int32_t relation);

/// Bounds whose sides are floats, rounded outward; what is beyond the floats lies on their rim. This map is monotone,
/// so shapes whose bounds are disjoint are disjoint. Trees of boxes that keep floats, or that multiply sides, hold such
/// bounds without loss. Min may exceed neither max nor the rim.
void shape_bounds(const struct shape* shape, vesica_aabb_f64* out);

#endif
