// SPDX-License-Identifier: Apache-2.0
// Batches of queries with bad arguments and bad elements.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vesica/shapes.hpp>

#include "capi/face.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Three unit circles in a row, at 0, 1 and 5.
std::array<vesica_circle_f64, 3> row() { return {{{0, 0, 1}, {1, 0, 1}, {5, 0, 1}}}; }

vesica_shapes_f64 shapes(const vesica_circle_f64* circles, int64_t count) {
  vesica_shapes_f64 s;
  vesica_shapes_from_records_f64(VESICA_CIRCLE, count, circles, sizeof *circles, &s);
  return s;
}

TEST(QueryArguments, NullIsAnErrorWhereItIsNeeded) {
  const auto circles = row();
  const vesica_shapes_f64 a = shapes(circles.data(), 1), b = shapes(circles.data(), 3);
  double out[3];
  uint8_t codes[3];
  EXPECT_EQ(vesica_relation_many_f64(nullptr, &b, codes), VESICA_E_NULL);
  EXPECT_EQ(vesica_contains_many_f64(&a, nullptr, codes), VESICA_E_NULL);
  EXPECT_EQ(vesica_area_many_f64(&a, &b, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_iou_matrix_f64(&a, &b, nullptr, 3), VESICA_E_NULL);
  EXPECT_EQ(vesica_nearest_many_f64(&a, &b, nullptr, nullptr, nullptr, nullptr, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_depth_many_f64(&a, &b, nullptr, nullptr, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_nearest_many_f64(&a, &b, out, nullptr, nullptr, nullptr, nullptr), 2);
  EXPECT_EQ(vesica_boundary_distance_many_f64(&a, &b, nullptr, out, nullptr, nullptr, nullptr), 2);
  const vesica_shapes_f64 none = shapes(nullptr, 0);
  EXPECT_EQ(vesica_area_many_f64(&none, &none, nullptr), 0);
  EXPECT_EQ(vesica_nearest_many_f64(&none, &none, nullptr, nullptr, nullptr, nullptr, nullptr), 0);
}

/// With a count of 0 the other array's fields may be NULL, however many shapes it has.
template <class T>
void expect_nothing_is_read() {
  using F = capi_tests::Face<T>;
  const typename F::Shapes none{VESICA_CIRCLE, 0, 0, 0, {}, nullptr, nullptr, 0},
      some{VESICA_RECT, 0, 5, 6 * sizeof(T), {}, nullptr, nullptr, 0};
  for (const auto& [a, b] : {std::pair{&none, &some}, {&some, &none}}) {
    EXPECT_EQ(F::overlap_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::relation_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::contains_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::area_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::iou_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::ratio_matrix(VESICA_RATIO_GENERALIZED, a, b, nullptr, 5), 0);
    EXPECT_EQ(F::nearest_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::boundary_distance_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::depth_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::signed_distance_matrix(a, b, nullptr, 5), 0);
    EXPECT_EQ(F::within_matrix(a, b, 1, nullptr, 5), 0);
  }
  typename F::Shapes one = some;
  one.count = 1;
  EXPECT_EQ(F::area_many(&one, &none, nullptr), 0);
  EXPECT_EQ(F::within_many(&none, &one, 1, nullptr), 0);
  EXPECT_EQ(F::cast_many(&one, &none, nullptr, nullptr, 0, 1, nullptr, nullptr, nullptr, nullptr, nullptr), 0);
  EXPECT_EQ(F::overlap_select(&one, &none, nullptr, 0), 0);
  // The shape that moves is looked at whatever the others are.
  typename F::Impact impact;
  EXPECT_EQ(F::cast_first(&one, &none, 1, 0, 1, &impact), VESICA_E_NULL);
  EXPECT_EQ(F::cast_first(&one, &none, 1, 0, -1, &impact), VESICA_E_NULL);
  const T circle[3] = {0, 0, 1};
  one = {VESICA_CIRCLE, 0, 1, 0, {circle, circle + 1, circle + 2}, nullptr, nullptr, 0};
  EXPECT_EQ(F::cast_first(&one, &none, 1, 0, 1, &impact), 0);
}

TEST(QueryArguments, NothingToAnswerReadsNothing) {
  expect_nothing_is_read<double>();
  expect_nothing_is_read<float>();
}

TEST(QueryArguments, CountsKindsAndRows) {
  const auto circles = row();
  vesica_shapes_f64 a = shapes(circles.data(), 2), b = shapes(circles.data(), 3);
  std::array<double, 6> out;
  out.fill(7);
  EXPECT_EQ(vesica_area_many_f64(&a, &b, out.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_area_matrix_f64(&a, &b, out.data(), 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_area_matrix_f64(&a, &b, out.data(), PTRDIFF_MAX / 4), VESICA_E_ARGUMENT);
  a.kind = VESICA_POLYLINE + 1;
  EXPECT_EQ(vesica_iou_many_f64(&a, &b, out.data()), VESICA_E_KIND);
  a.kind = VESICA_CIRCLE;
  a.count = -1;
  EXPECT_EQ(vesica_depth_many_f64(&a, &b, out.data(), nullptr, nullptr), VESICA_E_ARGUMENT);
  for (const double x : out) EXPECT_EQ(x, 7);
}

TEST(QueryArguments, MatrixRowsMayRunBackwards) {
  const auto circles = row();
  const vesica_shapes_f64 a = shapes(circles.data(), 2), b = shapes(circles.data(), 3);
  std::array<uint8_t, 8> out;
  out.fill(9);
  EXPECT_EQ(vesica_relation_matrix_f64(&a, &b, out.data() + 4, -4), 4);
  EXPECT_EQ(out, (std::array<uint8_t, 8>{VESICA_CROSS, VESICA_EQUAL, VESICA_DISJOINT, 9, VESICA_EQUAL, VESICA_CROSS,
                                         VESICA_DISJOINT, 9}));
}

TEST(QueryArguments, AnInvalidElementCostsNoOtherItsAnswer) {
  auto circles = row();
  const vesica_circle_f64 probe{0, 0, 1};
  circles[1].r = nan;
  const vesica_shapes_f64 a = shapes(&probe, 1), b = shapes(circles.data(), 3);
  std::array<double, 3> out;
  std::array<uint8_t, 3> codes;
  EXPECT_EQ(vesica_nearest_many_f64(&a, &b, out.data(), nullptr, nullptr, nullptr, nullptr), VESICA_E_SHAPE);
  EXPECT_EQ(out[0], 0);
  EXPECT_TRUE(std::isnan(out[1]));
  EXPECT_EQ(out[2], 3);
  EXPECT_EQ(vesica_iou_many_f64(&a, &b, out.data()), VESICA_E_SHAPE);
  EXPECT_EQ(out[0], 1);
  EXPECT_TRUE(std::isnan(out[1]));
  EXPECT_EQ(out[2], 0);
  EXPECT_EQ(vesica_relation_many_f64(&a, &b, codes.data()), VESICA_E_SHAPE);
  EXPECT_EQ(codes, (std::array<uint8_t, 3>{VESICA_EQUAL, 0, VESICA_DISJOINT}));
}

TEST(QueryArguments, ErrorsOfValidPairsYieldToInvalidShapes) {
  const vesica_circle_f64 circles[] = {{0, 0, 0}, {0, 0, 1}}, point{0, 0, 0};
  const vesica_shapes_f64 a = shapes(&point, 1), b = shapes(circles, 2);
  std::array<double, 2> out;
  EXPECT_EQ(vesica_iou_many_f64(&a, &b, out.data()), VESICA_E_ARGUMENT);  // 0 over 0
  EXPECT_TRUE(std::isnan(out[0]));
  EXPECT_EQ(out[1], 0);
  const vesica_circle_f64 bad[] = {{0, 0, 0}, {0, 0, -1}};
  const vesica_shapes_f64 c = shapes(bad, 2);
  EXPECT_EQ(vesica_iou_many_f64(&a, &c, out.data()), VESICA_E_SHAPE);
}

/// The distance is a double, and no float.
TEST(QueryArguments, FloatsBeyondTheRange) {
  const vesica_point_f32 left{-3e38f, 0}, right{3e38f, 0};
  vesica_shapes_f32 a, b;
  vesica_shapes_from_records_f32(VESICA_POINT, 1, &left, sizeof left, &a);
  vesica_shapes_from_records_f32(VESICA_POINT, 1, &right, sizeof right, &b);
  float distance = 1, ax = 1;
  EXPECT_EQ(vesica_nearest_many_f32(&a, &b, &distance, &ax, nullptr, nullptr, nullptr), VESICA_E_RANGE);
  EXPECT_TRUE(std::isnan(distance));
  EXPECT_TRUE(std::isnan(ax));
}

}  // namespace
