// SPDX-License-Identifier: Apache-2.0
// Functions of the header at the ends of their ranges: roots, ranks, roundings, angles, slices of areas.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vesica/area.hpp>
#include <vesica/area/circular_segment.hpp>
#include <vesica/area/ellipse_ellipse.hpp>
#include <vesica/area/extreme_ratio.hpp>
#include <vesica/arithmetic/rounding.hpp>
#include <vesica/arithmetic/scaled.hpp>
#include <vesica/boundary_distance.hpp>
#include <vesica/bounds.hpp>
#include <vesica/square_root.hpp>
#include <vesica/within.hpp>

#include "properties/random.hpp"

namespace {

using namespace vesica::detail;

/// Compile time and run time give the same bits.
TEST(CoreFunctions, SquareRoot) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  properties::Random random(properties::seed());
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const double x = std::bit_cast<double>(random.bits() >> 1);
    if (!(x <= infinity)) continue;
    ASSERT_EQ(square_root(x), std::sqrt(x)) << x;
    const auto narrow = static_cast<float>(std::ldexp(random.unit(), random.integer(-150, 120)));
    ASSERT_EQ(square_root(narrow), std::sqrt(narrow)) << narrow;
  }
  for (const double x : {0.0, 0x1p-1074, 0x1p-1022, 1.0, 2.0, 0x1.fffffffffffffp+1023, infinity}) {
    EXPECT_EQ(square_root(x), std::sqrt(x)) << x;
  }
  EXPECT_TRUE(std::isnan(square_root(-1.0)) && std::isnan(square_root(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::signbit(square_root(-0.0)));
}

/// Places in ascending order, one apart from a number to the next, both zeros at the same one.
template <class T>
void expect_ranks() {
  constexpr T infinity = std::numeric_limits<T>::infinity(), least = std::numeric_limits<T>::denorm_min();
  const auto at = [](T x) { return arithmetic::rank(x); };
  EXPECT_EQ(at(T(-0.0)), at(T(0)));
  EXPECT_FALSE(std::signbit(arithmetic::at_rank<T>(at(T(-0.0)))));
  for (const T x : {-infinity, T(-1), -least, T(-0.0), T(0), least, T(1), std::numeric_limits<T>::max()}) {
    EXPECT_EQ(at(std::nextafter(x, infinity)), at(x) + 1) << x;
    EXPECT_EQ(arithmetic::at_rank<T>(at(x)), x);
  }
}
TEST(CoreFunctions, RanksOfNumbers) {
  expect_ranks<double>();
  expect_ranks<float>();
}

/// The least float at or above a double, also beyond the floats, where a constant must not overflow.
TEST(CoreFunctions, RoundedUpToFloats) {
  constexpr float largest = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  const auto up = [](double x) {
    float out = 7;
    return arithmetic::round_up_to(x, out) ? out : 7;
  };
  for (const double x : {-0x1p1000, -0x1p128, -0x1.fffffffp127}) {
    EXPECT_EQ(up(x), -largest) << x;
  }
  EXPECT_EQ(up(static_cast<double>(-largest)), -largest);
  EXPECT_EQ(up(-1 - 0x1p-50), -1);
  EXPECT_EQ(up(-0x1p-200), 0);
  EXPECT_EQ(up(0x1p-200), least);
  EXPECT_EQ(up(1 + 0x1p-50), 1 + 0x1p-23F);
  EXPECT_EQ(up(static_cast<double>(largest)), largest);
  EXPECT_EQ(up(0x1p128), 7);
}

TEST(CoreFunctions, AngleOfArea) {
  EXPECT_EQ(area::angle(0, -1), area::pi_high);
  EXPECT_EQ(area::angle(0, 1), 0);
  EXPECT_EQ(area::angle(0, 0), 0);
  properties::Random random(properties::seed());
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const double turn = random.between(0, area::pi_high), length = std::exp2(random.between(-30, 30));
    const double x = length * std::cos(turn), y = length * std::sin(turn);
    EXPECT_NEAR(area::angle(y, x), std::atan2(y, x), 0x1p-51);
  }
}

/// How far the value is concave along the upper half of the disc, and where it is least: nowhere as soon as the other's
/// height reaches its flatness.
TEST(CoreFunctions, UpperHalf) {
  for (const double ratio : {0.0, 0.25, 0.5, 0.75, 0x1.fffp-1}) {
    area::Against<double> f{};
    f.p = 1, f.over_p = 1, f.q = ratio;
    const double flatness = (1 - ratio) * (1 + ratio);
    double last = 2;
    for (const double share : {0x1p-60, 0.001, 0.5, 0.999, 1 - 0x1p-30, 1 - 0x1p-53}) {
      f.y = share * flatness;
      const auto [reach, least] = area::upper_half(f);
      EXPECT_TRUE(reach >= 0 && reach < last) << ratio << ' ' << share;
      EXPECT_NEAR(reach * reach, 1 - std::cbrt(share * share), 1e-3) << ratio << ' ' << share;
      EXPECT_NEAR(least * least, (1 - share) * (1 + share), 0x1p-50) << ratio << ' ' << share;
      last = reach;
    }
    f.y = flatness;
    EXPECT_EQ(area::upper_half(f).reach, 0);
  }
}

/// Places at which an ellipse just reaches beyond the disc are found in few steps, however thin and near to each other.
TEST(CoreFunctions, CrossingsThatNearlyCoincide) {
  for (const double q : {0x1p-3, 0x1p-20, 0x1p-56, 0x1p-400}) {
    for (const double y : {0x1p-40, 0.5, 1 - 0x1p-30, 1 - 0x1p-53}) {
      area::Against<double> f{};
      f.y = y, f.p = 4, f.over_p = 0.25, f.q = q, f.over_q = 1 / q;
      const area::HalfCircle<double> half{f, 1};
      const double x = std::sqrt((1 - y) * (1 + y)), low = half.value(x), high = half.value(1);
      if (!(low < 0 && high > 0)) continue;
      area::Search<double> search(half, {x, low}, {1, high});
      int steps = 0;
      for (; !search.found(); ++steps) search.step();
      EXPECT_LE(steps, 20) << q << ' ' << y;
      EXPECT_NEAR(std::fabs(std::sqrt((1 - search.place()) * (1 + search.place())) - y), q, 0x1p-52 + 0.1 * q);
    }
  }
}

/// The shared area between two places, of a disc and an ellipse above it or below: mirror images share as much.
TEST(CoreFunctions, MirroredSlices) {
  const auto slice = [](double y, double q, double from, double to) {
    area::Against<double> f{};
    f.y = y;
    f.p = 1, f.over_p = 1, f.q = q, f.over_q = 1 / q;
    return area::slice(f, from, area::heights(f, from), to, area::heights(f, to));
  };
  // Half the lens of two discs: its arcs are above and below of it the same way round.
  const double height = 0.5, corner = std::sqrt(1 - height * height / 4);
  const double lens = 2 * std::acos(height / 2) - height * corner;
  EXPECT_NEAR(slice(height, 1, -corner, corner), lens, 0x1p-48);
  for (const double y : {0x1p-30, 0.25, 0.5, 1.0, 1.5}) {
    for (const double q : {0.125, 0.5, 1.0, 2.0}) {
      for (const double from : {-0.75, -0.25, 0.0}) {
        EXPECT_EQ(slice(y, q, from, from + 0.5), slice(-y, q, from, from + 0.5)) << y << ' ' << q << ' ' << from;
      }
    }
  }
  // One that is nowhere in the disc, on either side.
  EXPECT_EQ(slice(3, 0.5, -0.5, 0.5), 0);
  EXPECT_EQ(slice(-3, 0.5, -0.5, 0.5), 0);
}

/// Two discs that share a lens of 2 t - sin 2 t for cos t = 1 - 2^-31, some 2^-45 of either: double-doubles have its
/// digits.
TEST(CoreFunctions, AreaOfAThinLens) {
  const vesica::Ellipse<double> a{0, 0, 1, 0, 1, 1}, b{2 - 0x1p-30, 0, 0, 1, 1, 1};
  const double angle = 4 * std::asin(0x1p-16), squared = angle * angle;
  const double lens = angle * squared / 6 * (1 - squared / 20);
  EXPECT_NEAR(vesica::area(a, b), lens, 0x1p-40 * lens);
  EXPECT_NEAR(vesica::area(b, a), lens, 0x1p-40 * lens);
}

/// The part of the unit disc on one side of a line that crosses it, or passes it on either side.
TEST(CoreFunctions, DiscInAHalfPlane) {
  const auto part = [](double distance) {
    return area::area_in_half_plane(area::Oval<double>{1, 0, 1, 1}, area::HalfPlane{1, 0, distance});
  };
  for (const double beyond : {1.0, 1.5, 0x1p900}) {
    EXPECT_EQ(part(beyond), area::pi_high);
    EXPECT_EQ(part(-beyond), 0);
  }
  EXPECT_EQ(part(0), area::pi_high / 2);
  for (const double d : {0.25, 0.5, 0.75}) {
    const double cap = std::acos(d) - d * std::sqrt(1 - d * d);
    EXPECT_NEAR(part(-d), cap, 0x1p-51);
    EXPECT_NEAR(part(d), area::pi_high - cap, 0x1p-51);
  }
}

/// Bounds of ordinary shapes need no exact numbers: what they are estimated by leaves no doubt but of a few.
TEST(CoreFunctions, EstimatesThatSettleBounds) {
  properties::Random random(properties::seed());
  int settled = 0, asked = 0;
  const auto ask = [&](const auto& shape, const bounds::Reach& reach) {
    double high = 0;
    settled += arithmetic::round_up(arithmetic::add(reach.c, bounds::extent_estimate(shape, reach)), high) ? 1 : 0;
    ++asked;
  };
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const double c = random.between(-4, 4);
    const double p0 = random.between(-1, 1);
    const double q0 = random.between(0, 2);
    const double p1 = random.between(-1, 1);
    const double q1 = random.between(0, 2);
    ask(vesica::Rect<double>{}, {c, p0, q0, p1, q1});
    ask(vesica::Ellipse<double>{}, {c, p0, q0, p1, q1});
  }
  EXPECT_GT(settled, asked * 99 / 100);
}

/// Outlines that are one curve have no single places in common: any point of it will do.
TEST(CoreFunctions, ClosestPointsOfOneCurve) {
  const vesica::Ellipse<double> shapes[] = {
      {0, 0, 1, 0, 2, 1}, {0, 0, 0, 1, 1, 2}, {0, 0, -2, 0, 1, 0.5}, {0, 0, 0, -0.5, 2, 4}};
  for (const auto& a : shapes) {
    for (const auto& b : shapes) {
      vesica::ClosestPoints<double> out;
      ASSERT_EQ(vesica::boundary_distance_or_error(a, b, out), 0);
      EXPECT_EQ(out.distance, 0);
      EXPECT_TRUE(out.ax == out.bx && out.ay == out.by);
      EXPECT_NEAR(out.ax * out.ax / 4 + out.ay * out.ay, 1, 0x1p-50);
    }
  }
}

/// At half a quantum the even one of two subnormal numbers, unless the low part decides.
TEST(CoreFunctions, SubnormalTies) {
  constexpr double quantum = 0x1p-1074;
  for (int k = 0; k < 8; ++k) {
    for (const double sign : {1.0, -1.0}) {
      const double tie = sign * (k + 0.5), even = sign * (k % 2 == 0 ? k : k + 1);
      EXPECT_EQ(arithmetic::scale_rounded(tie, 0, -1074), even * quantum) << tie;
      EXPECT_EQ(arithmetic::scale_rounded(tie, sign * 0x1p-60, -1074), sign * (k + 1) * quantum) << tie;
      if (k == 0) continue;
      EXPECT_EQ(arithmetic::scale_rounded(tie, -sign * 0x1p-60, -1074), sign * k * quantum) << tie;
    }
  }
}

}  // namespace
