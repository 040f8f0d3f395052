// SPDX-License-Identifier: Apache-2.0
// Indexes and joins of polygons and polylines, in each layout and mixed with other kinds, against every pair asked.
#include <gtest/gtest.h>
#include <vesica_detection.h>
#include <vesica_index.h>
#include <vesica_measures.h>
#include <vesica_motion.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/shapes.hpp"

namespace polygon_index {

using namespace polygons;

constexpr int each_set = 60;

struct Room {
  std::int64_t size;
  std::unique_ptr<void, void (*)(void*)> memory;
  explicit Room(std::int64_t bytes)
      : size((bytes + 63) / 64 * 64), memory(std::aligned_alloc(64, static_cast<std::size_t>(size)), std::free) {}
};

/// Quads in one array, polygons with holes by offsets, structs of polygons, polylines of one chain each, and rows.
struct Sets {
  std::vector<double> quads;
  Path holed, chains;
  std::vector<std::int32_t> polygons{0};
  std::vector<Path> scattered;
  std::vector<vesica_polygon_f64> structs;
  inflated::Columns<double> ellipses, capsules;
  std::vector<vesica_shapes_f64> sets;

  explicit Sets(Random& random)
      : ellipses(VESICA_ELLIPSE, each_set, random), capsules(VESICA_CAPSULE, each_set, random) {
    const auto place = [&] { return random.between(-2, 2); };
    for (int i = 0; i < each_set; ++i) {
      const auto quad = star(4, place(), place(), 0.8, 0.4, random);
      quads.insert(quads.end(), quad.begin(), quad.end());
      const double x = place(), y = place();
      holed.add_ring(star(7, x, y, 0.9, 0.8, random));
      if (random.chance(0.5)) holed.add_ring(star(5, x, y, 0.3, 0.5, random));
      polygons.push_back(static_cast<std::int32_t>(holed.ring_count()));
      scattered.emplace_back();
      scattered.back().add_ring(star(random.integer(3, 40), place(), place(), 0.7, 0.3, random));
      chains.add_ring(star(random.integer(1, 6), place(), place(), 0.7, 0.3, random));
    }
    for (const Path& path : scattered) structs.push_back(path.view());
    sets.resize(6);
    sets[0] = vertices(VESICA_POLYGON, quads);
    sets[0].each = 4;
    sets[1] = vertices(VESICA_POLYGON, holed.xy);
    sets[1].rings = holed.rings.data();
    sets[1].polygons = polygons.data();
    sets[1].each = static_cast<std::int64_t>(holed.xy.size() / 2);
    vesica_shapes_from_records_f64(VESICA_POLYGON, each_set, structs.data(), sizeof structs[0], &sets[2]);
    sets[3] = vertices(VESICA_POLYLINE, chains.xy);
    sets[3].rings = chains.rings.data();
    sets[4] = inflated::array(ellipses);
    sets[5] = inflated::array(capsules);
  }

  std::int64_t items() const { return each_set * static_cast<std::int64_t>(sets.size()); }

  /// Asks overlap of two items, each as a single shape.
  std::int32_t overlap(std::int64_t i, std::int64_t j) const {
    Single a, b;
    single(i, a);
    single(j, b);
    return vesica_overlap_f64(a.kind, a.shape, b.kind, b.shape);
  }
  std::int32_t within(std::int64_t i, std::int64_t j, double distance) const {
    Single a, b;
    single(i, a);
    single(j, b);
    return vesica_within_f64(a.kind, a.shape, b.kind, b.shape, distance);
  }

  /// The ratio of two items: its error, or 0.
  std::int32_t ratio(std::int32_t which, std::int64_t i, std::int64_t j, double& out) const {
    Single a, b;
    single(i, a);
    single(j, b);
    return vesica_ratio_f64(which, a.kind, a.shape, b.kind, b.shape, &out);
  }

  /// Casts item j, which moves, at item i.
  std::int32_t cast(std::int64_t i, std::int64_t j, double vx, double vy, double end, vesica_impact_f64& out) const {
    Single a, b;
    single(i, a);
    single(j, b);
    return vesica_cast_f64(a.kind, a.shape, b.kind, b.shape, vx, vy, end, &out);
  }
  /// An item alone, as an array of one in its set's layout.
  vesica_shapes_f64 alone(std::int64_t item) const {
    const auto set = static_cast<std::size_t>(item / each_set);
    vesica_shapes_f64 one = sets[set];
    const std::int64_t i = item % each_set;
    one.count = 1;
    if (set == 0) {
      one.field[0] += 8 * i;
      one.field[1] += 8 * i;
    } else if (set == 1) {
      one.polygons += i;
    } else if (set == 2) {
      one.field[0] = reinterpret_cast<const double*>(&structs[static_cast<std::size_t>(i)]);
    } else if (set == 3) {
      one.rings += i;
    } else {
      for (auto& field : one.field) field += field == nullptr ? 0 : i;
    }
    return one;
  }

 private:
  struct Single {
    std::int32_t kind;
    const void* shape;
    vesica_polygon_f64 path;
    inflated::Shape row;
  };

  static vesica_shapes_f64 vertices(std::int32_t kind, const std::vector<double>& xy) {
    vesica_shapes_f64 shapes{};
    shapes.kind = kind;
    shapes.count = each_set;
    shapes.stride = 16;
    shapes.field[0] = xy.data();
    shapes.field[1] = xy.data() + 1;
    return shapes;
  }

  void single(std::int64_t item, Single& out) const {
    const auto set = static_cast<std::size_t>(item / each_set), i = static_cast<std::size_t>(item % each_set);
    out.kind = sets[set].kind;
    out.shape = &out.path;
    switch (set) {
      case 0:
        out.path = {&quads[8 * i], &quads[8 * i + 1], 16, nullptr, 4};
        break;
      case 1:
        out.path = {holed.xy.data(), holed.xy.data() + 1, 16, &holed.rings[static_cast<std::size_t>(polygons[i])],
                    polygons[i + 1] - polygons[i]};
        break;
      case 2:
        out.path = structs[i];
        break;
      case 3:
        out.path = {chains.xy.data(), chains.xy.data() + 1, 16, &chains.rings[i], 1};
        break;
      default:
        out.row = (set == 4 ? ellipses : capsules).at(i);
        out.shape = out.row.number.data();
    }
  }
};

inline Room index_of(const Sets& sets) {
  Room index(vesica_index_size(sets.items())), scratch(vesica_index_scratch(sets.items()));
  EXPECT_GT(vesica_index_build_f64(sets.sets.data(), static_cast<std::int32_t>(sets.sets.size()), index.memory.get(),
                                   index.size, scratch.memory.get(), scratch.size),
            0);
  return index;
}

TEST(PolygonIndex, JoinsAsEveryPairAsked) {
  Random random(properties::seed());
  const Sets sets(random);
  const Room index = index_of(sets), scratch(vesica_join_scratch());
  std::set<std::pair<std::int64_t, std::int64_t>> expected, found;
  for (std::int64_t i = 0; i < sets.items(); ++i) {
    for (std::int64_t j = i + 1; j < sets.items(); ++j) {
      const std::int32_t answer = sets.overlap(i, j);
      ASSERT_GE(answer, 0);
      if (answer == 1) expected.insert({i, j});
    }
  }
  const auto join = [&](std::int32_t query, std::int64_t* a, std::int64_t* b, std::int64_t capacity,
                        std::int64_t* state) {
    const auto count = static_cast<std::int32_t>(sets.sets.size());
    return vesica_join_f64(query, index.memory.get(), sets.sets.data(), count, index.memory.get(), sets.sets.data(),
                           count, 0, 1, scratch.memory.get(), scratch.size, a, b, capacity, state);
  };
  constexpr std::int64_t room = 700;  // a few calls
  std::vector<std::int64_t> a(room), b(room);
  std::int64_t state[4] = {}, n = 0;
  while (state[0] != -1) {
    n = join(VESICA_JOIN_OVERLAP, a.data(), b.data(), room, state);
    ASSERT_GE(n, 0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) found.insert({a[i], b[i]});
  }
  EXPECT_GT(expected.size(), 1000U);
  EXPECT_EQ(found, expected);
  EXPECT_GE(join(VESICA_JOIN_BOUNDS, nullptr, nullptr, 0, nullptr), static_cast<std::int64_t>(expected.size()));
}

/// Pairs of every kind of path, and their ratios, bit for bit.
TEST(PolygonIndex, RatiosOfPairsThatMeet) {
  Random random(properties::seed());
  const Sets sets(random);
  const Room index = index_of(sets), scratch(vesica_join_scratch());
  const auto count = static_cast<std::int32_t>(sets.sets.size());
  std::size_t pairs = 0, without = 0;
  for (const auto& [which, threshold] : {std::pair{VESICA_RATIO_OVER_UNION, 0.0},
                                         {VESICA_RATIO_OVER_UNION, 0.3},
                                         {VESICA_RATIO_OVER_FIRST, 0.5},
                                         {VESICA_RATIO_GENERALIZED, -0.25}}) {
    std::map<std::pair<std::int64_t, std::int64_t>, double> expected, found;
    for (std::int64_t i = 0; i < sets.items(); ++i) {
      for (std::int64_t j = i + 1; j < sets.items(); ++j) {
        double ratio = 0;
        if (sets.overlap(i, j) != 1) continue;
        const bool has_one = sets.ratio(which, i, j, ratio) == 0;
        without += static_cast<std::size_t>(!has_one);
        if (has_one && ratio >= threshold) expected[{i, j}] = ratio;
      }
    }
    constexpr std::int64_t room = 700;  // a few calls
    std::vector<std::int64_t> a(room), b(room);
    std::vector<double> values(room);
    std::int64_t state[4] = {};
    while (state[0] != -1) {
      const std::int64_t n = vesica_join_ratio_f64(
          which, threshold, index.memory.get(), sets.sets.data(), count, index.memory.get(), sets.sets.data(), count, 0,
          1, scratch.memory.get(), scratch.size, a.data(), b.data(), values.data(), room, state);
      ASSERT_GE(n, 0);
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) found[{a[i], b[i]}] = values[i];
    }
    EXPECT_EQ(found, expected) << which << ' ' << threshold;
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 1000U);
  EXPECT_GT(without, 0U);  // polylines that cross
}

TEST(PolygonIndex, SelectsAsEveryItemAsked) {
  Random random(properties::seed());
  const Sets sets(random);
  const Room index = index_of(sets);
  std::size_t selected = 0;
  for (std::int64_t one = 0; one < sets.items(); one += 7) {
    const vesica_shapes_f64 single = sets.alone(one);
    std::set<std::int64_t> expected, found;
    for (std::int64_t j = 0; j < sets.items(); ++j) {
      if (sets.overlap(one, j) == 1) expected.insert(j);
    }
    std::int64_t state[4] = {}, out[40];
    while (state[0] != -1) {
      const std::int64_t n = vesica_index_select_f64(
          index.memory.get(), sets.sets.data(), static_cast<std::int32_t>(sets.sets.size()), &single, out, 40, state);
      ASSERT_GE(n, 0);
      found.insert(out, out + n);
    }
    ASSERT_EQ(found, expected) << one;
    selected += found.size();
  }
  EXPECT_GT(selected, 500U);
}

/// Items of every kind are cast at all others, from where they are and from outside.
TEST(PolygonIndex, CastsAsEveryItemAsked) {
  Random random(properties::seed());
  const Sets sets(random);
  const Room index = index_of(sets);
  const auto count = static_cast<std::int32_t>(sets.sets.size());
  std::size_t hits = 0, misses = 0, apart = 0;
  for (std::int64_t one = 0; one < sets.items(); one += random.integer(1, 5)) {
    const double x = random.between(-3, 3), y = random.chance(0.2) ? 0 : random.between(-3, 3),
                 end = random.chance(0.5) ? random.between(0, 1) : 8;
    const vesica_shapes_f64 single = sets.alone(one);
    std::set<std::int64_t> expected, found;
    std::int64_t first = sets.items();
    vesica_impact_f64 impact{}, earliest{HUGE_VAL, 0, 0, 0, 0};
    for (std::int64_t j = 0; j < sets.items(); ++j) {
      const std::int32_t code = sets.cast(j, one, x, y, end, impact);
      ASSERT_GE(code, 0);
      if (code == VESICA_CAST_MISS) continue;
      expected.insert(j);
      if (first < sets.items() && impact.t >= earliest.t) continue;
      first = j;
      earliest = impact;
    }
    std::int64_t state[4] = {}, out[40];
    while (state[0] != -1) {
      const std::int64_t n =
          vesica_index_cast_f64(index.memory.get(), sets.sets.data(), count, &single, x, y, end, out, 40, state);
      ASSERT_GE(n, 0);
      found.insert(out, out + n);
    }
    ASSERT_EQ(found, expected) << one;
    ASSERT_EQ(
        vesica_index_cast_f64(index.memory.get(), sets.sets.data(), count, &single, x, y, end, nullptr, 0, nullptr),
        static_cast<std::int64_t>(expected.size()));
    const std::int64_t item =
        vesica_index_cast_first_f64(index.memory.get(), sets.sets.data(), count, &single, x, y, end, &impact);
    ASSERT_EQ(item, first) << one;
    if (item < sets.items()) {
      ASSERT_EQ(std::memcmp(&impact, &earliest, sizeof impact), 0) << one;
      apart += earliest.t > 0 ? 1 : 0;
    }
    hits += found.size();
    misses += static_cast<std::size_t>(sets.items()) - found.size();
  }
  EXPECT_GT(std::min(hits, misses), 1000U);
  // Each item overlaps itself, so the first contact is at the start. Rays from outside reach others first.
  EXPECT_EQ(apart, 0U);
  for (int i = 0; i < 200; ++i) {
    const double turn = random.between(0, 6.28), x = 8 * std::cos(turn), y = 8 * std::sin(turn);
    const vesica_point_f64 from{x, y};
    const double vx = random.between(-1, 1) - x, vy = random.between(-1, 1) - y;
    vesica_shapes_f64 ray;
    ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_POINT, 1, &from, sizeof from, &ray), 0);
    std::int64_t first = sets.items();
    vesica_impact_f64 earliest{HUGE_VAL, 0, 0, 0, 0};
    for (std::size_t s = 0; s < sets.sets.size(); ++s) {
      vesica_impact_f64 of_set{};
      const std::int64_t k = vesica_cast_first_f64(&ray, &sets.sets[s], vx, vy, 2, &of_set);
      ASSERT_GE(k, 0);
      if (k == each_set || of_set.t >= earliest.t) continue;
      first = static_cast<std::int64_t>(s) * each_set + k;
      earliest = of_set;
    }
    vesica_impact_f64 impact{};
    ASSERT_EQ(vesica_index_cast_first_f64(index.memory.get(), sets.sets.data(), count, &ray, vx, vy, 2, &impact),
              first);
    if (first < sets.items()) {
      ASSERT_EQ(std::memcmp(&impact, &earliest, sizeof impact), 0);
      apart += impact.t > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(apart, 100U);
}

TEST(PolygonIndex, CastsInFloat) {
  const std::vector<float> quads{0, 0, 1, 0, 1, 1, 0, 1, 4, 0, 6, 1, 4, 2, 5, 1};
  vesica_shapes_f32 shapes{};
  shapes.kind = VESICA_POLYGON;
  shapes.count = 2;
  shapes.stride = 8;
  shapes.each = 4;
  shapes.field[0] = quads.data();
  shapes.field[1] = quads.data() + 1;
  Room index(vesica_index_size(2)), scratch(vesica_index_scratch(2));
  ASSERT_GT(vesica_index_build_f32(&shapes, 1, index.memory.get(), index.size, scratch.memory.get(), scratch.size), 0);
  vesica_shapes_f32 first = shapes;
  first.count = 1;
  vesica_impact_f32 impact{};
  vesica_shapes_f32 second = shapes;
  second.count = 1;
  second.field[0] += 8;
  second.field[1] += 8;
  EXPECT_EQ(vesica_index_cast_f32(index.memory.get(), &shapes, 1, &first, 1, 0, 4, nullptr, 0, nullptr), 2);
  EXPECT_EQ(vesica_index_cast_f32(index.memory.get(), &shapes, 1, &first, 1, 0, 2.5F, nullptr, 0, nullptr), 1);
  EXPECT_EQ(vesica_index_cast_first_f32(index.memory.get(), &shapes, 1, &second, -1, 0, 4, &impact), 1);
  const vesica_point_f32 point{2, 0.5};
  vesica_shapes_f32 ray;
  ASSERT_EQ(vesica_shapes_from_records_f32(VESICA_POINT, 1, &point, sizeof point, &ray), 0);
  EXPECT_EQ(vesica_index_cast_first_f32(index.memory.get(), &shapes, 1, &ray, 1, 0, 9, &impact), 1);
  EXPECT_EQ(impact.t, 2.5F);
  EXPECT_EQ(impact.x, 4.5F);
}

TEST(PolygonIndex, JoinsWithinADistance) {
  Random random(properties::seed());
  const Sets sets(random);
  const Room index = index_of(sets);
  const double distance = 0.2;
  std::set<std::pair<std::int64_t, std::int64_t>> expected, found;
  for (std::int64_t i = 0; i < sets.items(); ++i) {
    for (std::int64_t j = i + 1; j < sets.items(); ++j) {
      if (sets.within(i, j, distance) > 0) expected.insert({i, j});
    }
  }
  constexpr std::int64_t room = 900;  // a few calls
  std::vector<std::int64_t> a(room), b(room);
  std::int64_t state[4] = {};
  const auto count = static_cast<std::int32_t>(sets.sets.size());
  while (state[0] != -1) {
    const std::int64_t n =
        vesica_join_within_f64(index.memory.get(), sets.sets.data(), count, index.memory.get(), sets.sets.data(), count,
                               distance, 0, 1, a.data(), b.data(), room, state);
    ASSERT_GE(n, 0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) found.insert({a[i], b[i]});
  }
  EXPECT_GT(expected.size(), 1000U);
  EXPECT_EQ(found, expected);
}

TEST(PolygonIndex, LeavesOutABadPolygon) {
  Random random(properties::seed());
  Sets sets(random);
  sets.quads[8 * 17 + 3] = std::numeric_limits<double>::quiet_NaN();
  Room index(vesica_index_size(sets.items())), scratch(vesica_index_scratch(sets.items()));
  EXPECT_EQ(vesica_index_build_f64(sets.sets.data(), static_cast<std::int32_t>(sets.sets.size()), index.memory.get(),
                                   index.size, scratch.memory.get(), scratch.size),
            VESICA_E_SHAPE);
  std::vector<std::int64_t> order(static_cast<std::size_t>(sets.items()));
  EXPECT_EQ(vesica_index_order(index.memory.get(), order.data(), sets.items()), sets.items() - 1);
}

}  // namespace polygon_index
