/* SPDX-License-Identifier: Apache-2.0 */
/* Written by bindings/declare from capi/vesica.json: not to be edited. */
#ifndef VESICA_GO_H
#define VESICA_GO_H

#include <string.h>
#include <vesica.h>

/* vesica_shapes_f64 and vesica_shapes_f32. */
typedef struct {
    int32_t kind, reserved;
    int64_t count;
    ptrdiff_t stride;
    const char *field[8];
    const int32_t *rings, *polygons;
    int64_t each;
} vesica_go_view;

/* As many as an index may have. */
typedef struct {
    vesica_go_view set[64];
} vesica_go_sets;

/* vesica_polygon_f64 and vesica_polygon_f32. Polylines have the same members. */
typedef struct {
    const char *x, *y;
    ptrdiff_t stride;
    const int32_t *rings;
    int64_t count;
} vesica_go_path;

/* One shape: its numbers, in double or float, or the path of a polygon or a polyline. */
typedef struct {
    double numbers[7];
    vesica_go_path path;
} vesica_go_shape;

typedef union {
    double numbers[7];
    vesica_polygon_f64 path;
} vesica_go_f64;

static inline vesica_go_f64 go_read_f64(int32_t kind, const vesica_go_shape *shape) {
    vesica_go_f64 read;
    if (kind < VESICA_POLYGON) {
        memcpy(&read.numbers, &shape->numbers, sizeof read.numbers);
    } else {
        memcpy(&read.path, &shape->path, sizeof read.path);
    }
    return read;
}

typedef union {
    float numbers[7];
    vesica_polygon_f32 path;
} vesica_go_f32;

static inline vesica_go_f32 go_read_f32(int32_t kind, const vesica_go_shape *shape) {
    vesica_go_f32 read;
    if (kind < VESICA_POLYGON) {
        memcpy(&read.numbers, &shape->numbers, sizeof read.numbers);
    } else {
        memcpy(&read.path, &shape->path, sizeof read.path);
    }
    return read;
}

static inline int32_t go_overlap_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_overlap_f64(kind_a, &of_a, kind_b, &of_b);
}

static inline int32_t go_overlap_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_overlap_f32(kind_a, &of_a, kind_b, &of_b);
}

static inline int32_t go_interiors_overlap_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_interiors_overlap_f64(kind_a, &of_a, kind_b, &of_b);
}

static inline int32_t go_interiors_overlap_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_interiors_overlap_f32(kind_a, &of_a, kind_b, &of_b);
}

static inline int32_t go_contains_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_contains_f64(kind_a, &of_a, kind_b, &of_b);
}

static inline int32_t go_contains_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_contains_f32(kind_a, &of_a, kind_b, &of_b);
}

static inline int32_t go_relation_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_relation_f64(kind_a, &of_a, kind_b, &of_b);
}

static inline int32_t go_relation_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_relation_f32(kind_a, &of_a, kind_b, &of_b);
}

static inline int32_t go_nearest_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_nearest_f64(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_nearest_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_nearest_f32(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_depth_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_depth_f64(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_depth_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_depth_f32(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_area_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_area_f64(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_area_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_area_f32(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_iou_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_iou_f64(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_iou_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_iou_f32(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_bounds_f64(int32_t kind, vesica_go_shape shape, char *out) {
    vesica_go_f64 of_shape = go_read_f64(kind, &shape);
    return vesica_bounds_f64(kind, &of_shape, (void *)out);
}

static inline int32_t go_bounds_f32(int32_t kind, vesica_go_shape shape, char *out) {
    vesica_go_f32 of_shape = go_read_f32(kind, &shape);
    return vesica_bounds_f32(kind, &of_shape, (void *)out);
}

static inline int32_t go_check_f64(int32_t kind, vesica_go_shape shape) {
    vesica_go_f64 of_shape = go_read_f64(kind, &shape);
    return vesica_check_f64(kind, &of_shape);
}

static inline int32_t go_check_f32(int32_t kind, vesica_go_shape shape) {
    vesica_go_f32 of_shape = go_read_f32(kind, &shape);
    return vesica_check_f32(kind, &of_shape);
}

static inline int64_t go_crossings_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out,
    int64_t capacity, char *shared) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_crossings_f64(kind_a, &of_a, kind_b, &of_b, (void *)out, capacity, (void *)shared);
}

static inline int64_t go_crossings_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out,
    int64_t capacity, char *shared) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_crossings_f32(kind_a, &of_a, kind_b, &of_b, (void *)out, capacity, (void *)shared);
}

static inline int32_t go_boundary_distance_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_boundary_distance_f64(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_boundary_distance_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_boundary_distance_f32(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_shape_area_f64(int32_t kind, vesica_go_shape shape, char *out) {
    vesica_go_f64 of_shape = go_read_f64(kind, &shape);
    return vesica_shape_area_f64(kind, &of_shape, (void *)out);
}

static inline int32_t go_shape_area_f32(int32_t kind, vesica_go_shape shape, char *out) {
    vesica_go_f32 of_shape = go_read_f32(kind, &shape);
    return vesica_shape_area_f32(kind, &of_shape, (void *)out);
}

static inline int32_t go_polygon_facts_f64(const char *polygon, char *out) {
    return vesica_polygon_facts_f64((const void *)polygon, (void *)out);
}

static inline int32_t go_polygon_facts_f32(const char *polygon, char *out) {
    return vesica_polygon_facts_f32((const void *)polygon, (void *)out);
}

static inline int32_t go_aabb_from_corners_f64(double x0, double y0, double x1, double y1, char *out) {
    return vesica_aabb_from_corners_f64(x0, y0, x1, y1, (void *)out);
}

static inline int32_t go_aabb_from_corners_f32(float x0, float y0, float x1, float y1, char *out) {
    return vesica_aabb_from_corners_f32(x0, y0, x1, y1, (void *)out);
}

static inline int32_t go_rect_from_angle_f64(double cx, double cy, double angle, double width, double height,
    char *out) {
    return vesica_rect_from_angle_f64(cx, cy, angle, width, height, (void *)out);
}

static inline int32_t go_rect_from_angle_f32(float cx, float cy, float angle, float width, float height, char *out) {
    return vesica_rect_from_angle_f32(cx, cy, angle, width, height, (void *)out);
}

static inline int32_t go_rect_from_corners_f64(const char *corners, char *out) {
    return vesica_rect_from_corners_f64((const void *)corners, (void *)out);
}

static inline int32_t go_rect_from_corners_f32(const char *corners, char *out) {
    return vesica_rect_from_corners_f32((const void *)corners, (void *)out);
}

static inline int32_t go_rect_corners_misfit_f64(const char *corners, const char *r, char *misfit) {
    return vesica_rect_corners_misfit_f64((const void *)corners, (const void *)r, (void *)misfit);
}

static inline int32_t go_rect_corners_misfit_f32(const char *corners, const char *r, char *misfit) {
    return vesica_rect_corners_misfit_f32((const void *)corners, (const void *)r, (void *)misfit);
}

static inline int32_t go_round_rect_from_angle_f64(double cx, double cy, double angle, double width, double height,
    double radius, char *out) {
    return vesica_round_rect_from_angle_f64(cx, cy, angle, width, height, radius, (void *)out);
}

static inline int32_t go_round_rect_from_angle_f32(float cx, float cy, float angle, float width, float height,
    float radius, char *out) {
    return vesica_round_rect_from_angle_f32(cx, cy, angle, width, height, radius, (void *)out);
}

static inline int32_t go_capsule_from_angle_f64(double cx, double cy, double angle, double length, double radius,
    char *out) {
    return vesica_capsule_from_angle_f64(cx, cy, angle, length, radius, (void *)out);
}

static inline int32_t go_capsule_from_angle_f32(float cx, float cy, float angle, float length, float radius,
    char *out) {
    return vesica_capsule_from_angle_f32(cx, cy, angle, length, radius, (void *)out);
}

static inline int32_t go_capsule_from_width_f64(double x0, double y0, double x1, double y1, double width, char *out) {
    return vesica_capsule_from_width_f64(x0, y0, x1, y1, width, (void *)out);
}

static inline int32_t go_capsule_from_width_f32(float x0, float y0, float x1, float y1, float width, char *out) {
    return vesica_capsule_from_width_f32(x0, y0, x1, y1, width, (void *)out);
}

static inline int32_t go_ellipse_from_angle_f64(double cx, double cy, double angle, double a, double b, char *out) {
    return vesica_ellipse_from_angle_f64(cx, cy, angle, a, b, (void *)out);
}

static inline int32_t go_ellipse_from_angle_f32(float cx, float cy, float angle, float a, float b, char *out) {
    return vesica_ellipse_from_angle_f32(cx, cy, angle, a, b, (void *)out);
}

static inline int32_t go_ellipse_from_radius_vector_f64(double cx, double cy, double wx, double wy, double ratio,
    char *out) {
    return vesica_ellipse_from_radius_vector_f64(cx, cy, wx, wy, ratio, (void *)out);
}

static inline int32_t go_ellipse_from_radius_vector_f32(float cx, float cy, float wx, float wy, float ratio,
    char *out) {
    return vesica_ellipse_from_radius_vector_f32(cx, cy, wx, wy, ratio, (void *)out);
}

static inline int32_t go_ellipse_from_covariance_f64(double mean_x, double mean_y, double cxx, double cxy, double cyy,
    double k, char *out) {
    return vesica_ellipse_from_covariance_f64(mean_x, mean_y, cxx, cxy, cyy, k, (void *)out);
}

static inline int32_t go_ellipse_from_covariance_f32(float mean_x, float mean_y, float cxx, float cxy, float cyy,
    float k, char *out) {
    return vesica_ellipse_from_covariance_f32(mean_x, mean_y, cxx, cxy, cyy, k, (void *)out);
}

static inline int32_t go_ellipse_from_matrix_f64(double cx, double cy, double mxx, double mxy, double myy, char *out) {
    return vesica_ellipse_from_matrix_f64(cx, cy, mxx, mxy, myy, (void *)out);
}

static inline int32_t go_ellipse_from_matrix_f32(float cx, float cy, float mxx, float mxy, float myy, char *out) {
    return vesica_ellipse_from_matrix_f32(cx, cy, mxx, mxy, myy, (void *)out);
}

static inline int64_t go_overlap_many_f64(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_overlap_many_f64(&of_a, &of_b, (void *)out);
}

static inline int64_t go_overlap_many_f32(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_overlap_many_f32(&of_a, &of_b, (void *)out);
}

static inline int64_t go_interiors_overlap_many_f64(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_interiors_overlap_many_f64(&of_a, &of_b, (void *)out);
}

static inline int64_t go_interiors_overlap_many_f32(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_interiors_overlap_many_f32(&of_a, &of_b, (void *)out);
}

static inline int64_t go_relation_many_f64(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_relation_many_f64(&of_a, &of_b, (void *)out);
}

static inline int64_t go_relation_many_f32(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_relation_many_f32(&of_a, &of_b, (void *)out);
}

static inline int64_t go_contains_many_f64(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_contains_many_f64(&of_a, &of_b, (void *)out);
}

static inline int64_t go_contains_many_f32(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_contains_many_f32(&of_a, &of_b, (void *)out);
}

static inline int64_t go_nearest_many_f64(vesica_go_view a, vesica_go_view b, char *distance, char *ax, char *ay,
    char *bx, char *by) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_nearest_many_f64(&of_a, &of_b, (void *)distance, (void *)ax, (void *)ay, (void *)bx, (void *)by);
}

static inline int64_t go_nearest_many_f32(vesica_go_view a, vesica_go_view b, char *distance, char *ax, char *ay,
    char *bx, char *by) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_nearest_many_f32(&of_a, &of_b, (void *)distance, (void *)ax, (void *)ay, (void *)bx, (void *)by);
}

static inline int64_t go_boundary_distance_many_f64(vesica_go_view a, vesica_go_view b, char *distance, char *ax,
    char *ay, char *bx, char *by) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_boundary_distance_many_f64(&of_a, &of_b, (void *)distance, (void *)ax, (void *)ay, (void *)bx,
        (void *)by);
}

static inline int64_t go_boundary_distance_many_f32(vesica_go_view a, vesica_go_view b, char *distance, char *ax,
    char *ay, char *bx, char *by) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_boundary_distance_many_f32(&of_a, &of_b, (void *)distance, (void *)ax, (void *)ay, (void *)bx,
        (void *)by);
}

static inline int64_t go_depth_many_f64(vesica_go_view a, vesica_go_view b, char *depth, char *x, char *y) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_depth_many_f64(&of_a, &of_b, (void *)depth, (void *)x, (void *)y);
}

static inline int64_t go_depth_many_f32(vesica_go_view a, vesica_go_view b, char *depth, char *x, char *y) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_depth_many_f32(&of_a, &of_b, (void *)depth, (void *)x, (void *)y);
}

static inline int64_t go_area_many_f64(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_area_many_f64(&of_a, &of_b, (void *)out);
}

static inline int64_t go_area_many_f32(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_area_many_f32(&of_a, &of_b, (void *)out);
}

static inline int64_t go_iou_many_f64(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_iou_many_f64(&of_a, &of_b, (void *)out);
}

static inline int64_t go_iou_many_f32(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_iou_many_f32(&of_a, &of_b, (void *)out);
}

static inline int64_t go_overlap_matrix_f64(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_overlap_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_overlap_matrix_f32(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_overlap_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_interiors_overlap_matrix_f64(vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_interiors_overlap_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_interiors_overlap_matrix_f32(vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_interiors_overlap_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_relation_matrix_f64(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_relation_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_relation_matrix_f32(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_relation_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_contains_matrix_f64(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_contains_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_contains_matrix_f32(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_contains_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_area_matrix_f64(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_area_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_area_matrix_f32(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_area_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_iou_matrix_f64(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_iou_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_iou_matrix_f32(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_iou_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_overlap_select_f64(vesica_go_view one, vesica_go_view many, char *out, int64_t capacity) {
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f64 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_overlap_select_f64(&of_one, &of_many, (void *)out, capacity);
}

static inline int64_t go_overlap_select_f32(vesica_go_view one, vesica_go_view many, char *out, int64_t capacity) {
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f32 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_overlap_select_f32(&of_one, &of_many, (void *)out, capacity);
}

static inline int64_t go_interiors_overlap_select_f64(vesica_go_view one, vesica_go_view many, char *out,
    int64_t capacity) {
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f64 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_interiors_overlap_select_f64(&of_one, &of_many, (void *)out, capacity);
}

static inline int64_t go_interiors_overlap_select_f32(vesica_go_view one, vesica_go_view many, char *out,
    int64_t capacity) {
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f32 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_interiors_overlap_select_f32(&of_one, &of_many, (void *)out, capacity);
}

static inline int32_t go_nms_f64(vesica_go_view shapes, const char *scores, double threshold, char *scratch,
    int64_t scratch_size, char *keep, char *kept) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_nms_f64(&of_shapes, (const void *)scores, threshold, (void *)scratch, scratch_size, (void *)keep,
        (void *)kept);
}

static inline int32_t go_nms_f32(vesica_go_view shapes, const char *scores, float threshold, char *scratch,
    int64_t scratch_size, char *keep, char *kept) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_nms_f32(&of_shapes, (const void *)scores, threshold, (void *)scratch, scratch_size, (void *)keep,
        (void *)kept);
}

static inline int64_t go_rects_from_boxes_f64(const char *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
    char *out) {
    return vesica_rects_from_boxes_f64((const void *)boxes, count, stride, angle, (void *)out);
}

static inline int64_t go_rects_from_boxes_f32(const char *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
    char *out) {
    return vesica_rects_from_boxes_f32((const void *)boxes, count, stride, angle, (void *)out);
}

static inline int64_t go_ellipses_from_boxes_f64(const char *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
    char *out) {
    return vesica_ellipses_from_boxes_f64((const void *)boxes, count, stride, angle, (void *)out);
}

static inline int64_t go_ellipses_from_boxes_f32(const char *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
    char *out) {
    return vesica_ellipses_from_boxes_f32((const void *)boxes, count, stride, angle, (void *)out);
}

static inline int64_t go_rects_from_corners_f64(const char *corners, int64_t count, ptrdiff_t stride, char *out) {
    return vesica_rects_from_corners_f64((const void *)corners, count, stride, (void *)out);
}

static inline int64_t go_rects_from_corners_f32(const char *corners, int64_t count, ptrdiff_t stride, char *out) {
    return vesica_rects_from_corners_f32((const void *)corners, count, stride, (void *)out);
}

static inline int64_t go_rect_corners_misfit_many_f64(const char *corners, ptrdiff_t stride, vesica_go_view rects,
    char *misfit) {
    vesica_shapes_f64 of_rects;
    memcpy(&of_rects, &rects, sizeof of_rects);
    return vesica_rect_corners_misfit_many_f64((const void *)corners, stride, &of_rects, (void *)misfit);
}

static inline int64_t go_rect_corners_misfit_many_f32(const char *corners, ptrdiff_t stride, vesica_go_view rects,
    char *misfit) {
    vesica_shapes_f32 of_rects;
    memcpy(&of_rects, &rects, sizeof of_rects);
    return vesica_rect_corners_misfit_many_f32((const void *)corners, stride, &of_rects, (void *)misfit);
}

static inline int64_t go_boxes_from_shapes_f64(vesica_go_view shapes, int32_t angle, char *boxes) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_boxes_from_shapes_f64(&of_shapes, angle, (void *)boxes);
}

static inline int64_t go_boxes_from_shapes_f32(vesica_go_view shapes, int32_t angle, char *boxes) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_boxes_from_shapes_f32(&of_shapes, angle, (void *)boxes);
}

static inline int64_t go_corners_of_shapes_f64(vesica_go_view shapes, char *corners) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_corners_of_shapes_f64(&of_shapes, (void *)corners);
}

static inline int64_t go_corners_of_shapes_f32(vesica_go_view shapes, char *corners) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_corners_of_shapes_f32(&of_shapes, (void *)corners);
}

static inline int64_t go_bounds_many_f64(vesica_go_view shapes, char *out) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_bounds_many_f64(&of_shapes, (void *)out);
}

static inline int64_t go_bounds_many_f32(vesica_go_view shapes, char *out) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_bounds_many_f32(&of_shapes, (void *)out);
}

static inline int64_t go_shape_area_many_f64(vesica_go_view shapes, char *out) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_shape_area_many_f64(&of_shapes, (void *)out);
}

static inline int64_t go_shape_area_many_f32(vesica_go_view shapes, char *out) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_shape_area_many_f32(&of_shapes, (void *)out);
}

static inline int64_t go_convex_hull_f64(const char *points, char *out, int64_t capacity) {
    return vesica_convex_hull_f64((const void *)points, (void *)out, capacity);
}

static inline int64_t go_convex_hull_f32(const char *points, char *out, int64_t capacity) {
    return vesica_convex_hull_f32((const void *)points, (void *)out, capacity);
}

static inline int32_t go_min_area_rect_f64(const char *points, char *out) {
    return vesica_min_area_rect_f64((const void *)points, (void *)out);
}

static inline int32_t go_min_area_rect_f32(const char *points, char *out) {
    return vesica_min_area_rect_f32((const void *)points, (void *)out);
}

static inline int32_t go_min_perimeter_rect_f64(const char *points, char *out) {
    return vesica_min_perimeter_rect_f64((const void *)points, (void *)out);
}

static inline int32_t go_min_perimeter_rect_f32(const char *points, char *out) {
    return vesica_min_perimeter_rect_f32((const void *)points, (void *)out);
}

static inline int64_t go_min_area_rect_many_f64(vesica_go_view points, char *out) {
    vesica_shapes_f64 of_points;
    memcpy(&of_points, &points, sizeof of_points);
    return vesica_min_area_rect_many_f64(&of_points, (void *)out);
}

static inline int64_t go_min_area_rect_many_f32(vesica_go_view points, char *out) {
    vesica_shapes_f32 of_points;
    memcpy(&of_points, &points, sizeof of_points);
    return vesica_min_area_rect_many_f32(&of_points, (void *)out);
}

static inline int64_t go_min_perimeter_rect_many_f64(vesica_go_view points, char *out) {
    vesica_shapes_f64 of_points;
    memcpy(&of_points, &points, sizeof of_points);
    return vesica_min_perimeter_rect_many_f64(&of_points, (void *)out);
}

static inline int64_t go_min_perimeter_rect_many_f32(vesica_go_view points, char *out) {
    vesica_shapes_f32 of_points;
    memcpy(&of_points, &points, sizeof of_points);
    return vesica_min_perimeter_rect_many_f32(&of_points, (void *)out);
}

static inline int64_t go_join_ratio_f64(int32_t ratio, double threshold, const char *index_a, vesica_go_sets sets_a,
    int32_t set_count_a, const char *index_b, vesica_go_sets sets_b, int32_t set_count_b, int64_t part, int64_t parts,
    char *scratch, int64_t scratch_size, char *out_a, char *out_b, char *values, int64_t capacity, char *state) {
    vesica_shapes_f64 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f64 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_ratio_f64(ratio, threshold, (const void *)index_a, of_sets_a, set_count_a, (const void *)index_b,
        of_sets_b, set_count_b, part, parts, (void *)scratch, scratch_size, (void *)out_a, (void *)out_b,
        (void *)values, capacity, (void *)state);
}

static inline int64_t go_join_ratio_f32(int32_t ratio, float threshold, const char *index_a, vesica_go_sets sets_a,
    int32_t set_count_a, const char *index_b, vesica_go_sets sets_b, int32_t set_count_b, int64_t part, int64_t parts,
    char *scratch, int64_t scratch_size, char *out_a, char *out_b, char *values, int64_t capacity, char *state) {
    vesica_shapes_f32 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f32 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_ratio_f32(ratio, threshold, (const void *)index_a, of_sets_a, set_count_a, (const void *)index_b,
        of_sets_b, set_count_b, part, parts, (void *)scratch, scratch_size, (void *)out_a, (void *)out_b,
        (void *)values, capacity, (void *)state);
}

static inline int64_t go_assign_greedy_f64(const char *a, const char *b, const char *values, int64_t count,
    int64_t count_a, int64_t count_b, char *scratch, int64_t scratch_size, char *chosen) {
    return vesica_assign_greedy_f64((const void *)a, (const void *)b, (const void *)values, count, count_a, count_b,
        (void *)scratch, scratch_size, (void *)chosen);
}

static inline int64_t go_assign_greedy_f32(const char *a, const char *b, const char *values, int64_t count,
    int64_t count_a, int64_t count_b, char *scratch, int64_t scratch_size, char *chosen) {
    return vesica_assign_greedy_f32((const void *)a, (const void *)b, (const void *)values, count, count_a, count_b,
        (void *)scratch, scratch_size, (void *)chosen);
}

static inline int32_t go_fuse_f64(vesica_go_view shapes, const char *scores, const char *weights, const char *labels,
    double threshold, int32_t fused_score, char *scratch, int64_t scratch_size, char *fused, char *fused_scores,
    char *clusters, char *count) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_fuse_f64(&of_shapes, (const void *)scores, (const void *)weights, (const void *)labels, threshold,
        fused_score, (void *)scratch, scratch_size, (void *)fused, (void *)fused_scores, (void *)clusters,
        (void *)count);
}

static inline int32_t go_fuse_f32(vesica_go_view shapes, const char *scores, const char *weights, const char *labels,
    float threshold, int32_t fused_score, char *scratch, int64_t scratch_size, char *fused, char *fused_scores,
    char *clusters, char *count) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_fuse_f32(&of_shapes, (const void *)scores, (const void *)weights, (const void *)labels, threshold,
        fused_score, (void *)scratch, scratch_size, (void *)fused, (void *)fused_scores, (void *)clusters,
        (void *)count);
}

static inline int32_t go_volume_ratio_f64(int32_t ratio, int32_t kind_a, vesica_go_shape a, const char *span_a,
    int32_t kind_b, vesica_go_shape b, const char *span_b, char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_volume_ratio_f64(ratio, kind_a, &of_a, (const void *)span_a, kind_b, &of_b, (const void *)span_b,
        (void *)out);
}

static inline int32_t go_volume_ratio_f32(int32_t ratio, int32_t kind_a, vesica_go_shape a, const char *span_a,
    int32_t kind_b, vesica_go_shape b, const char *span_b, char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_volume_ratio_f32(ratio, kind_a, &of_a, (const void *)span_a, kind_b, &of_b, (const void *)span_b,
        (void *)out);
}

static inline int64_t go_volume_ratio_many_f64(int32_t ratio, vesica_go_view a, const char *spans_a, vesica_go_view b,
    const char *spans_b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_volume_ratio_many_f64(ratio, &of_a, (const void *)spans_a, &of_b, (const void *)spans_b, (void *)out);
}

static inline int64_t go_volume_ratio_many_f32(int32_t ratio, vesica_go_view a, const char *spans_a, vesica_go_view b,
    const char *spans_b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_volume_ratio_many_f32(ratio, &of_a, (const void *)spans_a, &of_b, (const void *)spans_b, (void *)out);
}

static inline int64_t go_volume_ratio_matrix_f64(int32_t ratio, vesica_go_view a, const char *spans_a, vesica_go_view b,
    const char *spans_b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_volume_ratio_matrix_f64(ratio, &of_a, (const void *)spans_a, &of_b, (const void *)spans_b,
        (void *)out, row_stride);
}

static inline int64_t go_volume_ratio_matrix_f32(int32_t ratio, vesica_go_view a, const char *spans_a, vesica_go_view b,
    const char *spans_b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_volume_ratio_matrix_f32(ratio, &of_a, (const void *)spans_a, &of_b, (const void *)spans_b,
        (void *)out, row_stride);
}

static inline int32_t go_match_truths_f64(int32_t rule, const char *a, const char *b, const char *values, int64_t count,
    const char *scores, int64_t detections, const char *flags, int64_t truths, const char *thresholds,
    int64_t threshold_count, char *scratch, int64_t scratch_size, char *outcomes, char *taken) {
    return vesica_match_truths_f64(rule, (const void *)a, (const void *)b, (const void *)values, count,
        (const void *)scores, detections, (const void *)flags, truths, (const void *)thresholds, threshold_count,
        (void *)scratch, scratch_size, (void *)outcomes, (void *)taken);
}

static inline int32_t go_match_truths_f32(int32_t rule, const char *a, const char *b, const char *values, int64_t count,
    const char *scores, int64_t detections, const char *flags, int64_t truths, const char *thresholds,
    int64_t threshold_count, char *scratch, int64_t scratch_size, char *outcomes, char *taken) {
    return vesica_match_truths_f32(rule, (const void *)a, (const void *)b, (const void *)values, count,
        (const void *)scores, detections, (const void *)flags, truths, (const void *)thresholds, threshold_count,
        (void *)scratch, scratch_size, (void *)outcomes, (void *)taken);
}

static inline int32_t go_average_precision_f64(int32_t rule, const char *scores, const char *outcomes, int64_t count,
    int64_t truths, char *scratch, int64_t scratch_size, char *out) {
    return vesica_average_precision_f64(rule, (const void *)scores, (const void *)outcomes, count, truths,
        (void *)scratch, scratch_size, (void *)out);
}

static inline int32_t go_average_precision_f32(int32_t rule, const char *scores, const char *outcomes, int64_t count,
    int64_t truths, char *scratch, int64_t scratch_size, char *out) {
    return vesica_average_precision_f32(rule, (const void *)scores, (const void *)outcomes, count, truths,
        (void *)scratch, scratch_size, (void *)out);
}

static inline int32_t go_gaussian_distance_f64(int32_t which, int32_t kind_a, vesica_go_shape a, int32_t kind_b,
    vesica_go_shape b, char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_gaussian_distance_f64(which, kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_gaussian_distance_f32(int32_t which, int32_t kind_a, vesica_go_shape a, int32_t kind_b,
    vesica_go_shape b, char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_gaussian_distance_f32(which, kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int64_t go_gaussian_distance_many_f64(int32_t which, vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_gaussian_distance_many_f64(which, &of_a, &of_b, (void *)out);
}

static inline int64_t go_gaussian_distance_many_f32(int32_t which, vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_gaussian_distance_many_f32(which, &of_a, &of_b, (void *)out);
}

static inline int64_t go_gaussian_distance_matrix_f64(int32_t which, vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_gaussian_distance_matrix_f64(which, &of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_gaussian_distance_matrix_f32(int32_t which, vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_gaussian_distance_matrix_f32(which, &of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_index_build_f64(vesica_go_sets sets, int32_t set_count, char *index, int64_t index_size,
    char *scratch, int64_t scratch_size) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    return vesica_index_build_f64(of_sets, set_count, (void *)index, index_size, (void *)scratch, scratch_size);
}

static inline int64_t go_index_build_f32(vesica_go_sets sets, int32_t set_count, char *index, int64_t index_size,
    char *scratch, int64_t scratch_size) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    return vesica_index_build_f32(of_sets, set_count, (void *)index, index_size, (void *)scratch, scratch_size);
}

static inline int64_t go_index_step_f64(int32_t step, int64_t part, int64_t parts, vesica_go_sets sets,
    int32_t set_count, char *index, int64_t index_size, char *scratch, int64_t scratch_size) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    return vesica_index_step_f64(step, part, parts, of_sets, set_count, (void *)index, index_size, (void *)scratch,
        scratch_size);
}

static inline int64_t go_index_step_f32(int32_t step, int64_t part, int64_t parts, vesica_go_sets sets,
    int32_t set_count, char *index, int64_t index_size, char *scratch, int64_t scratch_size) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    return vesica_index_step_f32(step, part, parts, of_sets, set_count, (void *)index, index_size, (void *)scratch,
        scratch_size);
}

static inline int64_t go_index_select_f64(const char *index, vesica_go_sets sets, int32_t set_count, vesica_go_view one,
    char *out, int64_t capacity, char *state) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_select_f64((const void *)index, of_sets, set_count, &of_one, (void *)out, capacity,
        (void *)state);
}

static inline int64_t go_index_select_f32(const char *index, vesica_go_sets sets, int32_t set_count, vesica_go_view one,
    char *out, int64_t capacity, char *state) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_select_f32((const void *)index, of_sets, set_count, &of_one, (void *)out, capacity,
        (void *)state);
}

static inline int64_t go_join_f64(int32_t query, const char *index_a, vesica_go_sets sets_a, int32_t set_count_a,
    const char *index_b, vesica_go_sets sets_b, int32_t set_count_b, int64_t part, int64_t parts, char *scratch,
    int64_t scratch_size, char *out_a, char *out_b, int64_t capacity, char *state) {
    vesica_shapes_f64 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f64 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_f64(query, (const void *)index_a, of_sets_a, set_count_a, (const void *)index_b, of_sets_b,
        set_count_b, part, parts, (void *)scratch, scratch_size, (void *)out_a, (void *)out_b, capacity, (void *)state);
}

static inline int64_t go_join_f32(int32_t query, const char *index_a, vesica_go_sets sets_a, int32_t set_count_a,
    const char *index_b, vesica_go_sets sets_b, int32_t set_count_b, int64_t part, int64_t parts, char *scratch,
    int64_t scratch_size, char *out_a, char *out_b, int64_t capacity, char *state) {
    vesica_shapes_f32 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f32 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_f32(query, (const void *)index_a, of_sets_a, set_count_a, (const void *)index_b, of_sets_b,
        set_count_b, part, parts, (void *)scratch, scratch_size, (void *)out_a, (void *)out_b, capacity, (void *)state);
}

static inline int64_t go_join_within_f64(const char *index_a, vesica_go_sets sets_a, int32_t set_count_a,
    const char *index_b, vesica_go_sets sets_b, int32_t set_count_b, double distance, int64_t part, int64_t parts,
    char *out_a, char *out_b, int64_t capacity, char *state) {
    vesica_shapes_f64 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f64 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_within_f64((const void *)index_a, of_sets_a, set_count_a, (const void *)index_b, of_sets_b,
        set_count_b, distance, part, parts, (void *)out_a, (void *)out_b, capacity, (void *)state);
}

static inline int64_t go_join_within_f32(const char *index_a, vesica_go_sets sets_a, int32_t set_count_a,
    const char *index_b, vesica_go_sets sets_b, int32_t set_count_b, float distance, int64_t part, int64_t parts,
    char *out_a, char *out_b, int64_t capacity, char *state) {
    vesica_shapes_f32 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f32 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_within_f32((const void *)index_a, of_sets_a, set_count_a, (const void *)index_b, of_sets_b,
        set_count_b, distance, part, parts, (void *)out_a, (void *)out_b, capacity, (void *)state);
}

static inline int64_t go_index_nearest_f64(const char *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, int64_t k, double within, char *out, char *distance) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_nearest_f64((const void *)index, of_sets, set_count, &of_one, k, within, (void *)out,
        (void *)distance);
}

static inline int64_t go_index_nearest_f32(const char *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, int64_t k, float within, char *out, char *distance) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_nearest_f32((const void *)index, of_sets, set_count, &of_one, k, within, (void *)out,
        (void *)distance);
}

static inline int64_t go_join_nearest_f64(vesica_go_sets sets_a, int32_t set_count_a, const char *index_b,
    vesica_go_sets sets_b, int32_t set_count_b, int64_t k, double within, int64_t part, int64_t parts, char *out,
    char *distance) {
    vesica_shapes_f64 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f64 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_nearest_f64(of_sets_a, set_count_a, (const void *)index_b, of_sets_b, set_count_b, k, within,
        part, parts, (void *)out, (void *)distance);
}

static inline int64_t go_join_nearest_f32(vesica_go_sets sets_a, int32_t set_count_a, const char *index_b,
    vesica_go_sets sets_b, int32_t set_count_b, int64_t k, float within, int64_t part, int64_t parts, char *out,
    char *distance) {
    vesica_shapes_f32 of_sets_a[64];
    memcpy(of_sets_a, &sets_a, sizeof of_sets_a);
    vesica_shapes_f32 of_sets_b[64];
    memcpy(of_sets_b, &sets_b, sizeof of_sets_b);
    return vesica_join_nearest_f32(of_sets_a, set_count_a, (const void *)index_b, of_sets_b, set_count_b, k, within,
        part, parts, (void *)out, (void *)distance);
}

static inline int32_t go_polygon_boxes_f64(int32_t kind, const char *path, char *boxes, int64_t size) {
    return vesica_polygon_boxes_f64(kind, (const void *)path, (void *)boxes, size);
}

static inline int32_t go_polygon_boxes_f32(int32_t kind, const char *path, char *boxes, int64_t size) {
    return vesica_polygon_boxes_f32(kind, (const void *)path, (void *)boxes, size);
}

static inline int32_t go_polygon_boxes_overlap_f64(int32_t kind, const char *path, const char *boxes, int64_t size,
    int32_t kind_b, vesica_go_shape b) {
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_polygon_boxes_overlap_f64(kind, (const void *)path, (const void *)boxes, size, kind_b, &of_b);
}

static inline int32_t go_polygon_boxes_overlap_f32(int32_t kind, const char *path, const char *boxes, int64_t size,
    int32_t kind_b, vesica_go_shape b) {
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_polygon_boxes_overlap_f32(kind, (const void *)path, (const void *)boxes, size, kind_b, &of_b);
}

static inline int32_t go_polygon_boxes_nearest_f64(int32_t kind, const char *path, const char *boxes, int64_t size,
    int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_polygon_boxes_nearest_f64(kind, (const void *)path, (const void *)boxes, size, kind_b, &of_b,
        (void *)out);
}

static inline int32_t go_polygon_boxes_nearest_f32(int32_t kind, const char *path, const char *boxes, int64_t size,
    int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_polygon_boxes_nearest_f32(kind, (const void *)path, (const void *)boxes, size, kind_b, &of_b,
        (void *)out);
}

static inline int32_t go_polygon_boxes_within_f64(int32_t kind, const char *path, const char *boxes, int64_t size,
    int32_t kind_b, vesica_go_shape b, double distance) {
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_polygon_boxes_within_f64(kind, (const void *)path, (const void *)boxes, size, kind_b, &of_b,
        distance);
}

static inline int32_t go_polygon_boxes_within_f32(int32_t kind, const char *path, const char *boxes, int64_t size,
    int32_t kind_b, vesica_go_shape b, float distance) {
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_polygon_boxes_within_f32(kind, (const void *)path, (const void *)boxes, size, kind_b, &of_b,
        distance);
}

static inline int32_t go_ratio_f64(int32_t ratio, int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_ratio_f64(ratio, kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_ratio_f32(int32_t ratio, int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_ratio_f32(ratio, kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int64_t go_ratio_many_f64(int32_t ratio, vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_ratio_many_f64(ratio, &of_a, &of_b, (void *)out);
}

static inline int64_t go_ratio_many_f32(int32_t ratio, vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_ratio_many_f32(ratio, &of_a, &of_b, (void *)out);
}

static inline int64_t go_ratio_matrix_f64(int32_t ratio, vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_ratio_matrix_f64(ratio, &of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_ratio_matrix_f32(int32_t ratio, vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_ratio_matrix_f32(ratio, &of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_nearest_matrix_f64(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_nearest_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_nearest_matrix_f32(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_nearest_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_boundary_distance_matrix_f64(vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_boundary_distance_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_boundary_distance_matrix_f32(vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_boundary_distance_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_depth_matrix_f64(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_depth_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_depth_matrix_f32(vesica_go_view a, vesica_go_view b, char *out, ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_depth_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int32_t go_signed_distance_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_signed_distance_f64(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_signed_distance_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_signed_distance_f32(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int64_t go_signed_distance_many_f64(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_signed_distance_many_f64(&of_a, &of_b, (void *)out);
}

static inline int64_t go_signed_distance_many_f32(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_signed_distance_many_f32(&of_a, &of_b, (void *)out);
}

static inline int64_t go_signed_distance_matrix_f64(vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_signed_distance_matrix_f64(&of_a, &of_b, (void *)out, row_stride);
}

static inline int64_t go_signed_distance_matrix_f32(vesica_go_view a, vesica_go_view b, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_signed_distance_matrix_f32(&of_a, &of_b, (void *)out, row_stride);
}

static inline int32_t go_within_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    double distance) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_within_f64(kind_a, &of_a, kind_b, &of_b, distance);
}

static inline int32_t go_within_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    float distance) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_within_f32(kind_a, &of_a, kind_b, &of_b, distance);
}

static inline int64_t go_within_many_f64(vesica_go_view a, vesica_go_view b, double distance, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_within_many_f64(&of_a, &of_b, distance, (void *)out);
}

static inline int64_t go_within_many_f32(vesica_go_view a, vesica_go_view b, float distance, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_within_many_f32(&of_a, &of_b, distance, (void *)out);
}

static inline int64_t go_within_matrix_f64(vesica_go_view a, vesica_go_view b, double distance, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_within_matrix_f64(&of_a, &of_b, distance, (void *)out, row_stride);
}

static inline int64_t go_within_matrix_f32(vesica_go_view a, vesica_go_view b, float distance, char *out,
    ptrdiff_t row_stride) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_within_matrix_f32(&of_a, &of_b, distance, (void *)out, row_stride);
}

static inline int32_t go_suppress_f64(vesica_go_view shapes, const char *scores, const char *labels, int32_t ratio,
    double threshold, double least_score, int64_t most, char *scratch, int64_t scratch_size, char *keep, char *kept) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_suppress_f64(&of_shapes, (const void *)scores, (const void *)labels, ratio, threshold, least_score,
        most, (void *)scratch, scratch_size, (void *)keep, (void *)kept);
}

static inline int32_t go_suppress_f32(vesica_go_view shapes, const char *scores, const char *labels, int32_t ratio,
    float threshold, float least_score, int64_t most, char *scratch, int64_t scratch_size, char *keep, char *kept) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_suppress_f32(&of_shapes, (const void *)scores, (const void *)labels, ratio, threshold, least_score,
        most, (void *)scratch, scratch_size, (void *)keep, (void *)kept);
}

static inline int32_t go_suppress_soft_f64(vesica_go_view shapes, const char *scores, const char *labels, int32_t ratio,
    int32_t decay, double parameter, double least_score, int64_t most, char *scratch, int64_t scratch_size, char *keep,
    char *decayed, char *kept) {
    vesica_shapes_f64 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_suppress_soft_f64(&of_shapes, (const void *)scores, (const void *)labels, ratio, decay, parameter,
        least_score, most, (void *)scratch, scratch_size, (void *)keep, (void *)decayed, (void *)kept);
}

static inline int32_t go_suppress_soft_f32(vesica_go_view shapes, const char *scores, const char *labels, int32_t ratio,
    int32_t decay, float parameter, float least_score, int64_t most, char *scratch, int64_t scratch_size, char *keep,
    char *decayed, char *kept) {
    vesica_shapes_f32 of_shapes;
    memcpy(&of_shapes, &shapes, sizeof of_shapes);
    return vesica_suppress_soft_f32(&of_shapes, (const void *)scores, (const void *)labels, ratio, decay, parameter,
        least_score, most, (void *)scratch, scratch_size, (void *)keep, (void *)decayed, (void *)kept);
}

static inline int32_t go_coverage_f64(int32_t kind, vesica_go_shape shape, const char *grid, char *out,
    ptrdiff_t row_stride) {
    vesica_go_f64 of_shape = go_read_f64(kind, &shape);
    return vesica_coverage_f64(kind, &of_shape, (const void *)grid, (void *)out, row_stride);
}

static inline int32_t go_coverage_f32(int32_t kind, vesica_go_shape shape, const char *grid, char *out,
    ptrdiff_t row_stride) {
    vesica_go_f32 of_shape = go_read_f32(kind, &shape);
    return vesica_coverage_f32(kind, &of_shape, (const void *)grid, (void *)out, row_stride);
}

static inline int64_t go_coverage_cells_f64(int32_t kind, vesica_go_shape shape, const char *grid, char *cells,
    char *shares, int64_t capacity) {
    vesica_go_f64 of_shape = go_read_f64(kind, &shape);
    return vesica_coverage_cells_f64(kind, &of_shape, (const void *)grid, (void *)cells, (void *)shares, capacity);
}

static inline int64_t go_coverage_cells_f32(int32_t kind, vesica_go_shape shape, const char *grid, char *cells,
    char *shares, int64_t capacity) {
    vesica_go_f32 of_shape = go_read_f32(kind, &shape);
    return vesica_coverage_cells_f32(kind, &of_shape, (const void *)grid, (void *)cells, (void *)shares, capacity);
}

static inline int32_t go_cast_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, double vx,
    double vy, double t_end, char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_cast_f64(kind_a, &of_a, kind_b, &of_b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, float vx,
    float vy, float t_end, char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_cast_f32(kind_a, &of_a, kind_b, &of_b, vx, vy, t_end, (void *)out);
}

static inline int64_t go_cast_many_f64(vesica_go_view a, vesica_go_view b, const char *vx, const char *vy,
    ptrdiff_t stride, double t_end, char *t, char *x, char *y, char *nx, char *ny) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_cast_many_f64(&of_a, &of_b, (const void *)vx, (const void *)vy, stride, t_end, (void *)t, (void *)x,
        (void *)y, (void *)nx, (void *)ny);
}

static inline int64_t go_cast_many_f32(vesica_go_view a, vesica_go_view b, const char *vx, const char *vy,
    ptrdiff_t stride, float t_end, char *t, char *x, char *y, char *nx, char *ny) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_cast_many_f32(&of_a, &of_b, (const void *)vx, (const void *)vy, stride, t_end, (void *)t, (void *)x,
        (void *)y, (void *)nx, (void *)ny);
}

static inline int64_t go_cast_first_f64(vesica_go_view one, vesica_go_view many, double vx, double vy, double t_end,
    char *out) {
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f64 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_cast_first_f64(&of_one, &of_many, vx, vy, t_end, (void *)out);
}

static inline int64_t go_cast_first_f32(vesica_go_view one, vesica_go_view many, float vx, float vy, float t_end,
    char *out) {
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    vesica_shapes_f32 of_many;
    memcpy(&of_many, &many, sizeof of_many);
    return vesica_cast_first_f32(&of_one, &of_many, vx, vy, t_end, (void *)out);
}

static inline int32_t go_sweep_bounds_f64(int32_t kind, vesica_go_shape shape, double vx, double vy, double t_end,
    char *out) {
    vesica_go_f64 of_shape = go_read_f64(kind, &shape);
    return vesica_sweep_bounds_f64(kind, &of_shape, vx, vy, t_end, (void *)out);
}

static inline int32_t go_sweep_bounds_f32(int32_t kind, vesica_go_shape shape, float vx, float vy, float t_end,
    char *out) {
    vesica_go_f32 of_shape = go_read_f32(kind, &shape);
    return vesica_sweep_bounds_f32(kind, &of_shape, vx, vy, t_end, (void *)out);
}

static inline int64_t go_index_cast_f64(const char *index, vesica_go_sets sets, int32_t set_count, vesica_go_view one,
    double vx, double vy, double t_end, char *out, int64_t capacity, char *state) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_cast_f64((const void *)index, of_sets, set_count, &of_one, vx, vy, t_end, (void *)out, capacity,
        (void *)state);
}

static inline int64_t go_index_cast_f32(const char *index, vesica_go_sets sets, int32_t set_count, vesica_go_view one,
    float vx, float vy, float t_end, char *out, int64_t capacity, char *state) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_cast_f32((const void *)index, of_sets, set_count, &of_one, vx, vy, t_end, (void *)out, capacity,
        (void *)state);
}

static inline int64_t go_index_cast_first_f64(const char *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, double vx, double vy, double t_end, char *out) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_cast_first_f64((const void *)index, of_sets, set_count, &of_one, vx, vy, t_end, (void *)out);
}

static inline int64_t go_index_cast_first_f32(const char *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, float vx, float vy, float t_end, char *out) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_cast_first_f32((const void *)index, of_sets, set_count, &of_one, vx, vy, t_end, (void *)out);
}

static inline int32_t go_impact_time_f64(int32_t kind_a, vesica_go_shape a, const char *turn_a, int32_t kind_b,
    vesica_go_shape b, const char *turn_b, double tolerance, char *out, char *gap) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_impact_time_f64(kind_a, &of_a, (const void *)turn_a, kind_b, &of_b, (const void *)turn_b, tolerance,
        (void *)out, (void *)gap);
}

static inline int32_t go_impact_time_f32(int32_t kind_a, vesica_go_shape a, const char *turn_a, int32_t kind_b,
    vesica_go_shape b, const char *turn_b, float tolerance, char *out, char *gap) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_impact_time_f32(kind_a, &of_a, (const void *)turn_a, kind_b, &of_b, (const void *)turn_b, tolerance,
        (void *)out, (void *)gap);
}

static inline int64_t go_index_impact_time_f64(const char *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, const char *turn, double tolerance, char *out, char *gap, char *answer) {
    vesica_shapes_f64 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f64 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_impact_time_f64((const void *)index, of_sets, set_count, &of_one, (const void *)turn, tolerance,
        (void *)out, (void *)gap, (void *)answer);
}

static inline int64_t go_index_impact_time_f32(const char *index, vesica_go_sets sets, int32_t set_count,
    vesica_go_view one, const char *turn, float tolerance, char *out, char *gap, char *answer) {
    vesica_shapes_f32 of_sets[64];
    memcpy(of_sets, &sets, sizeof of_sets);
    vesica_shapes_f32 of_one;
    memcpy(&of_one, &one, sizeof of_one);
    return vesica_index_impact_time_f32((const void *)index, of_sets, set_count, &of_one, (const void *)turn, tolerance,
        (void *)out, (void *)gap, (void *)answer);
}

static inline int32_t go_manifold_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_manifold_f64(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int32_t go_manifold_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *out) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_manifold_f32(kind_a, &of_a, kind_b, &of_b, (void *)out);
}

static inline int64_t go_manifold_many_f64(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f64 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f64 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_manifold_many_f64(&of_a, &of_b, (void *)out);
}

static inline int64_t go_manifold_many_f32(vesica_go_view a, vesica_go_view b, char *out) {
    vesica_shapes_f32 of_a;
    memcpy(&of_a, &a, sizeof of_a);
    vesica_shapes_f32 of_b;
    memcpy(&of_b, &b, sizeof of_b);
    return vesica_manifold_many_f32(&of_a, &of_b, (void *)out);
}

static inline int32_t go_cast_point_point_f64(const char *a, const char *b, double vx, double vy, double t_end,
    char *out) {
    return vesica_cast_point_point_f64((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_point_point_f32(const char *a, const char *b, float vx, float vy, float t_end,
    char *out) {
    return vesica_cast_point_point_f32((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_segment_point_f64(const char *a, const char *b, double vx, double vy, double t_end,
    char *out) {
    return vesica_cast_segment_point_f64((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_segment_point_f32(const char *a, const char *b, float vx, float vy, float t_end,
    char *out) {
    return vesica_cast_segment_point_f32((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_circle_point_f64(const char *a, const char *b, double vx, double vy, double t_end,
    char *out) {
    return vesica_cast_circle_point_f64((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_circle_point_f32(const char *a, const char *b, float vx, float vy, float t_end,
    char *out) {
    return vesica_cast_circle_point_f32((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_aabb_point_f64(const char *a, const char *b, double vx, double vy, double t_end,
    char *out) {
    return vesica_cast_aabb_point_f64((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_aabb_point_f32(const char *a, const char *b, float vx, float vy, float t_end, char *out) {
    return vesica_cast_aabb_point_f32((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_rect_point_f64(const char *a, const char *b, double vx, double vy, double t_end,
    char *out) {
    return vesica_cast_rect_point_f64((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_rect_point_f32(const char *a, const char *b, float vx, float vy, float t_end, char *out) {
    return vesica_cast_rect_point_f32((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_ellipse_point_f64(const char *a, const char *b, double vx, double vy, double t_end,
    char *out) {
    return vesica_cast_ellipse_point_f64((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_ellipse_point_f32(const char *a, const char *b, float vx, float vy, float t_end,
    char *out) {
    return vesica_cast_ellipse_point_f32((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_circle_circle_f64(const char *a, const char *b, double vx, double vy, double t_end,
    char *out) {
    return vesica_cast_circle_circle_f64((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_circle_circle_f32(const char *a, const char *b, float vx, float vy, float t_end,
    char *out) {
    return vesica_cast_circle_circle_f32((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_rect_rect_f64(const char *a, const char *b, double vx, double vy, double t_end,
    char *out) {
    return vesica_cast_rect_rect_f64((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_cast_rect_rect_f32(const char *a, const char *b, float vx, float vy, float t_end, char *out) {
    return vesica_cast_rect_rect_f32((const void *)a, (const void *)b, vx, vy, t_end, (void *)out);
}

static inline int32_t go_de9im_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *matrix) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_de9im_f64(kind_a, &of_a, kind_b, &of_b, (void *)matrix);
}

static inline int32_t go_de9im_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b, char *matrix) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_de9im_f32(kind_a, &of_a, kind_b, &of_b, (void *)matrix);
}

static inline int64_t go_intersection_f64(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    char *out, int64_t capacity) {
    vesica_go_f64 of_a = go_read_f64(kind_a, &a);
    vesica_go_f64 of_b = go_read_f64(kind_b, &b);
    return vesica_intersection_f64(kind_a, &of_a, kind_b, &of_b, (void *)out, capacity);
}

static inline int64_t go_intersection_f32(int32_t kind_a, vesica_go_shape a, int32_t kind_b, vesica_go_shape b,
    char *out, int64_t capacity) {
    vesica_go_f32 of_a = go_read_f32(kind_a, &a);
    vesica_go_f32 of_b = go_read_f32(kind_b, &b);
    return vesica_intersection_f32(kind_a, &of_a, kind_b, &of_b, (void *)out, capacity);
}

#endif
