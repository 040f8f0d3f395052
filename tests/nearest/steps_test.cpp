// SPDX-License-Identifier: Apache-2.0
/// How long the searches take: their limits are never reached, which is looked for here, not hoped for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vesica/nearest.hpp>

#include "properties/generators.hpp"

namespace steps_test {
namespace {

using properties::Pair;
using properties::Random;
using properties::Scalar;

constexpr int allowed = 48;
static_assert(allowed < vesica::detail::nearest::direction_step_limit);

template <class Shape>
Shape to_shape(const properties::Numbers& n) {
  if constexpr (vesica::ShapeTraits<Shape>::fields == 3) {
    return {n[0], n[1], n[2]};
  } else {
    return {n[0], n[1], n[2], n[3], n[4], n[5]};
  }
}

/// Steps of the pair's own search, whatever it was worth; 0 for overlapping shapes.
template <class A, class B>
int steps_of(const Pair& p) {
  const A a = to_shape<A>(p.a);
  const B b = to_shape<B>(p.b);
  if (vesica::overlap_or_error(a, b) != 0) return 0;
  int steps = 0;
  vesica::detail::nearest::disjoint_points(a, b, steps);
  return steps;
}

using Steps = int (*)(const Pair&);

/// Climbs from random pairs to slower ones: changes that do not make the search quicker are kept.
int most_steps(int kind_a, int kind_b, Steps steps, properties::Workload workload, int starts, Random& random) {
  int most = 0;
  for (int start = 0; start < starts; ++start) {
    Pair p = properties::draw(workload, kind_a, kind_b, Scalar::f64, random);
    int slowest = steps(p);
    for (int change = 0; change < 60; ++change) {
      Pair q = p;
      auto& numbers = random.chance(0.5) ? q.a : q.b;
      double& x = numbers[static_cast<std::size_t>(random.below(6))];
      x += std::fabs(x) * random.between(-1, 1) * std::pow(10.0, -random.between(0, 15));
      if (!properties::valid(kind_a, q.a) || !properties::valid(kind_b, q.b)) continue;
      const int now = steps(q);
      if (now >= slowest) {
        slowest = now;
        p = q;
      }
    }
    if (slowest > most) {
      most = slowest;
      EXPECT_LE(most, allowed) << properties::describe(p);
    }
  }
  return most;
}

void expect_few_steps(int kind_a, int kind_b, Steps steps) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  Random random(properties::seed());
  for (const properties::Workload workload : properties::all_workloads) {
    if (workload == properties::Workload::near_contact) continue;
    const int most = most_steps(kind_a, kind_b, steps, workload, 400 * properties::repeat(), random);
    std::printf("%s: %d steps at most\n", properties::name(workload), most);
  }
}

TEST(NearestSteps, EllipseEllipse) {
  expect_few_steps(5, 5, steps_of<vesica::Ellipse<double>, vesica::Ellipse<double>>);
}
TEST(NearestSteps, CircleEllipse) { expect_few_steps(2, 5, steps_of<vesica::Circle<double>, vesica::Ellipse<double>>); }
TEST(NearestSteps, RectEllipse) { expect_few_steps(4, 5, steps_of<vesica::Rect<double>, vesica::Ellipse<double>>); }

}  // namespace
}  // namespace steps_test
