// SPDX-License-Identifier: Apache-2.0
/// One index and one order of pairs for all: instruction sets (VESICA_ISA, by the entries of ctest), parts, capacities,
/// and steps of a build. Inputs are made without functions whose last digits differ between machines.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "index/face.hpp"

namespace index_tests {
namespace {

std::uint64_t next(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return state >> 33;
}

/// Rectangles over 20 scales with axes of length 1 and 1.25, whose outlines often touch: multiples of powers of two.
template <class T>
Laid<T> touching(std::int64_t n, std::uint64_t seed) {
  Records<T> rects{VESICA_RECT, {}}, circles{VESICA_CIRCLE, {}}, points{VESICA_POINT, {}};
  for (std::int64_t i = 0; i < n; ++i) {
    const auto unit = static_cast<T>(std::ldexp(1.0, i % 7 == 0 ? -static_cast<int>(next(seed) % 20) : 0));
    const T x = static_cast<T>(next(seed) % 60) * unit, y = static_cast<T>(next(seed) % 60) * unit;
    if (i % 5 == 0) circles.numbers.insert(circles.numbers.end(), {x, y, unit / 2});
    if (i % 5 == 1) points.numbers.insert(points.numbers.end(), {x + unit / 2, y});
    if (i % 5 > 1) rects.numbers.insert(rects.numbers.end(), {x, y, T(i % 2), T(1) - T(i % 3) / 4, unit / 2, unit / 4});
  }
  return {rects, circles, points};
}

std::uint64_t hash_pairs(const std::vector<Pair>& pairs) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (const auto& [a, b] : pairs) {
    h = (h ^ static_cast<std::uint64_t>(a)) * 0x100000001b3u;
    h = (h ^ static_cast<std::uint64_t>(b)) * 0x100000001b3u;
  }
  return h;
}

TEST(SameBytes, IndexAndOrderOfPairs) {
  const Indexed<double> a(touching<double>(9000, 1)), b(touching<double>(7000, 2));
  // Numbers are in the machine's byte order, which the header names.
  if constexpr (std::endian::native == std::endian::little) {
    EXPECT_EQ(hash_bytes(a.index.get(), static_cast<std::size_t>(a.result)), 14017431053294008823u);
  }
  EXPECT_EQ(hash_pairs(join(VESICA_JOIN_OVERLAP, a, b)), 9459960488521776375u);
  EXPECT_EQ(hash_pairs(join(VESICA_JOIN_OVERLAP, a, a)), 12175247251169411526u);
  const Indexed<float> c(touching<float>(9000, 1)), d(touching<float>(7000, 2));
  EXPECT_EQ(hash_pairs(join(VESICA_JOIN_OVERLAP, c, d)), 9459960488521776375u) << "the same numbers as floats";
}

/// Shapes of all six kinds in the same places.
Laid<double> touching_kinds(std::int64_t n, std::uint64_t seed) {
  Laid<double> laid = touching<double>(n, seed);
  Records<double> segments{VESICA_SEGMENT, {}}, boxes{VESICA_AABB, {}}, ellipses{VESICA_ELLIPSE, {}};
  for (std::int64_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(next(seed) % 60), y = static_cast<double>(next(seed) % 60);
    if (i % 3 == 0) segments.numbers.insert(segments.numbers.end(), {x, y, x + 1.5, y + static_cast<double>(i % 2)});
    if (i % 3 == 1) boxes.numbers.insert(boxes.numbers.end(), {x, y, x + 0.5, y + 1});
    if (i % 3 == 2) ellipses.numbers.insert(ellipses.numbers.end(), {x, y, 0.75, static_cast<double>(i % 2), 1, 0.5});
  }
  laid.push_back(segments);
  laid.push_back(boxes);
  laid.push_back(ellipses);
  return laid;
}

TEST(SameBytes, EveryQueryOfAllKinds) {
  const Indexed<double> a(touching_kinds(1500, 7)), b(touching_kinds(1200, 8));
  EXPECT_EQ(hash_pairs(join(VESICA_JOIN_OVERLAP, a, b)), 15043699840328478058u);
  EXPECT_EQ(hash_pairs(join(VESICA_JOIN_BOUNDS, a, b)), 2428866954791285896u);
  EXPECT_EQ(hash_pairs(join(VESICA_JOIN_CONTAINS, a, b)), 5787565343280259415u);
  EXPECT_EQ(hash_pairs(join(VESICA_JOIN_INSIDE, a, b)), 15244132183344297971u);
  constexpr std::int64_t k = 5;
  std::vector<std::int64_t> items(static_cast<std::size_t>(k * a.sets.items));
  std::vector<double> distance(items.size());
  ASSERT_EQ(vesica_join_nearest_f64(a.sets.data(), a.sets.count(), b.index.get(), b.sets.data(), b.sets.count(), k,
                                    INFINITY, 0, 1, items.data(), distance.data()),
            k * a.sets.items);
  std::vector<Pair> nearest;
  for (std::size_t i = 0; i < items.size(); ++i)
    nearest.emplace_back(items[i], std::bit_cast<std::int64_t>(distance[i]));
  EXPECT_EQ(hash_pairs(nearest), 17292048023935730889u);
}

/// Shapes enough for seven levels of cells, and some that are too wide or too tall for them.
TEST(SameBytes, ManyLevels) {
  Laid<double> laid = touching<double>(60000, 5);
  Records<double> boxes{VESICA_AABB, {}};
  std::uint64_t seed = 6;
  for (int i = 0; i < 2000; ++i) {
    const double x = static_cast<double>(next(seed) % 60), y = static_cast<double>(next(seed) % 60);
    const double width = i % 2 == 0 ? 40 : 0.25, height = i % 2 == 0 ? 0.25 : 40;
    boxes.numbers.insert(boxes.numbers.end(), {x, y, x + width, y + height});
  }
  laid.push_back(boxes);
  const Indexed<double> all(laid);
  if constexpr (std::endian::native == std::endian::little) {
    EXPECT_EQ(hash_bytes(all.index.get(), static_cast<std::size_t>(all.result)), 17148071495984785089u);
  }
}

TEST(SameBytes, PartsAndCapacities) {
  const Indexed<double> a(touching<double>(5000, 3)), b(touching<double>(4000, 4));
  for (const Indexed<double>* other : {&b, &a}) {
    const std::vector<Pair> whole = join(VESICA_JOIN_OVERLAP, a, *other);
    ASSERT_GT(whole.size(), 1000u);
    for (const std::int64_t parts : {2, 7, 64}) {
      for (const std::int64_t capacity : {7, 4096}) {
        std::vector<Pair> all;
        for (std::int64_t part = 0; part < parts; ++part) {
          const std::vector<Pair> some = join(VESICA_JOIN_OVERLAP, a, *other, part, parts, capacity);
          EXPECT_EQ(count(VESICA_JOIN_OVERLAP, a, *other, part, parts), static_cast<std::int64_t>(some.size()));
          all.insert(all.end(), some.begin(), some.end());
        }
        EXPECT_TRUE(all == whole) << parts << " parts, capacity " << capacity;
      }
    }
  }
}

TEST(SameBytes, ResumedAtEveryPair) {
  const Indexed<double> a(touching<double>(700, 3)), b(touching<double>(1500, 4));
  for (const Indexed<double>* other : {&b, &a}) {
    const std::vector<Pair> whole = join(VESICA_JOIN_OVERLAP, a, *other);
    ASSERT_GT(whole.size(), 100u);
    EXPECT_TRUE(join(VESICA_JOIN_OVERLAP, a, *other, 0, 1, 1) == whole);
  }
}

/// More pairs of one pair of blocks than are decided at once: calls go on in its midst. Some candidates are no pairs.
TEST(SameBytes, ResumedInACrowd) {
  Records<double> discs{VESICA_CIRCLE, {}};
  for (int i = 0; i < 150; ++i) discs.numbers.insert(discs.numbers.end(), {i % 2 * 1.5, i % 2 * 1.5, 1});
  const Indexed<double> crowd(discs), other(discs);
  for (const Indexed<double>* with : {&other, &crowd}) {
    const std::vector<Pair> whole = join(VESICA_JOIN_OVERLAP, crowd, *with, 0, 1, 1 << 16);
    ASSERT_EQ(whole.size(), with == &other ? 2u * 75 * 75 : 2u * 75 * 74 / 2);
    EXPECT_TRUE(join(VESICA_JOIN_OVERLAP, crowd, *with, 0, 1, 7) == whole);
    EXPECT_TRUE(join(VESICA_JOIN_OVERLAP, crowd, *with, 0, 1, 1000) == whole);
  }
}

/// Places that no join returns: beyond a block's candidates.
TEST(SameBytes, PlacesThatAreNone) {
  const Indexed<double> all(touching<double>(5000, 3));
  const auto next = [&all, index = all.index.get()](std::int64_t* state) {
    const Memory scratch(vesica_join_scratch());
    std::int64_t out_a[7], out_b[7];
    return vesica_join_f64(VESICA_JOIN_OVERLAP, index, all.sets.data(), all.sets.count(), index, all.sets.data(),
                           all.sets.count(), 0, 1, scratch.get(), scratch.size, out_a, out_b, 7, state);
  };
  std::int64_t state[4] = {0, 0, 0, 0};
  ASSERT_EQ(next(state), 7);
  const std::int64_t place = state[2];
  for (const std::int64_t none : {place | 0x10000, place + (std::int64_t{1} << 48), INT64_MAX}) {
    state[2] = none;
    EXPECT_EQ(next(state), VESICA_E_ARGUMENT) << none;
  }
  state[2] = place;
  EXPECT_EQ(next(state), 7);
}

TEST(SameBytes, StepsInParts) {
  const Laid<double> laid = touching<double>(20000, 5);
  const Indexed<double> whole{Laid<double>(laid)};
  const Sets<double> sets(laid);
  for (const std::int64_t parts : {1, 2, 7, 64}) {
    const Memory index(vesica_index_size(sets.items)), scratch(vesica_index_scratch(sets.items));
    std::int64_t result = 0;
    for (std::int32_t step = 0; step < 5; ++step) {
      const std::int64_t callers = step == 0 || step == 4 ? 1 : parts;
      for (std::int64_t part = callers; part-- > 0;) {
        result = vesica_index_step_f64(step, part, callers, sets.data(), sets.count(), index.get(), index.size,
                                       scratch.get(), scratch.size);
        ASSERT_GE(result, 0);
      }
    }
    ASSERT_EQ(result, whole.result);
    EXPECT_EQ(std::memcmp(index.get(), whole.index.get(), static_cast<std::size_t>(result)), 0) << parts;
  }
}

/// Columns of numbers and records far apart, and an order of one's own.
TEST(SameBytes, LayoutsAndOrder) {
  const Records<double> r = rects<double>("near_ties", 3000, 6);
  const Indexed<double> records{Records<double>(r)};
  std::vector<double> columns[6];
  for (std::size_t i = 0; i < r.numbers.size(); ++i) columns[i % 6].push_back(r.numbers[i]);
  vesica_shapes_f64 shapes{VESICA_RECT, 0, r.count(), sizeof(double), {}, nullptr, nullptr, 0};
  for (int k = 0; k < 6; ++k) shapes.field[k] = columns[k].data();
  const Memory index(vesica_index_size(r.count())), scratch(vesica_index_scratch(r.count()));
  ASSERT_EQ(vesica_index_build_f64(&shapes, 1, index.get(), index.size, scratch.get(), scratch.size), records.result);
  EXPECT_EQ(std::memcmp(index.get(), records.index.get(), static_cast<std::size_t>(records.result)), 0);
  const Memory join_scratch(vesica_join_scratch());
  EXPECT_EQ(vesica_join_f64(VESICA_JOIN_OVERLAP, index.get(), &shapes, 1, index.get(), &shapes, 1, 0, 1,
                            join_scratch.get(), join_scratch.size, nullptr, nullptr, 0, nullptr),
            count(VESICA_JOIN_OVERLAP, records, records));

  std::vector<std::int64_t> order(3000);
  ASSERT_EQ(vesica_index_order(index.get(), order.data(), 3000), 3000);
  std::vector<bool> seen(3000);
  for (const std::int64_t i : order) {
    EXPECT_FALSE(seen[static_cast<std::size_t>(i)]);
    seen[static_cast<std::size_t>(i)] = true;
  }
}

}  // namespace
}  // namespace index_tests
