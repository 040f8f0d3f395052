// SPDX-License-Identifier: Apache-2.0
// Contact in integers of 256 bits: what they decide is what the oracle decides, at contacts, at their neighbours and
// anywhere else; they decide numbers of any digits where exponents are alike; and no invalid shape passes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vesica/overlap.hpp>

#include "oracle/oracle.hpp"
#include "properties/random.hpp"

namespace vesica::filter_test {
namespace {

using properties::Random;

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

struct Counts {
  int asked = 0, decided = 0, wrong = 0, overlap = 0;
};

template <class A, class B>
void ask(const A& a, const B& b, Counts& counts) {
  constexpr int kind_a = static_cast<int>(ShapeTraits<A>::kind), kind_b = static_cast<int>(ShapeTraits<B>::kind);
  if (check(a) != 0 || check(b) != 0) return;
  const filter::Verdict<bool> verdict = filter::by_integers(a, b);
  const bool truth =
      oracle::overlap(kind_a, reinterpret_cast<const double*>(&a), kind_b, reinterpret_cast<const double*>(&b));
  ++counts.asked;
  counts.overlap += truth;
  counts.decided += verdict.overlap || verdict.disjoint;
  counts.wrong += truth ? verdict.disjoint : verdict.overlap;
}

template <class A, class B>
bool decided(const A& a, const B& b) {
  const filter::Verdict<bool> verdict = filter::by_integers(a, b);
  return verdict.overlap || verdict.disjoint;
}

/// A number up to two places away.
double neighbour(double x, Random& random) {
  for (int places = random.integer(0, 2); places > 0; --places) x = std::nextafter(x, random.chance(0.5) ? inf : -inf);
  return x;
}

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
  const Circle<double> beside{x + hx * r.ux, y + hx * r.uy, hx * std::hypot(r.ux, r.uy)};
  const Segment<double> segment{x, y, x + s * wx, y + t * wy};
  ask(beside, r, counts);
  ask(Circle<double>{x, y, 0}, r, counts);
  ask(Point<double>{x, y}, beside, counts);
  ask(beside, Circle<double>{x - hy * r.ux, y - hy * r.uy, hy * std::hypot(r.ux, r.uy)}, counts);
  ask(beside, Aabb<double>{x - width, y, x, y + height}, counts);
  ask(segment, beside, counts);
  ask(segment, Segment<double>{x - hy * r.uy, y + hy * r.ux, x + hx * r.uy, y - hx * r.ux}, counts);
  ask(segment, Segment<double>{x, y, x, y}, counts);
  ask(Segment<double>{x, y, x, y}, Segment<double>{x, neighbour(y, random), x, neighbour(y, random)}, counts);
  ask(segment, Aabb<double>{x, y - height, x + width, y}, counts);
  ask(Point<double>{x, y}, Segment<double>{x - hy * wx, y - hy * wy, x + hx * wx, y + hx * wy}, counts);
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

/// Integers: axes and sizes of about `digits` digits, centres of twice as many.
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

TEST(ByIntegers, DecideIntegersOfAnyLength) {
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
    EXPECT_GE(point.decided, point.asked * 99 / 100) << digits;
    EXPECT_GT(exact.overlap, exact.asked / 4) << digits;
    EXPECT_LT(exact.overlap, exact.asked) << digits;
  }
}

TEST(ByIntegers, DecideNumbersOfAllDigits) {
  Random random(properties::seed());
  Counts counts;
  for (int i = 0; i < 3000 * properties::repeat(); ++i) ask_all(moved(anywhere(1, 0, random), random), random, counts);
  EXPECT_EQ(counts.wrong, 0);
  EXPECT_GT(counts.decided, counts.asked * 85 / 100);
}

TEST(ByIntegers, DecideThinRectanglesAndWhatIsFarFromTheOrigin) {
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
TEST(ByIntegers, DecideOnlyWhatTheUnitsHold) {
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
      EXPECT_LT(counts.decided, counts.asked) << spread;
    }
  }
}

TEST(ByIntegers, DecideOnlyWhatIsRightAtTheEndsOfTheRange) {
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
    if ((e < -330 && e > -1000) || e > 330) {  // below, numbers vanish, and 0 is a multiple of any unit
      EXPECT_LT(counts.decided, counts.asked / 8) << e;
    }
  }
}

TEST(ByIntegers, LeaveInvalidShapes) {
  const Point<double> p{0.5, 0.5};
  const Segment<double> s{0, 0, 1, 1};
  const Aabb<double> box{0.5, 0.5, 1, 1};
  const Circle<double> c{0.5, 0, 1};
  const Rect<double> r{0.25, 0, 1, 0.5, 1, 2};
  EXPECT_TRUE(decided(p, r) && decided(s, r) && decided(box, r) && decided(r, r) && decided(c, r) && decided(p, c));
  const auto each = [&](const Rect<double>& wrong) {
    return decided(p, wrong) || decided(s, wrong) || decided(box, wrong) || decided(r, wrong) || decided(wrong, r) ||
           decided(c, wrong);
  };
  EXPECT_TRUE(each(r));
  for (const double bad : {nan, inf, -inf, -nan}) {
    EXPECT_FALSE(each({bad, 0, 1, 0.5, 1, 2}) || each({0, bad, 1, 0.5, 1, 2}) || each({0, 0, bad, 0.5, 1, 2}));
    EXPECT_FALSE(each({0, 0, 1, bad, 1, 2}) || each({0, 0, 1, 0.5, bad, 2}) || each({0, 0, 1, 0.5, 1, bad}));
    EXPECT_FALSE(decided(Point<double>{bad, 0.5}, r) || decided(Point<double>{0.5, bad}, r));
    EXPECT_FALSE(decided(Segment<double>{bad, 0, 1, 1}, r) || decided(Segment<double>{0, 0, 1, bad}, r));
    EXPECT_FALSE(decided(Circle<double>{bad, 0, 1}, r) || decided(p, Circle<double>{0, 0, bad}) ||
                 decided(c, Circle<double>{0, bad, 1}));
    EXPECT_FALSE(decided(Aabb<double>{bad, 0, 1, 1}, r) || decided(Aabb<double>{0, 0, 1, bad}, r));
  }
  EXPECT_FALSE(each({0, 0, 0, 0, 1, 2}) || each({0, 0, 0, -0.0, 1, 2}));
  EXPECT_FALSE(each({0, 0, 1, 0.5, -1, 2}) || each({0, 0, 1, 0.5, 1, -2}));
  EXPECT_FALSE(decided(Circle<double>{0, 0, -1}, r) || decided(c, Circle<double>{0, 0, -1}) ||
               decided(p, Circle<double>{0, 0, -0x1p-40}));
  EXPECT_FALSE(decided(Aabb<double>{1, 0, 0, 1}, r) || decided(Aabb<double>{0, 1, 1, 0}, r));
}

}  // namespace
}  // namespace vesica::filter_test
