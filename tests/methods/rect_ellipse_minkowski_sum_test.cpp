// SPDX-License-Identifier: Apache-2.0
// As printed the test misjudged pairs in which a small rectangle lies beside a skewed ellipse: it looked at the corner
// in the quadrant of the ellipse's centre, and another corner's arc applied. Both printed forms stand here, for the
// record.
#include <cstdio>
#include <vesica/methods/rect_ellipse_minkowski_sum.hpp>

#include "methods/exact_method.hpp"
#include "methods/rect_ellipse_cases.hpp"

namespace rect_ellipse_minkowski_sum_test {
namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_rect_ellipse_minkowski_sum_f64;
constexpr auto f32 = vesica_method_rect_ellipse_minkowski_sum_f32;

enum class Typo { as_printed, mended };

/// The printed test, in units in which both axes have length 1; `as_printed`, the corner has the first extent twice.
bool printed(const Pair& pair, Typo typo) {
  const auto& [cx, cy, ux, uy, e0, e1, radius_a] = pair.a;
  const auto& [kx, ky, vx, vy, a0, a1, radius_b] = pair.b;
  const double x = ux * (kx - cx) + uy * (ky - cy), y = ux * (ky - cy) - uy * (kx - cx);
  // The ellipse's axes in the rectangle's frame: (c, s) and (-s, c). M and its inverse.
  const double c = ux * vx + uy * vy, s = ux * vy - uy * vx;
  const double m00 = c * c / (a0 * a0) + s * s / (a1 * a1), m11 = s * s / (a0 * a0) + c * c / (a1 * a1);
  const double m01 = c * s * (1 / (a0 * a0) - 1 / (a1 * a1));
  const double l0 = std::hypot(a0 * c, a1 * s), l1 = std::hypot(a0 * s, a1 * c);
  if (std::abs(x) > e0 + l0 || std::abs(y) > e1 + l1) return false;
  const double s0 = x >= 0 ? 1 : -1, s1 = y >= 0 ? 1 : -1;
  const double dx = x - s0 * e0, dy = y - s1 * (typo == Typo::as_printed ? e0 : e1);
  const double mx = m00 * dx + m01 * dy, my = m01 * dx + m11 * dy;
  if (s0 * mx <= 0 || s1 * my <= 0) return true;
  return dx * mx + dy * my <= 1;
}

TEST(RectEllipseMinkowskiSum, PrintedTestMisjudges) {
  const Pair skewed{
      VESICA_RECT, VESICA_ELLIPSE, {0, 0, 1, 0, 0.25, 0.875}, {-1.25, -0.375, 8. / 17, 15. / 17, 3, 0.125}};
  const double diagonal = std::sqrt(0.5);
  const Pair small{VESICA_RECT, VESICA_ELLIPSE, {0, 0, 1, 0, 0.1, 0.1}, {0.2, 0.9, diagonal, diagonal, 2, 0.1}};
  for (const Pair& pair : {skewed, small}) {
    EXPECT_TRUE(printed(pair, Typo::mended));
    EXPECT_TRUE(printed(pair, Typo::as_printed));
    EXPECT_EQ((call<f64, f32>(Scalar::f64, pair)), 0);
    EXPECT_EQ(truth(Scalar::f64, pair), 0);
    EXPECT_EQ((call<f64, f32>(Scalar::f32, pair)), 0);
  }
}

TEST(RectEllipseMinkowskiSum, PrintedTestCounts) {
  for (const Typo typo : {Typo::as_printed, Typo::mended}) {
    const char* name = typo == Typo::as_printed ? "minkowski_sum as printed" : "minkowski_sum typo mended";
    const Method variant = [typo](const Pair& pair) { return printed(pair, typo) ? 1 : 0; };
    const Counts random =
        count(variant, properties::Workload::random, VESICA_RECT, VESICA_ELLIPSE, Scalar::f64, 100000);
    print(name, Scalar::f64, "random", random);
    EXPECT_GT(random.wrong_beyond_gap, 0);
    print(name, Scalar::f64, "near tangent -6",
          count_near_tangent(variant, 1e-6, VESICA_RECT, VESICA_ELLIPSE, Scalar::f64, 20000));
  }
}

TEST(RectEllipseMinkowskiSum, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) expect_known_answers(scalar, method<f64, f32>(scalar));
}

TEST(RectEllipseMinkowskiSum, InvalidInput) {
  InvalidInput<f64>::expect_errors();
  InvalidInput<f32>::expect_errors();
}

TEST(RectEllipseMinkowskiSum, ExactBeyondTheGap) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_exact_beyond_gap("rect_ellipse_minkowski_sum", method<f64, f32>(scalar), VESICA_RECT, VESICA_ELLIPSE,
                            scalar);
  }
}

TEST(RectEllipseMinkowskiSum, NearTangentCounts) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_counts_near_tangent("rect_ellipse_minkowski_sum", method<f64, f32>(scalar), VESICA_RECT, VESICA_ELLIPSE,
                               scalar);
  }
}

TEST(RectEllipseMinkowskiSum, Core) {
  using namespace vesica;
  static_assert(noexcept(methods::minkowski_sum(Rect<float>{}, Ellipse<float>{})));
  EXPECT_EQ(methods::minkowski_sum(Rect<double>{0, 0, 1, 0, 1, 1}, Ellipse<double>{4, 5, 1, 0, 5, 5}), 1);
  EXPECT_EQ(methods::minkowski_sum(Rect<float>{0, 0, 1, 0, 1, 1}, Ellipse<float>{4, 6, 1, 0, 5, 5}), 0);
  EXPECT_EQ(methods::minkowski_sum(Rect<double>{0, 0, 1, 0, 1, 1}, Ellipse<double>{4, 5, 0, 0, 5, 5}), error_shape);
}

}  // namespace
}  // namespace rect_ellipse_minkowski_sum_test
