// SPDX-License-Identifier: Apache-2.0
// Contact by sides of lines, in near and in far units: what it decides is what the oracle decides, at contacts, at
// their neighbours and anywhere else; it decides numbers of any length where exponents are alike; and no invalid shape
// passes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vesica/overlap.hpp>

#include "residues.hpp"

namespace vesica::filter_test {
namespace {

/// A segment, and a point on or about it.
struct Place {
  Segment<double> s;
  Point<double> p;
};

/// The place in all pairs: by itself, as the end of another segment or its inside, and as the corner or edge of a box.
void ask_all(const Place& at, double size, Random& random, Counts& counts) {
  const auto [s, p] = at;
  const auto other = [&](double x) { return x + size * random.between(-1, 1); };
  const Segment<double> reversed{s.x1, s.y1, s.x0, s.y0};
  ask(p, s, counts);
  ask(p, reversed, counts);
  ask(Segment<double>{p.x, p.y, other(p.x), other(p.y)}, s, counts);
  ask(s, Segment<double>{other(p.x), other(p.y), p.x, p.y}, counts);
  ask(Segment<double>{p.x, p.y, p.x, p.y}, reversed, counts);
  ask(Segment<double>{p.x, p.y, s.x1, s.y1}, s, counts);
  ask(Segment<double>{2 * p.x - s.x1, 2 * p.y - s.y1, p.x, p.y}, s, counts);
  const double x = p.x + size * random.unit(), y = p.y + size * random.unit();
  ask(s, Aabb<double>{p.x, p.y, x, y}, counts);
  ask(reversed, Aabb<double>{2 * p.x - x, p.y, p.x, y}, counts);
  ask(s, Aabb<double>{p.x, 2 * p.y - y, x, p.y}, counts);
  ask(s, Aabb<double>{p.x, p.y, p.x, p.y}, counts);
  ask(s, Aabb<double>{p.x, 2 * p.y - y, p.x, y}, counts);
}

Place moved(Place at, Random& random) {
  at.p.x = neighbour(at.p.x, random);
  at.p.y = neighbour(at.p.y, random);
  return at;
}
Place scaled(const Place& at, int e) {
  const auto f = [&](double x) { return std::ldexp(x, e); };
  return {{f(at.s.x0), f(at.s.y0), f(at.s.x1), f(at.s.y1)}, {f(at.p.x), f(at.p.y)}};
}

/// A point exactly on a segment whose numbers are integers of so many digits, and often a little off it.
Place on_lattice(int digits, Random& random) {
  const auto whole = [&] { return std::round(std::ldexp(random.between(-1, 1), digits - 4)) * 8; };
  const double x = whole(), y = whole(), dx = whole() - x, dy = whole() - y, part = random.integer(0, 8) / 8.0;
  return {{x, y, x + dx, y + dy}, {x + part * dx, y + part * dy}};
}

/// Numbers of all digits; the point as near to the segment as rounding lets it be.
Place anywhere(double height, double shift, Random& random) {
  const double x = random.between(-1, 1), y = height * random.between(-1, 1), part = random.between(-0.1, 1.1);
  const double dx = random.between(-2, 2), dy = height * random.between(-2, 2);
  return {{x + shift, y + shift, x + dx + shift, y + dy + shift}, {x + part * dx + shift, y + part * dy + shift}};
}

TEST(Sides, DecideIntegersOfAnyLength) {
  Random random(properties::seed());
  for (int digits = 8; digits <= 52; ++digits) {
    Counts exact, near;
    for (int i = 0; i < 60 * properties::repeat(); ++i) {
      const Place at = on_lattice(digits, random);
      const int e = random.integer(-240, 240);
      ask(scaled(at, e).p, scaled(at, e).s, exact);
      ask_all(scaled(at, e), std::ldexp(1.0, digits - 3 + e), random, near);
      ask_all(moved(at, random), std::ldexp(1.0, digits - 3), random, near);
    }
    EXPECT_EQ(exact.wrong + near.wrong, 0) << digits;
    // All but a segment at the origin of no length.
    EXPECT_GE(exact.near, exact.asked - 1) << digits;
    EXPECT_EQ(exact.overlap, exact.asked) << digits;
    EXPECT_GT(near.overlap, near.asked / 4) << digits;
    EXPECT_LT(near.overlap, near.asked) << digits;
  }
}

TEST(Sides, DecideNumbersOfAllDigits) {
  Random random(properties::seed());
  Counts counts;
  for (int i = 0; i < 4000 * properties::repeat(); ++i)
    ask_all(moved(anywhere(1, 0, random), random), 1, random, counts);
  EXPECT_EQ(counts.wrong, 0);
  EXPECT_GT(counts.near, counts.asked * 9 / 10);
  EXPECT_GT(counts.far, counts.asked * 999 / 1000);
}

TEST(Sides, DecideNeedlesAndWhatIsFarFromTheOrigin) {
  Random random(properties::seed());
  for (const double height : {1e-6, 1e-12, 1e-15}) {
    for (const double shift : {0.0, 0.1, 1e6, 1e15, -3e18}) {
      Counts counts;
      for (int i = 0; i < 300 * properties::repeat(); ++i) {
        ask_all(moved(anywhere(height, shift, random), random), 1, random, counts);
      }
      EXPECT_EQ(counts.wrong, 0) << height << ' ' << shift;
    }
  }
}

/// Each number of another exponent, about what either unit holds: what is beyond must be left open.
TEST(Sides, DecideOnlyWhatTheUnitsHold) {
  Random random(properties::seed());
  for (int spread = 0; spread <= 140; spread += 4) {
    Counts counts;
    for (int i = 0; i < 60 * properties::repeat(); ++i) {
      const auto number = [&] { return std::ldexp(random.between(-1, 1), -random.integer(0, spread)); };
      const double x = number(), y = number(), x1 = number(), y1 = number(), part = random.unit();
      ask_all(moved({{x, y, x1, y1}, {x + part * (x1 - x), y + part * (y1 - y)}}, random), 1, random, counts);
      ask_all({{0, 0, x1, y1}, {x1 / 2, y1 / 2}}, 1, random, counts);
      ask_all({{x, y, x1, y1}, {x1, y1}}, std::ldexp(1.0, -spread), random, counts);
    }
    EXPECT_EQ(counts.wrong, 0) << spread;
    if (spread <= 20) {
      EXPECT_GT(counts.far, counts.asked * 99 / 100) << spread;
    }
    if (spread == 140) {
      EXPECT_LT(counts.far, counts.asked) << spread;
    }
  }
}

TEST(Sides, DecideOnlyWhatIsRightAtTheEndsOfTheRange) {
  Random random(properties::seed());
  for (int e = -1074; e <= 1022; e += e < -320 || e > 320 ? 31 : 5) {
    Counts counts;
    for (int i = 0; i < 20; ++i) {
      ask_all(scaled(on_lattice(20, random), e - 21), std::ldexp(1.0, e), random, counts);
      ask_all(scaled(moved(anywhere(1, 0, random), random), e), std::ldexp(1.0, e), random, counts);
      // One number that is as small as can be, beside others.
      Place at = scaled(on_lattice(20, random), e - 21);
      (random.chance(0.5) ? at.s.x0 : at.p.y) = random.sign() * std::ldexp(1.0, random.integer(-1074, e));
      ask_all(at, std::ldexp(1.0, e), random, counts);
    }
    EXPECT_EQ(counts.wrong, 0) << e;
    EXPECT_EQ(counts.far > 0, e >= -300 && e <= 302) << e;
  }
}

TEST(Sides, LeaveInvalidShapes) {
  const Point<double> p{0.5, 0.5};
  const Segment<double> s{0, 0, 1, 1};
  const Aabb<double> box{0.5, 0.5, 1, 1};
  EXPECT_TRUE(decided(p, s) && decided(s, s) && decided(s, box));
  for (const double bad : {nan, inf, -inf, -nan}) {
    for (const auto& wrong :
         {Segment<double>{bad, 0, 1, 1}, Segment<double>{0, bad, 1, 1}, Segment<double>{0, 0, bad, 1},
          Segment<double>{0, 0, 1, bad}, Segment<double>{bad, bad, bad, bad}}) {
      EXPECT_FALSE(decided(p, wrong) || decided(s, wrong) || decided(wrong, s) || decided(wrong, box));
    }
    EXPECT_FALSE(decided(Point<double>{bad, 0.5}, s) || decided(Point<double>{0.5, bad}, s));
    for (const auto& wrong : {Aabb<double>{bad, 0, 1, 1}, Aabb<double>{0, bad, 1, 1}, Aabb<double>{0, 0, bad, 1},
                              Aabb<double>{0, 0, 1, bad}}) {
      EXPECT_FALSE(decided(s, wrong));
    }
  }
  EXPECT_FALSE(decided(s, Aabb<double>{1, 0, 0, 1}) || decided(s, Aabb<double>{0, 1, 1, 0}));
}

}  // namespace
}  // namespace vesica::filter_test
