// SPDX-License-Identifier: Apache-2.0
/* The C11 macro vesica_overlap: kinds and scalar from the types of two pointers. Its own program, as it needs C11. */
#include <stdio.h>
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
  vesica_circle_f64 touching = {5, 0, 2};
  vesica_aabb_f64 apart = {3.0000000000000004, -9, 9, 9};

  EXPECT(VESICA_KIND_OF(&point), VESICA_POINT);
  EXPECT(VESICA_KIND_OF(&segment), VESICA_SEGMENT);
  EXPECT(VESICA_KIND_OF(&circle), VESICA_CIRCLE);
  EXPECT(VESICA_KIND_OF(&aabb), VESICA_AABB);
  EXPECT(VESICA_KIND_OF(&rect), VESICA_RECT);
  EXPECT(VESICA_KIND_OF(&ellipse), VESICA_ELLIPSE);

  EXPECT(vesica_overlap(&point, &touching), 1);
  EXPECT(vesica_overlap(&segment, &touching), 1);
  EXPECT(vesica_overlap(&circle, &touching), 1);
  EXPECT(vesica_overlap(&aabb, &touching), 1);
  EXPECT(vesica_overlap(&rect, &touching), 1);
  EXPECT(vesica_overlap(&ellipse, &touching), 1);

  EXPECT(vesica_overlap(&apart, &point), 0);
  EXPECT(vesica_overlap(&apart, &segment), 0);
  EXPECT(vesica_overlap(&apart, &circle), 0);
  EXPECT(vesica_overlap(&apart, &aabb), 0);
  EXPECT(vesica_overlap(&apart, &rect), 0);
  EXPECT(vesica_overlap(&apart, &ellipse), 0);
}

static void test_float(void) {
  const vesica_point_f32 point = {3, 0};
  const vesica_segment_f32 segment = {0, 0, 3, 0};
  const vesica_circle_f32 circle = {1, 0, 2};
  const vesica_aabb_f32 aabb = {0, -1, 3, 1};
  const vesica_rect_f32 rect = {1, 0, 1, 0, 2, 1};
  const vesica_ellipse_f32 ellipse = {1, 0, 1, 0, 2, 1};
  vesica_circle_f32 touching = {5, 0, 2};
  vesica_aabb_f32 apart = {3.0000002f, -9, 9, 9};

  EXPECT(VESICA_KIND_OF(&point), VESICA_POINT);
  EXPECT(VESICA_KIND_OF(&segment), VESICA_SEGMENT);
  EXPECT(VESICA_KIND_OF(&circle), VESICA_CIRCLE);
  EXPECT(VESICA_KIND_OF(&aabb), VESICA_AABB);
  EXPECT(VESICA_KIND_OF(&rect), VESICA_RECT);
  EXPECT(VESICA_KIND_OF(&ellipse), VESICA_ELLIPSE);

  EXPECT(vesica_overlap(&point, &touching), 1);
  EXPECT(vesica_overlap(&segment, &touching), 1);
  EXPECT(vesica_overlap(&circle, &touching), 1);
  EXPECT(vesica_overlap(&aabb, &touching), 1);
  EXPECT(vesica_overlap(&rect, &touching), 1);
  EXPECT(vesica_overlap(&ellipse, &touching), 1);

  EXPECT(vesica_overlap(&apart, &point), 0);
  EXPECT(vesica_overlap(&apart, &segment), 0);
  EXPECT(vesica_overlap(&apart, &circle), 0);
  EXPECT(vesica_overlap(&apart, &aabb), 0);
  EXPECT(vesica_overlap(&apart, &rect), 0);
  EXPECT(vesica_overlap(&apart, &ellipse), 0);
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
  test_float();
  test_arguments();
  return failures != 0;
}
