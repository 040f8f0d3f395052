// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vesica/methods/ellipse_ellipse_parallel_axes.hpp>

#include "methods/approximation.hpp"
#include "methods/ellipse_cases.hpp"
#include "methods/ellipse_growth.hpp"

namespace ellipse_ellipse_parallel_axes_test {
namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_ellipse_ellipse_parallel_axes_f64;
constexpr auto f32 = vesica_method_ellipse_ellipse_parallel_axes_f32;

TEST(EllipseEllipseParallelAxes, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_known_answers(parallel_ellipse_cases, VESICA_ELLIPSE, VESICA_ELLIPSE, scalar,
                         method_with<f64, f32, 12>(scalar));
  }
}

TEST(EllipseEllipseParallelAxes, TouchingIsUncertain) {
  const vesica_ellipse_f64 a{0, 0, 3, 4, 45, 12.5}, b{-160, -80, -3, -4, 13, 6.5};
  for (const std::int32_t n : {0, 5, 30}) {
    vesica_approximation_f64 out;
    EXPECT_EQ(f64(&a, &b, n, &out), VESICA_UNCERTAIN) << n;
    EXPECT_EQ(out.iterations, n);
    EXPECT_DOUBLE_EQ(out.outline_error, std::ldexp(225 * std::exp2(0.303), -2 * n));
    EXPECT_EQ(f64(&b, &a, n, &out), VESICA_UNCERTAIN) << n;
    EXPECT_DOUBLE_EQ(out.outline_error, std::ldexp(65 * std::exp2(0.303), -2 * n));
  }
}

template <auto function, class Ellipse, class T>
std::int32_t answer_of_axes(T ux, T uy, T wx, T wy) {
  const Ellipse a{0, 0, ux, uy, 1, 1}, b{0, 0, wx, wy, 1, 1};
  typename Halving<decltype(function)>::Out out;
  return function(&a, &b, 5, &out);
}
std::int32_t answer_of_axes(double ux, double uy, double wx, double wy) {
  return answer_of_axes<f64, vesica_ellipse_f64>(ux, uy, wx, wy);
}
std::int32_t answer_of_axes(float ux, float uy, float wx, float wy) {
  return answer_of_axes<f32, vesica_ellipse_f32>(ux, uy, wx, wy);
}

// As stored, without any tolerance: one place off is not parallel.
TEST(EllipseEllipseParallelAxes, AxesMustBeParallel) {
  const double x = std::cos(1.), y = std::sin(1.);
  EXPECT_EQ(answer_of_axes(x, y, x, y), VESICA_YES);
  EXPECT_EQ(answer_of_axes(x, y, -y, x), VESICA_YES);
  EXPECT_EQ(answer_of_axes(x, y, y, -x), VESICA_YES);
  EXPECT_EQ(answer_of_axes(x, y, -4 * x, -4 * y), VESICA_YES);
  EXPECT_EQ(answer_of_axes(1., 3., 5., 15.), VESICA_YES);
  EXPECT_EQ(answer_of_axes(0x1p-900, 0x3p-900, 0x5p900, 0xfp900), VESICA_YES);
  EXPECT_EQ(answer_of_axes(1., 0., 0., -7.), VESICA_YES);
  EXPECT_EQ(answer_of_axes(x, y, x, -y), VESICA_E_ARGUMENT);
  EXPECT_EQ(answer_of_axes(x, y, y, x), VESICA_E_ARGUMENT);
  EXPECT_EQ(answer_of_axes(x, y, std::nextafter(x, 1), y), VESICA_E_ARGUMENT);
  EXPECT_EQ(answer_of_axes(x, y, x, std::nextafter(y, 0)), VESICA_E_ARGUMENT);
  EXPECT_EQ(answer_of_axes(1., 0., 1., 0x1p-1074), VESICA_E_ARGUMENT);
  // Both products round to 1: (1 + 2^-52) (1 - 2^-52) = 1 - 2^-104.
  EXPECT_EQ(answer_of_axes(1 + 0x1p-52, 1., 1., 1 - 0x1p-52), VESICA_E_ARGUMENT);
  EXPECT_EQ(answer_of_axes(1.F, 3.F, 5.F, 15.F), VESICA_YES);
  EXPECT_EQ(answer_of_axes(1 + 0x1p-23F, 1.F, 1.F, 1 - 0x1p-23F), VESICA_E_ARGUMENT);
  EXPECT_EQ(answer_of_axes(3.F, 4.F, 4.F, 3.F), VESICA_E_ARGUMENT);
}

TEST(EllipseEllipseParallelAxes, InvalidInput) {
  expect_errors<f64>({1, 2, 3, 4, 2, 1}, {1, 2, 3, 4, 2, 1});
  expect_errors<f32>({1, 2, 3, 4, 2, 1}, {1, 2, 3, 4, 2, 1});
}

/// b with a's axis, or that turned by a quarter, turned about, or longer.
Pair aligned(Pair pair, Random& random) {
  const double ux = pair.a[2], uy = pair.a[3];
  const bool turned = random.chance(0.5);
  const double sign = random.sign();
  pair.b[2] = sign * (turned ? -uy : ux);
  pair.b[3] = sign * (turned ? ux : uy);
  return pair;
}

void expect_never_wrong_aligned(Scalar scalar, int cases) {
  const Method parallel_axes = method_with<f64, f32, 12>(scalar);
  Random random(properties::seed());
  const auto expect = [&](const char* workload, const std::function<Pair()>& next) {
    const Counts counts = count(parallel_axes, scalar, std::int64_t{cases} * properties::repeat(), next);
    print("parallel_axes n = 12", scalar, workload, counts);
    EXPECT_EQ(counts.wrong, 0) << workload << ", VESICA_SEED=" << properties::seed();
    EXPECT_EQ(counts.refused, 0) << workload;
  };
  for (const properties::Workload workload : properties::all_workloads) {
    if (workload == properties::Workload::near_contact) continue;  // turning an axis would leave the contact
    expect(properties::name(workload),
           [&] { return aligned(properties::draw(workload, VESICA_ELLIPSE, VESICA_ELLIPSE, scalar, random), random); });
  }
  // Skips pairs that bisection cannot place (beyond the range of numbers, or not near each other).
  for (const properties::Workload workload : {properties::Workload::random, properties::Workload::grid}) {
    for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
      expect("near tangent", [&] {
        Pair pair = aligned(properties::draw(workload, VESICA_ELLIPSE, VESICA_ELLIPSE, scalar, random), random);
        if (pair.a[0] == pair.b[0] && pair.a[1] == pair.b[1]) pair.b[0] += 1;
        return moved_near_contact(pair, scalar, gap, random);
      });
    }
  }
}

TEST(EllipseEllipseParallelAxes, EveryYesAndNoIsTrue) {
  expect_never_wrong_aligned(Scalar::f64, 8000);
  expect_never_wrong_aligned(Scalar::f32, 8000);
}

TEST(EllipseEllipseParallelAxes, UncertainWithinTheBound) { expect_uncertain_within_bound(f64, aligned); }

TEST(EllipseEllipseParallelAxes, Core) {
  using namespace vesica;
  methods::Approximation<float> out;
  static_assert(noexcept(methods::parallel_axes(Ellipse<float>{}, Ellipse<float>{}, 1, out)));
  EXPECT_EQ(methods::parallel_axes(Ellipse<float>{0, 0, 1, 0, 5, 2}, Ellipse<float>{8, 0, 1, 0, 4, 7}, 5, out), 1);
  EXPECT_EQ(methods::parallel_axes(Ellipse<float>{0, 0, 1, 0, 5, 2}, Ellipse<float>{8, 0, 1, 0, 2, 7}, 5, out), 0);
  EXPECT_EQ(methods::parallel_axes(Ellipse<float>{0, 0, 1, 0, 5, 2}, Ellipse<float>{8, 0, 1, 1, 2, 7}, 5, out),
            error_argument);
}

}  // namespace
}  // namespace ellipse_ellipse_parallel_axes_test
