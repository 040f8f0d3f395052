// SPDX-License-Identifier: Apache-2.0
// Contact of circles by squares, in near and in far units: what it decides is what the oracle decides, at contacts, at
// their neighbours and anywhere else; it decides numbers of any length where exponents are alike; and no invalid shape
// passes.
#include <gtest/gtest.h>

#include <cmath>

#include "residues.hpp"

namespace vesica::filter_test {
namespace {

/// A circle, and the way from its centre to a point on or about its rim.
struct Place {
  Circle<double> c;
  double x, y;
};

/// The rim's point in all pairs: by itself, as a point of another circle, a box's corner, and a point of segments that
/// touch with their inside or an end, or pass by. The factors are small whole numbers: short numbers stay so.
void ask_all(const Place& at, Random& random, Counts& round, Counts& segments) {
  const auto& [c, x, y] = at;
  const double px = c.cx + x, py = c.cy + y, k = random.integer(1, 3), part = random.integer(0, 1);
  ask(Point<double>{px, py}, c, round);
  ask(c, Circle<double>{px, py, 0}, round);
  ask(c, Circle<double>{px + k * x, py + k * y, k * c.r}, round);
  ask(Circle<double>{px + k * x, py + k * y, k * c.r}, c, round);
  ask(c,
      Aabb<double>{std::fmin(px, px + k * x), std::fmin(py, py + x * x), std::fmax(px, px + k * x),
                   std::fmax(py, py + x * x)},
      round);
  ask(c, Aabb<double>{px - (x < 0 ? k : 0), py - (y < 0 ? k : 0), px + (x < 0 ? 0 : k), py + (y < 0 ? 0 : k)}, round);
  ask(c, Aabb<double>{c.cx - k, c.cy + c.r, c.cx + part, c.cy + 2 * c.r}, round);
  ask(c, Aabb<double>{px, py, px, py}, round);
  ask(Segment<double>{px - k * y, py + k * x, px + part * y, py - part * x}, c, segments);
  ask(Segment<double>{px, py, px + k * x - part * y, py + k * y + part * x}, c, segments);
  ask(Segment<double>{px + x + y, py, px, py}, c, segments);
  ask(Segment<double>{px, py, px, py}, c, segments);
  ask(Segment<double>{px - y, py + x, px + k * y, py - (k + part) * x}, c, segments);
}

Place moved(Place at, Random& random) {
  at.c.r = neighbour(at.c.r, random);
  at.x = neighbour(at.x, random);
  at.c.cy = neighbour(at.c.cy, random);
  return at;
}
Place scaled(const Place& at, int e) {
  const auto f = [&](double x) { return std::ldexp(x, e); };
  return {{f(at.c.cx), f(at.c.cy), f(at.c.r)}, f(at.x), f(at.y)};
}

/// A right triangle of whole sides, about so many digits long, and a centre as long.
Place on_lattice(int digits, Random& random) {
  const auto whole = [&](double digits_of_it) { return std::floor(std::exp2(digits_of_it) * random.unit()); };
  const double m = whole(digits / 2.0) + 2, n = whole(digits / 2.0), sx = random.sign(), sy = random.sign();
  return {{sy * whole(digits), whole(digits), m * m + n * n}, sx * (m * m - n * n), sy * 2 * m * n};
}

/// Numbers of all digits; the radius as near to the distance as rounding lets it be.
Place anywhere(double height, double shift, Random& random) {
  const double x = random.between(-1, 1), y = height * random.between(-1, 1);
  return {{random.between(-1, 1) + shift, height * random.between(-1, 1) + shift, std::sqrt(x * x + y * y)}, x, y};
}

TEST(Reach, DecidesIntegersOfAnyLength) {
  Random random(properties::seed());
  for (int digits = 4; digits <= 48; ++digits) {
    Counts point, round, segments;
    for (int i = 0; i < 60 * properties::repeat(); ++i) {
      const Place at = scaled(on_lattice(digits, random), random.integer(-240, 240));
      ask(Point<double>{at.c.cx + at.x, at.c.cy + at.y}, at.c, point);
      ask_all(at, random, round, segments);
      ask_all(moved(at, random), random, round, segments);
    }
    EXPECT_EQ(point.wrong + round.wrong + segments.wrong, 0) << digits;
    EXPECT_EQ(point.near, point.asked) << digits;
    EXPECT_EQ(point.overlap, point.asked) << digits;
    for (const Counts& counts : {round, segments}) {
      EXPECT_GT(counts.near, counts.asked * 4 / 10) << digits;
      EXPECT_GT(counts.overlap, counts.asked / 4) << digits;
      EXPECT_LT(counts.overlap, counts.asked) << digits;
    }
  }
}

TEST(Reach, DecidesNumbersOfAllDigits) {
  Random random(properties::seed());
  Counts round, segments;
  for (int i = 0; i < 4000 * properties::repeat(); ++i)
    ask_all(moved(anywhere(1, 0, random), random), random, round, segments);
  EXPECT_EQ(round.wrong + segments.wrong, 0);
  EXPECT_GT(round.near, round.asked * 9 / 10);
  EXPECT_GT(segments.near, segments.asked * 9 / 10);
  EXPECT_GT(round.far, round.asked * 999 / 1000);
}

TEST(Reach, DecidesFlatOffsetsAndWhatIsFarFromTheOrigin) {
  Random random(properties::seed());
  for (const double height : {1e-6, 1e-12, 1e-15}) {
    for (const double shift : {0.0, 0.1, 1e6, 1e15, -3e18}) {
      Counts round, segments;
      for (int i = 0; i < 200 * properties::repeat(); ++i) {
        ask_all(moved(anywhere(height, shift, random), random), random, round, segments);
      }
      EXPECT_EQ(round.wrong + segments.wrong, 0) << height << ' ' << shift;
    }
  }
}

/// Each number of another exponent, about what either unit holds: what is beyond must be left open.
TEST(Reach, DecidesOnlyWhatTheUnitsHold) {
  Random random(properties::seed());
  for (int spread = 0; spread <= 140; spread += 4) {
    Counts round, segments;
    for (int i = 0; i < 60 * properties::repeat(); ++i) {
      const auto number = [&] { return std::ldexp(random.between(-1, 1), -random.integer(0, spread)); };
      const double cx = number(), cy = number(), x = number(), y = number();
      ask_all(moved({{cx, cy, std::hypot(x, y)}, x, y}, random), random, round, segments);
      ask_all({{cx, 0, std::fabs(x)}, x, 0}, random, round, segments);
      ask_all({{0, cy, std::fabs(y)}, 0, y}, random, round, segments);
      ask_all({{cx, cy, std::fabs(number())}, x, y}, random, round, segments);
    }
    EXPECT_EQ(round.wrong + segments.wrong, 0) << spread;
    if (spread <= 20) {
      EXPECT_GT(round.far, round.asked * 98 / 100) << spread;
    }
    if (spread == 140) {
      EXPECT_LT(round.far, round.asked) << spread;
      EXPECT_LT(segments.near, segments.asked) << spread;
    }
  }
}

TEST(Reach, DecidesOnlyWhatIsRightAtTheEndsOfTheRange) {
  Random random(properties::seed());
  for (int e = -1074; e <= 1022; e += e < -320 || e > 320 ? 31 : 5) {
    Counts round, segments;
    for (int i = 0; i < 12; ++i) {
      ask_all(scaled(on_lattice(20, random), e - 21), random, round, segments);
      ask_all(scaled(moved(anywhere(1, 0, random), random), e), random, round, segments);
      // One number that is as small as can be, beside others.
      Place at = scaled(on_lattice(20, random), e - 21);
      (random.chance(0.5) ? at.c.cx : at.y) = random.sign() * std::ldexp(1.0, random.integer(-1074, e));
      ask_all(at, random, round, segments);
      at.c.r = std::ldexp(1.0, random.integer(-1074, e));
      ask_all(at, random, round, segments);
    }
    EXPECT_EQ(round.wrong + segments.wrong, 0) << e;
    if (e >= -290 && e <= 290) {
      EXPECT_GT(round.far, 0) << e;
      EXPECT_GT(segments.near, 0) << e;
    }
    if (e < -320 || e > 320) {
      EXPECT_EQ(segments.near, 0) << e;
    }
  }
}

TEST(Reach, LeavesInvalidShapes) {
  const Point<double> p{3, 4};
  const Circle<double> c{0, 0, 5}, d{6, 8, 5};
  const Segment<double> s{3, 4, 6, 8};
  const Aabb<double> box{3, 4, 6, 8};
  EXPECT_TRUE(decided(p, c) && decided(c, d) && decided(c, box) && decided(s, c));
  for (const double bad : {nan, inf, -inf, -nan}) {
    for (const auto& wrong : {Circle<double>{bad, 0, 5}, Circle<double>{0, bad, 5}, Circle<double>{0, 0, bad}}) {
      EXPECT_FALSE(decided(p, wrong) || decided(wrong, d) || decided(d, wrong) || decided(wrong, box) ||
                   decided(s, wrong));
    }
    EXPECT_FALSE(decided(Point<double>{bad, 4}, c) || decided(Point<double>{3, bad}, c));
    for (const auto& wrong :
         {Segment<double>{bad, 4, 6, 8}, Segment<double>{3, bad, 6, 8}, Segment<double>{3, 4, bad, 8}}) {
      EXPECT_FALSE(decided(wrong, c));
    }
    for (const auto& wrong : {Aabb<double>{bad, 4, 6, 8}, Aabb<double>{3, bad, 6, 8}, Aabb<double>{3, 4, bad, 8},
                              Aabb<double>{3, 4, 6, bad}}) {
      EXPECT_FALSE(decided(c, wrong));
    }
  }
  const Circle<double> negative{0, 0, -5};
  EXPECT_FALSE(decided(p, negative) || decided(negative, d) || decided(d, negative) || decided(negative, box) ||
               decided(s, negative));
  EXPECT_FALSE(decided(c, Aabb<double>{6, 4, 3, 8}) || decided(c, Aabb<double>{3, 8, 6, 4}));
}

}  // namespace
}  // namespace vesica::filter_test
