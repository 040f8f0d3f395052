/* SPDX-License-Identifier: Apache-2.0 */
/* Written by capi/declare from capi/vesica.json: not to be edited. */
#ifndef VESICA_GO_H
#define VESICA_GO_H

#include <string.h>
#include <vesica.h>

/* vesica_shapes_f64 and vesica_shapes_f32. */
typedef struct {
    int32_t kind, reserved;
    int64_t count;
    ptrdiff_t stride;
    const void *field[6];
} vesica_go_view;

/* As many as an index may have. */
typedef struct {
    vesica_go_view set[64];
} vesica_go_sets;

/* The numbers of one shape, in double or float. */
typedef struct {
    double number[6];
} vesica_go_numbers;

static inline int32_t go_check_f64(int32_t kind, vesica_go_numbers numbers) {
    double of_numbers[6];
    memcpy(of_numbers, &numbers, sizeof of_numbers);
    return vesica_check_f64(kind, of_numbers);
}

static inline int32_t go_check_f32(int32_t kind, vesica_go_numbers numbers) {
    float of_numbers[6];
    memcpy(of_numbers, &numbers, sizeof of_numbers);
    return vesica_check_f32(kind, of_numbers);
}

static inline int32_t go_overlap_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_overlap_f64(kind_a, of_numbers_a, kind_b, of_numbers_b);
}

static inline int32_t go_overlap_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_overlap_f32(kind_a, of_numbers_a, kind_b, of_numbers_b);
}

static inline int32_t go_relation_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_relation_f64(kind_a, of_numbers_a, kind_b, of_numbers_b);
}

static inline int32_t go_relation_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_relation_f32(kind_a, of_numbers_a, kind_b, of_numbers_b);
}

static inline int32_t go_contains_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_contains_f64(kind_a, of_numbers_a, kind_b, of_numbers_b);
}

static inline int32_t go_contains_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_contains_f32(kind_a, of_numbers_a, kind_b, of_numbers_b);
}

static inline int32_t go_crossings_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_crossings_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_crossings_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_crossings_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_nearest_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_nearest_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_nearest_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_nearest_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_boundary_distance_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_boundary_distance_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_boundary_distance_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_boundary_distance_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_depth_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_depth_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_depth_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_depth_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_shape_area_f64(int32_t kind, vesica_go_numbers numbers, void *out) {
    double of_numbers[6];
    memcpy(of_numbers, &numbers, sizeof of_numbers);
    return vesica_shape_area_f64(kind, of_numbers, out);
}

static inline int32_t go_shape_area_f32(int32_t kind, vesica_go_numbers numbers, void *out) {
    float of_numbers[6];
    memcpy(of_numbers, &numbers, sizeof of_numbers);
    return vesica_shape_area_f32(kind, of_numbers, out);
}

static inline int32_t go_area_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_area_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_area_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_area_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_iou_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_iou_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_iou_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_iou_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_bounds_f64(int32_t kind, vesica_go_numbers numbers, void *out) {
    double of_numbers[6];
    memcpy(of_numbers, &numbers, sizeof of_numbers);
    return vesica_bounds_f64(kind, of_numbers, out);
}

static inline int32_t go_bounds_f32(int32_t kind, vesica_go_numbers numbers, void *out) {
    float of_numbers[6];
    memcpy(of_numbers, &numbers, sizeof of_numbers);
    return vesica_bounds_f32(kind, of_numbers, out);
}

static inline int32_t go_aabb_from_corners_f64(double x0, double y0, double x1, double y1, void *out) {
    return vesica_aabb_from_corners_f64(x0, y0, x1, y1, out);
}

static inline int32_t go_aabb_from_corners_f32(float x0, float y0, float x1, float y1, void *out) {
    return vesica_aabb_from_corners_f32(x0, y0, x1, y1, out);
}

static inline int32_t go_rect_from_angle_f64(double cx, double cy, double angle, double width, double height,
    void *out) {
    return vesica_rect_from_angle_f64(cx, cy, angle, width, height, out);
}

static inline int32_t go_rect_from_angle_f32(float cx, float cy, float angle, float width, float height, void *out) {
    return vesica_rect_from_angle_f32(cx, cy, angle, width, height, out);
}

static inline int32_t go_rect_from_corners_f64(const void *corners, void *out) {
    return vesica_rect_from_corners_f64(corners, out);
}

static inline int32_t go_rect_from_corners_f32(const void *corners, void *out) {
    return vesica_rect_from_corners_f32(corners, out);
}

static inline int32_t go_ellipse_from_angle_f64(double cx, double cy, double angle, double a, double b, void *out) {
    return vesica_ellipse_from_angle_f64(cx, cy, angle, a, b, out);
}

static inline int32_t go_ellipse_from_angle_f32(float cx, float cy, float angle, float a, float b, void *out) {
    return vesica_ellipse_from_angle_f32(cx, cy, angle, a, b, out);
}

static inline int32_t go_ellipse_from_radius_vector_f64(double cx, double cy, double wx, double wy, double ratio,
    void *out) {
    return vesica_ellipse_from_radius_vector_f64(cx, cy, wx, wy, ratio, out);
}

static inline int32_t go_ellipse_from_radius_vector_f32(float cx, float cy, float wx, float wy, float ratio,
    void *out) {
    return vesica_ellipse_from_radius_vector_f32(cx, cy, wx, wy, ratio, out);
}

static inline int32_t go_ellipse_from_covariance_f64(double mean_x, double mean_y, double cxx, double cxy, double cyy,
    double k, void *out) {
    return vesica_ellipse_from_covariance_f64(mean_x, mean_y, cxx, cxy, cyy, k, out);
}

static inline int32_t go_ellipse_from_covariance_f32(float mean_x, float mean_y, float cxx, float cxy, float cyy,
    float k, void *out) {
    return vesica_ellipse_from_covariance_f32(mean_x, mean_y, cxx, cxy, cyy, k, out);
}

static inline int32_t go_ellipse_from_matrix_f64(double cx, double cy, double mxx, double mxy, double myy, void *out) {
    return vesica_ellipse_from_matrix_f64(cx, cy, mxx, mxy, myy, out);
}

static inline int32_t go_ellipse_from_matrix_f32(float cx, float cy, float mxx, float mxy, float myy, void *out) {
    return vesica_ellipse_from_matrix_f32(cx, cy, mxx, mxy, myy, out);
}

static inline int64_t go_overlap_many_f64(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_overlap_many_f64(&of_a, &of_b, out);
}

static inline int64_t go_overlap_many_f32(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_overlap_many_f32(&of_a, &of_b, out);
}

static inline int64_t go_relation_many_f64(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_relation_many_f64(&of_a, &of_b, out);
}

static inline int64_t go_relation_many_f32(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_relation_many_f32(&of_a, &of_b, out);
}

static inline int64_t go_contains_many_f64(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_contains_many_f64(&of_a, &of_b, out);
}

static inline int64_t go_contains_many_f32(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_contains_many_f32(&of_a, &of_b, out);
}

static inline int64_t go_nearest_many_f64(vesica_go_view a, vesica_go_view b, void *distance, void *ax, void *ay,
    void *bx, void *by) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_nearest_many_f64(&of_a, &of_b, distance, ax, ay, bx, by);
}

static inline int64_t go_nearest_many_f32(vesica_go_view a, vesica_go_view b, void *distance, void *ax, void *ay,
    void *bx, void *by) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_nearest_many_f32(&of_a, &of_b, distance, ax, ay, bx, by);
}

static inline int64_t go_boundary_distance_many_f64(vesica_go_view a, vesica_go_view b, void *distance, void *ax,
    void *ay, void *bx, void *by) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_boundary_distance_many_f64(&of_a, &of_b, distance, ax, ay, bx, by);
}

static inline int64_t go_boundary_distance_many_f32(vesica_go_view a, vesica_go_view b, void *distance, void *ax,
    void *ay, void *bx, void *by) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_boundary_distance_many_f32(&of_a, &of_b, distance, ax, ay, bx, by);
}

static inline int64_t go_depth_many_f64(vesica_go_view a, vesica_go_view b, void *depth, void *x, void *y) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_depth_many_f64(&of_a, &of_b, depth, x, y);
}

static inline int64_t go_depth_many_f32(vesica_go_view a, vesica_go_view b, void *depth, void *x, void *y) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_depth_many_f32(&of_a, &of_b, depth, x, y);
}

static inline int64_t go_area_many_f64(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_area_many_f64(&of_a, &of_b, out);
}

static inline int64_t go_area_many_f32(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_area_many_f32(&of_a, &of_b, out);
}

static inline int64_t go_iou_many_f64(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_iou_many_f64(&of_a, &of_b, out);
}

static inline int64_t go_iou_many_f32(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_iou_many_f32(&of_a, &of_b, out);
}

static inline int64_t go_overlap_matrix_f64(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_overlap_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_overlap_matrix_f32(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_overlap_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_relation_matrix_f64(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_relation_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_relation_matrix_f32(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_relation_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_contains_matrix_f64(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_contains_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_contains_matrix_f32(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_contains_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_area_matrix_f64(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_area_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_area_matrix_f32(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_area_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_iou_matrix_f64(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_iou_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_iou_matrix_f32(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_iou_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_overlap_select_f64(vesica_go_view one, vesica_go_view many, void *out, int64_t capacity) {
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f64 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_overlap_select_f64(&of_one, &of_many, out, capacity);
}

static inline int64_t go_overlap_select_f32(vesica_go_view one, vesica_go_view many, void *out, int64_t capacity) {
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f32 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_overlap_select_f32(&of_one, &of_many, out, capacity);
}

static inline int32_t go_nms_f64(vesica_go_view shapes, const void *scores, double threshold, void *scratch,
    int64_t scratch_size, void *keep, void *kept) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_nms_f64(&of_shapes, scores, threshold, scratch, scratch_size, keep, kept);
}

static inline int32_t go_nms_f32(vesica_go_view shapes, const void *scores, float threshold, void *scratch,
    int64_t scratch_size, void *keep, void *kept) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_nms_f32(&of_shapes, scores, threshold, scratch, scratch_size, keep, kept);
}

static inline int64_t go_rects_from_boxes_f64(const void *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
    void *out) {
    return vesica_rects_from_boxes_f64(boxes, count, stride, angle, out);
}

static inline int64_t go_rects_from_boxes_f32(const void *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
    void *out) {
    return vesica_rects_from_boxes_f32(boxes, count, stride, angle, out);
}

static inline int64_t go_ellipses_from_boxes_f64(const void *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
    void *out) {
    return vesica_ellipses_from_boxes_f64(boxes, count, stride, angle, out);
}

static inline int64_t go_ellipses_from_boxes_f32(const void *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
    void *out) {
    return vesica_ellipses_from_boxes_f32(boxes, count, stride, angle, out);
}

static inline int64_t go_boxes_from_shapes_f64(vesica_go_view shapes, int32_t angle, void *boxes) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_boxes_from_shapes_f64(&of_shapes, angle, boxes);
}

static inline int64_t go_boxes_from_shapes_f32(vesica_go_view shapes, int32_t angle, void *boxes) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_boxes_from_shapes_f32(&of_shapes, angle, boxes);
}

static inline int64_t go_corners_of_shapes_f64(vesica_go_view shapes, void *corners) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_corners_of_shapes_f64(&of_shapes, corners);
}

static inline int64_t go_corners_of_shapes_f32(vesica_go_view shapes, void *corners) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_corners_of_shapes_f32(&of_shapes, corners);
}

static inline int64_t go_bounds_many_f64(vesica_go_view shapes, void *out) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_bounds_many_f64(&of_shapes, out);
}

static inline int64_t go_bounds_many_f32(vesica_go_view shapes, void *out) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_bounds_many_f32(&of_shapes, out);
}

static inline int64_t go_index_build_f64(vesica_go_sets sets, int32_t set_count, void *index, int64_t index_size,
    void *scratch, int64_t scratch_size) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    return vesica_index_build_f64(of_sets, set_count, index, index_size, scratch, scratch_size);
}

static inline int64_t go_index_build_f32(vesica_go_sets sets, int32_t set_count, void *index, int64_t index_size,
    void *scratch, int64_t scratch_size) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    return vesica_index_build_f32(of_sets, set_count, index, index_size, scratch, scratch_size);
}

static inline int64_t go_index_select_f64(const void *index, vesica_go_sets sets, int32_t set_count, vesica_go_view one,
    void *out, int64_t capacity, void *state) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_select_f64(index, of_sets, set_count, &of_one, out, capacity, state);
}

static inline int64_t go_index_select_f32(const void *index, vesica_go_sets sets, int32_t set_count, vesica_go_view one,
    void *out, int64_t capacity, void *state) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_select_f32(index, of_sets, set_count, &of_one, out, capacity, state);
}

static inline int64_t go_join_f64(int32_t query, const void *index_a, vesica_go_sets sets_a, int32_t set_count_a,
    const void *index_b, vesica_go_sets sets_b, int32_t set_count_b, int64_t part, int64_t parts, void *scratch,
    int64_t scratch_size, void *out_a, void *out_b, int64_t capacity, void *state) {
    vesica_shapes_f64 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f64 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_f64(query, index_a, of_sets_a, set_count_a, index_b, of_sets_b, set_count_b, part, parts,
        scratch, scratch_size, out_a, out_b, capacity, state);
}

static inline int64_t go_join_f32(int32_t query, const void *index_a, vesica_go_sets sets_a, int32_t set_count_a,
    const void *index_b, vesica_go_sets sets_b, int32_t set_count_b, int64_t part, int64_t parts, void *scratch,
    int64_t scratch_size, void *out_a, void *out_b, int64_t capacity, void *state) {
    vesica_shapes_f32 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f32 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_f32(query, index_a, of_sets_a, set_count_a, index_b, of_sets_b, set_count_b, part, parts,
        scratch, scratch_size, out_a, out_b, capacity, state);
}

static inline int64_t go_join_within_f64(const void *index_a, vesica_go_sets sets_a, int32_t set_count_a,
    const void *index_b, vesica_go_sets sets_b, int32_t set_count_b, double distance, int64_t part, int64_t parts,
    void *out_a, void *out_b, int64_t capacity, void *state) {
    vesica_shapes_f64 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f64 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_within_f64(index_a, of_sets_a, set_count_a, index_b, of_sets_b, set_count_b, distance, part,
        parts, out_a, out_b, capacity, state);
}

static inline int64_t go_join_within_f32(const void *index_a, vesica_go_sets sets_a, int32_t set_count_a,
    const void *index_b, vesica_go_sets sets_b, int32_t set_count_b, float distance, int64_t part, int64_t parts,
    void *out_a, void *out_b, int64_t capacity, void *state) {
    vesica_shapes_f32 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f32 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_within_f32(index_a, of_sets_a, set_count_a, index_b, of_sets_b, set_count_b, distance, part,
        parts, out_a, out_b, capacity, state);
}

static inline int64_t go_index_nearest_f64(const void *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, int64_t k, double within, void *out, void *distance) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_nearest_f64(index, of_sets, set_count, &of_one, k, within, out, distance);
}

static inline int64_t go_index_nearest_f32(const void *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, int64_t k, float within, void *out, void *distance) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_nearest_f32(index, of_sets, set_count, &of_one, k, within, out, distance);
}

static inline int64_t go_join_nearest_f64(vesica_go_sets sets_a, int32_t set_count_a, const void *index_b,
    vesica_go_sets sets_b, int32_t set_count_b, int64_t k, double within, int64_t part, int64_t parts, void *out,
    void *distance) {
    vesica_shapes_f64 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f64 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_nearest_f64(of_sets_a, set_count_a, index_b, of_sets_b, set_count_b, k, within, part, parts, out,
        distance);
}

static inline int64_t go_join_nearest_f32(vesica_go_sets sets_a, int32_t set_count_a, const void *index_b,
    vesica_go_sets sets_b, int32_t set_count_b, int64_t k, float within, int64_t part, int64_t parts, void *out,
    void *distance) {
    vesica_shapes_f32 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f32 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_nearest_f32(of_sets_a, set_count_a, index_b, of_sets_b, set_count_b, k, within, part, parts, out,
        distance);
}

static inline int32_t go_ratio_f64(int32_t ratio, int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_ratio_f64(ratio, kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_ratio_f32(int32_t ratio, int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_ratio_f32(ratio, kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int64_t go_ratio_many_f64(int32_t ratio, vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_ratio_many_f64(ratio, &of_a, &of_b, out);
}

static inline int64_t go_ratio_many_f32(int32_t ratio, vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_ratio_many_f32(ratio, &of_a, &of_b, out);
}

static inline int64_t go_ratio_matrix_f64(int32_t ratio, vesica_go_view a, vesica_go_view b, void *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_ratio_matrix_f64(ratio, &of_a, &of_b, out, row_stride);
}

static inline int64_t go_ratio_matrix_f32(int32_t ratio, vesica_go_view a, vesica_go_view b, void *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_ratio_matrix_f32(ratio, &of_a, &of_b, out, row_stride);
}

static inline int64_t go_nearest_matrix_f64(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_nearest_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_nearest_matrix_f32(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_nearest_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_boundary_distance_matrix_f64(vesica_go_view a, vesica_go_view b, void *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_boundary_distance_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_boundary_distance_matrix_f32(vesica_go_view a, vesica_go_view b, void *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_boundary_distance_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_depth_matrix_f64(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_depth_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_depth_matrix_f32(vesica_go_view a, vesica_go_view b, void *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_depth_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int32_t go_signed_distance_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_signed_distance_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int32_t go_signed_distance_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_signed_distance_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, out);
}

static inline int64_t go_signed_distance_many_f64(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_signed_distance_many_f64(&of_a, &of_b, out);
}

static inline int64_t go_signed_distance_many_f32(vesica_go_view a, vesica_go_view b, void *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_signed_distance_many_f32(&of_a, &of_b, out);
}

static inline int64_t go_signed_distance_matrix_f64(vesica_go_view a, vesica_go_view b, void *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_signed_distance_matrix_f64(&of_a, &of_b, out, row_stride);
}

static inline int64_t go_signed_distance_matrix_f32(vesica_go_view a, vesica_go_view b, void *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_signed_distance_matrix_f32(&of_a, &of_b, out, row_stride);
}

static inline int32_t go_within_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, double distance) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_within_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, distance);
}

static inline int32_t go_within_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, float distance) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_within_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, distance);
}

static inline int64_t go_within_many_f64(vesica_go_view a, vesica_go_view b, double distance, void *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_within_many_f64(&of_a, &of_b, distance, out);
}

static inline int64_t go_within_many_f32(vesica_go_view a, vesica_go_view b, float distance, void *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_within_many_f32(&of_a, &of_b, distance, out);
}

static inline int64_t go_within_matrix_f64(vesica_go_view a, vesica_go_view b, double distance, void *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_within_matrix_f64(&of_a, &of_b, distance, out, row_stride);
}

static inline int64_t go_within_matrix_f32(vesica_go_view a, vesica_go_view b, float distance, void *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_within_matrix_f32(&of_a, &of_b, distance, out, row_stride);
}

static inline int32_t go_suppress_f64(vesica_go_view shapes, const void *scores, const void *labels, int32_t ratio,
    double threshold, double least_score, int64_t most, void *scratch, int64_t scratch_size, void *keep, void *kept) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_suppress_f64(&of_shapes, scores, labels, ratio, threshold, least_score, most, scratch, scratch_size,
        keep, kept);
}

static inline int32_t go_suppress_f32(vesica_go_view shapes, const void *scores, const void *labels, int32_t ratio,
    float threshold, float least_score, int64_t most, void *scratch, int64_t scratch_size, void *keep, void *kept) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_suppress_f32(&of_shapes, scores, labels, ratio, threshold, least_score, most, scratch, scratch_size,
        keep, kept);
}

static inline int32_t go_suppress_soft_f64(vesica_go_view shapes, const void *scores, const void *labels, int32_t ratio,
    int32_t decay, double parameter, double least_score, int64_t most, void *scratch, int64_t scratch_size, void *keep,
    void *decayed, void *kept) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_suppress_soft_f64(&of_shapes, scores, labels, ratio, decay, parameter, least_score, most, scratch,
        scratch_size, keep, decayed, kept);
}

static inline int32_t go_suppress_soft_f32(vesica_go_view shapes, const void *scores, const void *labels, int32_t ratio,
    int32_t decay, float parameter, float least_score, int64_t most, void *scratch, int64_t scratch_size, void *keep,
    void *decayed, void *kept) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_suppress_soft_f32(&of_shapes, scores, labels, ratio, decay, parameter, least_score, most, scratch,
        scratch_size, keep, decayed, kept);
}

static inline int32_t go_cast_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, double vx, double vy, double t_end, void *out) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_cast_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, vx, vy, t_end, out);
}

static inline int32_t go_cast_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, float vx, float vy, float t_end, void *out) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_cast_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, vx, vy, t_end, out);
}

static inline int64_t go_cast_many_f64(vesica_go_view a, vesica_go_view b, const void *vx, const void *vy,
    ptrdiff_t stride, double t_end, void *t, void *x, void *y, void *nx, void *ny) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_cast_many_f64(&of_a, &of_b, vx, vy, stride, t_end, t, x, y, nx, ny);
}

static inline int64_t go_cast_many_f32(vesica_go_view a, vesica_go_view b, const void *vx, const void *vy,
    ptrdiff_t stride, float t_end, void *t, void *x, void *y, void *nx, void *ny) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_cast_many_f32(&of_a, &of_b, vx, vy, stride, t_end, t, x, y, nx, ny);
}

static inline int64_t go_cast_first_f64(vesica_go_view one, vesica_go_view many, double vx, double vy, double t_end,
    void *out) {
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f64 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_cast_first_f64(&of_one, &of_many, vx, vy, t_end, out);
}

static inline int64_t go_cast_first_f32(vesica_go_view one, vesica_go_view many, float vx, float vy, float t_end,
    void *out) {
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f32 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_cast_first_f32(&of_one, &of_many, vx, vy, t_end, out);
}

static inline int32_t go_sweep_bounds_f64(int32_t kind, vesica_go_numbers numbers, double vx, double vy, double t_end,
    void *out) {
    double of_numbers[6];
    memcpy(of_numbers, &numbers, sizeof of_numbers);
    return vesica_sweep_bounds_f64(kind, of_numbers, vx, vy, t_end, out);
}

static inline int32_t go_sweep_bounds_f32(int32_t kind, vesica_go_numbers numbers, float vx, float vy, float t_end,
    void *out) {
    float of_numbers[6];
    memcpy(of_numbers, &numbers, sizeof of_numbers);
    return vesica_sweep_bounds_f32(kind, of_numbers, vx, vy, t_end, out);
}

static inline int64_t go_index_cast_f64(const void *index, vesica_go_sets sets, int32_t set_count, vesica_go_view one,
    double vx, double vy, double t_end, void *out, int64_t capacity, void *state) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_cast_f64(index, of_sets, set_count, &of_one, vx, vy, t_end, out, capacity, state);
}

static inline int64_t go_index_cast_f32(const void *index, vesica_go_sets sets, int32_t set_count, vesica_go_view one,
    float vx, float vy, float t_end, void *out, int64_t capacity, void *state) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_cast_f32(index, of_sets, set_count, &of_one, vx, vy, t_end, out, capacity, state);
}

static inline int64_t go_index_cast_first_f64(const void *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, double vx, double vy, double t_end, void *out) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_cast_first_f64(index, of_sets, set_count, &of_one, vx, vy, t_end, out);
}

static inline int64_t go_index_cast_first_f32(const void *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, float vx, float vy, float t_end, void *out) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_cast_first_f32(index, of_sets, set_count, &of_one, vx, vy, t_end, out);
}

static inline int32_t go_impact_time_f64(int32_t kind_a, vesica_go_numbers numbers_a, const void *turn_a,
    int32_t kind_b, vesica_go_numbers numbers_b, const void *turn_b, double tolerance, void *out, void *gap) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_impact_time_f64(kind_a, of_numbers_a, turn_a, kind_b, of_numbers_b, turn_b, tolerance, out, gap);
}

static inline int32_t go_impact_time_f32(int32_t kind_a, vesica_go_numbers numbers_a, const void *turn_a,
    int32_t kind_b, vesica_go_numbers numbers_b, const void *turn_b, float tolerance, void *out, void *gap) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_impact_time_f32(kind_a, of_numbers_a, turn_a, kind_b, of_numbers_b, turn_b, tolerance, out, gap);
}

static inline int32_t go_cast_point_point_f64(const void *a, const void *b, double vx, double vy, double t_end,
    void *out) {
    return vesica_cast_point_point_f64(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_point_point_f32(const void *a, const void *b, float vx, float vy, float t_end,
    void *out) {
    return vesica_cast_point_point_f32(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_segment_point_f64(const void *a, const void *b, double vx, double vy, double t_end,
    void *out) {
    return vesica_cast_segment_point_f64(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_segment_point_f32(const void *a, const void *b, float vx, float vy, float t_end,
    void *out) {
    return vesica_cast_segment_point_f32(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_circle_point_f64(const void *a, const void *b, double vx, double vy, double t_end,
    void *out) {
    return vesica_cast_circle_point_f64(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_circle_point_f32(const void *a, const void *b, float vx, float vy, float t_end,
    void *out) {
    return vesica_cast_circle_point_f32(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_aabb_point_f64(const void *a, const void *b, double vx, double vy, double t_end,
    void *out) {
    return vesica_cast_aabb_point_f64(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_aabb_point_f32(const void *a, const void *b, float vx, float vy, float t_end, void *out) {
    return vesica_cast_aabb_point_f32(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_rect_point_f64(const void *a, const void *b, double vx, double vy, double t_end,
    void *out) {
    return vesica_cast_rect_point_f64(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_rect_point_f32(const void *a, const void *b, float vx, float vy, float t_end, void *out) {
    return vesica_cast_rect_point_f32(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_ellipse_point_f64(const void *a, const void *b, double vx, double vy, double t_end,
    void *out) {
    return vesica_cast_ellipse_point_f64(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_ellipse_point_f32(const void *a, const void *b, float vx, float vy, float t_end,
    void *out) {
    return vesica_cast_ellipse_point_f32(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_circle_circle_f64(const void *a, const void *b, double vx, double vy, double t_end,
    void *out) {
    return vesica_cast_circle_circle_f64(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_circle_circle_f32(const void *a, const void *b, float vx, float vy, float t_end,
    void *out) {
    return vesica_cast_circle_circle_f32(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_rect_rect_f64(const void *a, const void *b, double vx, double vy, double t_end,
    void *out) {
    return vesica_cast_rect_rect_f64(a, b, vx, vy, t_end, out);
}

static inline int32_t go_cast_rect_rect_f32(const void *a, const void *b, float vx, float vy, float t_end, void *out) {
    return vesica_cast_rect_rect_f32(a, b, vx, vy, t_end, out);
}

static inline int32_t go_de9im_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *matrix) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_de9im_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, matrix);
}

static inline int32_t go_de9im_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *matrix) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_de9im_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, matrix);
}

static inline int32_t go_intersection_f64(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *vertices) {
    double of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    double of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_intersection_f64(kind_a, of_numbers_a, kind_b, of_numbers_b, vertices);
}

static inline int32_t go_intersection_f32(int32_t kind_a, vesica_go_numbers numbers_a, int32_t kind_b,
    vesica_go_numbers numbers_b, void *vertices) {
    float of_numbers_a[6];
    memcpy(of_numbers_a, &numbers_a, sizeof of_numbers_a);
    float of_numbers_b[6];
    memcpy(of_numbers_b, &numbers_b, sizeof of_numbers_b);
    return vesica_intersection_f32(kind_a, of_numbers_a, kind_b, of_numbers_b, vertices);
}

#endif
