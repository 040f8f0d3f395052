// SPDX-License-Identifier: Apache-2.0
// No number of this file may ever change: they are the ABI.
#include <gtest/gtest.h>
#include <vesica.h>
#include <vesica_methods.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

namespace {

// Size, order and place of every field at once: the bytes of a struct are its fields' numbers and nothing else.
template <class T, std::size_t count, class Struct>
constexpr bool is_flat(const Struct& s) {
  const auto numbers = std::bit_cast<std::array<T, count>>(s);
  for (std::size_t i = 0; i < count; ++i) {
    if (numbers[i] != static_cast<T>(i + 1)) return false;
  }
  return alignof(Struct) == alignof(T);
}

static_assert(is_flat<double, 2>(vesica_point_f64{.x = 1, .y = 2}));
static_assert(is_flat<double, 4>(vesica_segment_f64{.x0 = 1, .y0 = 2, .x1 = 3, .y1 = 4}));
static_assert(is_flat<double, 3>(vesica_circle_f64{.cx = 1, .cy = 2, .r = 3}));
static_assert(is_flat<double, 4>(vesica_aabb_f64{.min_x = 1, .min_y = 2, .max_x = 3, .max_y = 4}));
static_assert(is_flat<double, 6>(vesica_rect_f64{.cx = 1, .cy = 2, .ux = 3, .uy = 4, .hx = 5, .hy = 6}));
static_assert(is_flat<double, 6>(vesica_ellipse_f64{.cx = 1, .cy = 2, .ux = 3, .uy = 4, .a = 5, .b = 6}));
static_assert(is_flat<double, 5>(vesica_capsule_f64{.x0 = 1, .y0 = 2, .x1 = 3, .y1 = 4, .r = 5}));
static_assert(is_flat<double, 7>(vesica_round_rect_f64{.cx = 1, .cy = 2, .ux = 3, .uy = 4, .hx = 5, .hy = 6, .r = 7}));
static_assert(is_flat<float, 5>(vesica_capsule_f32{.x0 = 1, .y0 = 2, .x1 = 3, .y1 = 4, .r = 5}));
static_assert(is_flat<float, 7>(vesica_round_rect_f32{.cx = 1, .cy = 2, .ux = 3, .uy = 4, .hx = 5, .hy = 6, .r = 7}));
static_assert(is_flat<float, 2>(vesica_point_f32{.x = 1, .y = 2}));
static_assert(is_flat<float, 4>(vesica_segment_f32{.x0 = 1, .y0 = 2, .x1 = 3, .y1 = 4}));
static_assert(is_flat<float, 3>(vesica_circle_f32{.cx = 1, .cy = 2, .r = 3}));
static_assert(is_flat<float, 4>(vesica_aabb_f32{.min_x = 1, .min_y = 2, .max_x = 3, .max_y = 4}));
static_assert(is_flat<float, 6>(vesica_rect_f32{.cx = 1, .cy = 2, .ux = 3, .uy = 4, .hx = 5, .hy = 6}));
static_assert(is_flat<float, 6>(vesica_ellipse_f32{.cx = 1, .cy = 2, .ux = 3, .uy = 4, .a = 5, .b = 6}));

TEST(CapiConstants, StructSizes) {
  EXPECT_EQ(sizeof(vesica_point_f64), 16u);
  EXPECT_EQ(sizeof(vesica_segment_f64), 32u);
  EXPECT_EQ(sizeof(vesica_circle_f64), 24u);
  EXPECT_EQ(sizeof(vesica_aabb_f64), 32u);
  EXPECT_EQ(sizeof(vesica_rect_f64), 48u);
  EXPECT_EQ(sizeof(vesica_ellipse_f64), 48u);
  EXPECT_EQ(sizeof(vesica_point_f32), 8u);
  EXPECT_EQ(sizeof(vesica_segment_f32), 16u);
  EXPECT_EQ(sizeof(vesica_circle_f32), 12u);
  EXPECT_EQ(sizeof(vesica_aabb_f32), 16u);
  EXPECT_EQ(sizeof(vesica_rect_f32), 24u);
  EXPECT_EQ(sizeof(vesica_ellipse_f32), 24u);
  EXPECT_EQ(sizeof(vesica_capsule_f64), 40u);
  EXPECT_EQ(sizeof(vesica_capsule_f32), 20u);
  EXPECT_EQ(sizeof(vesica_round_rect_f64), 56u);
  EXPECT_EQ(sizeof(vesica_round_rect_f32), 28u);
  if (sizeof(void*) == 8) {
    EXPECT_EQ(sizeof(vesica_polygon_f64), 40u);
    EXPECT_EQ(sizeof(vesica_polygon_f32), 40u);
    EXPECT_EQ(sizeof(vesica_polyline_f64), 40u);
    EXPECT_EQ(sizeof(vesica_polyline_f32), 40u);
    EXPECT_EQ(sizeof(vesica_facts_f64), 48u);
    EXPECT_EQ(sizeof(vesica_facts_f32), 48u);
    EXPECT_EQ(sizeof(vesica_grid_f64), 48u);
    EXPECT_EQ(sizeof(vesica_span_f64), 16u);
    EXPECT_EQ(sizeof(vesica_span_f32), 8u);
    EXPECT_EQ(sizeof(vesica_grid_f32), 32u);
  }
}

// Holds pointers and a ptrdiff_t: these are the numbers of 64-bit machines.
template <class Shapes>
void expect_layout_of_shapes() {
  EXPECT_EQ(offsetof(Shapes, kind), 0u);
  EXPECT_EQ(offsetof(Shapes, reserved), 4u);
  EXPECT_EQ(offsetof(Shapes, count), 8u);
  EXPECT_EQ(offsetof(Shapes, stride), 16u);
  EXPECT_EQ(offsetof(Shapes, field), 24u);
  EXPECT_EQ(sizeof(Shapes::field) / sizeof(void*), 8u);
  EXPECT_EQ(offsetof(Shapes, rings), 88u);
  EXPECT_EQ(offsetof(Shapes, polygons), 96u);
  EXPECT_EQ(offsetof(Shapes, each), 104u);
}

TEST(CapiConstants, SizesOfResults) {
  EXPECT_EQ(sizeof(vesica_closest_points_f64), 40u);
  EXPECT_EQ(sizeof(vesica_closest_points_f32), 20u);
  EXPECT_EQ(sizeof(vesica_penetration_f64), 24u);
  EXPECT_EQ(sizeof(vesica_penetration_f32), 12u);
  EXPECT_EQ(sizeof(vesica_impact_f64), 40u);
  EXPECT_EQ(sizeof(vesica_impact_f32), 20u);
  EXPECT_EQ(sizeof(vesica_contacts_f64), 104u);
  EXPECT_EQ(sizeof(vesica_contacts_f32), 72u);
  EXPECT_EQ(sizeof(vesica_turn_f64), 24u);
  EXPECT_EQ(sizeof(vesica_turn_f32), 12u);
}

TEST(CapiConstants, LayoutOfShapes) {
  EXPECT_EQ(sizeof(vesica_shapes_f64), 112u);
  EXPECT_EQ(sizeof(vesica_shapes_f32), 112u);
  expect_layout_of_shapes<vesica_shapes_f64>();
  expect_layout_of_shapes<vesica_shapes_f32>();
}

TEST(CapiConstants, LayoutOfMethods) {
  EXPECT_EQ(sizeof(vesica_metric_closest_f64), 24u);
  EXPECT_EQ(sizeof(vesica_metric_closest_f32), 12u);
  EXPECT_EQ(sizeof(vesica_turned_rect_f64), 40u);
  EXPECT_EQ(sizeof(vesica_turned_rect_f32), 20u);
  EXPECT_EQ(sizeof(vesica_approximation_f64), 16u);
  EXPECT_EQ(sizeof(vesica_approximation_f32), 8u);
  EXPECT_EQ(sizeof(vesica_radius_vector_ellipse_f64), 40u);
  EXPECT_EQ(sizeof(vesica_radius_vector_ellipse_f32), 20u);
  EXPECT_EQ(sizeof(vesica_descent_settings_f64), 32u);
  EXPECT_EQ(sizeof(vesica_descent_settings_f32), 20u);
  EXPECT_EQ(sizeof(vesica_descent_result_f64), 40u);
  EXPECT_EQ(sizeof(vesica_descent_result_f32), 24u);
}

TEST(CapiConstants, Values) {
  EXPECT_EQ(VESICA_CAST_MISS, 0);
  EXPECT_EQ(VESICA_CAST_HIT, 1);
  EXPECT_EQ(VESICA_CAST_START, 2);
  EXPECT_EQ(VESICA_CAST_NEAR, 3);
  EXPECT_EQ(VESICA_POINT, 0);
  EXPECT_EQ(VESICA_SEGMENT, 1);
  EXPECT_EQ(VESICA_CIRCLE, 2);
  EXPECT_EQ(VESICA_AABB, 3);
  EXPECT_EQ(VESICA_RECT, 4);
  EXPECT_EQ(VESICA_ELLIPSE, 5);
  EXPECT_EQ(VESICA_CAPSULE, 6);
  EXPECT_EQ(VESICA_ROUND_RECT, 7);
  EXPECT_EQ(VESICA_POLYGON, 8);
  EXPECT_EQ(VESICA_POLYLINE, 9);
  EXPECT_EQ(VESICA_DISJOINT, 0);
  EXPECT_EQ(VESICA_TOUCH, 1);
  EXPECT_EQ(VESICA_CROSS, 2);
  EXPECT_EQ(VESICA_INSIDE, 3);
  EXPECT_EQ(VESICA_INSIDE_TOUCH, 4);
  EXPECT_EQ(VESICA_CONTAINS, 5);
  EXPECT_EQ(VESICA_CONTAINS_TOUCH, 6);
  EXPECT_EQ(VESICA_EQUAL, 7);

  EXPECT_EQ(VESICA_RATIO_OVER_UNION, 0);
  EXPECT_EQ(VESICA_RATIO_OVER_FIRST, 1);
  EXPECT_EQ(VESICA_RATIO_OVER_SECOND, 2);
  EXPECT_EQ(VESICA_RATIO_OVER_SMALLER, 3);
  EXPECT_EQ(VESICA_RATIO_GENERALIZED, 4);
  EXPECT_EQ(VESICA_RATIO_DISTANCE, 5);
  EXPECT_EQ(VESICA_RATIO_COMPLETE, 6);
  EXPECT_EQ(VESICA_WITHIN_NO, 0);
  EXPECT_EQ(VESICA_WITHIN_YES, 1);
  EXPECT_EQ(VESICA_WITHIN_NEARLY, 2);
  EXPECT_EQ(VESICA_DECAY_LINEAR, 0);
  EXPECT_EQ(VESICA_DECAY_GAUSSIAN, 1);
  EXPECT_EQ(VESICA_FUSED_MEAN, 0);
  EXPECT_EQ(VESICA_FUSED_MAX, 1);
  EXPECT_EQ(VESICA_MATCH_VOC, 0);
  EXPECT_EQ(VESICA_MATCH_COCO, 1);
  EXPECT_EQ(VESICA_TRUTH_COUNTS, 0);
  EXPECT_EQ(VESICA_TRUTH_CROWD, 1);
  EXPECT_EQ(VESICA_TRUTH_IGNORED, 2);
  EXPECT_EQ(VESICA_OUTCOME_MISS, 0);
  EXPECT_EQ(VESICA_OUTCOME_HIT, 1);
  EXPECT_EQ(VESICA_OUTCOME_IGNORED, 2);
  EXPECT_EQ(VESICA_PRECISION_VOC_2007, 0);
  EXPECT_EQ(VESICA_PRECISION_VOC_2010, 1);
  EXPECT_EQ(VESICA_PRECISION_COCO, 2);
  EXPECT_EQ(VESICA_DE9IM_SIZE, 10);

  EXPECT_EQ(VESICA_ANGLE_RADIANS, 0);
  EXPECT_EQ(VESICA_ANGLE_DEGREES, 1);
  EXPECT_EQ(VESICA_ANGLE_QUARTERS, 2);
  EXPECT_EQ(VESICA_ANGLE_REVERSED, 4);
  EXPECT_EQ(VESICA_E_NULL, -1);
  EXPECT_EQ(VESICA_E_SHAPE, -2);
  EXPECT_EQ(VESICA_E_KIND, -3);
  EXPECT_EQ(VESICA_E_ARGUMENT, -4);
  EXPECT_EQ(VESICA_E_NOT_FINITE, -5);
  EXPECT_EQ(VESICA_E_NEGATIVE_SIZE, -6);
  EXPECT_EQ(VESICA_E_ZERO_AXIS, -7);
  EXPECT_EQ(VESICA_E_INVERTED, -8);
  EXPECT_EQ(VESICA_E_RANGE, -9);
  EXPECT_EQ(VESICA_E_INDEX, -10);
  EXPECT_EQ(VESICA_E_RINGS, -11);
  EXPECT_EQ(VESICA_E_NOT_SIMPLE, -12);
  EXPECT_EQ(VESICA_E_NOT_CONVEX, -13);
  EXPECT_STREQ(vesica_strerror(VESICA_E_NOT_CONVEX), "a polygon is not convex, as the function requires");
  EXPECT_EQ(VESICA_JOIN_OVERLAP, 0);
  EXPECT_EQ(VESICA_JOIN_BOUNDS, 1);
  EXPECT_EQ(VESICA_JOIN_CONTAINS, 2);
  EXPECT_EQ(VESICA_JOIN_INSIDE, 3);
  EXPECT_EQ(VESICA_JOIN_INTERIORS, 4);
}

TEST(CapiConstants, Version) {
  EXPECT_EQ(vesica_version_major(), VESICA_VERSION_MAJOR);
  EXPECT_EQ(vesica_version_minor(), VESICA_VERSION_MINOR);
  EXPECT_EQ(vesica_version_patch(), VESICA_VERSION_PATCH);
  EXPECT_EQ(vesica_version(), VESICA_VERSION);
  EXPECT_EQ(VESICA_VERSION, VESICA_VERSION_MAJOR * 10000 + VESICA_VERSION_MINOR * 100 + VESICA_VERSION_PATCH);
  // The project's own version, from CMakeLists.txt.
  const std::string version = std::to_string(VESICA_VERSION_MAJOR) + "." + std::to_string(VESICA_VERSION_MINOR) + "." +
                              std::to_string(VESICA_VERSION_PATCH);
  EXPECT_EQ(version, VESICA_PROJECT_VERSION);
}

TEST(CapiConstants, EveryErrorHasItsOwnWords) {
  std::set<std::string> phrases{"success", "unknown error"};
  for (std::int32_t code = VESICA_E_NOT_CONVEX; code <= VESICA_E_NULL; ++code) {
    const char* words = vesica_strerror(code);
    ASSERT_NE(words, nullptr) << code;
    const std::string phrase = words;
    ASSERT_FALSE(phrase.empty()) << code;
    EXPECT_NE(phrase.back(), '.') << code;
    EXPECT_EQ(phrase.find('\n'), std::string::npos) << code;
    EXPECT_TRUE(phrases.insert(phrase).second) << code << " shares \"" << phrase << '"';
    EXPECT_EQ(vesica_strerror(code), words) << "not static storage";
  }
}

TEST(CapiConstants, AnswersAndUnknownCodesHaveWords) {
  for (std::int32_t code : {0, 1, 7, INT32_MAX}) EXPECT_STREQ(vesica_strerror(code), "success") << code;
  for (std::int32_t code : {VESICA_E_NOT_CONVEX - 1, -1000, INT32_MIN})
    EXPECT_STREQ(vesica_strerror(code), "unknown error") << code;
}

TEST(CapiConstants, FieldCounts) {
  EXPECT_EQ(vesica_field_count(VESICA_POINT), 2);
  EXPECT_EQ(vesica_field_count(VESICA_SEGMENT), 4);
  EXPECT_EQ(vesica_field_count(VESICA_CIRCLE), 3);
  EXPECT_EQ(vesica_field_count(VESICA_AABB), 4);
  EXPECT_EQ(vesica_field_count(VESICA_RECT), 6);
  EXPECT_EQ(vesica_field_count(VESICA_ELLIPSE), 6);
  EXPECT_EQ(vesica_field_count(VESICA_CAPSULE), 5);
  EXPECT_EQ(vesica_field_count(VESICA_ROUND_RECT), 7);
  // Polygons and polylines have any number of vertices.
  for (std::int32_t kind : {-1, VESICA_POLYGON, VESICA_POLYLINE, 10, INT32_MIN, INT32_MAX}) {
    EXPECT_EQ(vesica_field_count(kind), VESICA_E_KIND) << kind;
  }
}

TEST(CapiConstants, KindNames) {
  EXPECT_STREQ(vesica_kind_name(VESICA_POINT), "point");
  EXPECT_STREQ(vesica_kind_name(VESICA_SEGMENT), "segment");
  EXPECT_STREQ(vesica_kind_name(VESICA_CIRCLE), "circle");
  EXPECT_STREQ(vesica_kind_name(VESICA_AABB), "aabb");
  EXPECT_STREQ(vesica_kind_name(VESICA_RECT), "rect");
  EXPECT_STREQ(vesica_kind_name(VESICA_ELLIPSE), "ellipse");
  EXPECT_STREQ(vesica_kind_name(VESICA_CAPSULE), "capsule");
  EXPECT_STREQ(vesica_kind_name(VESICA_ROUND_RECT), "round_rect");
  EXPECT_STREQ(vesica_kind_name(VESICA_POLYGON), "polygon");
  EXPECT_STREQ(vesica_kind_name(VESICA_POLYLINE), "polyline");
  for (std::int32_t kind : {-1, 10, INT32_MIN, INT32_MAX}) EXPECT_EQ(vesica_kind_name(kind), nullptr) << kind;
}

}  // namespace
