// SPDX-License-Identifier: Apache-2.0
// The evaluation without errors: where numbers are short it decides every tie, and what it decides is the exact stage's
// answer, near ties and the ends of the range included.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>
#include <vesica/overlap.hpp>

#include "by_kind.hpp"
#include "properties/lattice.hpp"

namespace {

using properties::Lattice;
using properties::Random;
using namespace vesica;

struct Counts {
  int asked = 0, decided = 0, wrong = 0, beyond_the_filter = 0;
};

template <class A, class B>
void ask(const A& a, const B& b, Counts& counts) {
  if constexpr (filter::HasErrorFree<A, B> && detail::in_order<A, B>) {
    const auto verdict = filter::error_free(a, b), bounded = detail::overlap::filter(a, b);
    const bool decided = verdict.overlap || verdict.disjoint;
    ++counts.asked;
    counts.decided += decided;
    counts.beyond_the_filter += decided && !bounded.overlap && !bounded.disjoint;
    counts.wrong += decided && (check(a) != 0 || check(b) != 0 || verdict.overlap == verdict.disjoint ||
                                verdict.overlap != detail::overlap::exact(a, b));
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
  }
}

TEST(ErrorFree, DecidesOnlyWhatIsRight) {
  for (const double step : {1.0, 0.5, 0.1, 0.01, 1.0 / 3}) EXPECT_EQ(ask_all({step, 0, 0}, 3000, 0.5).wrong, 0) << step;
}

/// An error that underflows must not pass for none.
TEST(ErrorFree, DecidesOnlyWhatIsRightAtTheEndsOfTheRange) {
  for (int e = -1074; e <= 1020; e += 12) {
    EXPECT_EQ(ask_all({1, e, 0}, 60, 0.5).wrong, 0) << "lengths 2^" << e;
    EXPECT_EQ(ask_all({1, 0, e}, 60, 0.5).wrong, 0) << "axes 2^" << e;
    EXPECT_EQ(ask_all({0.01, e / 2, e / 2}, 60, 0.5).wrong, 0) << "both 2^" << e / 2;
  }
}

template <class A, class B>
bool decided(const A& a, const B& b) {
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
