// SPDX-License-Identifier: Apache-2.0
// Queries of whole arrays: each is its scalar function, a kernel where there is one, and the engine in src/.
#include "arrays.hpp"
#include "queries.hpp"

namespace {

using namespace vesica::capi;
using vesica::QueryTable;
using vesica::batch::Known;
using vesica::batch::Query;
using vesica::batch::QueryTally;
using vesica::batch::Reversal;

int32_t answer_relation(int32_t kind_a, const double* a, int32_t kind_b, const double* b, double* results) noexcept {
  const int32_t code = vesica_relation_f64(kind_a, a, kind_b, b);
  if (code < 0) return code;
  results[0] = code;
  return 0;
}

/// 1 where a relation's code says that a contains b; NaN stays.
double contains_from_relation(double code) noexcept {
  return code == VESICA_CONTAINS || code == VESICA_CONTAINS_TOUCH || code == VESICA_EQUAL ? 1 : 0 * code;
}

int32_t answer_nearest(int32_t kind_a, const double* a, int32_t kind_b, const double* b, double* results) noexcept {
  vesica_closest_points_f64 found;
  const int32_t error = vesica_nearest_f64(kind_a, a, kind_b, b, &found);
  if (error == 0) std::memcpy(results, &found, sizeof found);
  return error;
}
int32_t answer_boundary_distance(int32_t kind_a, const double* a, int32_t kind_b, const double* b,
                                 double* results) noexcept {
  vesica_closest_points_f64 found;
  const int32_t error = vesica_boundary_distance_f64(kind_a, a, kind_b, b, &found);
  if (error == 0) std::memcpy(results, &found, sizeof found);
  return error;
}
int32_t answer_depth(int32_t kind_a, const double* a, int32_t kind_b, const double* b, double* results) noexcept {
  vesica_penetration_f64 found;
  const int32_t error = vesica_depth_f64(kind_a, a, kind_b, b, &found);
  if (error == 0) std::memcpy(results, &found, sizeof found);
  return error;
}

int32_t answer_area(int32_t kind_a, const double* a, int32_t kind_b, const double* b, double* results) noexcept {
  return vesica_area_f64(kind_a, a, kind_b, b, results);
}
int32_t answer_iou(int32_t kind_a, const double* a, int32_t kind_b, const double* b, double* results) noexcept {
  return vesica_iou_f64(kind_a, a, kind_b, b, results);
}
double shape_area(int32_t kind, const double* numbers) noexcept {
  double area = std::numeric_limits<double>::quiet_NaN();
  vesica_shape_area_f64(kind, numbers, &area);
  return area;
}

constexpr Query distance_query(vesica::batch::Answer answer, vesica::QueryKernels QueryTable::*kernels) {
  return {.results = 5,
          .is_length = true,
          .counts_zero = true,
          .answer = answer,
          .kernels = kernels,
          .reversal = Reversal::points,
          .known = Known::overlap,
          .shape_area = nullptr,
          .relation = nullptr,
          .from_relation = nullptr};
}

/// Queries of one number.
constexpr Query number_query(vesica::batch::Answer answer, vesica::QueryKernels QueryTable::*kernels, Reversal reversal,
                             Known known, vesica::batch::ShapeArea area) {
  return {.results = 1,
          .is_length = false,
          .counts_zero = false,
          .answer = answer,
          .kernels = kernels,
          .reversal = reversal,
          .known = known,
          .shape_area = area,
          .relation = nullptr,
          .from_relation = nullptr};
}

constexpr Query relation =
    number_query(answer_relation, &QueryTable::relation, Reversal::converse, Known::nothing, nullptr);
constexpr Query contains{.results = 1,
                         .is_length = false,
                         .counts_zero = false,
                         .answer = nullptr,
                         .kernels = nullptr,
                         .reversal = Reversal::none,
                         .known = Known::nothing,
                         .shape_area = nullptr,
                         .relation = &relation,
                         .from_relation = contains_from_relation};
constexpr Query nearest = distance_query(answer_nearest, &QueryTable::nearest);
constexpr Query boundary_distance = distance_query(answer_boundary_distance, &QueryTable::boundary_distance);
constexpr Query depth{.results = 3,
                      .is_length = true,
                      .counts_zero = false,
                      .answer = answer_depth,
                      .kernels = &QueryTable::depth,
                      .reversal = Reversal::direction,
                      .known = Known::overlap,
                      .shape_area = nullptr,
                      .relation = nullptr,
                      .from_relation = nullptr};
constexpr Query area = number_query(answer_area, &QueryTable::area, Reversal::none, Known::reach, nullptr);
constexpr Query iou = number_query(answer_iou, &QueryTable::iou, Reversal::none, Known::reach, shape_area);

int64_t result(const QueryTally& tally) noexcept { return tally.error != 0 ? tally.error : tally.count; }

/// Columns may be null, but not all of them.
template <class T, class Out>
int64_t many(const Query& query, const CShapesOf<T>* a, const CShapesOf<T>* b, Out* const* columns) noexcept {
  const void* some = nullptr;
  for (int k = 0; k < query.results; ++k) some = columns[k] != nullptr ? columns[k] : some;
  const int32_t error = check_call(a, b, some, anything(a, b));
  if (error != 0) return error;
  const int64_t n = pairs_in_step(*a, *b);
  if (n < 0) return n;
  return result(vesica::batch::query_many(query, vesica::kernels(), view<T>(*a), view<T>(*b), n, columns));
}

template <class T, class Out>
int64_t matrix(const Query& query, const CShapesOf<T>* a, const CShapesOf<T>* b, Out* out,
               ptrdiff_t row_stride) noexcept {
  const int32_t error = check_call(a, b, out, anything(a, b));
  if (error != 0) return error;
  if (!rows_apart(a->count, b->count, row_stride, sizeof(Out))) return VESICA_E_ARGUMENT;
  return result(vesica::batch::query_matrix(query, vesica::kernels(), view<T>(*a), view<T>(*b), out, row_stride));
}

}  // namespace

#define VESICA_MANY_AND_MATRIX(name, Out, scalar, T)                                                                  \
  int64_t vesica_##name##_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, Out* out) { \
    Out* const columns[] = {out};                                                                                     \
    return many<T>(name, a, b, columns);                                                                              \
  }                                                                                                                   \
  int64_t vesica_##name##_matrix_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, Out* out, \
                                          ptrdiff_t row_stride) {                                                     \
    return matrix<T>(name, a, b, out, row_stride);                                                                    \
  }
#define VESICA_DISTANCE_MANY(name, scalar, T)                                                                          \
  int64_t vesica_##name##_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, T* distance, \
                                        T* ax, T* ay, T* bx, T* by) {                                                  \
    T* const columns[] = {distance, ax, ay, bx, by};                                                                   \
    return many<T>(name, a, b, columns);                                                                               \
  }
#define VESICA_QUERIES(scalar, T)                                                                      \
  VESICA_MANY_AND_MATRIX(relation, uint8_t, scalar, T)                                                 \
  VESICA_MANY_AND_MATRIX(contains, uint8_t, scalar, T)                                                 \
  VESICA_MANY_AND_MATRIX(area, T, scalar, T)                                                           \
  VESICA_MANY_AND_MATRIX(iou, T, scalar, T)                                                            \
  VESICA_DISTANCE_MANY(nearest, scalar, T)                                                             \
  VESICA_DISTANCE_MANY(boundary_distance, scalar, T)                                                   \
  int64_t vesica_depth_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, \
                                     T* depth_column, T* x, T* y) {                                    \
    T* const columns[] = {depth_column, x, y};                                                         \
    return many<T>(depth, a, b, columns);                                                              \
  }

VESICA_QUERIES(f64, double)
VESICA_QUERIES(f32, float)
