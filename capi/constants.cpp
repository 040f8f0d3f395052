// SPDX-License-Identifier: Apache-2.0
// Every constant of vesica.h and vesica_methods.h as a function, and the names of things.
#include "by_kind.hpp"
#include "vesica.h"
#include "vesica_methods.h"

int32_t vesica_version(void) { return VESICA_VERSION; }
int32_t vesica_version_major(void) { return VESICA_VERSION_MAJOR; }
int32_t vesica_version_minor(void) { return VESICA_VERSION_MINOR; }
int32_t vesica_version_patch(void) { return VESICA_VERSION_PATCH; }

int32_t vesica_point(void) { return VESICA_POINT; }
int32_t vesica_segment(void) { return VESICA_SEGMENT; }
int32_t vesica_circle(void) { return VESICA_CIRCLE; }
int32_t vesica_aabb(void) { return VESICA_AABB; }
int32_t vesica_rect(void) { return VESICA_RECT; }
int32_t vesica_ellipse(void) { return VESICA_ELLIPSE; }

int32_t vesica_disjoint(void) { return VESICA_DISJOINT; }
int32_t vesica_touch(void) { return VESICA_TOUCH; }
int32_t vesica_cross(void) { return VESICA_CROSS; }
int32_t vesica_inside(void) { return VESICA_INSIDE; }
int32_t vesica_inside_touch(void) { return VESICA_INSIDE_TOUCH; }
int32_t vesica_contains(void) { return VESICA_CONTAINS; }
int32_t vesica_contains_touch(void) { return VESICA_CONTAINS_TOUCH; }
int32_t vesica_equal(void) { return VESICA_EQUAL; }

int32_t vesica_e_null(void) { return VESICA_E_NULL; }
int32_t vesica_e_shape(void) { return VESICA_E_SHAPE; }
int32_t vesica_e_kind(void) { return VESICA_E_KIND; }
int32_t vesica_e_argument(void) { return VESICA_E_ARGUMENT; }
int32_t vesica_e_not_finite(void) { return VESICA_E_NOT_FINITE; }
int32_t vesica_e_negative_size(void) { return VESICA_E_NEGATIVE_SIZE; }
int32_t vesica_e_zero_axis(void) { return VESICA_E_ZERO_AXIS; }
int32_t vesica_e_inverted(void) { return VESICA_E_INVERTED; }
int32_t vesica_e_range(void) { return VESICA_E_RANGE; }

int32_t vesica_no(void) { return VESICA_NO; }
int32_t vesica_yes(void) { return VESICA_YES; }
int32_t vesica_uncertain(void) { return VESICA_UNCERTAIN; }
int32_t vesica_most_sample_points(void) { return VESICA_MOST_SAMPLE_POINTS; }
int32_t vesica_most_sandwich_iterations(void) { return VESICA_MOST_SANDWICH_ITERATIONS; }
int32_t vesica_schedule_scale_aware(void) { return VESICA_SCHEDULE_SCALE_AWARE; }
int32_t vesica_schedule_literal(void) { return VESICA_SCHEDULE_LITERAL; }
int32_t vesica_most_descent_iterations(void) { return VESICA_MOST_DESCENT_ITERATIONS; }

// The core's error codes are the C face's.
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
      return "unknown kind of shape";
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
      return "the bytes are no index of this version, or damaged";
    default:
      return "unknown error";
  }
}

int32_t vesica_field_count(int32_t kind) { return vesica::field_count(kind); }

const char* vesica_kind_name(int32_t kind) {
  switch (kind) {
#define VESICA_CASE(name, Name)                  \
  case static_cast<int32_t>(vesica::Kind::name): \
    return #name;
    VESICA_EACH_SHAPE(VESICA_CASE)
#undef VESICA_CASE
    default:
      return nullptr;
  }
}
