// SPDX-License-Identifier: Apache-2.0
// The header's own cast(), which the library does not call: it has the bits of the C function.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vesica/cast.hpp>

#include "cast/motions.hpp"
#include "properties/core_shape.hpp"
#include "properties/generators.hpp"
#include "properties/random.hpp"

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

constexpr double never = std::numeric_limits<double>::infinity();
double before(double x) { return std::nextafter(x, -never); }

/// Head on: a zero of a normal has no sign, by the filter for these kinds and by the general path.
TEST(CastOfTheHeader, NormalsHaveNoNegativeZero) {
  const auto expect = [](const auto& a, const auto& b, double vx, double vy) {
    Impact<double> quick, found;
    const auto check = [&](const Impact<double>& i) {
      EXPECT_FALSE(std::signbit(i.nx) && i.nx == 0) << vx << ' ' << vy;
      EXPECT_FALSE(std::signbit(i.ny) && i.ny == 0) << vx << ' ' << vy;
      EXPECT_EQ(i.nx, vx == 0 ? 0 : -vx);
      EXPECT_EQ(i.ny, vy == 0 ? 0 : -vy);
    };
    if (detail::cast::fast_hit<detail::cast::UsualProducts>(a, b, {vx, vy, never}, quick) ==
        detail::cast::EarlyOut::hit)
      check(quick);
    ASSERT_EQ(detail::cast::cast_any(a, b, {vx, vy, never}, found), cast_hit);
    check(found);
    ASSERT_EQ(cast_or_error(a, b, vx, vy, never, found), cast_hit);
    check(found);
  };
  for (const double v : {1.0, -1.0}) {
    for (const double zero : {0.0, -0.0}) {
      for (const double at : {0.0, -0.0}) {
        const Ellipse<double> e{0, 0, 1, zero, 2, 1}, f{0, 0, zero, 1, 1.5, 1};
        const Circle<double> c{0, 0, 2};
        const double far = -8 * v;
        expect(e, Ellipse<double>{far, at, 1, 0, 2, 1}, v, zero);
        expect(f, Ellipse<double>{at, far, 0, 1, 2, 1}, zero, v);
        expect(e, Point<double>{far, at}, v, zero);
        expect(f, Point<double>{at, far}, zero, v);
        expect(c, Point<double>{far, at}, v, zero);
        expect(c, Circle<double>{at, far, 1}, zero, v);
      }
    }
  }
}

/// Points at the flat side of a thin ellipse: contact at the start is the overlap, whether they come or go.
TEST(CastOfTheHeader, StartsAtTheFlatSideOfAThinEllipse) {
  properties::Random random(properties::seed());
  int starts = 0, others = 0;
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const double side = random.sign(), a = 1 + random.unit(), thin = random.between(1, 20), b = a * std::exp2(-thin);
    const double length = 1 + random.unit(), slope = random.chance(0.3) ? 0 : std::exp2(-random.between(1, 30));
    const double along = b * random.between(-1, 1), off = random.integer(-4, 4) * 0x1p-53;
    const double across = side * b * std::sqrt(1 - along / a * (along / a)) * (1 + off);
    const Ellipse<double> e{0, 0, length, length * slope, a, b};
    const Point<double> p{along * e.ux - across * e.uy, along * e.uy + across * e.ux};
    const std::int32_t overlapping = overlap_or_error(e, p);
    for (const double v : {1.0, -1.0}) {
      Impact<double> out;
      const std::int32_t code = cast_or_error(e, p, 0.125, v, never, out);
      ASSERT_EQ(code == cast_start, overlapping == 1) << e.uy << ' ' << p.x << ' ' << p.y << ' ' << a << ' ' << b;
    }
    (overlapping == 1 ? starts : others) += 1;
  }
  EXPECT_GT(starts, 500 * properties::repeat());
  EXPECT_GT(others, 500 * properties::repeat());
}

/// Contact at a double that the quotient of rounded numbers misses.
TEST(CastOfTheHeader, ContactAtADouble) {
  constexpr double v = 0x1.199999999999ap+0, t = 0x1.e666686b5e666p+0;
  const Aabb<double> box{0x1.0b851fd4a71ecp+1, 0, 8, 1};
  const Point<double> point{0x1.47ae12dd4e148p-53, 0.5};
  ASSERT_NE((box.min_x - point.x) / v, t);
  Impact<double> found;
  EXPECT_EQ(cast_or_error(box, point, v, 0.0, never, found), cast_hit);
  EXPECT_EQ(found.t, t);
  EXPECT_EQ(cast_or_error(box, point, v, 0.0, t, found), cast_hit);
  EXPECT_EQ(cast_or_error(box, point, v, 0.0, before(t), found), cast_miss);
}

/// Bad motions; and starts whose common point or depth is beyond the finite numbers.
TEST(CastOfTheHeader, Errors) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), largest = std::numeric_limits<double>::max();
  Impact<double> out{7, 7, 7, 7, 7};
  const Circle<double> disc{0, 0, 1}, other{9, 0, 1};
  EXPECT_EQ(cast_or_error(disc, other, nan, 0.0, 1.0, out), error_argument);
  EXPECT_EQ(cast_or_error(disc, other, 0.0, never, 1.0, out), error_argument);
  EXPECT_EQ(cast_or_error(disc, other, 1.0, 0.0, -1.0, out), error_argument);
  const Aabb<double> all{-largest, -largest, largest, largest};
  EXPECT_EQ(cast_or_error(all, all, 0.0, 0.0, 1.0, out), error_range);
  // Two needles that cross beyond the numbers.
  const Rect<double> down{1e308, 1e308, 1, -1, 1.2e308, 0}, up{1e308, -1e308, 1, 1, 1.2e308, 0};
  ASSERT_EQ(overlap_or_error(down, up), 1);
  EXPECT_EQ(cast_or_error(down, up, 0.0, 0.0, 1.0, out), error_range);
  EXPECT_EQ(out.t, 7);
}

/// A slide along a face: the witness comes in the middle, after the end, and contact before.
TEST(CastOfTheHeader, ASlideThatEndsBeforeItsMiddle) {
  const Aabb<double> a{0, 0, 1, 1}, b{3, 1, 4, 2};
  Impact<double> out;
  EXPECT_EQ(cast_or_error(a, b, -1.0, 0.0, 2.5, out), cast_hit);
  EXPECT_EQ(out.t, 2);
  EXPECT_EQ(cast_or_error(a, b, -1.0, 0.0, 2.0, out), cast_hit);
  EXPECT_EQ(cast_or_error(a, b, -1.0, 0.0, 1.5, out), cast_miss);
}

}  // namespace
