// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vesica/methods/rect_ellipse_all_features.hpp>

#include "methods/exact_method.hpp"
#include "methods/rect_ellipse_cases.hpp"
#include "properties/random.hpp"

namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_rect_ellipse_all_features_f64;
constexpr auto f32 = vesica_method_rect_ellipse_all_features_f32;

TEST(RectEllipseAllFeatures, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) expect_known_answers(scalar, method<f64, f32>(scalar));
}

/// Small ellipses whose centre is on a side of a rectangle, in numbers of few digits except the ellipse's axis, so
/// that its image is rounded: the centre alone shows that they overlap.
TEST(RectEllipseAllFeatures, CentreOnASide) {
  properties::Random random(properties::seed());
  for (int i = 0; i < 500; ++i) {
    const double ux = random.integer(-9, 9);
    const double uy = random.integer(1, 9);
    const double hx = random.integer(1, 9);
    const double hy = random.integer(1, 9);
    const bool across = random.chance(0.5);
    const double s = across ? hx : random.integer(0, 8) * hx / 16;
    const double t = across ? random.integer(0, 8) * hy / 16 : hy;
    const double turn = random.between(-3, 3);
    const vesica::Rect<double> rect{0, 0, ux, uy, hx, hy};
    const vesica::Ellipse<double> small{s * ux - t * uy, s * uy + t * ux, std::cos(turn), std::sin(turn), 1e-30, 2e-30};
    ASSERT_EQ(vesica::methods::all_features(rect, small), 1) << i;
  }
}

TEST(RectEllipseAllFeatures, InvalidInput) {
  InvalidInput<f64>::expect_errors();
  InvalidInput<f32>::expect_errors();
}

TEST(RectEllipseAllFeatures, ExactBeyondTheGap) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_exact_beyond_gap("rect_ellipse_all_features", method<f64, f32>(scalar), VESICA_RECT, VESICA_ELLIPSE, scalar);
  }
}

TEST(RectEllipseAllFeatures, NearTangentCounts) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_counts_near_tangent("rect_ellipse_all_features", method<f64, f32>(scalar), VESICA_RECT, VESICA_ELLIPSE,
                               scalar);
  }
}

TEST(RectEllipseAllFeatures, Core) {
  using namespace vesica;
  static_assert(noexcept(methods::all_features(Rect<float>{}, Ellipse<float>{})));
  EXPECT_EQ(methods::all_features(Rect<double>{0, 0, 1, 0, 1, 1}, Ellipse<double>{4, 5, 1, 0, 5, 5}), 1);
  EXPECT_EQ(methods::all_features(Rect<float>{0, 0, 1, 0, 1, 1}, Ellipse<float>{4, 6, 1, 0, 5, 5}), 0);
  EXPECT_EQ(methods::all_features(Rect<double>{0, 0, 1, 0, -1, 1}, Ellipse<double>{4, 5, 1, 0, 5, 5}), error_shape);
}

}  // namespace
