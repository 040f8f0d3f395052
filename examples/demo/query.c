// SPDX-License-Identifier: Apache-2.0
#include "query.h"

#include <string.h>
#include <vesica.h>

#include "scene.h"

// Some functions return their answer, which is never negative, or a negative error.
static int32_t take_result(int32_t result, double* out) {
  if (result < 0) return result;
  *out = result;
  return 0;
}

static int32_t answer_overlap(const struct pair* pair, double* out) {
  return take_result(vesica_overlap_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers), out);
}

static int32_t answer_contains(const struct pair* pair, double* out) {
  return take_result(vesica_contains_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers), out);
}

static int32_t answer_relation(const struct pair* pair, double* out) {
  return take_result(vesica_relation_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers), out);
}

static int32_t answer_crossings(const struct pair* pair, double* out) {
  const int64_t places =
      vesica_crossings_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers, NULL, 0, NULL);
  return take_result((int32_t)places, out);
}

// The others write their answer, and return 0 or a negative error.
static int32_t answer_distance(const struct pair* pair, double* out) {
  vesica_closest_points_f64 points;
  const int32_t error = vesica_nearest_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers, &points);
  if (error == 0) *out = points.distance;
  return error;
}

static int32_t answer_boundary_distance(const struct pair* pair, double* out) {
  vesica_closest_points_f64 points;
  const int32_t error =
      vesica_boundary_distance_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers, &points);
  if (error == 0) *out = points.distance;
  return error;
}

static int32_t answer_depth(const struct pair* pair, double* out) {
  vesica_penetration_f64 penetration;
  const int32_t error = vesica_depth_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers, &penetration);
  if (error == 0) *out = penetration.depth;
  return error;
}

static int32_t answer_area(const struct pair* pair, double* out) {
  return vesica_area_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers, out);
}

static int32_t answer_iou(const struct pair* pair, double* out) {
  return vesica_iou_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers, out);
}

const struct query queries[query_count] = {
    {"overlap", answer_overlap, 1},   {"contains", answer_contains, 1},
    {"relation", answer_relation, 0}, {"crossings", answer_crossings, 0},
    {"distance", answer_distance, 0}, {"boundary_distance", answer_boundary_distance, 0},
    {"depth", answer_depth, 0},       {"area", answer_area, 0},
    {"iou", answer_iou, 0},
};

const struct query* find_query(const char* name) {
  for (int i = 0; i < query_count; i++) {
    if (strcmp(queries[i].name, name) == 0) return &queries[i];
  }
  return NULL;
}
