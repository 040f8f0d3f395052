// SPDX-License-Identifier: Apache-2.0
#include <vesica/methods/rect_ellipse_closest_features.hpp>

#include "methods/exact_method.hpp"
#include "methods/rect_ellipse_cases.hpp"

namespace rect_ellipse_closest_features_test {
namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_rect_ellipse_closest_features_f64;
constexpr auto f32 = vesica_method_rect_ellipse_closest_features_f32;

TEST(RectEllipseClosestFeatures, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) expect_known_answers(scalar, method<f64, f32>(scalar));
}

TEST(RectEllipseClosestFeatures, InvalidInput) {
  InvalidInput<f64>::expect_errors();
  InvalidInput<f32>::expect_errors();
}

TEST(RectEllipseClosestFeatures, ExactBeyondTheGap) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_exact_beyond_gap("rect_ellipse_closest_features", method<f64, f32>(scalar), VESICA_RECT, VESICA_ELLIPSE,
                            scalar);
  }
}

TEST(RectEllipseClosestFeatures, NearTangentCounts) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_counts_near_tangent("rect_ellipse_closest_features", method<f64, f32>(scalar), VESICA_RECT, VESICA_ELLIPSE,
                               scalar);
  }
}

TEST(RectEllipseClosestFeatures, Core) {
  using namespace vesica;
  static_assert(noexcept(methods::closest_features(Rect<float>{}, Ellipse<float>{})));
  EXPECT_EQ(methods::closest_features(Rect<double>{0, 0, 1, 0, 1, 1}, Ellipse<double>{4, 5, 1, 0, 5, 5}), 1);
  EXPECT_EQ(methods::closest_features(Rect<float>{0, 0, 1, 0, 1, 1}, Ellipse<float>{4, 6, 1, 0, 5, 5}), 0);
  EXPECT_EQ(methods::closest_features(Rect<double>{0, 0, 1, 0, -1, 1}, Ellipse<double>{4, 5, 1, 0, 5, 5}), error_shape);
}

}  // namespace
}  // namespace rect_ellipse_closest_features_test
