// SPDX-License-Identifier: Apache-2.0
// The header's own cast(), which the library does not call: it has the bits of the C function.
#include <gtest/gtest.h>

#include <cmath>
#include <vesica/cast.hpp>

#include "cast/motions.hpp"
#include "properties/core_shape.hpp"
#include "properties/generators.hpp"

namespace {

using namespace cast_test;
using namespace vesica;
using properties::shape_of;

/// Equal, or both NaN, as after a miss.
void expect_same(double found, double wanted) {
  if (std::isnan(wanted)) {
    EXPECT_TRUE(std::isnan(found));
  } else {
    EXPECT_EQ(found, wanted);
  }
}

template <template <class> class A, template <class> class B, class T>
void expect_same_answers() {
  constexpr int kind_a = static_cast<int>(ShapeTraits<A<T>>::kind), kind_b = static_cast<int>(ShapeTraits<B<T>>::kind);
  constexpr Scalar scalar = sizeof(T) == 8 ? Scalar::f64 : Scalar::f32;
  int count[3] = {};
  for (const properties::Workload workload : properties::all_workloads) {
    properties::Stream stream(workload, kind_a, kind_b, scalar, properties::seed() + 41);
    properties::Random random(properties::seed() + 42);
    for (int i = 0; i < 20 * properties::repeat(); ++i) {
      const Pair p = stream.next();
      const Motion m = draw_motion(p, scalar, random);
      SCOPED_TRACE(describe(p, m));
      const Answer wanted = cast_test::cast(scalar, p, m);
      const T vx = static_cast<T>(m.vx), vy = static_cast<T>(m.vy), end = static_cast<T>(m.end);
      Impact<T> found{7, 7, 7, 7, 7};
      const int code = cast_or_error(shape_of<A<T>, T>(p.a), shape_of<B<T>, T>(p.b), vx, vy, end, found);
      ASSERT_EQ(code, wanted.code);
      if (code < 0) {
        EXPECT_EQ(found.t, 7);
        continue;
      }
      ++count[code];
      expect_same(static_cast<double>(found.t), wanted.t);
      expect_same(static_cast<double>(found.x), wanted.x);
      expect_same(static_cast<double>(found.y), wanted.y);
      expect_same(static_cast<double>(found.nx), wanted.nx);
      expect_same(static_cast<double>(found.ny), wanted.ny);
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(count[cast_miss], 0);
  EXPECT_GT(count[cast_hit], 0);
  EXPECT_GT(count[cast_start], 0);
}

TEST(CastOfTheHeader, HasTheBitsOfTheLibrary) {
  expect_same_answers<Circle, Circle, double>();
  expect_same_answers<Circle, Rect, double>();
  expect_same_answers<Circle, Circle, float>();
}

/// Velocities and ends need not be of the shapes' type: they become it.
TEST(CastOfTheHeader, TakesNumbersOfOtherTypes) {
  const Circle<double> disc{0, 0, 1};
  const Point<double> point{5, 0};
  EXPECT_EQ(cast(disc, point, -1, 0, 100).t, 4);
  EXPECT_EQ(cast(disc, point, -0.5, 0, HUGE_VAL).t, 8);
  EXPECT_EQ(cast(Circle<float>{0, 0, 1}, Point<float>{5, 0}, -1, 0, INFINITY).t, 4);
  Aabb<double> box;
  EXPECT_EQ(sweep_bounds(disc, 0, 0, 3, box), 0);
  EXPECT_EQ(box.max_x, 1);
}

}  // namespace
