// SPDX-License-Identifier: Apache-2.0
/* The C11 macros: kinds and scalar from the types of pointers. Its own program, as it needs C11. */
#include <stdio.h>
#include <string.h>
#include <vesica.h>

static int failures = 0;

static void expect(int line, int32_t answer, int32_t expected) {
  if (answer == expected) return;
  fprintf(stderr, "generic_test.c:%d: %d instead of %d\n", line, (int)answer, (int)expected);
  ++failures;
}
#define EXPECT(answer, expected) expect(__LINE__, answer, expected)

/* Each shape touches the line x = 3 from the left, at (3, 0) or along an edge; the probes lie on either side of it. */
static void test_double(void) {
  const vesica_point_f64 point = {3, 0};
  const vesica_segment_f64 segment = {0, 0, 3, 0};
  const vesica_circle_f64 circle = {1, 0, 2};
  const vesica_aabb_f64 aabb = {0, -1, 3, 1};
  const vesica_rect_f64 rect = {1, 0, 1, 0, 2, 1};
  const vesica_ellipse_f64 ellipse = {1, 0, 1, 0, 2, 1};
  const vesica_capsule_f64 capsule = {0, 0, 2, 0, 1};
  const vesica_round_rect_f64 round_rect = {1, 0, 1, 0, 1, 1, 1};
  vesica_circle_f64 touching = {5, 0, 2};
  vesica_aabb_f64 apart = {3.0000000000000004, -9, 9, 9};

  EXPECT(VESICA_KIND_OF(&point), VESICA_POINT);
  EXPECT(VESICA_KIND_OF(&segment), VESICA_SEGMENT);
  EXPECT(VESICA_KIND_OF(&circle), VESICA_CIRCLE);
  EXPECT(VESICA_KIND_OF(&aabb), VESICA_AABB);
  EXPECT(VESICA_KIND_OF(&rect), VESICA_RECT);
  EXPECT(VESICA_KIND_OF(&ellipse), VESICA_ELLIPSE);
  EXPECT(VESICA_KIND_OF(&capsule), VESICA_CAPSULE);
  EXPECT(VESICA_KIND_OF(&round_rect), VESICA_ROUND_RECT);

  EXPECT(vesica_overlap(&point, &touching), 1);
  EXPECT(vesica_overlap(&segment, &touching), 1);
  EXPECT(vesica_overlap(&circle, &touching), 1);
  EXPECT(vesica_overlap(&aabb, &touching), 1);
  EXPECT(vesica_overlap(&rect, &touching), 1);
  EXPECT(vesica_overlap(&ellipse, &touching), 1);
  EXPECT(vesica_overlap(&capsule, &touching), 1);
  EXPECT(vesica_overlap(&round_rect, &touching), 1);

  EXPECT(vesica_overlap(&apart, &point), 0);
  EXPECT(vesica_overlap(&apart, &segment), 0);
  EXPECT(vesica_overlap(&apart, &circle), 0);
  EXPECT(vesica_overlap(&apart, &aabb), 0);
  EXPECT(vesica_overlap(&apart, &rect), 0);
  EXPECT(vesica_overlap(&apart, &ellipse), 0);
  EXPECT(vesica_overlap(&apart, &capsule), 0);
  EXPECT(vesica_overlap(&apart, &round_rect), 0);
  EXPECT(vesica_check(&capsule), 0);
  EXPECT(vesica_check(&round_rect), 0);
}

static void test_polygons(void) {
  const double wide[] = {0, 0, 4, 0, 4, 4};
  const float narrow[] = {0, 0, 4, 0, 4, 4};
  const vesica_polygon_f64 polygon = {wide, wide + 1, 2 * sizeof(double), NULL, 3};
  const vesica_polygon_f32 polygon_f32 = {narrow, narrow + 1, 2 * sizeof(float), NULL, 3};
  vesica_facts_f64 facts;
  vesica_facts_f32 facts_f32;
  EXPECT(VESICA_KIND_OF(&polygon), VESICA_POLYGON);
  EXPECT(vesica_polygon_facts(&polygon, &facts), 0);
  EXPECT(facts.area == 8 && facts.convex == 1, 1);
  EXPECT(vesica_polygon_facts(&polygon_f32, &facts_f32), 0);
  EXPECT(facts_f32.area == 8 && facts_f32.convex == 1, 1);
  vesica_point_f64 corners[3];
  vesica_rect_f64 rect;
  EXPECT(vesica_convex_hull(&polygon, corners, 3) == 3 && corners[1].x == 4, 1);
  EXPECT(vesica_min_area_rect(&polygon, &rect), 0);
  EXPECT(vesica_min_perimeter_rect(&polygon, &rect), 0);
  EXPECT(rect.hx == 2 && rect.hy == 2, 1);
  const vesica_grid_f64 grid = {0, 0, 4, 4, 1, 1};
  const vesica_grid_f32 grid_f32 = {0, 0, 4, 4, 1, 1};
  double share = 0;
  float share_f32 = 0;
  int64_t cell = -1;
  EXPECT(vesica_coverage(&polygon, &grid, &share, 1), 0);
  EXPECT(vesica_coverage_cells(&polygon_f32, &grid_f32, &cell, &share_f32, 1) == 1 && cell == 0, 1);
  EXPECT(share == 0.5 && share_f32 == 0.5f, 1);
}

static void test_float(void) {
  const vesica_point_f32 point = {3, 0};
  const vesica_segment_f32 segment = {0, 0, 3, 0};
  const vesica_circle_f32 circle = {1, 0, 2};
  const vesica_aabb_f32 aabb = {0, -1, 3, 1};
  const vesica_rect_f32 rect = {1, 0, 1, 0, 2, 1};
  const vesica_ellipse_f32 ellipse = {1, 0, 1, 0, 2, 1};
  const vesica_capsule_f32 capsule = {0, 0, 2, 0, 1};
  const vesica_round_rect_f32 round_rect = {1, 0, 1, 0, 1, 1, 1};
  vesica_circle_f32 touching = {5, 0, 2};
  vesica_aabb_f32 apart = {3.0000002f, -9, 9, 9};

  EXPECT(VESICA_KIND_OF(&point), VESICA_POINT);
  EXPECT(VESICA_KIND_OF(&segment), VESICA_SEGMENT);
  EXPECT(VESICA_KIND_OF(&circle), VESICA_CIRCLE);
  EXPECT(VESICA_KIND_OF(&aabb), VESICA_AABB);
  EXPECT(VESICA_KIND_OF(&rect), VESICA_RECT);
  EXPECT(VESICA_KIND_OF(&ellipse), VESICA_ELLIPSE);
  EXPECT(VESICA_KIND_OF(&capsule), VESICA_CAPSULE);
  EXPECT(VESICA_KIND_OF(&round_rect), VESICA_ROUND_RECT);

  EXPECT(vesica_overlap(&point, &touching), 1);
  EXPECT(vesica_overlap(&segment, &touching), 1);
  EXPECT(vesica_overlap(&circle, &touching), 1);
  EXPECT(vesica_overlap(&aabb, &touching), 1);
  EXPECT(vesica_overlap(&rect, &touching), 1);
  EXPECT(vesica_overlap(&ellipse, &touching), 1);
  EXPECT(vesica_overlap(&capsule, &touching), 1);
  EXPECT(vesica_overlap(&round_rect, &touching), 1);

  EXPECT(vesica_overlap(&apart, &point), 0);
  EXPECT(vesica_overlap(&apart, &segment), 0);
  EXPECT(vesica_overlap(&apart, &circle), 0);
  EXPECT(vesica_overlap(&apart, &aabb), 0);
  EXPECT(vesica_overlap(&apart, &rect), 0);
  EXPECT(vesica_overlap(&apart, &ellipse), 0);
  EXPECT(vesica_overlap(&apart, &capsule), 0);
  EXPECT(vesica_overlap(&apart, &round_rect), 0);
  EXPECT(vesica_check(&capsule), 0);
  EXPECT(vesica_check(&round_rect), 0);
}

/* Each query of a kind, as first and as second shape, is the function called with kinds and numbers: the same answer
   and the same bytes. */
#define EXPECT_ANSWER(query, scalar, T, a, KIND_A, b, KIND_B) \
  EXPECT(query(a, b), query##_##scalar(KIND_A, (const T*)(a), KIND_B, (const T*)(b)))
#define EXPECT_RESULT(query, scalar, T, Result, a, KIND_A, b, KIND_B)                                       \
  do {                                                                                                      \
    Result generic, direct;                                                                                 \
    memset(&generic, 0xaa, sizeof generic);                                                                 \
    memset(&direct, 0x55, sizeof direct);                                                                   \
    EXPECT(query(a, b, &generic), query##_##scalar(KIND_A, (const T*)(a), KIND_B, (const T*)(b), &direct)); \
    EXPECT(memcmp(&generic, &direct, sizeof direct), 0);                                                    \
  } while (0)
#define EXPECT_OF_ONE(query, scalar, T, Result, a, KIND_A)                        \
  do {                                                                            \
    Result generic, direct;                                                       \
    memset(&generic, 0xaa, sizeof generic);                                       \
    memset(&direct, 0x55, sizeof direct);                                         \
    EXPECT(query(a, &generic), query##_##scalar(KIND_A, (const T*)(a), &direct)); \
    EXPECT(memcmp(&generic, &direct, sizeof direct), 0);                          \
  } while (0)
#define EXPECT_RATIO(scalar, T, a, KIND_A, b, KIND_B)                                                               \
  do {                                                                                                              \
    T generic = -7, direct = -7;                                                                                    \
    EXPECT(vesica_ratio(VESICA_RATIO_GENERALIZED, a, b, &generic),                                                  \
           vesica_ratio_##scalar(VESICA_RATIO_GENERALIZED, KIND_A, (const T*)(a), KIND_B, (const T*)(b), &direct)); \
    EXPECT(generic == direct, 1);                                                                                   \
  } while (0)
#define EXPECT_WITHIN(scalar, T, a, KIND_A, b, KIND_B) \
  EXPECT(vesica_within(a, b, 1), vesica_within_##scalar(KIND_A, (const T*)(a), KIND_B, (const T*)(b), 1))
#define EXPECT_TOPOLOGY(scalar, T, a, KIND_A, b, KIND_B)                                                              \
  do {                                                                                                                \
    char generic[10] = "", direct[10] = "?";                                                                          \
    vesica_point_##scalar vertices[8] = {{0, 0}}, directly[8] = {{0, 0}};                                             \
    EXPECT(vesica_de9im(a, b, generic), vesica_de9im_##scalar(KIND_A, (const T*)(a), KIND_B, (const T*)(b), direct)); \
    EXPECT(strcmp(generic, direct), 0);                                                                               \
    EXPECT((int32_t)vesica_intersection(a, b, vertices, 8),                                                           \
           (int32_t)vesica_intersection_##scalar(KIND_A, (const T*)(a), KIND_B, (const T*)(b), directly, 8));         \
    int32_t shared = 7, directly_shared = -7;                                                                         \
    EXPECT((int32_t)vesica_crossings(a, b, vertices, 8, &shared),                                                     \
           (int32_t)vesica_crossings_##scalar(KIND_A, (const T*)(a), KIND_B, (const T*)(b), directly, 8,              \
                                              &directly_shared));                                                     \
    EXPECT(shared == directly_shared && memcmp(&vertices[0], &directly[0], sizeof directly[0]) == 0, 1);              \
  } while (0)
#define EXPECT_CAST(scalar, T, a, KIND_A, b, KIND_B)                                              \
  do {                                                                                            \
    vesica_impact_##scalar generic, direct;                                                       \
    memset(&generic, 0xaa, sizeof generic);                                                       \
    memset(&direct, 0x55, sizeof direct);                                                         \
    EXPECT(vesica_cast(a, b, 1, 2, 3, &generic),                                                  \
           vesica_cast_##scalar(KIND_A, (const T*)(a), KIND_B, (const T*)(b), 1, 2, 3, &direct)); \
    EXPECT(memcmp(&generic, &direct, sizeof direct), 0);                                          \
  } while (0)
#define EXPECT_IMPACT_TIME(scalar, T, a, KIND_A, b, KIND_B)                                                      \
  do {                                                                                                           \
    const vesica_turn_##scalar turn_a = {1, 0, 2}, turn_b = {-1, 1, -3};                                         \
    vesica_impact_##scalar generic, direct;                                                                      \
    T gap = 7, direct_gap = 8;                                                                                   \
    memset(&generic, 0xaa, sizeof generic);                                                                      \
    memset(&direct, 0x55, sizeof direct);                                                                        \
    EXPECT(vesica_impact_time(a, &turn_a, b, &turn_b, (T)0.125, &generic, &gap),                                 \
           vesica_impact_time_##scalar(KIND_A, (const T*)(a), &turn_a, KIND_B, (const T*)(b), &turn_b, (T)0.125, \
                                       &direct, &direct_gap));                                                   \
    EXPECT(memcmp(&generic, &direct, sizeof direct), 0);                                                         \
    EXPECT(memcmp(&gap, &direct_gap, sizeof gap), 0);                                                            \
  } while (0)
#define EXPECT_PAIR(scalar, T, a, KIND_A, b, KIND_B)                                                          \
  do {                                                                                                        \
    EXPECT_ANSWER(vesica_overlap, scalar, T, a, KIND_A, b, KIND_B);                                           \
    EXPECT_ANSWER(vesica_interiors_overlap, scalar, T, a, KIND_A, b, KIND_B);                                 \
    EXPECT_ANSWER(vesica_relation, scalar, T, a, KIND_A, b, KIND_B);                                          \
    EXPECT_ANSWER(vesica_contains, scalar, T, a, KIND_A, b, KIND_B);                                          \
    EXPECT_RESULT(vesica_nearest, scalar, T, vesica_closest_points_##scalar, a, KIND_A, b, KIND_B);           \
    EXPECT_RESULT(vesica_boundary_distance, scalar, T, vesica_closest_points_##scalar, a, KIND_A, b, KIND_B); \
    EXPECT_RESULT(vesica_depth, scalar, T, vesica_penetration_##scalar, a, KIND_A, b, KIND_B);                \
    EXPECT_RESULT(vesica_manifold, scalar, T, vesica_contacts_##scalar, a, KIND_A, b, KIND_B);                \
    EXPECT_CAST(scalar, T, a, KIND_A, b, KIND_B);                                                             \
    EXPECT_IMPACT_TIME(scalar, T, a, KIND_A, b, KIND_B);                                                      \
    EXPECT_RESULT(vesica_area, scalar, T, T, a, KIND_A, b, KIND_B);                                           \
    EXPECT_RESULT(vesica_iou, scalar, T, T, a, KIND_A, b, KIND_B);                                            \
    EXPECT_RATIO(scalar, T, a, KIND_A, b, KIND_B);                                                            \
    EXPECT_RESULT(vesica_signed_distance, scalar, T, T, a, KIND_A, b, KIND_B);                                \
    EXPECT_WITHIN(scalar, T, a, KIND_A, b, KIND_B);                                                           \
    EXPECT_TOPOLOGY(scalar, T, a, KIND_A, b, KIND_B);                                                         \
  } while (0)
#define EXPECT_KIND(scalar, T, a, KIND_A)                                     \
  do {                                                                        \
    EXPECT(vesica_check(a), vesica_check_##scalar(KIND_A, (const T*)(a)));    \
    EXPECT_OF_ONE(vesica_shape_area, scalar, T, T, a, KIND_A);                \
    EXPECT_OF_ONE(vesica_bounds, scalar, T, vesica_aabb_##scalar, a, KIND_A); \
    EXPECT_PAIR(scalar, T, a, KIND_A, &probe, VESICA_ELLIPSE);                \
    EXPECT_PAIR(scalar, T, &probe, VESICA_ELLIPSE, a, KIND_A);                \
  } while (0)
#define TEST_EVERY_QUERY(scalar, T)                                     \
  static void test_every_query_##scalar(void) {                         \
    const vesica_ellipse_##scalar probe = {4, 1, (T)0.6, (T)0.8, 3, 1}; \
    const vesica_point_##scalar point = {4, 2};                         \
    const vesica_segment_##scalar segment = {0, 0, 4, 2};               \
    vesica_circle_##scalar circle = {1, 0, 2};                          \
    vesica_aabb_##scalar aabb = {0, -1, 3, 1};                          \
    const vesica_rect_##scalar rect = {1, 0, 1, 0, 2, 1};               \
    const vesica_ellipse_##scalar ellipse = {1, 0, 1, 0, 2, 1};         \
    const vesica_ellipse_##scalar invalid = {1, 0, 1, 0, 2, -1};        \
    EXPECT_KIND(scalar, T, &point, VESICA_POINT);                       \
    EXPECT_KIND(scalar, T, &segment, VESICA_SEGMENT);                   \
    EXPECT_KIND(scalar, T, &circle, VESICA_CIRCLE);                     \
    EXPECT_KIND(scalar, T, &aabb, VESICA_AABB);                         \
    EXPECT_KIND(scalar, T, &rect, VESICA_RECT);                         \
    EXPECT_KIND(scalar, T, &ellipse, VESICA_ELLIPSE);                   \
    EXPECT(vesica_check(&ellipse), 0);                                  \
    EXPECT(vesica_check(&invalid), VESICA_E_NEGATIVE_SIZE);             \
  }
TEST_EVERY_QUERY(f64, double)
TEST_EVERY_QUERY(f32, float)

/* Known numbers, so that a macro that calls another query would be found out. */
static void test_results(void) {
  const vesica_circle_f64 disc = {0, 0, 2};
  const vesica_aabb_f32 box = {0, 0, 2, 1}, other = {1, 0, 4, 1};
  const vesica_span_f32 span = {0, 1};
  const vesica_point_f64 point = {5, 0};
  vesica_closest_points_f64 closest;
  vesica_point_f32 places[8];
  int32_t shared;
  vesica_penetration_f32 penetration;
  vesica_aabb_f64 bounds;
  vesica_impact_f64 impact;
  char matrix[10];
  float number;

  EXPECT(vesica_nearest(&disc, &point, &closest), 0);
  EXPECT(closest.distance == 3 && closest.ax == 2 && closest.bx == 5, 1);
  EXPECT(vesica_boundary_distance(&point, &disc, &closest), 0);
  EXPECT(closest.distance == 3 && closest.ax == 5 && closest.bx == 2, 1);
  EXPECT(vesica_relation(&box, &other), VESICA_CROSS);
  EXPECT(vesica_contains(&box, &box), 1);
  EXPECT((int32_t)vesica_crossings(&box, &other, places, 8, &shared), 4);
  EXPECT(shared == 1 && places[0].x == 1 && places[0].y == 0, 1);
  EXPECT(vesica_depth(&box, &other, &penetration), 0);
  EXPECT(penetration.depth == 1, 1);
  EXPECT(vesica_area(&box, &other, &number), 0);
  EXPECT(number == 1, 1);
  EXPECT(vesica_iou(&box, &other, &number), 0);
  EXPECT(number == 0.25f, 1);
  EXPECT(vesica_ratio(VESICA_RATIO_OVER_FIRST, &box, &other, &number), 0);
  EXPECT(number == 0.5f, 1);
  EXPECT(vesica_volume_ratio(VESICA_RATIO_OVER_FIRST, &box, &span, &other, &span, &number), 0);
  EXPECT(number == 0.5f, 1);
  EXPECT(vesica_gaussian_distance(VESICA_GAUSSIAN_HELLINGER, &box, &box, &number), 0);
  EXPECT(number == 0, 1);
  EXPECT(vesica_signed_distance(&box, &other, &number), 0);
  EXPECT(number == -1, 1);
  EXPECT(vesica_within(&disc, &point, 3), VESICA_WITHIN_YES);
  EXPECT(vesica_within(&disc, &point, 2), VESICA_WITHIN_NO);
  EXPECT(vesica_de9im(&box, &other, matrix), 0);
  EXPECT(strcmp(matrix, "212111212"), 0);
  EXPECT((int32_t)vesica_intersection(&box, &other, places, 8), 4);
  EXPECT(places[0].x == 1 && places[1].x == 2 && places[2].y == 1, 1);
  EXPECT(vesica_shape_area(&box, &number), 0);
  EXPECT(number == 2, 1);
  EXPECT(vesica_bounds(&disc, &bounds), 0);
  EXPECT(bounds.min_x == -2 && bounds.max_y == 2, 1);
  EXPECT(vesica_cast(&disc, &point, -1, 0, 9, &impact), VESICA_CAST_HIT);
  EXPECT(impact.t == 3 && impact.x == 2 && impact.y == 0 && impact.nx == 1 && impact.ny == 0, 1);
  EXPECT(vesica_sweep_bounds(&disc, 0, 0, 1, &bounds), 0);
  EXPECT(bounds.min_x == -2 && bounds.max_y == 2, 1);
}

static void test_arguments(void) {
  const vesica_point_f64 points[] = {{0, 0}, {9, 9}};
  const vesica_point_f64* next = points;
  const vesica_point_f64* none = NULL;
  vesica_circle_f64 circle = {0, 0, 1};
  vesica_circle_f64 invalid = {0, 0, -1};

  EXPECT(vesica_overlap(next++, &circle), 1); /* evaluated once */
  EXPECT(next == points + 1, 1);
  EXPECT(vesica_overlap(&circle, next), 0);
  EXPECT(vesica_overlap(none, &circle), VESICA_E_NULL);
  EXPECT(vesica_overlap(&circle, none), VESICA_E_NULL);
  EXPECT(vesica_overlap(&invalid, &circle), VESICA_E_SHAPE);
}

int main(void) {
  test_double();
  test_polygons();
  test_float();
  test_every_query_f64();
  test_every_query_f32();
  test_results();
  test_arguments();
  return failures != 0;
}
