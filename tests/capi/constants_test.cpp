// SPDX-License-Identifier: Apache-2.0
// Each constant is also a function, and no number of this file may ever change: they are the ABI.
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
}

// Holds pointers and a ptrdiff_t: these are the numbers of 64-bit machines.
template <class Shapes>
void expect_layout_of_shapes() {
  EXPECT_EQ(offsetof(Shapes, kind), 0u);
  EXPECT_EQ(offsetof(Shapes, reserved), 4u);
  EXPECT_EQ(offsetof(Shapes, count), 8u);
  EXPECT_EQ(offsetof(Shapes, stride), 16u);
  EXPECT_EQ(offsetof(Shapes, field), 24u);
}

TEST(CapiConstants, SizesOfResults) {
  EXPECT_EQ(sizeof(vesica_closest_points_f64), 40u);
  EXPECT_EQ(sizeof(vesica_closest_points_f32), 20u);
  EXPECT_EQ(sizeof(vesica_crossing_points_f64), 136u);
  EXPECT_EQ(sizeof(vesica_crossing_points_f32), 72u);
  EXPECT_EQ(sizeof(vesica_penetration_f64), 24u);
  EXPECT_EQ(sizeof(vesica_penetration_f32), 12u);
}

TEST(CapiConstants, LayoutOfShapes) {
  EXPECT_EQ(sizeof(vesica_shapes_f64), 72u);
  EXPECT_EQ(sizeof(vesica_shapes_f32), 72u);
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

struct Constant {
  std::int32_t macro;
  std::int32_t (*function)();
  std::int32_t value;
};

TEST(CapiConstants, MacrosFunctionsAndValuesAgree) {
  const Constant constants[] = {
      {VESICA_POINT, vesica_point, 0},
      {VESICA_SEGMENT, vesica_segment, 1},
      {VESICA_CIRCLE, vesica_circle, 2},
      {VESICA_AABB, vesica_aabb, 3},
      {VESICA_RECT, vesica_rect, 4},
      {VESICA_ELLIPSE, vesica_ellipse, 5},
      {VESICA_DISJOINT, vesica_disjoint, 0},
      {VESICA_TOUCH, vesica_touch, 1},
      {VESICA_CROSS, vesica_cross, 2},
      {VESICA_INSIDE, vesica_inside, 3},
      {VESICA_INSIDE_TOUCH, vesica_inside_touch, 4},
      {VESICA_CONTAINS, vesica_contains, 5},
      {VESICA_CONTAINS_TOUCH, vesica_contains_touch, 6},
      {VESICA_EQUAL, vesica_equal, 7},
      {VESICA_E_NULL, vesica_e_null, -1},
      {VESICA_E_SHAPE, vesica_e_shape, -2},
      {VESICA_E_KIND, vesica_e_kind, -3},
      {VESICA_E_ARGUMENT, vesica_e_argument, -4},
      {VESICA_E_NOT_FINITE, vesica_e_not_finite, -5},
      {VESICA_E_NEGATIVE_SIZE, vesica_e_negative_size, -6},
      {VESICA_E_ZERO_AXIS, vesica_e_zero_axis, -7},
      {VESICA_E_INVERTED, vesica_e_inverted, -8},
      {VESICA_E_RANGE, vesica_e_range, -9},
      {VESICA_E_INDEX, vesica_e_index, -10},
      {VESICA_JOIN_OVERLAP, vesica_join_overlap, 0},
      {VESICA_JOIN_BOUNDS, vesica_join_bounds, 1},
      {VESICA_JOIN_CONTAINS, vesica_join_contains, 2},
      {VESICA_JOIN_INSIDE, vesica_join_inside, 3},
  };
  for (const Constant& constant : constants) {
    EXPECT_EQ(constant.macro, constant.value);
    EXPECT_EQ(constant.function(), constant.value);
  }
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
  for (std::int32_t code = VESICA_E_INDEX; code <= VESICA_E_NULL; ++code) {
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
  for (std::int32_t code : {-11, -12, -1000, INT32_MIN}) EXPECT_STREQ(vesica_strerror(code), "unknown error") << code;
}

TEST(CapiConstants, FieldCounts) {
  EXPECT_EQ(vesica_field_count(VESICA_POINT), 2);
  EXPECT_EQ(vesica_field_count(VESICA_SEGMENT), 4);
  EXPECT_EQ(vesica_field_count(VESICA_CIRCLE), 3);
  EXPECT_EQ(vesica_field_count(VESICA_AABB), 4);
  EXPECT_EQ(vesica_field_count(VESICA_RECT), 6);
  EXPECT_EQ(vesica_field_count(VESICA_ELLIPSE), 6);
  for (std::int32_t kind : {-1, 6, INT32_MIN, INT32_MAX}) EXPECT_EQ(vesica_field_count(kind), VESICA_E_KIND) << kind;
}

TEST(CapiConstants, KindNames) {
  EXPECT_STREQ(vesica_kind_name(VESICA_POINT), "point");
  EXPECT_STREQ(vesica_kind_name(VESICA_SEGMENT), "segment");
  EXPECT_STREQ(vesica_kind_name(VESICA_CIRCLE), "circle");
  EXPECT_STREQ(vesica_kind_name(VESICA_AABB), "aabb");
  EXPECT_STREQ(vesica_kind_name(VESICA_RECT), "rect");
  EXPECT_STREQ(vesica_kind_name(VESICA_ELLIPSE), "ellipse");
  for (std::int32_t kind : {-1, 6, INT32_MIN, INT32_MAX}) EXPECT_EQ(vesica_kind_name(kind), nullptr) << kind;
}

}  // namespace
