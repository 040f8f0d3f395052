// SPDX-License-Identifier: Apache-2.0
// The evaluations without errors: where numbers are short they decide every tie, and what they decide is the exact
// stage's answer, near ties, the ends of the range and numbers of the most digits included.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vesica/overlap.hpp>

#include "by_kind.hpp"
#include "properties/lattice.hpp"

namespace {

using properties::Lattice;
using properties::Random;
using namespace vesica;

struct Counts {
  int asked = 0, decided = 0, wrong = 0, beyond_the_filter = 0, short_pairs = 0, short_ones = 0;
};

template <class A, class B>
bool is_wrong(const A& a, const B& b, const filter::Verdict<bool>& verdict) {
  return (verdict.overlap || verdict.disjoint) &&
         (check(a) != 0 || check(b) != 0 || verdict.overlap == verdict.disjoint ||
          verdict.overlap != detail::overlap::exact(a, b));
}

template <class A, class B>
void ask(const A& a, const B& b, Counts& counts) {
  if constexpr (filter::HasErrorFree<A, B> && detail::in_order<A, B>) {
    const auto verdict = filter::error_free(a, b), bounded = detail::overlap::filter(a, b);
    const bool decided = verdict.overlap || verdict.disjoint;
    ++counts.asked;
    counts.decided += decided;
    counts.beyond_the_filter += decided && !bounded.overlap && !bounded.disjoint;
    counts.wrong += is_wrong(a, b, verdict);
    if constexpr (filter::HasShortNumbers<A, B>) {
      const auto by_digits = filter::short_numbers(a, b);
      ++counts.short_pairs;
      counts.short_ones += by_digits.overlap || by_digits.disjoint;
      counts.wrong += is_wrong(a, b, by_digits);
    }
  }
}

/// Pairs of all kinds from one lattice, the second shape's number moved by a place with a probability.
Counts ask_all(const Lattice& lattice, int count, double moved) {
  Random random(properties::seed());
  Counts counts;
  for (int kind_a = VESICA_POINT; kind_a <= VESICA_RECT; ++kind_a) {
    for (int kind_b = kind_a; kind_b <= VESICA_RECT; ++kind_b) {
      for (int i = 0; i < count * properties::repeat(); ++i) {
        const auto a = properties::lattice_shape<double>(kind_a, lattice, random);
        auto b = properties::lattice_shape<double>(kind_b, lattice, random);
        if (random.chance(moved)) properties::move_by_a_place(kind_b, b, random);
        with_shape(kind_a, a.data(), [&](const auto& first) {
          return with_shape(kind_b, b.data(), [&](const auto& second) {
            ask(first, second, counts);
            return 0;
          });
        });
      }
    }
  }
  return counts;
}

TEST(ErrorFree, DecidesShortNumbers) {
  for (const Lattice& lattice : {Lattice{1, 0, 0}, Lattice{0.5, 0, 0}, Lattice{0x1p-7, 0, 3}, Lattice{1, 40, -20}}) {
    const Counts counts = ask_all(lattice, 1000, 0);
    EXPECT_EQ(counts.wrong, 0);
    EXPECT_GT(counts.beyond_the_filter, counts.asked / 20);
    // What is left are rectangles along (0.6, 0.8), and segments of no length.
    EXPECT_GT(counts.decided, counts.asked * 7 / 10);
    // Sizes and offsets are to be of like magnitude.
    if (lattice.lengths == 0) {
      EXPECT_GT(counts.short_ones, counts.short_pairs * 6 / 10);
    }
  }
}

TEST(ErrorFree, DecidesOnlyWhatIsRight) {
  for (const double step : {1.0, 0.5, 0.1, 0.01, 1.0 / 3}) EXPECT_EQ(ask_all({step, 0, 0}, 3000, 0.5).wrong, 0) << step;
}

/// Apart by 2^-60, which the difference to the near side rounds away, and that to the far side does not.
TEST(ErrorFree, LooksAtTheSideThatIsNear) {
  Counts counts;
  ask(Circle<double>{1, 0, 1}, Aabb<double>{-1, -1, -0x1p-60, 1}, counts);
  ask(Circle<double>{-1, 0, 1}, Aabb<double>{0x1p-60, -1, 1, 1}, counts);
  ask(Circle<double>{0, 1, 1}, Aabb<double>{-1, -1, 1, -0x1p-60}, counts);
  ask(Circle<double>{0, -1, 1}, Aabb<double>{-1, 0x1p-60, 1, 1}, counts);
  EXPECT_EQ(counts.asked, 4);
  EXPECT_EQ(counts.wrong, 0);
}

/// An error that underflows must not pass for none.
TEST(ErrorFree, DecidesOnlyWhatIsRightAtTheEndsOfTheRange) {
  for (int e = -1074; e <= 1020; e += 12) {
    EXPECT_EQ(ask_all({1, e, 0}, 60, 0.5).wrong, 0) << "lengths 2^" << e;
    EXPECT_EQ(ask_all({1, 0, e}, 60, 0.5).wrong, 0) << "axes 2^" << e;
    EXPECT_EQ(ask_all({0.01, e / 2, e / 2}, 60, 0.5).wrong, 0) << "both 2^" << e / 2;
  }
}

using Whole = std::int64_t;

/// x with a x = value modulo m, of coprime a and m (Euclid).
Whole divided(Whole value, Whole a, Whole m) {
  if (m == 1) return 0;
  const Whole b = ((a % m) + m) % m, v = ((value % m) + m) % m;
  // m | b x - v, so that b | m y + v.
  if (b == 1) return v;
  const Whole y = divided(-v, m, b);
  return (m * y + v) / b;
}

/// A rectangle and shapes at its face. The corner and the edge are at the first, the others at one with less inside.
struct AtFace {
  Rect<double> a, less, b;
  Segment<double> edge;
  Point<double> corner;
  Circle<double> disc;
};

/// They touch, or the gap or the overlap is as small as the numbers can have it. Directions have so many digits, and a
/// whole length for the disc's sake, before they are divided by a power of two; sizes have so many.
AtFace at_face(int of_directions, int of_sizes, Random& random) {
  const auto whole = [&](int digits) { return static_cast<Whole>(std::ldexp(random.between(0.5, 1), digits)); };
  const Whole one = Whole{1} << of_directions, p = std::max<Whole>(whole((of_directions + 1) / 2), 2);
  Whole q = p - 1;
  for (int i = 0; i < 9; ++i) {
    const Whole other = random.integer(1, static_cast<int>(p) - 1);
    if (std::gcd(p, other) == 1 && (p + other) % 2 == 1) q = other;
  }
  const Whole ux = p * p - q * q, uy = 2 * p * q, length = p * p + q * q, uu = length * length;
  // The axis is (ux, uy) / one. So that h uu is the offset's projection times one, but for a gap of 1 or none.
  const Whole gap = random.integer(-1, 1), part = divided(gap, uu, one);
  const Whole h = (whole(of_sizes) / one + 1) * one + part, less = random.integer(0, 1) * (h / 3);
  const Whole projection = (h * uu - gap) / one;
  Whole x = divided(projection, ux, uy), y = (projection - ux * x) / uy;
  const Whole along =
      std::llround(static_cast<double>(ux * y - uy * x) / static_cast<double>(uu)) + random.integer(-1, 1);
  x += along * uy;
  y -= along * ux;
  const auto number = [](Whole n) { return static_cast<double>(n); };
  const double dx = number(x), dy = number(y), vx = number(ux) / number(one), vy = number(uy) / number(one);
  const Whole far = whole(of_sizes) / one;
  const double other = number(whole(of_sizes)), edge_x = number(x - far * uy), edge_y = number(y + far * ux);
  const bool across = random.chance(0.5);
  return {
      {0, 0, vx, vy, number(h), other},
      {0, 0, vx, vy, number(h - less), other},
      across ? Rect<double>{dx, dy, -vy, vx, other, number(less)} : Rect<double>{dx, dy, vx, vy, number(less), other},
      {dx, dy, edge_x, edge_y},
      {dx, dy},
      {dx, dy, number(less) * (number(length) / number(one))}};
}

/// The digits that are allowed, and more: what is beyond must be left undecided rather than answered wrongly.
TEST(ErrorFree, DecidesOnlyWhatIsRightAtTheMostDigits) {
  Random random(properties::seed());
  for (int of_directions = 2; of_directions <= 20; ++of_directions) {
    for (int of_sizes = of_directions; of_sizes <= 58 - 2 * of_directions; ++of_sizes) {
      Counts counts;
      for (int i = 0; i < 30 * properties::repeat(); ++i) {
        const AtFace t = at_face(of_directions, of_sizes, random);
        ask(t.less, t.b, counts);
        ask(t.edge, t.a, counts);
        ask(t.corner, t.a, counts);
        ask(t.corner, t.edge, counts);
        ask(t.disc, t.less, counts);
        ask(t.edge, t.disc, counts);
      }
      EXPECT_EQ(counts.wrong, 0) << of_directions << ' ' << of_sizes;
    }
  }
}

/// Rectangles with as many digits as short_numbers() is to know.
TEST(ErrorFree, ShortNumbersAreAsLongAsTheirProofAllows) {
  Random random(properties::seed());
  for (int i = 0; i < 1000; ++i) {
    const AtFace t = at_face(7, 20, random);
    const auto verdict = filter::short_numbers(t.less, t.b);
    EXPECT_TRUE(verdict.overlap || verdict.disjoint);
    EXPECT_EQ(verdict.overlap, detail::overlap::exact(t.less, t.b));
  }
}

template <class A, class B>
bool decided(const A& a, const B& b) {
  if constexpr (filter::HasShortNumbers<A, B>) {
    const auto by_digits = filter::short_numbers(a, b);
    if (by_digits.overlap || by_digits.disjoint) return true;
  }
  const auto verdict = filter::error_free(a, b);
  return verdict.overlap || verdict.disjoint;
}

/// 16.1 - 0.1 is rounded to 16, and is a little more.
TEST(ErrorFree, KeepsTheLowPartOfOffsets) {
  const Rect<double> left{0.1, 0, 1, 0, 8, 8}, right{16.1, 0, 1, 0, 8, 8};
  EXPECT_EQ(right.cx - left.cx, 16);
  EXPECT_TRUE(decided(left, right));
  EXPECT_TRUE(filter::error_free(left, right).disjoint);
  EXPECT_FALSE(detail::overlap::exact(left, right));
}

TEST(ErrorFree, LeavesInvalidShapes) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Rect<double> good{0, 0, 1, 0, 1, 1};
  EXPECT_TRUE(decided(good, good));
  for (const double bad : {nan, inf, -inf}) {
    for (const Rect<double>& rect :
         {Rect<double>{bad, 0, 1, 0, 1, 1}, Rect<double>{0, bad, 1, 0, 1, 1}, Rect<double>{0, 0, bad, 0, 1, 1},
          Rect<double>{0, 0, 1, bad, 1, 1}, Rect<double>{0, 0, 1, 0, bad, 1}, Rect<double>{0, 0, 1, 0, 1, bad}}) {
      EXPECT_FALSE(decided(rect, good));
      EXPECT_FALSE(decided(good, rect));
      EXPECT_FALSE(decided(Circle<double>{0, 0, 1}, rect));
    }
    EXPECT_FALSE(decided(Circle<double>{0, 0, bad}, good));
    EXPECT_FALSE(decided(Circle<double>{0, 0, bad}, Circle<double>{0, 0, 1}));
    EXPECT_FALSE(decided(Circle<double>{bad, 0, 1}, Aabb<double>{0, 0, 1, 1}));
    EXPECT_FALSE(decided(Circle<double>{0, 0, 1}, Aabb<double>{0, 0, bad, 1}));
    EXPECT_FALSE(decided(Segment<double>{0, 0, 1, bad}, good));
  }
  EXPECT_FALSE(decided(good, Rect<double>{0, 0, 0, 0, 1, 1}));
  EXPECT_FALSE(decided(good, Rect<double>{0, 0, 1, 0, -1, 1}));
  EXPECT_FALSE(decided(Circle<double>{0, 0, -1}, good));
  EXPECT_FALSE(decided(Circle<double>{0, 0, -1}, Circle<double>{0, 0, 3}));
  EXPECT_FALSE(decided(Circle<double>{0, 0, 1}, Aabb<double>{1, 0, 0, 1}));
}

}  // namespace
