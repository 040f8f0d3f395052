// SPDX-License-Identifier: Apache-2.0
// The queries other than overlap: each is its descriptor (src/query.hpp), asked about two shapes or about arrays.
#include "queries.hpp"

#include <vesica/relation_code.hpp>

#include "query_calls.hpp"

namespace {

using namespace vesica::capi;
using vesica::Relation;
namespace queries = vesica::queries;

consteval bool is_code(Relation relation, int32_t code) { return static_cast<int32_t>(relation) == code; }

// The core's codes are the C interface's.
static_assert(is_code(Relation::disjoint, VESICA_DISJOINT) && is_code(Relation::touch, VESICA_TOUCH));
static_assert(is_code(Relation::cross, VESICA_CROSS) && is_code(Relation::inside, VESICA_INSIDE));
static_assert(is_code(Relation::inside_touch, VESICA_INSIDE_TOUCH) && is_code(Relation::contains, VESICA_CONTAINS));
static_assert(is_code(Relation::contains_touch, VESICA_CONTAINS_TOUCH) && is_code(Relation::equal, VESICA_EQUAL));

}  // namespace

#define VESICA_MANY_AND_MATRIX(name, Out, scalar, T)                                                                  \
  int64_t vesica_##name##_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, Out* out) { \
    Out* const columns[] = {out};                                                                                     \
    return many<T>(queries::name, a, b, columns);                                                                     \
  }                                                                                                                   \
  int64_t vesica_##name##_matrix_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, Out* out, \
                                          ptrdiff_t row_stride) {                                                     \
    return matrix<T>(queries::name, a, b, out, row_stride);                                                           \
  }

#define VESICA_NUMBERS(name, Out, scalar, T)                                                                 \
  int32_t vesica_##name##_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b, Out* out) { \
    VESICA_DEFAULT_ENVIRONMENT(vesica_##name##_##scalar, kind_a, a, kind_b, b, out);                         \
    return answer<T>(queries::name, kind_a, a, kind_b, b, out);                                              \
  }

/// Queries whose result is the returned code, a byte in batches.
#define VESICA_CODE(name, scalar, T)                                                               \
  int32_t vesica_##name##_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b) { \
    VESICA_DEFAULT_ENVIRONMENT(vesica_##name##_##scalar, kind_a, a, kind_b, b);                    \
    return vesica::ask<T>(queries::name, kind_a, a, kind_b, b, nullptr);                           \
  }                                                                                                \
  VESICA_MANY_AND_MATRIX(name, uint8_t, scalar, T)

/// Queries of one number.
#define VESICA_NUMBER(name, scalar, T) \
  VESICA_NUMBERS(name, T, scalar, T)   \
  VESICA_MANY_AND_MATRIX(name, T, scalar, T)

#define VESICA_DISTANCE(name, scalar, T)                                                                               \
  VESICA_NUMBERS(name, vesica_closest_points_##scalar, scalar, T)                                                      \
  int64_t vesica_##name##_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, T* distance, \
                                        T* ax, T* ay, T* bx, T* by) {                                                  \
    T* const columns[] = {distance, ax, ay, bx, by};                                                                   \
    return many<T>(queries::name, a, b, columns);                                                                      \
  }

#define VESICA_DEPTH(scalar, T)                                                                        \
  VESICA_NUMBERS(depth, vesica_penetration_##scalar, scalar, T)                                        \
  int64_t vesica_depth_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, \
                                     T* depth_column, T* x, T* y) {                                    \
    T* const columns[] = {depth_column, x, y};                                                         \
    return many<T>(queries::depth, a, b, columns);                                                     \
  }

#define VESICA_QUERIES(scalar, T)               \
  VESICA_CODE(relation, scalar, T)              \
  VESICA_CODE(contains, scalar, T)              \
  VESICA_NUMBER(area, scalar, T)                \
  VESICA_NUMBER(iou, scalar, T)                 \
  VESICA_NUMBER(signed_distance, scalar, T)     \
  VESICA_DISTANCE(nearest, scalar, T)           \
  VESICA_DISTANCE(boundary_distance, scalar, T) \
  VESICA_DEPTH(scalar, T)

VESICA_QUERIES(f64, double)
VESICA_QUERIES(f32, float)
