// SPDX-License-Identifier: Apache-2.0
// Contact of rectangles by separating axes in integers: what it decides is what the oracle decides, at contacts, at
// their neighbours and anywhere else; it decides numbers of any length where exponents are alike; and no invalid shape
// passes.
#include <gtest/gtest.h>

#include <cmath>

#include "residues.hpp"

namespace vesica::filter_test {
namespace {

/// A rectangle, a point on or about one of its faces, and another axis with sizes.
struct Place {
  Rect<double> r;
  double x, y, wx, wy, hx, hy;
};

/// The point in all pairs: by itself, as a corner of another rectangle or of a box, on either side, and as the end and
/// the inside of segments.
void ask_all(const Place& at, Random& random, Counts& counts) {
  const auto& [r, x, y, wx, wy, hx, hy] = at;
  ask(Point<double>{x, y}, r, counts);
  const double s = random.sign() * hx, t = random.sign() * hy;
  const Rect<double> other{x + s * wx - t * wy, y + s * wy + t * wx, wx, wy, hx, hy};
  ask(r, other, counts);
  ask(other, r, counts);
  ask(r, Rect<double>{x + hx * r.ux, y + hx * r.uy, r.ux, r.uy, hx, hy}, counts);
  ask(r, Rect<double>{x + hx * r.ux, y + hx * r.uy, r.uy, -r.ux, hy, hx}, counts);
  ask(Segment<double>{x, y, x + s * wx, y + t * wy}, r, counts);
  ask(Segment<double>{x - hy * r.uy, y + hy * r.ux, x + hx * r.uy, y - hx * r.ux}, r, counts);
  ask(Segment<double>{x, y, x, y}, r, counts);
  const double width = hx * std::fabs(wx), height = hy * std::fabs(wy);
  ask(Aabb<double>{x, y, x + width, y + height}, r, counts);
  ask(Aabb<double>{x - width, y, x, y + height}, r, counts);
  ask(Aabb<double>{x, y - height, x + width, y}, r, counts);
  ask(Aabb<double>{x, y, x, y}, r, counts);
}

Place moved(Place at, Random& random) {
  for (double* const number : {&at.r.hx, &at.r.uy, &at.r.cy, &at.x, &at.wx, &at.hy})
    *number = neighbour(*number, random);
  return at;
}
/// Places by e, sizes by f.
Place scaled(const Place& at, int e, int f) {
  const auto place = [&](double x) { return std::ldexp(x, e); };
  const auto axis = [&](double x) { return std::ldexp(x, e - f); };
  const auto size = [&](double x) { return std::ldexp(x, f); };
  const Rect<double>& r = at.r;
  return {{place(r.cx), place(r.cy), axis(r.ux), axis(r.uy), size(r.hx), size(r.hy)},
          place(at.x),
          place(at.y),
          axis(at.wx),
          axis(at.wy),
          size(at.hx),
          size(at.hy)};
}

/// Integers: axes and sizes of about so many digits, centres of twice as many.
Place on_lattice(int digits, Random& random) {
  const auto whole = [&] { return std::floor(std::ldexp(random.between(-1, 1), digits)); };
  const auto size = [&] { return std::fabs(whole()) + 1; };
  const double cx = whole() * size(), cy = whole() * size(), ux = whole(), uy = whole() + (ux == 0), hx = size(),
               hy = size();
  const double t = random.integer(-2, 2) * hy / 2, wx = whole(), wy = whole() + (wx == 0);
  return {{cx, cy, ux, uy, hx, hy}, cx + hx * ux - t * uy, cy + hx * uy + t * ux, wx, wy, size(), size()};
}

/// Numbers of all digits, unit axes; the point as near to a face as rounding lets it be.
Place anywhere(double thickness, double shift, Random& random) {
  const double angle = random.between(-4, 4), turn = random.between(-4, 4);
  const double ux = std::cos(angle), uy = std::sin(angle), hx = random.unit(), hy = thickness * random.unit();
  const double cx = random.between(-1, 1) + shift, cy = random.between(-1, 1) + shift, t = hy * random.between(-1, 1);
  return {{cx, cy, ux, uy, hx, hy},
          cx + hx * ux - t * uy,
          cy + hx * uy + t * ux,
          std::cos(turn),
          std::sin(turn),
          thickness * random.unit() + 0x1p-60,
          random.unit()};
}

TEST(Axes, DecideIntegersOfAnyLength) {
  Random random(properties::seed());
  for (int digits = 3; digits <= 24; ++digits) {
    Counts exact, point;
    for (int i = 0; i < 60 * properties::repeat(); ++i) {
      const Place at = scaled(on_lattice(digits, random), random.integer(-140, 140), random.integer(-100, 100));
      ask(Point<double>{at.x, at.y}, at.r, point);
      ask_all(at, random, exact);
      ask_all(moved(at, random), random, exact);
    }
    EXPECT_EQ(point.wrong + exact.wrong, 0) << digits;
    EXPECT_EQ(point.overlap, point.asked) << digits;
    EXPECT_GE(point.near, point.asked * 99 / 100) << digits;
    EXPECT_GT(exact.overlap, exact.asked / 4) << digits;
    EXPECT_LT(exact.overlap, exact.asked) << digits;
  }
}

TEST(Axes, DecideNumbersOfAllDigits) {
  Random random(properties::seed());
  Counts counts;
  for (int i = 0; i < 3000 * properties::repeat(); ++i) ask_all(moved(anywhere(1, 0, random), random), random, counts);
  EXPECT_EQ(counts.wrong, 0);
  EXPECT_GT(counts.near, counts.asked * 85 / 100);
}

TEST(Axes, DecideThinRectanglesAndWhatIsFarFromTheOrigin) {
  Random random(properties::seed());
  for (const double thickness : {1.0, 1e-6, 1e-12}) {
    for (const double shift : {0.0, 0.1, 1e6, 1e15, -3e18}) {
      Counts counts;
      for (int i = 0; i < 200 * properties::repeat(); ++i) {
        ask_all(moved(anywhere(thickness, shift, random), random), random, counts);
      }
      EXPECT_EQ(counts.wrong, 0) << thickness << ' ' << shift;
    }
  }
}

/// Each number of another exponent, about what the units hold, and places, axes and sizes of unlike magnitudes, about
/// what their difference may be: what is beyond must be left open.
TEST(Axes, DecideOnlyWhatTheUnitsHold) {
  Random random(properties::seed());
  for (int spread = 0; spread <= 140; spread += 4) {
    Counts counts, apart;
    for (int i = 0; i < 60 * properties::repeat(); ++i) {
      const auto number = [&] { return std::ldexp(random.between(-1, 1), -random.integer(0, spread)); };
      const double cx = number(), cy = number(), ux = number(), uy = number(), hx = std::fabs(number()),
                   hy = std::fabs(number());
      ask_all({{cx, cy, ux, uy, hx, hy}, cx + hx * ux, cy + hx * uy, number(), number(), hx, hy}, random, counts);
      Place at = anywhere(1, 0, random);
      const double scale = std::ldexp(random.sign(), random.integer(-spread, spread));
      at.r.ux *= scale;
      at.r.uy *= scale;
      ask_all(at, random, apart);
      at.r.cx *= scale;
      at.y *= scale;
      ask_all(at, random, apart);
      at.wx *= scale;
      at.wy *= scale;
      ask_all(at, random, apart);
    }
    EXPECT_EQ(counts.wrong + apart.wrong, 0) << spread;
    if (spread == 140) {
      EXPECT_LT(counts.near, counts.asked) << spread;
    }
  }
}

TEST(Axes, DecideOnlyWhatIsRightAtTheEndsOfTheRange) {
  Random random(properties::seed());
  for (int e = -1074; e <= 1022; e += e < -320 || e > 320 ? 31 : 5) {
    Counts counts;
    for (int i = 0; i < 12; ++i) {
      const int f = random.integer(-290, 290);
      Place at = scaled(on_lattice(10, random), e - 21, f);
      ask_all(at, random, counts);
      ask_all(scaled(moved(anywhere(1, 0, random), random), e, f), random, counts);
      // One number that is as small as can be, beside others.
      const double small = std::ldexp(1.0, random.integer(-1074, e));
      (random.chance(0.5) ? at.r.cx : at.y) = random.sign() * small;
      ask_all(at, random, counts);
      at.r.hy = small;
      ask_all(at, random, counts);
      at.r.uy = at.wx = small;
      ask_all(at, random, counts);
    }
    EXPECT_EQ(counts.wrong, 0) << e;
    if (e < -330 || e > 330) {
      EXPECT_LT(counts.near, counts.asked / 8) << e;
    }
  }
}

/// Where an axis is long, error-free sums decide nothing, so that they need not be asked.
TEST(Axes, AreLongWhereErrorFreeSumsCannotHold) {
  EXPECT_FALSE(filter::has_long_axis({0, 0, 0x1p28 - 1, 1, 1, 1}, 28));
  EXPECT_TRUE(filter::has_long_axis({0, 0, 0x1p29 - 1, 1, 1, 1}, 28));
  EXPECT_TRUE(filter::has_long_axis({0, 0, 1, 0.1, 1, 1}, 28));
  Random random(properties::seed());
  int long_ones = 0;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const int digits = random.integer(20, 53);
    const auto whole = [&] { return std::floor(std::ldexp(random.between(-1, 1), digits)) + 1; };
    const Rect<double> r{1, 0, whole(), random.chance(0.5) ? whole() : 0, 1, 1};
    if (!filter::has_long_axis(r, 28)) continue;
    ++long_ones;
    const auto verdict = filter::error_free(Rect<double>{0, 0, 1, 0, 1, 1}, r);
    EXPECT_FALSE(verdict.overlap || verdict.disjoint);
  }
  EXPECT_GT(long_ones, 0);
}

TEST(Axes, LeaveInvalidShapes) {
  const Point<double> p{0.5, 0.5};
  const Segment<double> s{0, 0, 1, 1};
  const Aabb<double> box{0.5, 0.5, 1, 1};
  const Rect<double> r{0.25, 0, 1, 0.5, 1, 2};
  EXPECT_TRUE(decided(p, r) && decided(s, r) && decided(box, r) && decided(r, r));
  const auto each = [&](const Rect<double>& wrong) {
    return decided(p, wrong) || decided(s, wrong) || decided(box, wrong) || decided(r, wrong) || decided(wrong, r);
  };
  EXPECT_TRUE(each(r));
  for (const double bad : {nan, inf, -inf, -nan}) {
    EXPECT_FALSE(each({bad, 0, 1, 0.5, 1, 2}) || each({0, bad, 1, 0.5, 1, 2}) || each({0, 0, bad, 0.5, 1, 2}));
    EXPECT_FALSE(each({0, 0, 1, bad, 1, 2}) || each({0, 0, 1, 0.5, bad, 2}) || each({0, 0, 1, 0.5, 1, bad}));
    EXPECT_FALSE(decided(Point<double>{bad, 0.5}, r) || decided(Point<double>{0.5, bad}, r));
    EXPECT_FALSE(decided(Segment<double>{bad, 0, 1, 1}, r) || decided(Segment<double>{0, 0, 1, bad}, r));
    EXPECT_FALSE(decided(Aabb<double>{bad, 0, 1, 1}, r) || decided(Aabb<double>{0, 0, 1, bad}, r));
  }
  EXPECT_FALSE(each({0, 0, 0, 0, 1, 2}) || each({0, 0, 0, -0.0, 1, 2}));
  EXPECT_FALSE(each({0, 0, 1, 0.5, -1, 2}) || each({0, 0, 1, 0.5, 1, -2}));
  EXPECT_FALSE(decided(Aabb<double>{1, 0, 0, 1}, r) || decided(Aabb<double>{0, 1, 1, 0}, r));
}

}  // namespace
}  // namespace vesica::filter_test
