// SPDX-License-Identifier: Apache-2.0
// As printed the formula took the root of a negative number where the circle's centre lies between the ellipse and its
// evolute, and misjudged one pair in ten.
#include <cmath>
#include <cstdio>
#include <vesica/methods/circle_ellipse_closed_form.hpp>

#include "methods/ellipse_cases.hpp"
#include "methods/exact_method.hpp"

namespace circle_ellipse_closed_form_test {
namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_circle_ellipse_closed_form_f64;
constexpr auto f32 = vesica_method_circle_ellipse_closed_form_f32;

/// The printed formula's x on an ellipse of half lengths 1 and 1 / b about the origin, b > 1, nearest to (c, d) in the
/// first quadrant. NaN where it takes the root of a negative number.
double printed_nearest_x(double b, double c, double d) {
  const double b2 = b * b, m = b2 - 1, mm = m * m, e = b2 * b2 * c * c, g = e - mm + d * d * b2, h = b2 * c, i = m * h;
  const double j = 72 * mm * e * g + 2 * g * g * g + (108 * (mm - e) + 36 * g) * i * i;
  const double k = 12 * i * i + g * g - 12 * mm * e;
  const double q = std::pow(j + std::sqrt(j * j - 4 * k * k * k), 1. / 3);
  const double o = g / (3 * mm) + g * g / mm * std::cbrt(2.) / (3 * q) + q / mm * std::cbrt(4.) / 6;
  const double p = std::sqrt((e - g) / mm + o);
  const double s = (2 * e - g) / mm - o - 2 * h * ((e - g) / (mm * m) - 2 / m) / p;
  return h / (2 * m) - p / 2 + std::sqrt(s) / 2;
}

/// 1, 0, or 2 for a root of a negative number. An ellipse along the coordinate axes about the origin, a > b.
std::int32_t printed(const Pair& pair) {
  const double c = std::abs(pair.a[0]) / pair.b[4], d = std::abs(pair.a[1]) / pair.b[4], r = pair.a[2] / pair.b[4];
  const double ratio = pair.b[4] / pair.b[5];
  if (c * c + d * d * ratio * ratio <= 1) return 1;
  const double x = printed_nearest_x(ratio, c, d), y = std::sqrt(1 - x * x) / ratio;
  if (std::isnan(x) || std::isnan(y)) return 2;
  return (x - c) * (x - c) + (y - d) * (y - d) <= r * r ? 1 : 0;
}

// Half lengths 2 and 1, the centre at (1/8, 5/4), 0.25 from the outline: the evolute reaches up to (0, 3).
TEST(CircleEllipseClosedForm, PrintedFormulaFailsWithinTheEvolute) {
  for (const double radius : {0.125, 0.5}) {
    const Pair pair{VESICA_CIRCLE, VESICA_ELLIPSE, {0.125, 1.25, radius}, {0, 0, 1, 0, 2, 1}};
    EXPECT_EQ(printed(pair), 2);
    EXPECT_EQ((call<f64, f32>(Scalar::f64, pair)), radius > 0.25 ? 1 : 0);
    EXPECT_EQ((call<f64, f32>(Scalar::f32, pair)), radius > 0.25 ? 1 : 0);
    EXPECT_EQ(truth(Scalar::f64, pair), radius > 0.25 ? 1 : 0);
  }
}

TEST(CircleEllipseClosedForm, PrintedFormulaCounts) {
  Random random(properties::seed());
  const auto next = [&] {
    const double a = random.between(0.25, 2);
    return Pair{VESICA_CIRCLE,
                VESICA_ELLIPSE,
                {random.between(-3, 3), random.between(-3, 3), random.between(0.25, 2)},
                {0, 0, 1, 0, a, a * random.between(0.1, 1)}};
  };
  const Counts counts = count(printed, Scalar::f64, 100000, next);
  print("closed_form as printed", Scalar::f64, "random, upright", counts);
  EXPECT_GT(counts.uncertain, counts.cases / 50);
  const Counts ours = count(method<f64, f32>(Scalar::f64), Scalar::f64, 100000, next);
  EXPECT_EQ(ours.wrong + ours.uncertain, 0);
}

TEST(CircleEllipseClosedForm, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_known_answers(circle_ellipse_cases, VESICA_CIRCLE, VESICA_ELLIPSE, scalar, method<f64, f32>(scalar));
  }
}

// k is the positive root of a^2 / (k + c)^2 + b^2 / k^2 = 1, in and out of the evolute, on it and on the axes.
TEST(CircleEllipseClosedForm, QuarticRoot) {
  using vesica::methods::detail::quartic_root;
  EXPECT_DOUBLE_EQ(quartic_root(1., 0., 0.25), 0.75);
  EXPECT_DOUBLE_EQ(quartic_root(0., 1., 0.25), 1);
  EXPECT_DOUBLE_EQ(quartic_root(0., 0.25, 1.), 0.25);
  EXPECT_DOUBLE_EQ(quartic_root(0.6, 0.8, 0.), 1);
  EXPECT_DOUBLE_EQ(quartic_root(0.9, 0.4, 1.), 0.5);  // 0.9 / 1.5 = 0.6, 0.4 / 0.5 = 0.8
  EXPECT_DOUBLE_EQ(quartic_root(0.6 * 1.001, 0.8e-3, 1.), 1e-3);
  EXPECT_DOUBLE_EQ(quartic_root(0.6 * (1 + 1e-9), 0.8e-9, 1.), 1e-9);
  EXPECT_FLOAT_EQ(quartic_root(0.9F, 0.4F, 1.F), 0.5F);
  Random random(properties::seed());
  double worst = 0;
  for (int i = 0; i < 100000 * properties::repeat(); ++i) {
    // From k and the angle of (a / (k + c), b / k) on the unit circle.
    const double c = random.chance(0.5) ? 1 : random.between(0, 1), angle = random.between(0, 1.5707);
    const double k = std::pow(10.0, -random.between(0, 8));
    const double a = std::cos(angle) * (k + c), b = std::sin(angle) * k;
    const double unit = std::max({a, b, c});
    worst = std::max(worst, std::abs(quartic_root(a / unit, b / unit, c / unit) * unit - k) * std::sin(angle) / k);
  }
  EXPECT_LT(worst, 1e-12);
  std::printf("quartic_root: largest relative error, times sin of the angle, %.3g\n", worst);
}

TEST(CircleEllipseClosedForm, InvalidInput) {
  InvalidInput<f64>::expect_errors();
  InvalidInput<f32>::expect_errors();
}

TEST(CircleEllipseClosedForm, ExactBeyondTheGap) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_exact_beyond_gap("circle_ellipse_closed_form", method<f64, f32>(scalar), VESICA_CIRCLE, VESICA_ELLIPSE,
                            scalar);
  }
}

TEST(CircleEllipseClosedForm, NearTangentCounts) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_counts_near_tangent("circle_ellipse_closed_form", method<f64, f32>(scalar), VESICA_CIRCLE, VESICA_ELLIPSE,
                               scalar);
  }
}

TEST(CircleEllipseClosedForm, Core) {
  using namespace vesica;
  static_assert(noexcept(methods::closed_form(Circle<float>{}, Ellipse<float>{})));
  EXPECT_EQ(methods::closed_form(Circle<double>{32, 32, 13.5}, Ellipse<double>{0, 0, 1, 0, 45, 25}), 1);
  EXPECT_EQ(methods::closed_form(Circle<float>{32, 32, 12.5}, Ellipse<float>{0, 0, 1, 0, 45, 25}), 0);
  EXPECT_EQ(methods::closed_form(Circle<double>{32, 32, -1}, Ellipse<double>{0, 0, 1, 0, 45, 25}), error_shape);
}

}  // namespace
}  // namespace circle_ellipse_closed_form_test
