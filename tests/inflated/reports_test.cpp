// SPDX-License-Identifier: Apache-2.0
// Public reports about shapes with a radius. The corpus has the same reports without one: its rows have six numbers.
#include <gtest/gtest.h>
#include <vesica.h>

namespace {

// kicad-tools issue 4985: a rounded pad beside a track, whose clearance another program took for zero.
TEST(Reports, ClearanceOfAPadAndATrack) {
  const vesica_round_rect_f64 pad = {
      (146.611449 + 147.561449) / 2, (97.746534 + 98.246534) / 2, 1, 0, 0.475, 0.25, 0.25};
  const vesica_capsule_f64 track = {147.9, 98.6, 154.4, 98.6, 0.055};
  vesica_closest_points_f64 gap;
  ASSERT_EQ(vesica_nearest_f64(VESICA_ROUND_RECT, &pad, VESICA_CAPSULE, &track, &gap), 0);
  EXPECT_NEAR(gap.distance, 0.184443554209267, 1e-12);
  EXPECT_EQ(vesica_overlap_f64(VESICA_ROUND_RECT, &pad, VESICA_CAPSULE, &track), 0);
  EXPECT_EQ(vesica_within_f64(VESICA_ROUND_RECT, &pad, VESICA_CAPSULE, &track, 0.18), VESICA_WITHIN_NO);
  EXPECT_EQ(vesica_within_f64(VESICA_ROUND_RECT, &pad, VESICA_CAPSULE, &track, 0.19), VESICA_WITHIN_YES);
}

// godot-box2d issue 93: a disc whose centre is on a capsule's core.
TEST(Reports, DiscOnACapsulesCore) {
  const vesica_capsule_f64 body = {0, -40, 0, 40, 10};
  const vesica_circle_f64 disc = {0, 20, 10};
  vesica_penetration_f64 way;
  EXPECT_EQ(vesica_overlap_f64(VESICA_CAPSULE, &body, VESICA_CIRCLE, &disc), 1);
  ASSERT_EQ(vesica_depth_f64(VESICA_CAPSULE, &body, VESICA_CIRCLE, &disc, &way), 0);
  EXPECT_EQ(way.depth, 20);
  EXPECT_EQ(way.y, 0);
}

// QGIS issue 54322: circles that miss each other by 3.3e-16.
TEST(Reports, CirclesThatMissByTheLastBit) {
  const vesica_circle_f64 a = {5.17140812687688189, 0.57209787912912891, 2.2602305137548804};
  const vesica_circle_f64 b = {11.33315669032675643, -2.99891549287022841, 4.8615165936742235};
  EXPECT_EQ(vesica_overlap_f64(VESICA_CIRCLE, &a, VESICA_CIRCLE, &b), 0);
  EXPECT_EQ(vesica_within_f64(VESICA_CIRCLE, &a, VESICA_CIRCLE, &b, 1e-15), VESICA_WITHIN_YES);
}

}  // namespace
