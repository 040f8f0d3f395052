/*
 * Vesica in C11: one name for each query, which takes kinds and scalar from the types of its arguments.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * vesica.h includes this file. To C99 and C++ it is empty.
 *
 *     vesica_circle_f64 car = {0, 0, 2};
 *     vesica_point_f64 person = {5, 0};
 *     vesica_closest_points_f64 out;
 *     int32_t error = vesica_nearest(&car, &person, &out);
 *
 * Every argument is a pointer to a shape, a motion or a result, or a number. Each is evaluated once. A call that mixes
 * pointers to double and to float does not compile; numbers are converted to the shapes' type. Results
 * and errors are those of the functions, such as vesica_nearest_f64.
 */
#if !defined(VESICA_GENERIC_H) && !defined(__cplusplus) && defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define VESICA_GENERIC_H

#include "vesica.h"

#define vesica_check(shape) VESICA_QUERY_(vesica_check, VESICA_SIZE_(shape))(VESICA_SHAPE_(shape))
#define vesica_shape_area(shape, out) VESICA_ONE_(vesica_shape_area, shape, out)
#define vesica_bounds(shape, out) VESICA_ONE_(vesica_bounds, shape, out)
#define vesica_polygon_facts(polygon, out) \
    VESICA_QUERY_(vesica_polygon_facts, VESICA_SIZE_(polygon) & VESICA_SIZE_(out))(polygon, out)
#define vesica_convex_hull(points, out, capacity) \
    VESICA_QUERY_(vesica_convex_hull, VESICA_SIZE_(points) & VESICA_SIZE_(out))(points, out, capacity)
#define vesica_min_area_rect(points, out) \
    VESICA_QUERY_(vesica_min_area_rect, VESICA_SIZE_(points) & VESICA_SIZE_(out))(points, out)
#define vesica_min_perimeter_rect(points, out) \
    VESICA_QUERY_(vesica_min_perimeter_rect, VESICA_SIZE_(points) & VESICA_SIZE_(out))(points, out)

#define vesica_coverage(shape, grid, out, row_stride) \
    VESICA_QUERY_(vesica_coverage, VESICA_SIZE_(shape) & VESICA_SIZE_(grid) & VESICA_SIZE_(out)) \
    (VESICA_SHAPE_(shape), grid, out, row_stride)
#define vesica_coverage_cells(shape, grid, cells, shares, capacity) \
    VESICA_QUERY_(vesica_coverage_cells, VESICA_SIZE_(shape) & VESICA_SIZE_(grid) & VESICA_SIZE_(shares)) \
    (VESICA_SHAPE_(shape), grid, cells, shares, capacity)

#define vesica_overlap(a, b) VESICA_TWO_(vesica_overlap, a, b)
#define vesica_interiors_overlap(a, b) VESICA_TWO_(vesica_interiors_overlap, a, b)
#define vesica_relation(a, b) VESICA_TWO_(vesica_relation, a, b)
#define vesica_contains(a, b) VESICA_TWO_(vesica_contains, a, b)

#define vesica_crossings(a, b, out, capacity, shared) \
    VESICA_QUERY_(vesica_crossings, VESICA_SIZE_(a) & VESICA_SIZE_(b) & VESICA_SIZE_(out)) \
    (VESICA_SHAPE_(a), VESICA_SHAPE_(b), out, capacity, shared)
#define vesica_nearest(a, b, out) VESICA_TWO_OUT_(vesica_nearest, a, b, out)
#define vesica_boundary_distance(a, b, out) VESICA_TWO_OUT_(vesica_boundary_distance, a, b, out)
#define vesica_depth(a, b, out) VESICA_TWO_OUT_(vesica_depth, a, b, out)
#define vesica_area(a, b, out) VESICA_TWO_OUT_(vesica_area, a, b, out)
#define vesica_iou(a, b, out) VESICA_TWO_OUT_(vesica_iou, a, b, out)
#define vesica_ratio(ratio, a, b, out) \
    VESICA_QUERY_(vesica_ratio, VESICA_SIZE_(a) & VESICA_SIZE_(b) & VESICA_SIZE_(out)) \
    (ratio, VESICA_SHAPE_(a), VESICA_SHAPE_(b), out)
#define vesica_gaussian_distance(which, a, b, out) \
    VESICA_QUERY_(vesica_gaussian_distance, VESICA_SIZE_(a) & VESICA_SIZE_(b) & VESICA_SIZE_(out)) \
    (which, VESICA_SHAPE_(a), VESICA_SHAPE_(b), out)
#define vesica_volume_ratio(ratio, a, span_a, b, span_b, out) \
    VESICA_QUERY_(vesica_volume_ratio, VESICA_SIZE_(a) & VESICA_SIZE_(span_a) & VESICA_SIZE_(b) & VESICA_SIZE_(span_b) \
        & VESICA_SIZE_(out)) \
    (ratio, VESICA_SHAPE_(a), span_a, VESICA_SHAPE_(b), span_b, out)
#define vesica_signed_distance(a, b, out) VESICA_TWO_OUT_(vesica_signed_distance, a, b, out)
#define vesica_within(a, b, distance) \
    VESICA_QUERY_(vesica_within, VESICA_SIZE_(a) & VESICA_SIZE_(b))(VESICA_SHAPE_(a), VESICA_SHAPE_(b), distance)

#define vesica_de9im(a, b, matrix) \
    VESICA_QUERY_(vesica_de9im, VESICA_SIZE_(a) & VESICA_SIZE_(b))(VESICA_SHAPE_(a), VESICA_SHAPE_(b), matrix)
#define vesica_intersection(a, b, out, capacity) \
    VESICA_QUERY_(vesica_intersection, VESICA_SIZE_(a) & VESICA_SIZE_(b) & VESICA_SIZE_(out)) \
    (VESICA_SHAPE_(a), VESICA_SHAPE_(b), out, capacity)

#define vesica_cast(a, b, vx, vy, t_end, out) \
    VESICA_QUERY_(vesica_cast, VESICA_SIZE_(a) & VESICA_SIZE_(b) & VESICA_SIZE_(out)) \
    (VESICA_SHAPE_(a), VESICA_SHAPE_(b), vx, vy, t_end, out)
#define vesica_impact_time(a, turn_a, b, turn_b, tolerance, out, gap) \
    VESICA_QUERY_(vesica_impact_time, VESICA_SIZE_(a) & VESICA_SIZE_(b) & VESICA_SIZE_(turn_a) & VESICA_SIZE_(turn_b) \
        & VESICA_SIZE_(out) & VESICA_SIZE_(gap)) \
    (VESICA_SHAPE_(a), turn_a, VESICA_SHAPE_(b), turn_b, tolerance, out, gap)
#define vesica_manifold(a, b, out) VESICA_TWO_OUT_(vesica_manifold, a, b, out)
#define vesica_sweep_bounds(shape, vx, vy, t_end, out) \
    VESICA_QUERY_(vesica_sweep_bounds, VESICA_SIZE_(shape) & VESICA_SIZE_(out)) \
    (VESICA_SHAPE_(shape), vx, vy, t_end, out)

/* Kind of the shape that a pointer points to: VESICA_POINT ... VESICA_POLYLINE. */
#define VESICA_KIND_OF(shape) \
    _Generic(*(shape), \
        vesica_point_f64: VESICA_POINT, vesica_point_f32: VESICA_POINT, \
        vesica_segment_f64: VESICA_SEGMENT, vesica_segment_f32: VESICA_SEGMENT, \
        vesica_circle_f64: VESICA_CIRCLE, vesica_circle_f32: VESICA_CIRCLE, \
        vesica_aabb_f64: VESICA_AABB, vesica_aabb_f32: VESICA_AABB, \
        vesica_rect_f64: VESICA_RECT, vesica_rect_f32: VESICA_RECT, \
        vesica_ellipse_f64: VESICA_ELLIPSE, vesica_ellipse_f32: VESICA_ELLIPSE, \
        vesica_capsule_f64: VESICA_CAPSULE, vesica_capsule_f32: VESICA_CAPSULE, \
        vesica_round_rect_f64: VESICA_ROUND_RECT, vesica_round_rect_f32: VESICA_ROUND_RECT, \
        vesica_polygon_f64: VESICA_POLYGON, vesica_polygon_f32: VESICA_POLYGON, \
        vesica_polyline_f64: VESICA_POLYLINE, vesica_polyline_f32: VESICA_POLYLINE)

/* ---- Implementation. Names that end in _ may change in any release. ---- */

/* Bytes of one number in what a pointer points to, a shape or a result: 8 for double, 4 for float. */
#define VESICA_SIZE_(pointer) \
    _Generic(*(pointer), \
        double: 8, vesica_point_f64: 8, vesica_segment_f64: 8, vesica_circle_f64: 8, vesica_aabb_f64: 8, \
        vesica_rect_f64: 8, vesica_ellipse_f64: 8, vesica_capsule_f64: 8, vesica_round_rect_f64: 8, \
        vesica_polygon_f64: 8, vesica_polyline_f64: 8, vesica_facts_f64: 8, vesica_closest_points_f64: 8, \
        vesica_grid_f64: 8, vesica_penetration_f64: 8, vesica_impact_f64: 8, vesica_turn_f64: 8, \
        vesica_span_f64: 8, vesica_contacts_f64: 8, \
        float: 4, vesica_point_f32: 4, vesica_segment_f32: 4, vesica_circle_f32: 4, vesica_aabb_f32: 4, \
        vesica_rect_f32: 4, vesica_ellipse_f32: 4, vesica_capsule_f32: 4, vesica_round_rect_f32: 4, \
        vesica_polygon_f32: 4, vesica_polyline_f32: 4, vesica_facts_f32: 4, vesica_closest_points_f32: 4, \
        vesica_grid_f32: 4, vesica_penetration_f32: 4, vesica_impact_f32: 4, vesica_turn_f32: 4, \
        vesica_span_f32: 4, vesica_contacts_f32: 4)

/* Chooses by a constant size. Sizes of several arguments are joined by &: 8 & 4 is 0, which matches nothing. */
#define VESICA_PICK_(size, of_double, of_float) \
    _Generic((char (*)[size])0, char (*)[8]: of_double, char (*)[4]: of_float)
#define VESICA_QUERY_(query, size) VESICA_PICK_(size, query##_f64, query##_f32)

/* A shape as the functions take it: its kind and a pointer to its struct. */
#define VESICA_SHAPE_(shape) VESICA_KIND_OF(shape), (shape)

#define VESICA_ONE_(query, shape, out) \
    VESICA_QUERY_(query, VESICA_SIZE_(shape) & VESICA_SIZE_(out))(VESICA_SHAPE_(shape), out)
#define VESICA_TWO_(query, a, b) \
    VESICA_QUERY_(query, VESICA_SIZE_(a) & VESICA_SIZE_(b))(VESICA_SHAPE_(a), VESICA_SHAPE_(b))
#define VESICA_TWO_OUT_(query, a, b, out) \
    VESICA_QUERY_(query, VESICA_SIZE_(a) & VESICA_SIZE_(b) & VESICA_SIZE_(out)) \
    (VESICA_SHAPE_(a), VESICA_SHAPE_(b), out)

#endif /* VESICA_GENERIC_H */
