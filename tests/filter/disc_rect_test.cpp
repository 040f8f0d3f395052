// SPDX-License-Identifier: Apache-2.0
// Contact of a circle with a rectangle by squares in integers: what it decides is what the oracle decides, at contacts
// with a face and with a corner, at their neighbours and anywhere else; it decides numbers of any length where
// exponents are alike; and no invalid shape passes.
#include <gtest/gtest.h>

#include <cmath>

#include "residues.hpp"

namespace vesica::filter_test {
namespace {

struct Contact {
  Circle<double> c;
  Rect<double> r;
};

void ask(const Contact& at, Counts& counts) { ask(at.c, at.r, counts); }

Contact moved(Contact at, Random& random) {
  for (double* const number :
       {&at.c.cx, &at.c.cy, &at.c.r, &at.r.cx, &at.r.cy, &at.r.ux, &at.r.uy, &at.r.hx, &at.r.hy}) {
    if (random.chance(0.3)) *number = neighbour(*number, random);
  }
  return at;
}
/// Places by e, sizes by f.
Contact scaled(const Contact& at, int e, int f) {
  const auto place = [&](double x) { return std::ldexp(x, e); };
  const auto& [c, r] = at;
  return {{place(c.cx), place(c.cy), place(c.r)},
          {place(r.cx), place(r.cy), std::ldexp(r.ux, e - f), std::ldexp(r.uy, e - f), std::ldexp(r.hx, f),
           std::ldexp(r.hy, f)}};
}

/// From the rectangle's centre s along its axis and t across it.
Circle<double> circle_at(const Rect<double>& r, double s, double t, double radius) {
  return {r.cx + s * r.ux - t * r.uy, r.cy + s * r.uy + t * r.ux, radius};
}

/// Integers of about so many digits that touch exactly: the legs and the hypotenuse of a right triangle are the axis
/// and its length, and those of another lead from a corner to the centre.
Contact on_lattice(int digits, bool at_corner, Random& random) {
  const auto whole = [&](double digits_of_it) { return std::floor(std::exp2(digits_of_it) * random.unit()) + 1; };
  const double part = digits / 3.0, n = whole(part / 2), m = n + whole(part / 2), q = whole(part / 2),
               p = q + whole(part / 2);
  const double size = whole(digits - part), hx = whole(digits), hy = whole(digits);
  const Rect<double> r{random.sign() * whole(digits + part),
                       whole(digits + part),
                       random.sign() * (m * m - n * n),
                       random.sign() * 2 * m * n,
                       hx,
                       hy};
  const double length = m * m + n * n, sx = random.sign(), sy = random.sign();
  if (!at_corner) return {circle_at(r, sx * (hx + size), std::floor(hy * random.between(-1, 1)), size * length), r};
  return {
      circle_at(r, sx * (hx + size * (p * p - q * q)), sy * (hy + size * 2 * p * q), size * (p * p + q * q) * length),
      r};
}

/// Numbers of all digits; the radius as near to the distance as rounding lets it be.
Contact anywhere(double thickness, double radius, double shift, Random& random) {
  const double angle = random.between(-4, 4), length = random.between(0.5, 2);
  const Rect<double> r{random.between(-1, 1) + shift,
                       random.between(-1, 1) + shift,
                       length * std::cos(angle),
                       length * std::sin(angle),
                       random.unit(),
                       thickness * random.unit()};
  const double x = radius * random.between(0.01, 1), y = random.chance(0.5) ? radius * random.unit() : 0;
  const double across = y == 0 ? r.hy * random.between(-1, 1) : r.hy + y;
  return {circle_at(r, random.sign() * (r.hx + x), random.sign() * across, length * std::hypot(x, y)), r};
}

TEST(DiscRect, DecideIntegersOfAnyLength) {
  Random random(properties::seed());
  for (int digits = 3; digits <= 22; ++digits) {
    Counts exact, near;
    for (int i = 0; i < 200 * properties::repeat(); ++i) {
      const Contact at =
          scaled(on_lattice(digits, i % 2 == 0, random), random.integer(-140, 140), random.integer(-100, 100));
      ask(at, exact);
      ask(moved(at, random), near);
    }
    EXPECT_EQ(exact.wrong + near.wrong, 0) << digits;
    EXPECT_EQ(exact.overlap, exact.asked) << digits;
    EXPECT_GE(exact.near, exact.asked * 99 / 100) << digits;
    EXPECT_GT(near.overlap, near.asked / 4) << digits;
    EXPECT_LT(near.overlap, near.asked) << digits;
  }
}

/// Lengths of 128 bits, less what was cut off: rounded up they would tell that shapes are disjoint, and one that was
/// cut off tells nothing where the squares are as near to each other as that.
TEST(DiscRect, WhatWasCutOffCounts) {
  using filter::Beyond, filter::Integer64, filter::Residue128, filter::Residue256, filter::compare_squares;
  const Beyond none({0, 0}, Integer64{0}, {1, 0}), half({0, 4}, Integer64{1}, {1ULL << 63, 0});  // 2^66 - 1/2
  const auto told = [&](const Beyond& x, const Residue256& reached) {
    const auto verdict = compare_squares(x, none, reached, true);
    return verdict.overlap ? 1 : verdict.disjoint ? 0 : -1;
  };
  // Its square is 2^132 - 2^66 + 1/4.
  EXPECT_EQ(told(half, {{0, 0 - 2ULL}, {15, 0}}), -1) << "2^132 - 2^65 is greater";
  EXPECT_EQ(told(half, {{0, 0 - 8ULL}, {15, 0}}), 0) << "2^132 - 2^67 is less";
  EXPECT_EQ(told(half, {{0, 0}, {17, 0}}), 1) << "2^132 + 2^128";
  const Beyond ten({10, 0}, Integer64{1}, {1, 0});  // 10 - 2^-64
  EXPECT_EQ(told(ten, {{90, 0}, {0, 0}}), -1) << "less, but it is rounded down to 9";
  EXPECT_EQ(told(ten, {{80, 0}, {0, 0}}), 0);
  const Beyond whole({10, 0}, Integer64{1}, {0, 1});  // 10 - 1
  EXPECT_EQ(told(whole, {{81, 0}, {0, 0}}), 1) << "contact";
  EXPECT_EQ(told(whole, {{80, 0}, {0, 0}}), 0);
}

/// All four products of halves, with what they carry: by numbers whose products are known, and as squares are.
TEST(DiscRect, ProductsOf128Bits) {
  using filter::Residue128, filter::Residue256, filter::product, filter::square;
  const auto expect = [](const Residue256& found, const Residue256& wanted) {
    EXPECT_TRUE(found <= wanted && wanted <= found)
        << std::hex << found.high.high << ' ' << found.high.low << ' ' << found.low.high << ' ' << found.low.low;
  };
  constexpr std::uint64_t all = ~std::uint64_t{0};
  const Residue128 zero{0, 0}, one{1, 0}, limb{0, 1}, greatest{all, all}, half{all, all >> 1};
  expect(product(zero, greatest), {zero, zero});
  expect(product(limb, limb), {zero, one});
  expect(product(greatest, greatest), {one, {all - 1, all}});  // (2^128 - 1)^2 = 2^256 - 2^129 + 1
  expect(square(half), {one, {all, all >> 2}});                // (2^127 - 1)^2 = 2^254 - 2^128 + 1
  Random random(properties::seed());
  for (int i = 0; i < 1000 * properties::repeat(); ++i) {
    const std::uint64_t low = random.bits();
    const std::uint64_t high = random.bits();
    const Residue128 x{low, high}, y{low, high >> 1};
    expect(product(x, one), {x, zero});
    expect(product(limb, x), {{0, low}, {high, 0}});
    expect(product(greatest, x) + Residue256{x, zero}, {zero, x});
    expect(product(y, y), square(y));
  }
}

TEST(DiscRect, DecideNumbersOfAllDigits) {
  Random random(properties::seed());
  Counts counts;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) ask(moved(anywhere(1, 1, 0, random), random), counts);
  EXPECT_EQ(counts.wrong, 0);
  EXPECT_GT(counts.near, counts.asked * 97 / 100);
  EXPECT_GT(counts.overlap, counts.asked / 4);
  EXPECT_LT(counts.overlap, counts.asked * 3 / 4);
}

/// A circle may be far larger or smaller than the rectangle, and both far from the origin, as long as the units hold.
TEST(DiscRect, DecideOtherSizesThinRectanglesAndWhatIsFarFromTheOrigin) {
  Random random(properties::seed());
  for (const double radius : {1e-12, 1e-6, 0.01, 1.0, 100.0, 1e6, 1e12}) {
    for (const double thickness : {1.0, 1e-6, 1e-12}) {
      for (const double shift : {0.0, 0.1, 1e6, 1e15, -3e18}) {
        Counts counts;
        for (int i = 0; i < 200 * properties::repeat(); ++i) {
          ask(moved(anywhere(thickness, radius, shift, random), random), counts);
        }
        EXPECT_EQ(counts.wrong, 0) << radius << ' ' << thickness << ' ' << shift;
        if (thickness == 1 && std::fabs(shift) < 1) {
          EXPECT_EQ(counts.near > counts.asked / 2, radius > 1e-3 && radius < 1e3) << radius << ' ' << shift;
        }
      }
    }
  }
}

/// Each number of another exponent, about what the units hold: what is beyond must be left open.
TEST(DiscRect, DecideOnlyWhatTheUnitsHold) {
  Random random(properties::seed());
  for (int spread = 0; spread <= 140; spread += 4) {
    Counts counts;
    for (int i = 0; i < 300 * properties::repeat(); ++i) {
      const auto number = [&] { return std::ldexp(random.between(-1, 1), -random.integer(0, spread)); };
      const auto size = [&] { return random.chance(0.1) ? 0 : std::fabs(number()); };
      const Rect<double> r{number(), number(), number(), number(), size(), size()};
      const double x = size(), y = size();
      ask({circle_at(r, r.hx + x, r.hy + y, std::hypot(r.ux, r.uy) * std::hypot(x, y)), r}, counts);
      ask({circle_at(r, r.hx + x, 0, std::hypot(r.ux, r.uy) * x), r}, counts);
      ask({{number(), number(), size()}, r}, counts);
    }
    EXPECT_EQ(counts.wrong, 0) << spread;
    if (spread == 0) {
      EXPECT_GT(counts.near, counts.asked * 8 / 10);
    }
    if (spread == 140) {
      EXPECT_LT(counts.near, counts.asked / 2);
    }
  }
}

TEST(DiscRect, DecideOnlyWhatIsRightAtTheEndsOfTheRange) {
  Random random(properties::seed());
  for (int e = -1074; e <= 1022; e += e < -320 || e > 320 ? 31 : 5) {
    Counts counts;
    for (int i = 0; i < 30; ++i) {
      const int f = random.integer(-290, 290);
      Contact at = scaled(on_lattice(12, i % 2 == 0, random), e - 21, f);
      ask(at, counts);
      ask(scaled(moved(anywhere(1, 1, 0, random), random), e, f), counts);
      // One number that is as small as can be, beside others.
      const double small = std::ldexp(1.0, random.integer(-1074, e));
      (random.chance(0.5) ? at.r.cx : at.c.cy) = random.sign() * small;
      ask(at, counts);
      at.r.hy = small;
      ask(at, counts);
      at.r.uy = at.c.r = small;
      ask(at, counts);
    }
    EXPECT_EQ(counts.wrong, 0) << e;
    if (e < -330 || e > 330) {
      EXPECT_LT(counts.near, counts.asked / 8) << e;
    }
  }
}

/// Rounded down to 9 from a little less than 10 the squares tell of r^2 U below 81, and from 81 + 2^128 on.
TEST(DiscRect, LeaveWhatRoundedSquaresCannotTell) {
  const auto compared_with = [](const filter::Residue256& reached, const filter::Beyond& x) {
    const filter::Beyond none({0, 0}, {1}, {0, 1});
    return filter::compare_squares(x, none, reached, true);
  };
  const auto is_overlap = [](const filter::Verdict<bool>& v) { return v.overlap && !v.disjoint; };
  const auto is_disjoint = [](const filter::Verdict<bool>& v) { return v.disjoint && !v.overlap; };
  const filter::Beyond rounded({10, 0}, {1}, {1, 0}), whole({9, 0}, {1}, {0, 0});
  const filter::Residue256 less{{80, 0}, {0, 0}}, equal{{81, 0}, {0, 0}}, most{{80, 0}, {1, 0}}, more{{81, 0}, {1, 0}};
  EXPECT_TRUE(is_disjoint(compared_with(less, rounded)));
  EXPECT_TRUE(is_overlap(compared_with(more, rounded)));
  for (const auto& reached : {equal, most}) {
    EXPECT_FALSE(compared_with(reached, rounded).disjoint || compared_with(reached, rounded).overlap);
    EXPECT_TRUE(is_overlap(compared_with(reached, whole)));
  }
  EXPECT_TRUE(is_disjoint(compared_with(less, whole)));
}

TEST(DiscRect, LeaveInvalidShapes) {
  const Circle<double> c{0.5, 0.5, 1};
  const Rect<double> r{0.25, 0, 1, 0.5, 1, 2};
  EXPECT_TRUE(decided(c, r));
  EXPECT_TRUE(decided(Circle<double>{0.5, 0.5, 0}, r));
  EXPECT_TRUE(decided(c, Rect<double>{0, 0, 1, 0, 0, 0}));
  for (const double bad : {nan, inf, -inf, -nan}) {
    for (const auto& wrong :
         {Circle<double>{bad, 0.5, 1}, Circle<double>{0.5, bad, 1}, Circle<double>{0.5, 0.5, bad}}) {
      EXPECT_FALSE(decided(wrong, r));
    }
    for (const auto& wrong :
         {Rect<double>{bad, 0, 1, 0.5, 1, 2}, Rect<double>{0, bad, 1, 0.5, 1, 2}, Rect<double>{0, 0, bad, 0.5, 1, 2},
          Rect<double>{0, 0, 1, bad, 1, 2}, Rect<double>{0, 0, 1, 0.5, bad, 2}, Rect<double>{0, 0, 1, 0.5, 1, bad}}) {
      EXPECT_FALSE(decided(c, wrong));
    }
  }
  EXPECT_FALSE(decided(Circle<double>{0.5, 0.5, -1}, r));
  EXPECT_FALSE(decided(c, Rect<double>{0, 0, 0, 0, 1, 2}) || decided(c, Rect<double>{0, 0, 0, -0.0, 1, 2}));
  EXPECT_FALSE(decided(c, Rect<double>{0, 0, 1, 0.5, -1, 2}) || decided(c, Rect<double>{0, 0, 1, 0.5, 1, -2}));
}

}  // namespace
}  // namespace vesica::filter_test
