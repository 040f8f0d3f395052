// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <vesica/methods/circle_ellipse_circle_approximation.hpp>

#include "methods/approximation.hpp"
#include "methods/ellipse_cases.hpp"
#include "methods/radius_at_contact.hpp"

namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_circle_ellipse_circle_approximation_f64;
constexpr auto f32 = vesica_method_circle_ellipse_circle_approximation_f32;

TEST(CircleEllipseCircleApproximation, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_known_answers(circle_ellipse_cases, VESICA_CIRCLE, VESICA_ELLIPSE, scalar,
                         method_with<f64, f32, 12>(scalar));
  }
}

// Near a slanting normal, circular segments decide with half the iterations that polygons need.
TEST(CircleEllipseCircleApproximation, IterationsAndBound) {
  const vesica_ellipse_f64 ellipse{0, 0, 1, 0, 45, 25};
  for (const double off_contact : {1e-6, -1e-6}) {
    const vesica_circle_f64 circle{32, 32, 13 + off_contact};
    vesica_approximation_f64 out{-1, -1, -1}, polygons;
    const std::int32_t answer = off_contact > 0 ? VESICA_YES : VESICA_NO;
    EXPECT_EQ(f64(&circle, &ellipse, 20, &out), answer);
    EXPECT_EQ(vesica_method_circle_ellipse_polygonal_sandwich_f64(&circle, &ellipse, 20, &polygons), answer);
    EXPECT_LE(out.iterations, 8);
    EXPECT_GE(polygons.iterations, 11);
    EXPECT_DOUBLE_EQ(out.outline_error, 45 * std::exp2(0.303 - 2 * out.iterations));
    EXPECT_EQ(out.reserved, 0);
  }
}

// A circle is its own circle segment: nothing is left to be halved.
TEST(CircleEllipseCircleApproximation, CircleNeedsNoIteration) {
  const vesica_ellipse_f64 ellipse{0, 0, 3, 4, 1, 1};
  for (const double off_contact : {1e-13, -1e-13}) {
    const vesica_circle_f64 circle{6, 8, 5 + off_contact};
    vesica_approximation_f64 out;
    EXPECT_EQ(f64(&circle, &ellipse, 0, &out), off_contact > 0 ? VESICA_YES : VESICA_NO);
  }
}

TEST(CircleEllipseCircleApproximation, TouchingIsUncertain) {
  const vesica_circle_f64 circle{32, 32, 13};
  const vesica_ellipse_f64 ellipse{0, 0, 1, 0, 45, 25};
  for (const std::int32_t n : {0, 5, 30}) {
    vesica_approximation_f64 out;
    EXPECT_EQ(f64(&circle, &ellipse, n, &out), VESICA_UNCERTAIN) << n;
    EXPECT_EQ(out.iterations, n);
  }
}

TEST(CircleEllipseCircleApproximation, InvalidInput) {
  expect_errors<f64>({1, 2, 3}, {1, 2, 3, 4, 2, 1});
  expect_errors<f32>({1, 2, 3}, {1, 2, 3, 4, 2, 1});
}

TEST(CircleEllipseCircleApproximation, EveryYesAndNoIsTrue) {
  expect_never_wrong_with_any_n<f64, f32>("circle_approximation", VESICA_CIRCLE, VESICA_ELLIPSE);
}

TEST(CircleEllipseCircleApproximation, DecidedBeyondTheGap) {
  expect_decided_beyond_gap(method_with<f64, f32, 18>(Scalar::f64), VESICA_CIRCLE, VESICA_ELLIPSE);
}

TEST(CircleEllipseCircleApproximation, UncertainWithinTheBound) {
  const double largest = largest_share_of_bound(f64);
  std::printf("circle_approximation: uncertain as far as %.3f of the bound from contact\n", largest);
  EXPECT_LT(largest, 1);
  EXPECT_GT(largest, 0.05);
}

TEST(CircleEllipseCircleApproximation, Core) {
  using namespace vesica;
  methods::Approximation<float> out;
  static_assert(noexcept(methods::circle_approximation(Circle<float>{}, Ellipse<float>{}, 1, out)));
  EXPECT_EQ(methods::circle_approximation(Circle<float>{32, 32, 14}, Ellipse<float>{0, 0, 1, 0, 45, 25}, 5, out), 1);
  EXPECT_EQ(methods::circle_approximation(Circle<float>{32, 32, 12}, Ellipse<float>{0, 0, 1, 0, 45, 25}, 5, out), 0);
}

}  // namespace
