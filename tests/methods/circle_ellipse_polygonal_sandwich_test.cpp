// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <vesica/methods/circle_ellipse_polygonal_sandwich.hpp>

#include "methods/approximation.hpp"
#include "methods/ellipse_cases.hpp"
#include "methods/radius_at_contact.hpp"

namespace circle_ellipse_polygonal_sandwich_test {
namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_circle_ellipse_polygonal_sandwich_f64;
constexpr auto f32 = vesica_method_circle_ellipse_polygonal_sandwich_f32;

TEST(CircleEllipsePolygonalSandwich, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_known_answers(circle_ellipse_cases, VESICA_CIRCLE, VESICA_ELLIPSE, scalar,
                         method_with<f64, f32, 12>(scalar));
  }
}

/// The bound before any iteration, of half lengths that are nearly the largest number, on a short axis.
double bound_of_the_longest(double axis) {
  const vesica_ellipse_f64 ellipse{0, 0, axis, 0, 0x1.fp+1023, 0x1p+1023};
  const vesica_circle_f64 circle{0, 0, 1};
  vesica_approximation_f64 out{-1, -1, -1};
  EXPECT_EQ(f64(&circle, &ellipse, 0, &out), VESICA_YES);
  return out.outline_error;
}

TEST(CircleEllipsePolygonalSandwich, BoundOfTheLongestHalfLengths) {
  for (const int e : {-460, -451, -450})
    EXPECT_EQ(bound_of_the_longest(std::ldexp(1, e)), std::ldexp(0x1.31f599cdd2c81p+0, 1024 + e));
}

// 2^0.303 times such a half length is beyond the range, and the bound is not.
TEST(CircleEllipsePolygonalSandwich, BoundOfTheLongestHalfLengthsOnOrdinaryAxes) {
  for (const int e : {-449, -100, -1})
    EXPECT_EQ(bound_of_the_longest(std::ldexp(1, e)), std::ldexp(0x1.31f599cdd2c81p+0, 1024 + e));
}

// The nearest point is at a slanting normal, so that the polygons have to grow towards it: the iterations that each gap
// takes, and the bound reached, 2^(0.303 - 2 iterations) 45.
TEST(CircleEllipsePolygonalSandwich, IterationsAndBound) {
  struct {
    double radius;
    std::int32_t answer, iterations;
    double outline_error;
  } constexpr cases[] = {{15, VESICA_YES, 1, 13.879205660356837},         {12, VESICA_NO, 1, 13.879205660356837},
                         {13.1, VESICA_YES, 4, 0.21686258844307557},      {12.9, VESICA_NO, 3, 0.8674503537723023},
                         {40, VESICA_YES, 0, 55.516822641427346},         {1, VESICA_NO, 0, 55.516822641427346},
                         {13, VESICA_UNCERTAIN, 8, 0.0008471194861057644}};
  const vesica_ellipse_f64 ellipse{0, 0, 1, 0, 45, 25};
  for (const auto& known : cases) {
    const vesica_circle_f64 circle{32, 32, known.radius};
    vesica_approximation_f64 out{-1, -1, -1};
    EXPECT_EQ(f64(&circle, &ellipse, 8, &out), known.answer) << known.radius;
    EXPECT_EQ(out.iterations, known.iterations) << known.radius;
    EXPECT_NEAR(out.outline_error, known.outline_error, 1e-13 * known.outline_error) << known.radius;
    EXPECT_EQ(out.reserved, 0);
  }
}

TEST(CircleEllipsePolygonalSandwich, BoundIsALength) {
  const vesica_circle_f64 circle{0, 0, 1};
  const auto bound = [&](const vesica_ellipse_f64& ellipse) {
    vesica_approximation_f64 out;
    EXPECT_EQ(f64(&circle, &ellipse, 3, &out), VESICA_YES);
    return out.outline_error;
  };
  EXPECT_DOUBLE_EQ(bound({0, 0, 1, 0, 1, 3}), 3.7011215094284897);
  EXPECT_DOUBLE_EQ(bound({0, 0, 3, 4, 3, 1}), 18.50560754714245);
  EXPECT_DOUBLE_EQ(bound({0, 0, 0x3p1000, 0x4p1000, 0x3p-1000, 0x1p-1000}), 18.50560754714245);
  EXPECT_DOUBLE_EQ(bound({0, 0, 0x3p-700, 0x4p-700, 0x3p700, 0x1p700}), 18.50560754714245);
  EXPECT_EQ(bound({0, 0, 0x1p1000, 0, 0x1p100, 0x1p100}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(bound({0, 0, 1, 0, 0, 0}), 0);
}

// Touching is overlap, and no polygon shows it.
TEST(CircleEllipsePolygonalSandwich, TouchingIsUncertain) {
  const vesica_circle_f64 circle{32, 32, 13}, at_vertex{7, 0, 2};
  const vesica_ellipse_f64 slanting{0, 0, 1, 0, 45, 25}, ellipse{0, 0, 1, 0, 5, 2};
  for (const std::int32_t n : {0, 5, 30}) {
    vesica_approximation_f64 out;
    EXPECT_EQ(f64(&circle, &slanting, n, &out), VESICA_UNCERTAIN) << n;
    EXPECT_EQ(f64(&at_vertex, &ellipse, n, &out), VESICA_UNCERTAIN) << n;
    EXPECT_EQ(out.iterations, n);
  }
}

TEST(CircleEllipsePolygonalSandwich, InvalidInput) {
  expect_errors<f64>({1, 2, 3}, {1, 2, 3, 4, 2, 1});
  expect_errors<f32>({1, 2, 3}, {1, 2, 3, 4, 2, 1});
}

TEST(CircleEllipsePolygonalSandwich, EveryYesAndNoIsTrue) {
  expect_never_wrong_with_any_n<f64, f32>("polygonal_sandwich", VESICA_CIRCLE, VESICA_ELLIPSE);
}

TEST(CircleEllipsePolygonalSandwich, DecidedBeyondTheGap) {
  expect_decided_beyond_gap(method_with<f64, f32, 18>(Scalar::f64), VESICA_CIRCLE, VESICA_ELLIPSE);
}

TEST(CircleEllipsePolygonalSandwich, UncertainWithinTheBound) {
  const double largest = largest_share_of_bound(f64);
  std::printf("polygonal_sandwich: uncertain as far as %.3f of the bound from contact\n", largest);
  EXPECT_LT(largest, 1);
  EXPECT_GT(largest, 0.2);
}

TEST(CircleEllipsePolygonalSandwich, Core) {
  using namespace vesica;
  methods::Approximation<float> out;
  static_assert(noexcept(methods::polygonal_sandwich(Circle<float>{}, Ellipse<float>{}, 1, out)));
  EXPECT_EQ(methods::polygonal_sandwich(Circle<float>{32, 32, 14}, Ellipse<float>{0, 0, 1, 0, 45, 25}, 5, out), 1);
  EXPECT_EQ(methods::polygonal_sandwich(Circle<float>{32, 32, 13}, Ellipse<float>{0, 0, 1, 0, 45, 25}, 5, out), 2);
  EXPECT_EQ(out.iterations, 5);
  EXPECT_FLOAT_EQ(out.outline_error, 0.054215647F);
}

}  // namespace
}  // namespace circle_ellipse_polygonal_sandwich_test
