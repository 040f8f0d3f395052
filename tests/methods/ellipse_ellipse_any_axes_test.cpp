// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vesica/methods/ellipse_ellipse_any_axes.hpp>

#include "methods/approximation.hpp"
#include "methods/ellipse_cases.hpp"
#include "methods/ellipse_growth.hpp"

namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_ellipse_ellipse_any_axes_f64;
constexpr auto f32 = vesica_method_ellipse_ellipse_any_axes_f32;

TEST(EllipseEllipseAnyAxes, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    const Method any_axes = method_with<f64, f32, 12>(scalar);
    expect_known_answers(any_ellipse_cases, VESICA_ELLIPSE, VESICA_ELLIPSE, scalar, any_axes);
    expect_known_answers(parallel_ellipse_cases, VESICA_ELLIPSE, VESICA_ELLIPSE, scalar, any_axes);
  }
}

// In the stretched plane the first ellipse leans over, so that the arc nearest to the second's centre lies in another
// quarter than that centre does.
TEST(EllipseEllipseAnyAxes, NearestPointInAnotherQuarter) {
  const vesica_ellipse_f64 leaning{0, 0, 1, 1, 4, 0.25};
  for (const double x : {1., -1.}) {
    for (const double height : {1.25, 1.75}) {
      const vesica_ellipse_f64 flat{x, x + 1.125 * height, 1, 0, 0.5, 0.5 * height};
      vesica_approximation_f64 out;
      EXPECT_EQ(f64(&leaning, &flat, 10, &out), vesica_overlap_ellipse_ellipse_f64(&leaning, &flat));
      EXPECT_EQ(f64(&flat, &leaning, 10, &out), vesica_overlap_ellipse_ellipse_f64(&leaning, &flat));
    }
  }
}

TEST(EllipseEllipseAnyAxes, TouchingIsUncertain) {
  const vesica_ellipse_f64 circle{-32, 224, 5, 12, 5, 5}, ellipse{0, 0, 3, 4, 45, 25};
  for (const std::int32_t n : {0, 5, 30}) {
    vesica_approximation_f64 out;
    EXPECT_EQ(f64(&ellipse, &circle, n, &out), VESICA_UNCERTAIN) << n;
    EXPECT_EQ(out.iterations, n);
    EXPECT_DOUBLE_EQ(out.outline_error, std::ldexp(225 * std::exp2(0.303), -2 * n));
    EXPECT_EQ(f64(&circle, &ellipse, n, &out), VESICA_UNCERTAIN) << n;
    EXPECT_DOUBLE_EQ(out.outline_error, std::ldexp(65 * std::exp2(0.303), -2 * n));
  }
}

// No map makes a circle of two segments: the exact overlap answers.
TEST(EllipseEllipseAnyAxes, TwoSegmentsAreExact) {
  const vesica_ellipse_f64 first{0, 0, 2, 1, 3, 0}, second{4, 2, 1, 1, 0, 5}, apart{4, 2.5, 2, 1, 1, 0};
  vesica_approximation_f64 out{-1, -1, -1};
  EXPECT_EQ(f64(&first, &second, 0, &out), VESICA_YES);
  EXPECT_EQ(out.outline_error, 0);
  EXPECT_EQ(out.iterations, 0);
  EXPECT_EQ(f64(&first, &apart, 0, &out), VESICA_NO);
}

TEST(EllipseEllipseAnyAxes, InvalidInput) {
  expect_errors<f64>({1, 2, 3, 4, 2, 1}, {1, 2, 3, 4, 2, 1});
  expect_errors<f32>({1, 2, 3, 4, 2, 1}, {1, 2, 3, 4, 2, 1});
}

TEST(EllipseEllipseAnyAxes, EveryYesAndNoIsTrue) {
  expect_never_wrong_with_any_n<f64, f32>("any_axes", VESICA_ELLIPSE, VESICA_ELLIPSE);
}

TEST(EllipseEllipseAnyAxes, DecidedBeyondTheGap) {
  expect_decided_beyond_gap(method_with<f64, f32, 20>(Scalar::f64), VESICA_ELLIPSE, VESICA_ELLIPSE);
}

TEST(EllipseEllipseAnyAxes, UncertainWithinTheBound) {
  expect_uncertain_within_bound(f64, [](const Pair& pair, Random&) { return pair; });
}

using Vectors = vesica_radius_vector_ellipse_f64;
using VectorsF = vesica_radius_vector_ellipse_f32;

std::int32_t answer(const Vectors& a, const Vectors& b) {
  vesica_approximation_f64 out;
  return vesica_method_radius_vector_ellipses_any_axes_f64(&a, &b, 10, &out);
}
std::int32_t answer(const VectorsF& a, const VectorsF& b) {
  vesica_approximation_f32 out;
  return vesica_method_radius_vector_ellipses_any_axes_f32(&a, &b, 7, &out);
}

// The first pair is the source's example of a collision.
TEST(RadiusVectorEllipsesAnyAxes, KnownAnswers) {
  EXPECT_EQ(answer(Vectors{-10, 5, 10, 20, 3}, Vectors{3, 4, 5, -4, 0.75}), VESICA_YES);
  EXPECT_EQ(answer(Vectors{0, 0, 135, 180, 5. / 9}, Vectors{-32, 224, 25, 60, 1.01}), VESICA_YES);
  EXPECT_EQ(answer(Vectors{0, 0, 135, 180, 5. / 9}, Vectors{-32, 224, 25, 60, 0.99}), VESICA_NO);
  EXPECT_EQ(answer(Vectors{0, 0, 3, 4, 0}, Vectors{3, 4, 0, 0, 1}), VESICA_YES) << "a point on a segment";
  EXPECT_EQ(answer(Vectors{0, 0, 3, 4, 0}, Vectors{3, 4.5, 0, 0, 1}), VESICA_NO) << "a point off a segment";
  EXPECT_EQ(answer(VectorsF{0, 0, 3, 4, 0.5}, VectorsF{8, 0, 0, 5, 1}), VESICA_YES);
  EXPECT_EQ(answer(VectorsF{0, 0, 3, 4, 0.5}, VectorsF{8, 0, 0, 3, 1}), VESICA_NO);
}

template <class Ellipse, class T>
void expect_vector_errors() {
  using Limits = std::numeric_limits<T>;
  const Ellipse valid{1, 2, 3, 2, 1};
  EXPECT_EQ(answer(valid, valid), VESICA_YES);
  const auto expect = [&](T Ellipse::*field, T number) {
    Ellipse broken = valid;
    broken.*field = number;
    EXPECT_EQ(answer(broken, valid), VESICA_E_SHAPE);
    EXPECT_EQ(answer(valid, broken), VESICA_E_SHAPE);
  };
  for (T Ellipse::*field : {&Ellipse::cx, &Ellipse::cy, &Ellipse::wx, &Ellipse::wy, &Ellipse::ratio}) {
    for (const T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) expect(field, bad);
  }
  expect(&Ellipse::ratio, -Limits::denorm_min());
}

TEST(RadiusVectorEllipsesAnyAxes, InvalidInput) {
  expect_vector_errors<Vectors, double>();
  expect_vector_errors<VectorsF, float>();
  const Vectors a{1, 2, 3, 2, 1};
  const VectorsF a_f32{1, 2, 3, 2, 1};
  vesica_approximation_f64 out{1, 2, 3};
  vesica_approximation_f32 out_f32;
  EXPECT_EQ(vesica_method_radius_vector_ellipses_any_axes_f64(&a, nullptr, 1, &out), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_radius_vector_ellipses_any_axes_f64(nullptr, &a, 1, &out), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_radius_vector_ellipses_any_axes_f64(&a, &a, 1, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_radius_vector_ellipses_any_axes_f64(&a, &a, 31, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_method_radius_vector_ellipses_any_axes_f64(&a, &a, -1, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(out.outline_error, 1);
  EXPECT_EQ(vesica_method_radius_vector_ellipses_any_axes_f32(&a_f32, nullptr, 1, &out_f32), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_radius_vector_ellipses_any_axes_f32(&a_f32, &a_f32, 31, &out_f32), VESICA_E_ARGUMENT);
}

// The same as of the standard form of the same ellipses, bound and iterations included; and true.
TEST(RadiusVectorEllipsesAnyAxes, AgreesWithTheStandardForm) {
  Random random(properties::seed());
  int overlapping = 0;
  for (int i = 0; i < 50000 * properties::repeat(); ++i) {
    const auto draw = [&] {
      return Vectors{random.between(-3, 3), random.between(-3, 3), random.between(-2, 2), random.between(-2, 2),
                     random.chance(0.1) ? 0 : random.between(0, 3)};
    };
    const Vectors a = draw(), b = draw();
    const vesica_ellipse_f64 first{a.cx, a.cy, a.wx, a.wy, 1, a.ratio}, second{b.cx, b.cy, b.wx, b.wy, 1, b.ratio};
    vesica_approximation_f64 out, standard;
    const std::int32_t verdict = vesica_method_radius_vector_ellipses_any_axes_f64(&a, &b, 6, &out);
    ASSERT_EQ(verdict, f64(&first, &second, 6, &standard));
    ASSERT_EQ(out.iterations, standard.iterations);
    ASSERT_EQ(out.outline_error, standard.outline_error);
    const std::int32_t expected = vesica_overlap_ellipse_ellipse_f64(&first, &second);
    overlapping += expected;
    if (verdict != VESICA_UNCERTAIN) {
      ASSERT_EQ(verdict, expected);
    }
  }
  EXPECT_GT(overlapping, 10000 * properties::repeat());
}

TEST(EllipseEllipseAnyAxes, Core) {
  using namespace vesica;
  methods::Approximation<float> out;
  using Vector = methods::RadiusVectorEllipse<float>;
  static_assert(noexcept(methods::any_axes(Ellipse<float>{}, Ellipse<float>{}, 1, out)));
  static_assert(noexcept(methods::any_axes(Vector{}, Vector{}, 1, out)));
  EXPECT_EQ(methods::any_axes(Ellipse<float>{0, 0, 3, 4, 45, 25}, Ellipse<float>{-32, 224, 5, 12, 6, 6}, 5, out), 1);
  EXPECT_EQ(methods::any_axes(Vector{0, 0, 3, 4, 0.5F}, Vector{8, 0, 0, 3, 1}, 5, out), 0);
}

}  // namespace
