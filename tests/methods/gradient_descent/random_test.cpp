// SPDX-License-Identifier: Apache-2.0
// On random pairs: against brute force, at every scale, and what print's schedule does there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "methods/gradient_descent/descent.hpp"
#include "methods/gradient_descent/outline_distance.hpp"
#include "properties/generators.hpp"

namespace {

using namespace descent;
using properties::Random;

struct Case {
  vesica_ellipse_f64 a, b;
  double distance;
};

Case random_disjoint(Random& random, double aspect) {
  for (;;) {
    const vesica_ellipse_f64 a = random_ellipse(random, aspect, 3), b = random_ellipse(random, aspect, 3);
    if (vesica_overlap_ellipse_ellipse_f64(&a, &b) == 0) return {a, b, outline_distance::of_disjoint(a, b)};
  }
}

/// The second inside the first, a thousandth or more from its outline.
Case random_nested(Random& random, double aspect) {
  for (;;) {
    const vesica_ellipse_f64 a = random_ellipse(random, aspect, 0.2);
    vesica_ellipse_f64 b = random_ellipse(random, aspect, 0.2);
    const double factor = random.between(0.05, 0.8);
    b.a *= factor;
    b.b *= factor;
    const double distance = outline_distance::of_nested(b, a);
    if (distance >= 1e-3) return {a, b, distance};
  }
}

/// Neither inside the other.
Case random_crossing(Random& random, double aspect) {
  for (;;) {
    const vesica_ellipse_f64 a = random_ellipse(random, aspect, 1), b = random_ellipse(random, aspect, 1);
    if (vesica_overlap_ellipse_ellipse_f64(&a, &b) == 0) continue;
    if (outline_distance::of_nested(a, b) < 0 && outline_distance::of_nested(b, a) < 0) return {a, b, 0};
  }
}

struct Counts {
  int cases = 0, converged = 0, not_least = 0;
  double largest_error = 0;  ///< of those that found the least distance
  double lowest = 0;         ///< below the true distance
};

Counts count(Case (*draw)(Random&, double), double aspect, std::int32_t schedule, double scale, int cases) {
  Random random(properties::seed());
  Counts counts;
  for (; counts.cases < cases * properties::repeat(); ++counts.cases) {
    const Case c = draw(random, aspect);
    const auto [code, result] = run(scaled(c.a, scale), scaled(c.b, scale), schedule);
    const double error = result.distance / scale - c.distance;
    counts.lowest = std::max(counts.lowest, -error);
    if (code != 1) continue;
    ++counts.converged;
    counts.not_least += error > 1e-5;
    if (error <= 1e-5) counts.largest_error = std::max(counts.largest_error, error);
  }
  return counts;
}

Counts count_and_print(const char* name, Case (*draw)(Random&, double), double aspect, std::int32_t schedule,
                       double scale, int cases) {
  const Counts counts = count(draw, aspect, schedule, scale, cases);
  std::printf("%-30s aspect to %-7g scale %-5g %5d cases %5d converged %4d not least, else error %.1e\n", name, aspect,
              scale, counts.cases, counts.converged, counts.not_least, counts.largest_error);
  return counts;
}

constexpr double aspects[] = {1, 3, 20, 1e3, 1e6};

// Descent that never goes up finds the one minimum, at any aspect; what does not converge is nearly in contact.
TEST(GradientDescentRandom, Disjoint) {
  for (const double aspect : aspects) {
    const Counts counts =
        count_and_print("disjoint, scale-aware", random_disjoint, aspect, VESICA_SCHEDULE_SCALE_AWARE, 1, 1000);
    EXPECT_GE(counts.converged, 0.99 * counts.cases) << "VESICA_SEED=" << properties::seed();
    EXPECT_EQ(counts.not_least, 0) << "VESICA_SEED=" << properties::seed();
    EXPECT_LT(counts.largest_error, 1e-9) << "VESICA_SEED=" << properties::seed();
    EXPECT_LT(counts.lowest, 1e-13) << "VESICA_SEED=" << properties::seed();
  }
}

// The exact default on the same pairs: what descent came to is never below it.
TEST(GradientDescentRandom, AgreesWithBoundaryDistance) {
  Random random(properties::seed());
  int agree = 0;
  constexpr int cases = 2000;
  for (int i = 0; i < cases; ++i) {
    const vesica_ellipse_f64 a = random_ellipse(random, 20, 1), b = random_ellipse(random, 20, 1);
    vesica_closest_points_f64 closest;
    ASSERT_EQ(vesica_boundary_distance_f64(VESICA_ELLIPSE, &a, VESICA_ELLIPSE, &b, &closest), 0);
    const double distance = run(a, b).result.distance;
    EXPECT_GE(distance, closest.distance - 1e-14) << "VESICA_SEED=" << properties::seed();
    agree += std::fabs(distance - closest.distance) < 1e-5;
  }
  EXPECT_GE(agree, 0.95 * cases) << "VESICA_SEED=" << properties::seed();
}

// Up to four local minima: descent from the nearest vertices ends in another one than the least now and then.
TEST(GradientDescentRandom, NestedAndCrossing) {
  for (const double aspect : aspects) {
    for (const bool nested : {true, false}) {
      const Counts counts =
          count_and_print(nested ? "nested, scale-aware" : "crossing, scale-aware",
                          nested ? random_nested : random_crossing, aspect, VESICA_SCHEDULE_SCALE_AWARE, 1, 500);
      EXPECT_GE(counts.converged, 0.95 * counts.cases) << "VESICA_SEED=" << properties::seed();
      EXPECT_LE(counts.not_least, 0.06 * counts.cases) << "VESICA_SEED=" << properties::seed();
      EXPECT_LT(counts.lowest, 1e-13) << "VESICA_SEED=" << properties::seed();
    }
  }
}

// Print's step has a dimension: what it does depends on the unit of length, and where it converges more, it is wrong.
TEST(GradientDescentRandom, LiteralScheduleDependsOnScale) {
  const auto literal = [](double scale) {
    return count_and_print("disjoint, literal", random_disjoint, 20, VESICA_SCHEDULE_LITERAL, scale, 300);
  };
  const Counts tenth = literal(0.1), same = literal(1), tenfold = literal(10);
  EXPECT_LT(tenth.converged, 0.2 * tenth.cases);
  EXPECT_LT(same.converged, 0.8 * same.cases);
  EXPECT_GT(tenfold.converged, 0.9 * tenfold.cases);
  EXPECT_GT(tenfold.not_least, 0);
}

// Powers of two are exact, so every iteration is the same one, up to the bits a subnormal number loses.
TEST(GradientDescentRandom, SameAtEveryScale) {
  Random random(properties::seed());
  for (int i = 0; i < 200; ++i) {
    const vesica_ellipse_f64 a = random_ellipse(random, 20, 1), b = random_ellipse(random, 20, 1);
    const auto expected = run(a, b);
    for (const double scale : {0x1p-900, 0x1p-300, 0x1p-20, 0x1p20, 0x1p300, 0x1p1000}) {
      const auto [code, result] = run(scaled(a, scale), scaled(b, scale));
      EXPECT_EQ(code, expected.code) << scale;
      EXPECT_EQ(result.iterations, expected.result.iterations) << scale;
      EXPECT_EQ(result.angle_a, expected.result.angle_a) << scale;
      EXPECT_EQ(result.angle_b, expected.result.angle_b) << scale;
      EXPECT_EQ(result.distance, expected.result.distance * scale) << scale;
    }
    // An axis is a unit of length.
    const vesica_ellipse_f64 longer{a.cx, a.cy, a.ux * 0x1p700, a.uy * 0x1p700, a.a * 0x1p-700, a.b * 0x1p-700};
    EXPECT_EQ(run(longer, b).result.distance, expected.result.distance);
    EXPECT_EQ(run(longer, b).result.iterations, expected.result.iterations);
  }
}

/// Any valid pair has an answer, and a finite one.
template <class T>
void expect_sane(const properties::Pair& pair, std::int32_t schedule) {
  using Ellipse = typename Face<T>::Ellipse;
  const auto ellipse = [](const properties::Numbers& n) {
    return Ellipse{static_cast<T>(n[0]), static_cast<T>(n[1]), static_cast<T>(n[2]),
                   static_cast<T>(n[3]), static_cast<T>(n[4]), static_cast<T>(n[5])};
  };
  const Ellipse a = ellipse(pair.a), b = ellipse(pair.b);
  auto s = settings<T>(schedule);
  s.iterations = 100;
  typename Face<T>::Result result{};
  const std::int32_t code = Face<T>::run(&a, &b, &s, &result, nullptr, 0);
  SCOPED_TRACE(properties::describe(pair));
  if (code == VESICA_E_RANGE) return;
  EXPECT_EQ(code, result.success);
  EXPECT_TRUE(code == 0 || code == 1);
  EXPECT_TRUE(std::isfinite(result.distance) && result.distance >= 0);
  EXPECT_TRUE(std::isfinite(result.error) && result.error >= 0);
  EXPECT_TRUE(std::fabs(result.angle_a) <= T{3.1415928F} && std::fabs(result.angle_b) <= T{3.1415928F});
  EXPECT_TRUE(result.iterations >= 1 && result.iterations <= 100);
}

TEST(GradientDescentRandom, EveryValidPair) {
  for (const properties::Workload workload : properties::all_workloads) {
    for (const auto scalar : {properties::Scalar::f64, properties::Scalar::f32}) {
      SCOPED_TRACE(testing::Message() << properties::name(workload) << ", VESICA_SEED=" << properties::seed());
      properties::Stream stream(workload, VESICA_ELLIPSE, VESICA_ELLIPSE, scalar, properties::seed(),
                                [](int kind_a, const double* a, int kind_b, const double* b) {
                                  return vesica_overlap_f64(kind_a, a, kind_b, b) == 1;
                                });
      for (int i = 0; i < 500 * properties::repeat(); ++i) {
        const properties::Pair pair = stream.next();
        for (const std::int32_t schedule : {VESICA_SCHEDULE_SCALE_AWARE, VESICA_SCHEDULE_LITERAL}) {
          scalar == properties::Scalar::f64 ? expect_sane<double>(pair, schedule) : expect_sane<float>(pair, schedule);
        }
      }
    }
  }
}

}  // namespace
