// SPDX-License-Identifier: Apache-2.0
// The version, and names: errors, kinds, instruction sets.
#include "by_kind.hpp"
#include "vesica.h"

int32_t vesica_version(void) { return VESICA_VERSION; }
int32_t vesica_version_major(void) { return VESICA_VERSION_MAJOR; }
int32_t vesica_version_minor(void) { return VESICA_VERSION_MINOR; }
int32_t vesica_version_patch(void) { return VESICA_VERSION_PATCH; }

// The core's error codes are the C interface's.
static_assert(vesica::error_null == VESICA_E_NULL && vesica::error_shape == VESICA_E_SHAPE);
static_assert(vesica::error_kind == VESICA_E_KIND && vesica::error_argument == VESICA_E_ARGUMENT);
static_assert(vesica::error_not_finite == VESICA_E_NOT_FINITE);
static_assert(vesica::error_negative_size == VESICA_E_NEGATIVE_SIZE);
static_assert(vesica::error_zero_axis == VESICA_E_ZERO_AXIS && vesica::error_inverted == VESICA_E_INVERTED);
static_assert(vesica::error_range == VESICA_E_RANGE);

const char* vesica_strerror(int32_t code) {
  if (code >= 0) return "success";
  switch (code) {
    case VESICA_E_NULL:
      return "a pointer is NULL";
    case VESICA_E_SHAPE:
      return "a shape is invalid (NaN, infinity, negative size, zero axis, or min above max)";
    case VESICA_E_KIND:
      return "a kind is unknown, or the function does not take it";
    case VESICA_E_ARGUMENT:
      return "an argument is out of range";
    case VESICA_E_NOT_FINITE:
      return "a number is NaN or infinite";
    case VESICA_E_NEGATIVE_SIZE:
      return "a size is negative";
    case VESICA_E_ZERO_AXIS:
      return "the axis is (0, 0)";
    case VESICA_E_INVERTED:
      return "min exceeds max";
    case VESICA_E_RANGE:
      return "the result is out of the range of its type";
    case VESICA_E_INDEX:
      return "the bytes are not an index of this version, or are damaged";
    case VESICA_E_NOT_CONVEX:
      return "a polygon is not convex, as the function requires";
    case VESICA_E_RINGS:
      return "a polygon has no vertex, or its offsets are negative or decrease";
    case VESICA_E_NOT_SIMPLE:
      return "edges of a polygon cross or overlap";
    default:
      return "unknown error";
  }
}

int32_t vesica_field_count(int32_t kind) { return vesica::field_count(kind); }

const char* vesica_kind_name(int32_t kind) {
#define VESICA_NAME(name, Name) #name,
  static constexpr const char* names[] = {VESICA_EACH_SHAPE(VESICA_NAME) "polygon", "polyline"};
#undef VESICA_NAME
  return vesica::is_kind(kind) ? names[kind] : nullptr;
}
