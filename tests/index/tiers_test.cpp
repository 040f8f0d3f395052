// SPDX-License-Identifier: Apache-2.0
/// Sets made against the plan of a build: tier beneath tier to the last, cells that would take more room than the index
/// has, and shapes that are overwritten while the build is under way. Answers are those of all shapes asked one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "index/face.hpp"
#include "properties/random.hpp"

namespace index_tests {
namespace {

void add_box(Records<double>& to, double x, double y, double half_width, double half_height) {
  to.numbers.insert(to.numbers.end(), {x - half_width, y - half_height, x + half_width, y + half_height});
}

/// How many of the boxes meet a window, by the index and one by one.
void expect_selected(const Indexed<double>& indexed, const double (&window)[4]) {
  const std::vector<double>& n = indexed.laid[0].numbers;
  std::int64_t expected = 0;
  for (std::size_t i = 0; i < n.size(); i += 4) {
    expected += n[i] <= window[2] && n[i + 2] >= window[0] && n[i + 1] <= window[3] && n[i + 3] >= window[1];
  }
  vesica_shapes_f64 one;
  Face<double>::from_records(VESICA_AABB, 1, window, 0, &one);
  EXPECT_EQ(Face<double>::index_select(indexed.index.get(), indexed.sets.data(), 1, &one, nullptr, 0, nullptr),
            expected)
      << window[0] << ' ' << window[1] << ' ' << window[2] << ' ' << window[3];
}

/// Each tier has a grid for the eighth that is smallest, in which the rest, a million times larger, does not fit.
Records<double> scales_within_scales(std::int64_t n) {
  Records<double> boxes{VESICA_AABB, {}};
  properties::Random random(1);
  double size = 0x1p-500;
  for (std::int64_t rest = n; rest > 0; size *= 0x1p20) {
    const std::int64_t some = rest / 8 + 1;
    for (std::int64_t i = 0; i < some; ++i) {
      const double x = size * random.between(-1, 1), y = size * random.between(-1, 1);
      add_box(boxes, x, y, size, size * random.unit());
    }
    rest -= some;
  }
  return boxes;
}

TEST(Tiers, ToTheDeepest) {
  const Indexed<double> all(scales_within_scales(768));
  EXPECT_EQ(vesica_index_check(all.index.get(), all.result), 0);
  for (int exponent = -510; exponent < 200; exponent += 7) {
    const double s = std::ldexp(1.0, exponent);
    expect_selected(all, {0.25 * s, 0.5 * s, s, s});
    expect_selected(all, {-s, -s, -0.5 * s, s});
  }
  std::int64_t expected = 0;
  const std::vector<double>& n = all.laid[0].numbers;
  for (std::size_t i = 0; i < n.size(); i += 4) {
    for (std::size_t k = i + 4; k < n.size(); k += 4) {
      expected += vesica_overlap_f64(VESICA_AABB, &n[i], VESICA_AABB, &n[k]);
    }
  }
  EXPECT_EQ(count(VESICA_JOIN_OVERLAP, all, all), expected);
}

/// 4,096 points, which alone the plan of 81,600 shapes samples, and between them 16 crowds. Most of a crowd is too
/// long, or too tall, for the grids that the crowd's own plan makes; these are planned for cells of 64 and have 33 in
/// each, so that every other leaf has one item.
Records<double> crowds_of_long_and_tall(std::int64_t n, std::int64_t samples) {
  Records<double> boxes{VESICA_AABB, {}};
  properties::Random random(2);
  std::int64_t sample = 0, crowded = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    if (sample < samples && i == sample * n / samples) {
      add_box(boxes, static_cast<double>(sample % 64) / 64, static_cast<double>(sample / 64) / 64, 0, 0);
      ++sample;
      continue;
    }
    const std::int64_t crowd = crowded % 16, member = crowded / 16 % 39;
    ++crowded;
    const double x = (static_cast<double>(crowd % 4 * 16 + 8) + 0.5) / 64 + random.unit() * 0x1p-12;
    const double y = (static_cast<double>(crowd / 4 * 16 + 8) + 0.5) / 64 + random.unit() * 0x1p-12;
    add_box(boxes, x, y, member < 17 ? 0x1p-8 : 0x1p-30, member >= 17 && member < 34 ? 0x1p-8 : 0x1p-30);
  }
  return boxes;
}

TEST(Tiers, NoRoomForCells) {
  const Indexed<double> all(crowds_of_long_and_tall(81600, 4096));
  EXPECT_GT(all.result, 0);
  EXPECT_LE(all.result, all.index.size);
  EXPECT_EQ(vesica_index_check(all.index.get(), all.result), 0);
  for (int crowd = 0; crowd < 16; ++crowd) {
    const double x = (crowd % 4 * 16 + 8.5) / 64, y = (crowd / 4 * 16 + 8.5) / 64;
    for (const double s : {0x1p-7, 0x1p-12, 0x1p-14, 0x1p-20}) expect_selected(all, {x, y, x + s, y + s});
  }
  expect_selected(all, {-1, -1, 2, 2});
  expect_selected(all, {0.1, 0.1, 0.7, 0.9});
}

/// 900 of a thousand boxes are wider than the greatest number: they fit only the grid for all.
Records<double> wider_than_any_grid() {
  Records<double> boxes{VESICA_AABB, {}};
  for (int i = 0; i < 1000; ++i) {
    const double x = i % 10 == 0 ? i : 0x1.8p1023;
    boxes.numbers.insert(boxes.numbers.end(), {-x, static_cast<double>(i), x, i + 0.5});
  }
  return boxes;
}

TEST(Tiers, OneGridForAll) {
  const Indexed<double> all(wider_than_any_grid());
  EXPECT_EQ(vesica_index_check(all.index.get(), all.result), 0);
  for (const double x : {0.0, 10.0, 995.0, 0x1p1000}) {
    for (const double y : {-1.0, 0.25, 500.75, 990.0}) expect_selected(all, {-x, y, x, y + 3});
  }
}

/// Shapes must not change between the steps. If they do, the build writes nowhere else, and leaves those out that have
/// become invalid before their cell was found.
TEST(Tiers, OverwrittenBetweenSteps) {
  for (const Records<double>& records :
       {crowds_of_long_and_tall(81600, 4096), scales_within_scales(768), wider_than_any_grid()}) {
    const Laid<double> laid{records};
    const Sets<double> sets(laid);
    const Memory index(vesica_index_size(sets.items)), scratch(vesica_index_scratch(sets.items));
    // The records that the sets point at.
    auto* numbers = const_cast<double*>(laid[0].numbers.data());
    std::int64_t result = 0;
    for (std::int32_t step = 0; step < 5; ++step) {
      if (step == 4) {
        for (std::int64_t i = 3; i < sets.items; i += 4) {
          numbers[4 * i] = std::numeric_limits<double>::quiet_NaN();
        }
      }
      result = vesica_index_step_f64(step, 0, 1, sets.data(), sets.count(), index.get(), index.size, scratch.get(),
                                     scratch.size);
    }
    EXPECT_EQ(result, VESICA_E_SHAPE);
    EXPECT_EQ(vesica_index_check(index.get(), index.size), 0);
    std::vector<std::int64_t> order(static_cast<std::size_t>(sets.items));
    const std::int64_t placed = vesica_index_order(index.get(), order.data(), sets.items);
    EXPECT_GT(placed, sets.items / 2);
    EXPECT_LT(placed, sets.items);
    std::vector<bool> seen(static_cast<std::size_t>(sets.items));
    for (std::int64_t i = 0; i < placed; ++i) {
      const auto item = static_cast<std::size_t>(order[static_cast<std::size_t>(i)]);
      ASSERT_LT(item, seen.size());
      EXPECT_FALSE(seen[item]);
      seen[item] = true;
    }
  }
}

}  // namespace
}  // namespace index_tests
