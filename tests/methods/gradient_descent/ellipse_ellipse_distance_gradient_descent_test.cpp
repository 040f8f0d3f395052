// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "methods/gradient_descent/descent.hpp"
#include "methods/gradient_descent/outline_distance.hpp"

namespace {

using namespace descent;

template <class T>
class GradientDescent : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(GradientDescent, Scalars);

// All samples of print converge to the outlines' distance; 0 is reached from above, within tolerance^(2/3) of the
// sizes.
TYPED_TEST(GradientDescent, NineteenEllipses) {
  const double rounding = std::is_same_v<TypeParam, double> ? 1e-12 : 1e-6;
  const auto first = sample<TypeParam>(nineteen_ellipses::first);
  for (std::size_t i = 0; i < nineteen_ellipses::others.size(); ++i) {
    const auto [code, result] = run(first, sample<TypeParam>(nineteen_ellipses::others[i]));
    EXPECT_EQ(code, 1) << i;
    EXPECT_EQ(result.success, 1) << i;
    EXPECT_LT(result.error, 1e-8) << i;
    EXPECT_LE(result.iterations, 400) << i;
    const double contact = nineteen_ellipses::touches_or_crosses(i) ? 1e-6 : 0;
    EXPECT_NEAR(static_cast<double>(result.distance), nineteen_ellipses::distances[i], contact + rounding) << i;
  }
}

// The exact default on the same samples.
TEST(GradientDescent, NineteenEllipsesByBoundaryDistance) {
  const auto first = sample<double>(nineteen_ellipses::first);
  for (std::size_t i = 0; i < nineteen_ellipses::others.size(); ++i) {
    const auto other = sample<double>(nineteen_ellipses::others[i]);
    vesica_closest_points_f64 closest;
    EXPECT_EQ(vesica_boundary_distance_f64(VESICA_ELLIPSE, &first, VESICA_ELLIPSE, &other, &closest), 0) << i;
    EXPECT_NEAR(closest.distance, nineteen_ellipses::distances[i], 1e-13) << i;
  }
}

// As printed they converge too: print chose its rate for these sizes.
TEST(GradientDescent, NineteenEllipsesAsPrinted) {
  const auto first = sample<double>(nineteen_ellipses::first);
  for (std::size_t i = 0; i < nineteen_ellipses::others.size(); ++i) {
    const auto [code, result] = run(first, sample<double>(nineteen_ellipses::others[i]), VESICA_SCHEDULE_LITERAL);
    EXPECT_EQ(code, 1) << i;
    EXPECT_LE(result.iterations, 500) << i;
    EXPECT_NEAR(result.distance, nineteen_ellipses::distances[i], 1e-7) << i;
  }
}

// Circles on a 3-4-5 triangle: distance 5 - 1 - 2, along (3, 4) / 5.
TYPED_TEST(GradientDescent, CirclesApart) {
  using T = TypeParam;
  const typename Face<T>::Ellipse a{0, 0, 1, 0, 1, 1}, b{3, 4, 0, 1, 2, 2};
  const auto [code, result] = run(a, b);
  EXPECT_EQ(code, 1);
  EXPECT_NEAR(result.distance, T{2}, T{2e-7F});
  EXPECT_NEAR(result.angle_a, std::atan2(T{4}, T{3}), T{1e-6F});
  EXPECT_NEAR(result.angle_b, std::atan2(T{3}, T{-4}), T{1e-6F});  // -(3, 4) seen along (0, 1), which is b's axis
}

TYPED_TEST(GradientDescent, ZeroSizes) {
  using T = TypeParam;
  using Ellipse = typename Face<T>::Ellipse;
  const auto distance = [](const Ellipse& a, const Ellipse& b) {
    const auto [code, result] = run(a, b);
    EXPECT_EQ(code, 1);
    return result.distance;
  };
  EXPECT_EQ(distance({1, 2, 1, 0, 0, 0}, {4, 6, 0, 1, 0, 0}), T{5}) << "points";
  EXPECT_EQ(distance({1, 2, 1, 0, 0, 0}, {1, 2, 0, 1, 0, 0}), T{0}) << "equal points";
  EXPECT_NEAR(distance({0, 5, 1, 0, 0, 0}, {0, 0, 1, 0, 4, 3}), T{2}, T{1e-6F}) << "point and ellipse";
  EXPECT_NEAR(distance({-5, 0, 1, 0, 2, 0}, {5, 0, 0, 1, 0, 3}), T{5}, T{1e-6F}) << "segments in line";
  EXPECT_NEAR(distance({0, 3, 1, 0, 2, 0}, {0, 0, 1, 0, 2, 1}), T{2}, T{1e-6F}) << "segment over ellipse";
  EXPECT_NEAR(distance({0, 0, 1, 0, 2, 0}, {1, 0, 0, 1, 2, 0}), T{0}, T{1e-5F}) << "crossing segments";
}

// The line of centres ends on a saddle, by symmetry. Print stops there with a distance of 1; the outlines cross.
TEST(GradientDescent, LeavesSaddles) {
  const vesica_ellipse_f64 a{0, 0, 1, 0, 2, 2}, b{3, 0, 1, 0, 2, 2};
  const auto [code, result] = run(a, b);
  EXPECT_EQ(code, 1);
  EXPECT_NEAR(result.distance, 0, 1e-6);
  // A lens too flat for any of the 24 vertices: the start is at the ends of its width, 0.02 apart.
  const auto flat = run(a, vesica_ellipse_f64{3.98, 0, 1, 0, 2, 2});
  EXPECT_EQ(flat.code, 1);
  EXPECT_NEAR(flat.result.distance, 0, 1e-6);
}

// A point off the middle of a segment by less than descent can see: the start's gradient is 0, at the segment's end.
// With one angle only, that angle's second derivative decides.
TEST(GradientDescent, LeavesTheEndOfASegment) {
  const vesica_ellipse_f64 point{0x1p-1000, 0x1p-1001, 1, 0, 0, 0}, segment{0, 0, 1, 0, 0x1p100, 0};
  ASSERT_EQ(vesica_overlap_ellipse_ellipse_f64(&point, &segment), 0);
  for (const auto& [code, result] : {run(point, segment), run(segment, point)}) {
    EXPECT_EQ(code, 1);
    EXPECT_LT(result.distance, 1e-6 * 0x1p100);
  }
}

// The angles are those of the distance, and the connecting segment is normal to both outlines.
TEST(GradientDescent, AnglesAreOfTheDistance) {
  const vesica_ellipse_f64 a{1, -2, 0.6, 0.8, 3, 1}, b{-4, 5, 1.5, -2, 0.5, 1};
  const auto [code, r] = run(a, b);
  ASSERT_EQ(code, 1);
  const auto point = [](const vesica_ellipse_f64& e, double t, double(&tangent)[2], double(&at)[2]) {
    const double c = e.a * std::cos(t), s = e.b * std::sin(t), dc = -e.a * std::sin(t), ds = e.b * std::cos(t);
    at[0] = e.cx + c * e.ux - s * e.uy, at[1] = e.cy + c * e.uy + s * e.ux;
    tangent[0] = dc * e.ux - ds * e.uy, tangent[1] = dc * e.uy + ds * e.ux;
  };
  double p[2], q[2], along_a[2], along_b[2];
  point(a, r.angle_a, along_a, p);
  point(b, r.angle_b, along_b, q);
  const double x = q[0] - p[0], y = q[1] - p[1];
  EXPECT_NEAR(std::hypot(x, y), r.distance, 1e-14);
  EXPECT_NEAR(x * along_a[0] + y * along_a[1], 0, 1e-6);
  EXPECT_NEAR(x * along_b[0] + y * along_b[1], 0, 1e-6);
}

TYPED_TEST(GradientDescent, ErrorsOfEachIteration) {
  using T = TypeParam;
  const auto a = sample<T>(nineteen_ellipses::first), b = sample<T>(nineteen_ellipses::others[8]);
  std::vector<T> errors(1000, T{-1});
  typename Face<T>::Result all, some;
  EXPECT_EQ(Face<T>::run(&a, &b, nullptr, &all, errors.data(), 1000), 1);
  ASSERT_GT(all.iterations, 10);
  ASSERT_LT(all.iterations, 1000);
  const auto count = static_cast<std::size_t>(all.iterations);
  for (std::size_t i = 0; i + 1 < count; ++i) EXPECT_GE(errors[i], T{1e-8F}) << i;
  EXPECT_EQ(errors[count - 1], all.error);
  for (std::size_t i = count; i < errors.size(); ++i) EXPECT_EQ(errors[i], T{-1}) << i;
  std::vector<T> first_few(10, T{-1});
  EXPECT_EQ(Face<T>::run(&a, &b, nullptr, &some, first_few.data(), 5), 1);
  EXPECT_EQ(some.iterations, all.iterations);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(first_few[i], i < 5 ? errors[i] : T{-1}) << i;
}

TEST(GradientDescent, RunsOutOfIterations) {
  const auto a = sample<double>(nineteen_ellipses::first), b = sample<double>(nineteen_ellipses::others[8]);
  double before = std::numeric_limits<double>::infinity();
  for (std::int32_t iterations = 1; iterations <= 60; ++iterations) {
    auto s = settings<double>(VESICA_SCHEDULE_SCALE_AWARE);
    s.iterations = iterations;
    vesica_descent_result_f64 result;
    EXPECT_EQ(vesica_method_ellipse_ellipse_distance_gradient_descent_f64(&a, &b, &s, &result, nullptr, 0), 0);
    EXPECT_EQ(result.success, 0);
    EXPECT_EQ(result.iterations, iterations);
    EXPECT_GE(result.error, 1e-8);
    EXPECT_LE(result.distance, before) << "never up";
    before = result.distance;
  }
  EXPECT_NEAR(before, nineteen_ellipses::distances[8], 1e-8);
}

TYPED_TEST(GradientDescent, Defaults) {
  const auto scale_aware = settings<TypeParam>(VESICA_SCHEDULE_SCALE_AWARE);
  EXPECT_EQ(scale_aware.tolerance, static_cast<TypeParam>(1e-8));
  EXPECT_EQ(scale_aware.rate, TypeParam{1});
  EXPECT_EQ(scale_aware.decay, TypeParam{0});
  EXPECT_EQ(scale_aware.iterations, 10000);
  EXPECT_EQ(scale_aware.schedule, 0);
  const auto literal = settings<TypeParam>(VESICA_SCHEDULE_LITERAL);
  EXPECT_EQ(literal.tolerance, static_cast<TypeParam>(1e-8));
  EXPECT_EQ(literal.rate, static_cast<TypeParam>(0.04));
  EXPECT_EQ(literal.decay, static_cast<TypeParam>(0.002));
  EXPECT_EQ(literal.iterations, 10000);
  EXPECT_EQ(literal.schedule, 1);
}

TEST(GradientDescent, Constants) {
  EXPECT_EQ(VESICA_SCHEDULE_SCALE_AWARE, 0);
  EXPECT_EQ(VESICA_SCHEDULE_LITERAL, 1);
  EXPECT_EQ(VESICA_MOST_DESCENT_ITERATIONS, 1000000);
}

}  // namespace
