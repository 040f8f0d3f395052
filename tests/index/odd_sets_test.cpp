// SPDX-License-Identifier: Apache-2.0
/// Sets and calls that are allowed and rare: nothing at all, several sets of one kind, windows over hundreds of blocks,
/// more parts than there is work, and states at their end or made up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "index/all_pairs.hpp"
#include "index/face.hpp"
#include "properties/random.hpp"

namespace index_tests {
namespace {

template <class T>
class OddSets : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(OddSets, Scalars);

template <class T>
typename Face<T>::Shapes one_shape(std::int32_t kind, const T* numbers) {
  typename Face<T>::Shapes one;
  EXPECT_EQ(Face<T>::from_records(kind, 1, numbers, 0, &one), 0);
  return one;
}

/// An index without a block: of no shape, and of invalid ones alone.
TYPED_TEST(OddSets, WithoutABlock) {
  using F = Face<TypeParam>;
  using T = TypeParam;
  const T disc[3] = {0, 0, 1};
  const auto one = one_shape<T>(VESICA_CIRCLE, disc);
  const Indexed<T> some(Records<T>{VESICA_CIRCLE, {0, 0, 1, 5, 5, 1}});
  for (const Records<T>& records : {Records<T>{VESICA_CIRCLE, {}}, Records<T>{VESICA_CIRCLE, {0, 0, -1, 1, 1, -2}}}) {
    const Indexed<T> none(records);
    const void* const index = none.index.get();
    std::int64_t out[4], state[4] = {};
    T distance[4];
    typename F::Impact impact;
    EXPECT_EQ(vesica_index_check(index, none.index.size), 0);
    EXPECT_EQ(F::index_select(index, none.sets.data(), none.sets.count(), &one, nullptr, 0, nullptr), 0);
    EXPECT_EQ(F::index_select(index, none.sets.data(), none.sets.count(), &one, out, 4, state), 0);
    EXPECT_EQ(F::index_nearest(index, none.sets.data(), none.sets.count(), &one, 2, std::numeric_limits<T>::infinity(),
                               out, distance),
              0);
    EXPECT_EQ(F::index_cast(index, none.sets.data(), none.sets.count(), &one, 1, 1, 9, nullptr, 0, nullptr), 0);
    EXPECT_EQ(F::index_cast_first(index, none.sets.data(), none.sets.count(), &one, 1, 1, 9, &impact),
              vesica_index_count(index));
    for (std::int64_t part = 0; part < 3; ++part) {
      EXPECT_EQ(count(VESICA_JOIN_OVERLAP, none, some, part, 3), 0);
      EXPECT_EQ(count(VESICA_JOIN_OVERLAP, some, none, part, 3), 0);
      EXPECT_TRUE(join(VESICA_JOIN_OVERLAP, none, some, part, 3).empty());
    }
  }
}

/// Shapes of one kind in three sets are the same shapes as in one.
TYPED_TEST(OddSets, SeveralOfOneKind) {
  const Records<TypeParam> all = rects<TypeParam>("clustered", 3000, 1);
  Laid<TypeParam> parted;
  for (const auto& [begin, end] : {std::pair{0, 100}, {100, 1900}, {1900, 3000}}) {
    parted.push_back({VESICA_RECT, {all.numbers.begin() + 6 * begin, all.numbers.begin() + 6 * end}});
  }
  parted.push_back({VESICA_CIRCLE, {-1000, -1000, 1}});
  const Indexed<TypeParam> whole(all), parts(parted), other(rects<TypeParam>("clustered", 2000, 2));
  for (const std::int32_t query :
       {VESICA_JOIN_OVERLAP, VESICA_JOIN_CONTAINS, VESICA_JOIN_INSIDE, VESICA_JOIN_INTERIORS}) {
    const std::vector<Pair> expected = sorted(join(query, whole, other));
    EXPECT_TRUE(sorted(join(query, parts, other)) == expected) << query;
    EXPECT_TRUE(sorted(join(query, parts, other, 0, 1, 37)) == expected) << query;
  }
  EXPECT_GT(join(VESICA_JOIN_OVERLAP, parts, other).size(), 100U);
  EXPECT_TRUE(sorted(join(VESICA_JOIN_OVERLAP, parts, parts)) == sorted(join(VESICA_JOIN_OVERLAP, whole, whole)));
}

/// n tiny discs on a lattice, and needles: each needle's window has a few discs of each of very many blocks.
Records<double> lattice_of_discs(int side) {
  Records<double> discs{VESICA_CIRCLE, {}};
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k)
      discs.numbers.insert(discs.numbers.end(), {static_cast<double>(i), static_cast<double>(k), 0.125});
  }
  return discs;
}

TEST(OddSets, AFewOfEachOfManyBlocks) {
  constexpr int side = 600;
  const Indexed<double> discs(lattice_of_discs(side));
  Records<double> lines{VESICA_SEGMENT, {}};
  for (int i = 0; i < 40; ++i) {
    const double at = 15 * i;
    lines.numbers.insert(lines.numbers.end(), {at, -1, at, side + 1.0});
    lines.numbers.insert(lines.numbers.end(), {-1, at, side + 1.0, at});
  }
  const Indexed<double> needles(lines);
  EXPECT_EQ(count(VESICA_JOIN_OVERLAP, discs, needles), 2 * 40 * side);
  EXPECT_EQ(count(VESICA_JOIN_OVERLAP, needles, discs), 2 * 40 * side);
  EXPECT_EQ(static_cast<int>(join(VESICA_JOIN_OVERLAP, needles, discs, 0, 1, 100).size()), 2 * 40 * side);
  const double line[4] = {300, -1, 300, side + 1.0};
  const auto one = one_shape<double>(VESICA_SEGMENT, line);
  EXPECT_EQ(vesica_index_select_f64(discs.index.get(), discs.sets.data(), 1, &one, nullptr, 0, nullptr), side);
  std::vector<std::int64_t> all;
  std::int64_t out[64], state[4] = {};
  while (state[0] != -1) {
    const std::int64_t n = vesica_index_select_f64(discs.index.get(), discs.sets.data(), 1, &one, out, 64, state);
    ASSERT_GE(n, 0);
    all.insert(all.end(), out, out + n);
  }
  std::sort(all.begin(), all.end());
  ASSERT_EQ(static_cast<int>(all.size()), side);
  for (int k = 0; k < side; ++k) EXPECT_EQ(all[static_cast<std::size_t>(k)], std::int64_t{300} * side + k);
}

/// A window over a hundred blocks in a row, with two items or three of each.
TEST(OddSets, AWindowAlongARow) {
  Records<double> points{VESICA_POINT, {}};
  properties::Random random(3);
  for (int i = 0; i < 100000; ++i) {
    for (const double most : {1000.0, 1.0}) points.numbers.push_back(most * random.unit());
  }
  const Indexed<double> row(points);
  const double window[4] = {0, 0.5, 1000, 0.5025};
  std::int64_t expected = 0;
  for (std::size_t i = 1; i < points.numbers.size(); i += 2) {
    expected += points.numbers[i] >= window[1] && points.numbers[i] <= window[3];
  }
  const auto one = one_shape<double>(VESICA_AABB, window);
  EXPECT_EQ(vesica_index_select_f64(row.index.get(), row.sets.data(), 1, &one, nullptr, 0, nullptr), expected);
  EXPECT_EQ(vesica_index_select_f64(row.index.get(), nullptr, 0, &one, nullptr, 0, nullptr), expected);
}

/// More parts of a build than there are slices or cells: some have nothing to do.
TEST(OddSets, MorePartsThanWork) {
  for (const std::int64_t n : {1, 50, 20000}) {
    const Indexed<double> whole(rects<double>("uniform", n, 1));
    const Memory index(whole.index.size), scratch(vesica_index_scratch(n));
    std::int64_t result = 0;
    for (std::int32_t step = 0; step < 5; ++step) {
      const std::int64_t parts = step == 0 || step == 4 ? 1 : 100;
      for (std::int64_t part = 0; part < parts; ++part) {
        result = vesica_index_step_f64(step, part, parts, whole.sets.data(), 1, index.get(), index.size, scratch.get(),
                                       scratch.size);
        ASSERT_GE(result, 0);
      }
    }
    ASSERT_EQ(result, whole.result);
    EXPECT_EQ(std::memcmp(index.get(), whole.index.get(), static_cast<std::size_t>(result)), 0) << n;
  }
}

/// At its end a state stays there.
TYPED_TEST(OddSets, AfterTheEnd) {
  using F = Face<TypeParam>;
  const Indexed<TypeParam> all(rects<TypeParam>("uniform", 300, 1));
  const auto one = one_shape<TypeParam>(VESICA_RECT, all.laid[0].numbers.data());
  const Memory scratch(vesica_join_scratch());
  std::int64_t out[4] = {7, 7, 7, 7}, state[4] = {-1, 0, 0, 0};
  EXPECT_EQ(F::index_select(all.index.get(), all.sets.data(), 1, &one, out, 4, state), 0);
  EXPECT_EQ(F::join(VESICA_JOIN_OVERLAP, all.index.get(), all.sets.data(), 1, all.index.get(), all.sets.data(), 1, 0, 1,
                    scratch.get(), scratch.size, out, out, 4, state),
            0);
  EXPECT_EQ(F::index_cast(all.index.get(), all.sets.data(), 1, &one, 1, 0, 9, out, 4, state), 0);
  EXPECT_TRUE(state[0] == -1 && out[0] == 7);
}

/// However many calls it took, an ended state is the same.
TYPED_TEST(OddSets, StatesAtTheEnd) {
  using F = Face<TypeParam>;
  using T = TypeParam;
  const Indexed<T> all(rects<T>("uniform", 3000, 1));
  const auto one = one_shape<T>(VESICA_RECT, all.laid[0].numbers.data());
  const void* const index = all.index.get();
  const auto* const sets = all.sets.data();
  const Memory scratch(vesica_join_scratch());
  const auto end_of = [&](std::int64_t capacity, const auto& call) {
    std::vector<std::int64_t> out_a(static_cast<std::size_t>(capacity)), out_b(out_a), state(4);
    std::int64_t calls = 0;
    for (; state[0] != -1 && calls < 10000; ++calls) {
      EXPECT_GE(call(out_a.data(), out_b.data(), capacity, state.data()), 0);
    }
    EXPECT_EQ(calls > 1, capacity < 100);
    return state;
  };
  const std::vector<std::int64_t> ended = {-1, 0, 0, 0};
  for (const std::int64_t capacity : {1, 5000}) {
    EXPECT_EQ(end_of(capacity,
                     [&](std::int64_t* out, std::int64_t*, std::int64_t room, std::int64_t* state) {
                       return F::index_select(index, nullptr, 0, &one, out, room, state);
                     }),
              ended);
    EXPECT_EQ(end_of(capacity,
                     [&](std::int64_t* out, std::int64_t*, std::int64_t room, std::int64_t* state) {
                       return F::index_cast(index, sets, 1, &one, 1, 0, 9, out, room, state);
                     }),
              ended);
    EXPECT_EQ(end_of(capacity,
                     [&](std::int64_t* out_a, std::int64_t* out_b, std::int64_t room, std::int64_t* state) {
                       return F::join(VESICA_JOIN_OVERLAP, index, sets, 1, index, sets, 1, 0, 50, scratch.get(),
                                      scratch.size, out_a, out_b, room, state);
                     }),
              ended);
    EXPECT_EQ(end_of(capacity,
                     [&](std::int64_t* out_a, std::int64_t* out_b, std::int64_t room, std::int64_t* state) {
                       return F::join_within(index, sets, 1, index, sets, 1, T(0), 0, 50, out_a, out_b, room, state);
                     }),
              ended);
  }
}

/// Behind all candidates of any pair of blocks.
constexpr std::int64_t last_place = std::int64_t{1024 * 32} << 32;

/// A state's numbers that no call has written: refused where they name no place; else the join goes on at that place,
/// and skips no more than its pair of blocks has.
TEST(OddSets, StatesMadeUp) {
  const Indexed<double> a(rects<double>("uniform", 5000, 1)), b(rects<double>("uniform", 5000, 2));
  const Memory scratch(vesica_join_scratch());
  std::vector<std::int64_t> out_a(100), out_b(100);
  const auto ask = [&](std::int64_t* state, std::int64_t capacity) {
    return vesica_join_f64(VESICA_JOIN_OVERLAP, a.index.get(), a.sets.data(), 1, b.index.get(), b.sets.data(), 1, 0, 1,
                           scratch.get(), scratch.size, out_a.data(), out_b.data(), capacity, state);
  };
  std::int64_t state[4] = {};
  std::int64_t written = ask(state, 100);
  ASSERT_EQ(written, 100);
  const std::int64_t marks = state[3] & 0x7fff, last = state[3] >> 15;
  for (const std::int64_t end : {std::int64_t{0}, state[0], last + 1, last + 1000}) {
    std::int64_t wrong[4] = {state[0], state[1], state[2], end << 15 | marks};
    EXPECT_EQ(ask(wrong, 100), VESICA_E_ARGUMENT) << end;
  }
  const std::int64_t pairs = count(VESICA_JOIN_OVERLAP, a, b);
  for (const std::int64_t skipped : {last_place, last_place | 4096, std::int64_t{1} << 40}) {
    std::int64_t forged[4] = {0, 0, skipped, state[3]}, rest = 0;
    while (forged[0] != -1) {
      written = ask(forged, 100);
      ASSERT_GE(written, 0);
      rest += written;
    }
    EXPECT_GT(rest, pairs / 2);
    EXPECT_LT(rest, pairs);
  }
}

/// More pairs of blocks, of a candidate or two, than are gathered at once: points of one set in a row, with room around
/// each that is one of the other set too.
TEST(OddSets, APointOfEachOfManyBlocks) {
  constexpr std::int64_t common = 2700, apart = 560, room = 24;
  Records<double> row{VESICA_POINT, {}}, points{VESICA_POINT, {}};
  std::vector<Pair> expected;
  for (std::int64_t i = 0; i < common * apart; ++i) {
    const std::int64_t beside = i % apart - apart / 2;
    if (beside != 0 && std::abs(beside) < room) continue;
    if (beside == 0) {
      expected.emplace_back(row.count(), points.count());
      points.numbers.insert(points.numbers.end(), {static_cast<double>(i), 0});
    }
    row.numbers.insert(row.numbers.end(), {static_cast<double>(i), 0});
  }
  const Indexed<double> many(row), few(points);
  EXPECT_EQ(count(VESICA_JOIN_OVERLAP, many, few), common);
  EXPECT_EQ(count(VESICA_JOIN_OVERLAP, few, many), common);
  EXPECT_TRUE(sorted(join(VESICA_JOIN_OVERLAP, many, few, 0, 1, 2 * common)) == expected);
  EXPECT_TRUE(sorted(join(VESICA_JOIN_OVERLAP, many, few, 0, 1, 777)) == expected);
}

/// Two blocks of 1,024 boxes, left and right; the given numbers of them reach the points of the other set.
Records<double> boxes_of_two_blocks(int reaching_left, int reaching_right) {
  Records<double> boxes{VESICA_AABB, {}};
  for (int i = 0; i < 2048; ++i) {
    const bool left = i < 1024, reaches = left ? i < reaching_left : i - 1024 < reaching_right;
    const double x = left ? -25 : 25, half = reaches ? 25.5 : 20;
    boxes.numbers.insert(boxes.numbers.end(), {x - half, -1, x + half, 1});
  }
  return boxes;
}
Records<double> points_of_a_block(int near) {
  Records<double> points{VESICA_POINT, {}};
  for (int i = 0; i < 1024; ++i) points.numbers.insert(points.numbers.end(), {0, i < near ? 0.0 : 5.0});
  return points;
}

/// A state skips all candidates of its pair of blocks, about as many as are gathered at once, and none of the next
/// pair: of another block of A, and of another block of B.
TEST(OddSets, StatesThatSkipAPairOfBlocks) {
  const Memory scratch(vesica_join_scratch());
  std::vector<std::int64_t> out_a(8192), out_b(8192);
  const auto ask = [&](const Indexed<double>& a, const Indexed<double>& b, std::int64_t capacity, std::int64_t* state) {
    return vesica_join_f64(VESICA_JOIN_OVERLAP, a.index.get(), a.sets.data(), 1, b.index.get(), b.sets.data(), 1, 0, 1,
                           scratch.get(), scratch.size, out_a.data(), out_b.data(), capacity, state);
  };
  const auto rest_of = [&](const Indexed<double>& a, const Indexed<double>& b) {
    std::int64_t state[4] = {};
    EXPECT_EQ(ask(a, b, 1, state), 1);
    std::int64_t forged[4] = {0, 0, last_place, state[3]};
    const std::int64_t rest = ask(a, b, 8192, forged);
    EXPECT_EQ(forged[0], -1);
    return rest;
  };
  const Indexed<double> boxes(boxes_of_two_blocks(4, 3));
  for (int near = 1000; near <= 1024; ++near) {
    const Indexed<double> points(points_of_a_block(near));
    ASSERT_EQ(count(VESICA_JOIN_OVERLAP, boxes, points), 7 * near);
    const std::int64_t rest = rest_of(boxes, points);
    EXPECT_TRUE(rest == 3 * near || rest == 4 * near) << near << ": " << rest;
    EXPECT_EQ(rest_of(points, boxes), rest) << near;
  }
}

/// The nearest of points on both sides of a line, which meets the blocks and few of their leaves: these are more than
/// the search lists, and some of them are farther than what it finds meanwhile.
TEST(OddSets, TheNearestBesideALine) {
  constexpr double length = 64000;
  Records<double> points{VESICA_POINT, {}};
  properties::Random random(5);
  std::vector<std::pair<double, std::int64_t>> expected;
  for (std::int64_t i = 0; i < 64000; ++i) {
    const double x = random.between(0, length), y = random.between(200, 240);
    points.numbers.insert(points.numbers.end(), {x, random.chance(0.5) ? y : -y});
    expected.emplace_back(y, i);
  }
  std::sort(expected.begin(), expected.end());
  const Indexed<double> all(points);
  const double line[4] = {0, 0, length, 0};
  const auto one = one_shape<double>(VESICA_SEGMENT, line);
  for (const std::int64_t k : {1, 100, 18000, 20000, 22000, 24000, 26000, 28000, 30000}) {
    std::vector<std::int64_t> out(static_cast<std::size_t>(k));
    std::vector<double> distance(out.size());
    ASSERT_EQ(vesica_index_nearest_f64(all.index.get(), all.sets.data(), 1, &one, k,
                                       std::numeric_limits<double>::infinity(), out.data(), distance.data()),
              k);
    for (std::size_t i = 0; i < out.size(); ++i) {
      ASSERT_EQ(distance[i], expected[i].first) << k;
      ASSERT_EQ(out[i], expected[i].second) << k;
    }
  }
}

/// Parts of a join of near ones that do not divide the shapes.
TYPED_TEST(OddSets, PartsThatDoNotDivide) {
  using F = Face<TypeParam>;
  const Indexed<TypeParam> a(rects<TypeParam>("uniform", 301, 1)), b(rects<TypeParam>("uniform", 200, 2));
  const auto part_of = [&](std::int64_t part, std::int64_t parts) {
    return F::join_within(a.index.get(), a.sets.data(), 1, b.index.get(), b.sets.data(), 1, TypeParam{1}, part, parts,
                          nullptr, nullptr, 0, nullptr);
  };
  const std::int64_t whole = part_of(0, 1);
  EXPECT_GT(whole, 100);
  for (const std::int64_t parts : {2, 3, 7, 1000}) {
    std::int64_t sum = 0;
    for (std::int64_t part = 0; part < parts; ++part) sum += part_of(part, parts);
    EXPECT_EQ(sum, whole) << parts;
  }
}

/// Distances of shapes from one that is 2^1900 times as large.
TEST(OddSets, NearestOfTheLeast) {
  Records<double> points{VESICA_POINT, {}};
  for (int i = 0; i < 200; ++i) points.numbers.insert(points.numbers.end(), {std::ldexp(i + 1, -1060), 0});
  const Indexed<double> least(points);
  const double box[4] = {-0x1p950, -0x1p950, 0, 0x1p950};
  const auto one = one_shape<double>(VESICA_AABB, box);
  std::int64_t out[3];
  double distance[3];
  ASSERT_EQ(vesica_index_nearest_f64(least.index.get(), least.sets.data(), 1, &one, 3,
                                     std::numeric_limits<double>::infinity(), out, distance),
            3);
  for (int i = 0; i < 3; ++i) {
    vesica_closest_points_f64 expected;
    const double* const point = &points.numbers[static_cast<std::size_t>(2 * out[i])];
    EXPECT_EQ(vesica_nearest_f64(VESICA_AABB, box, VESICA_POINT, point, &expected), 0);
    EXPECT_EQ(distance[i], expected.distance);
    EXPECT_LE(distance[i], 0x1p-1058);
  }
}

/// Half of the points lie at one place, the rest far along an axis: a block is as narrow as a column of its grid, and
/// columns are some 2^400 to 2^1060 times as wide as all is across the axis. A shape stands a tenth of a column away.
TEST(OddSets, NearestBesideABlockOfOneColumn) {
  constexpr int exponent = 601, near = 768, far = 732;
  for (const int turn : {0, 1, 2, 3}) {
    const double column = std::ldexp(turn < 2 ? 1 : -1, exponent);
    const int along = turn % 2, across = 1 - along;
    Records<double> points{VESICA_POINT, std::vector<double>(2 * (near + far))};
    for (int i = 0; i < near + far; ++i) {
      points.numbers[static_cast<std::size_t>(2 * i + along)] = (i < near ? 1.01 : 100 + (i - near) * 33.0) * column;
    }
    const Indexed<double> all(points);
    for (int smaller = 400; smaller <= 1060; smaller += 30) {
      const double half = std::fabs(std::ldexp(column, -smaller));
      double box[4];
      box[along] = box[along + 2] = 0.9 * column;
      box[across] = -half;
      box[across + 2] = half;
      const auto one = one_shape<double>(VESICA_AABB, box);
      vesica_closest_points_f64 expected;
      ASSERT_EQ(vesica_nearest_f64(VESICA_AABB, box, VESICA_POINT, points.numbers.data(), &expected), 0);
      ASSERT_LT(expected.distance, 0.12 * std::fabs(column));
      std::int64_t out[2];
      double distance[2];
      ASSERT_EQ(vesica_index_nearest_f64(all.index.get(), all.sets.data(), 1, &one, 2,
                                         std::numeric_limits<double>::infinity(), out, distance),
                2);
      EXPECT_TRUE(out[0] == 0 && out[1] == 1) << turn << ' ' << smaller << ": " << out[0] << ' ' << out[1];
      EXPECT_TRUE(distance[0] == expected.distance && distance[1] == expected.distance) << turn << ' ' << smaller;
    }
  }
}

}  // namespace
}  // namespace index_tests
