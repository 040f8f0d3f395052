// SPDX-License-Identifier: Apache-2.0
// Arrays, indexes and joins answer as single calls do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "inflated/shapes.hpp"

namespace {

using namespace inflated;
using properties::Random;

template <class T>
struct Api;
template <>
struct Api<double> {
  using Shapes = vesica_shapes_f64;
  static constexpr auto overlap_many = vesica_overlap_many_f64;
  static constexpr auto overlap_matrix = vesica_overlap_matrix_f64;
  static constexpr auto overlap_select = vesica_overlap_select_f64;
  static constexpr auto relation_many = vesica_relation_many_f64;
  static constexpr auto nearest_many = vesica_nearest_many_f64;
  static constexpr auto depth_many = vesica_depth_many_f64;
  static constexpr auto area_many = vesica_area_many_f64;
  static constexpr auto iou_many = vesica_iou_many_f64;
  static constexpr auto iou_matrix = vesica_iou_matrix_f64;
  static constexpr auto ratio_many = vesica_ratio_many_f64;
  static std::int32_t overlap(const Shape& a, const Shape& b) {
    return vesica_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data());
  }
};
template <>
struct Api<float> {
  using Shapes = vesica_shapes_f32;
  static constexpr auto overlap_many = vesica_overlap_many_f32;
  static constexpr auto overlap_matrix = vesica_overlap_matrix_f32;
  static constexpr auto overlap_select = vesica_overlap_select_f32;
  static constexpr auto relation_many = vesica_relation_many_f32;
  static constexpr auto nearest_many = vesica_nearest_many_f32;
  static constexpr auto depth_many = vesica_depth_many_f32;
  static constexpr auto area_many = vesica_area_many_f32;
  static constexpr auto iou_many = vesica_iou_many_f32;
  static constexpr auto iou_matrix = vesica_iou_matrix_f32;
  static constexpr auto ratio_many = vesica_ratio_many_f32;
  static std::int32_t overlap(const Shape& a, const Shape& b) { return Api<double>::overlap(a, b); }
};

template <class T>
class InflatedArrays : public ::testing::Test {};
using Scalars = ::testing::Types<double, float>;
TYPED_TEST_SUITE(InflatedArrays, Scalars);

constexpr int count = 301;  // not a multiple of any vector

TYPED_TEST(InflatedArrays, OverlapAsSingleCalls) {
  using A = Api<TypeParam>;
  Random random(properties::seed());
  for (std::int32_t kind = 0; kind < 8; ++kind) {
    for (const std::int32_t other : kinds) {
      const Columns<TypeParam> first(kind, count, random), second(other, count, random);
      const auto a = array(first), b = array(second);
      std::vector<std::uint8_t> out(count, 9), rows(20 * count, 9);
      std::int64_t expected = 0;
      const std::int64_t found = A::overlap_many(&a, &b, out.data());
      for (std::size_t i = 0; i < out.size(); ++i) {
        const std::int32_t one = A::overlap(first.at(i), second.at(i));
        expected += one;
        ASSERT_EQ(out[i], one) << kind << ", " << other << ", " << i;
      }
      EXPECT_EQ(found, expected);
      auto few = a;
      few.count = 20;
      EXPECT_GE(A::overlap_matrix(&few, &b, rows.data(), count), 0);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i], A::overlap(first.at(i / count), second.at(i % count))) << kind << ", " << other;
      }
    }
  }
}

TYPED_TEST(InflatedArrays, SelectsTheSame) {
  using A = Api<TypeParam>;
  Random random(properties::seed());
  const Columns<TypeParam> one(VESICA_CAPSULE, 1, random), many(VESICA_ROUND_RECT, count, random);
  const auto a = array(one), b = array(many);
  std::vector<std::int64_t> out(count + 1), expected;
  for (std::int64_t i = 0; i < count; ++i) {
    if (A::overlap(one.at(0), many.at(static_cast<std::size_t>(i))) == 1) expected.push_back(i);
  }
  const std::int64_t found = A::overlap_select(&a, &b, out.data(), count + 1);
  ASSERT_EQ(found, static_cast<std::int64_t>(expected.size()));
  EXPECT_EQ(out[expected.size()], -1);
  out.resize(expected.size());
  EXPECT_EQ(out, expected);
}

TEST(InflatedArrays, NumbersAsSingleCalls) {
  Random random(properties::seed());
  for (std::int32_t kind = 0; kind < 8; ++kind) {
    const Columns<double> first(kind, count, random), second(VESICA_ROUND_RECT, count, random);
    const auto a = array(first), b = array(second);
    std::vector<double> column[5];
    for (auto& c : column) c.resize(count);
    ASSERT_GE(vesica_nearest_many_f64(&a, &b, column[0].data(), column[1].data(), column[2].data(), column[3].data(),
                                      column[4].data()),
              0);
    for (std::size_t i = 0; i < count; ++i) {
      vesica_closest_points_f64 one;
      const Shape s = first.at(i), t = second.at(i);
      ASSERT_EQ(vesica_nearest_f64(s.kind, s.number.data(), t.kind, t.number.data(), &one), 0);
      ASSERT_EQ(column[0][i], one.distance);
      ASSERT_EQ(column[1][i], one.ax);
      ASSERT_EQ(column[4][i], one.by);
    }
    ASSERT_GE(vesica_depth_many_f64(&a, &b, column[0].data(), column[1].data(), column[2].data()), 0);
    std::vector<std::uint8_t> codes(count);
    ASSERT_GE(vesica_relation_many_f64(&a, &b, codes.data()), 0);
    for (std::size_t i = 0; i < count; ++i) {
      vesica_penetration_f64 one;
      const Shape s = first.at(i), t = second.at(i);
      ASSERT_EQ(vesica_depth_f64(s.kind, s.number.data(), t.kind, t.number.data(), &one), 0);
      ASSERT_EQ(column[0][i], one.depth);
      ASSERT_EQ(column[1][i], one.x);
      ASSERT_EQ(codes[i], vesica_relation_f64(s.kind, s.number.data(), t.kind, t.number.data()));
    }
  }
}

TYPED_TEST(InflatedArrays, SharedAreasAsSingleCalls) {
  using A = Api<TypeParam>;
  Random random(properties::seed());
  for (std::int32_t kind = 0; kind < 8; ++kind) {
    for (const std::int32_t other : kinds) {
      const Columns<TypeParam> first(kind, count, random), second(other, count, random);
      const auto a = array(first), b = array(second);
      std::vector<TypeParam> shared(count), part(count), part_matrix(20 * count), giou(count);
      ASSERT_GE(A::area_many(&a, &b, shared.data()), 0);
      ASSERT_GE(A::iou_many(&a, &b, part.data()), 0);
      ASSERT_GE(A::ratio_many(VESICA_RATIO_GENERALIZED, &a, &b, giou.data()), 0);
      auto few = a;
      few.count = 20;
      ASSERT_GE(A::iou_matrix(&few, &b, part_matrix.data(), count), 0);
      for (std::size_t i = 0; i < count; ++i) {
        const Shape s = first.at(i), t = second.at(i);
        double one = -1;
        ASSERT_EQ(vesica_area_f64(s.kind, s.number.data(), t.kind, t.number.data(), &one), 0);
        ASSERT_EQ(shared[i], static_cast<TypeParam>(one)) << kind << ", " << other << ", " << i;
        ASSERT_EQ(vesica_iou_f64(s.kind, s.number.data(), t.kind, t.number.data(), &one), 0);
        ASSERT_EQ(part[i], static_cast<TypeParam>(one)) << kind << ", " << other << ", " << i;
        ASSERT_EQ(vesica_ratio_f64(VESICA_RATIO_GENERALIZED, s.kind, s.number.data(), t.kind, t.number.data(), &one),
                  0);
        ASSERT_EQ(giou[i], static_cast<TypeParam>(one)) << kind << ", " << other << ", " << i;
      }
      for (std::size_t i = 0; i < 20; ++i) ASSERT_EQ(part_matrix[i * count + i], part[i]) << kind << ", " << other;
    }
  }
}

/// The shapes that remain after suppression, asked pair by pair.
std::vector<std::int64_t> kept_one_by_one(const Columns<double>& shapes, double threshold) {
  std::vector<std::int64_t> kept;
  for (std::int64_t i = 0; i < count; ++i) {
    const Shape s = shapes.at(static_cast<std::size_t>(i));
    const bool suppressed = std::ranges::any_of(kept, [&](std::int64_t k) {
      const Shape t = shapes.at(static_cast<std::size_t>(k));
      double ratio = 0;
      EXPECT_EQ(vesica_iou_f64(s.kind, s.number.data(), t.kind, t.number.data(), &ratio), 0);
      return ratio > threshold;
    });
    if (!suppressed) kept.push_back(i);
  }
  return kept;
}

TEST(InflatedArrays, SuppressAsSingleCalls) {
  Random random(properties::seed());
  for (const std::int32_t kind : kinds) {
    const Columns<double> shapes(kind, count, random);
    const auto a = array(shapes);
    std::vector<double> score(count), decayed(count);
    for (std::size_t i = 0; i < count; ++i) score[i] = 1.0 - static_cast<double>(i) / count;
    for (const double threshold : {0.05, 0.3}) {
      const std::vector<std::int64_t> expected = kept_one_by_one(shapes, threshold);
      const std::int64_t size = vesica_nms_scratch(count), soft_size = vesica_suppress_soft_scratch(count);
      const std::unique_ptr<double[]> scratch(new double[static_cast<std::size_t>(std::max(size, soft_size) / 8 + 1)]);
      std::vector<std::int64_t> keep(count), softly(count);
      std::int64_t kept = 0;
      ASSERT_EQ(vesica_nms_f64(&a, score.data(), threshold, scratch.get(), size, keep.data(), &kept), 0);
      keep.resize(static_cast<std::size_t>(kept));
      EXPECT_EQ(keep, expected);
      EXPECT_LT(kept, count);
      // A Gaussian so narrow that any ratio suppresses: the shapes kept share nothing.
      ASSERT_EQ(
          vesica_suppress_soft_f64(&a, score.data(), nullptr, VESICA_RATIO_OVER_UNION, VESICA_DECAY_GAUSSIAN, 1e-20,
                                   1e-9, count, scratch.get(), soft_size, softly.data(), decayed.data(), &kept),
          0);
      softly.resize(static_cast<std::size_t>(kept));
      EXPECT_EQ(softly, kept_one_by_one(shapes, 1e-9));
    }
  }
}

/// Memory for an index, at the alignment that it needs.
struct Room {
  std::unique_ptr<void, decltype(&std::free)> memory;
  std::int64_t size;
  explicit Room(std::int64_t bytes)
      : memory(std::aligned_alloc(64, static_cast<std::size_t>((bytes + 63) / 64 * 64)), std::free), size(bytes) {}
};

Room index_of(const std::vector<vesica_shapes_f64>& sets, std::int64_t items) {
  Room index(vesica_index_size(items)), scratch(vesica_index_scratch(items));
  EXPECT_GT(vesica_index_build_f64(sets.data(), static_cast<std::int32_t>(sets.size()), index.memory.get(), index.size,
                                   scratch.memory.get(), scratch.size),
            0);
  return index;
}

using Pairs = std::set<std::pair<std::int64_t, std::int64_t>>;

/// Fifty shapes of each of some kinds, and their index.
struct Many {
  std::vector<Columns<double>> columns;
  std::vector<vesica_shapes_f64> sets;
  Room index;

  Many(const std::vector<std::int32_t>& kinds, Random& random)
      : columns(drawn(kinds, random)), sets(arrays(columns)), index(index_of(sets, items())) {}
  std::int64_t items() const { return 50 * static_cast<std::int64_t>(sets.size()); }
  Shape at(std::int64_t i) const {
    const auto item = static_cast<std::size_t>(i);
    return columns[item / 50].at(item % 50);
  }

 private:
  static std::vector<Columns<double>> drawn(const std::vector<std::int32_t>& kinds, Random& random) {
    std::vector<Columns<double>> all;
    for (const std::int32_t kind : kinds) all.emplace_back(kind, 50, random);
    return all;
  }
  static std::vector<vesica_shapes_f64> arrays(const std::vector<Columns<double>>& columns) {
    std::vector<vesica_shapes_f64> sets;
    for (const auto& c : columns) sets.push_back(array(c));
    return sets;
  }
};

/// The join's pairs, or how many there are, negative for an error.
std::int64_t join(std::int32_t query, const Many& a, const Many& b, Pairs& found) {
  const auto most = static_cast<std::size_t>(a.items() * b.items());
  Room scratch(vesica_join_scratch());
  std::vector<std::int64_t> first(most), second(most);
  std::int64_t state[16] = {};
  const auto sets = [](const Many& m) { return static_cast<std::int32_t>(m.sets.size()); };
  const std::int64_t n = vesica_join_f64(query, a.index.memory.get(), a.sets.data(), sets(a), b.index.memory.get(),
                                         b.sets.data(), sets(b), 0, 1, scratch.memory.get(), scratch.size, first.data(),
                                         second.data(), static_cast<std::int64_t>(most), state);
  for (std::size_t i = 0; n > 0 && i < static_cast<std::size_t>(n); ++i) found.insert({first[i], second[i]});
  return n;
}

TEST(InflatedIndex, JoinsAsEveryPairAsked) {
  Random random(properties::seed());
  const Many all({0, 1, 2, 3, 4, 5, 6, 7}, random);
  Pairs expected, found;
  for (std::int64_t i = 0; i < all.items(); ++i) {
    for (std::int64_t j = i + 1; j < all.items(); ++j) {
      if (Api<double>::overlap(all.at(i), all.at(j)) == 1) expected.insert({i, j});
    }
  }
  ASSERT_GT(join(VESICA_JOIN_OVERLAP, all, all, found), 0);
  EXPECT_EQ(found, expected);
}

TEST(InflatedIndex, JoinsByContainment) {
  Random random(properties::seed());
  const Many a({VESICA_CAPSULE, VESICA_CIRCLE, VESICA_ROUND_RECT, VESICA_RECT}, random);
  const Many b({VESICA_POINT, VESICA_SEGMENT, VESICA_ROUND_RECT, VESICA_CAPSULE, VESICA_AABB}, random);
  Pairs holds, lies_in, contained, inside;
  for (std::int64_t i = 0; i < a.items(); ++i) {
    for (std::int64_t j = 0; j < b.items(); ++j) {
      const Shape p = a.at(i), q = b.at(j);
      if (vesica_contains_f64(p.kind, p.number.data(), q.kind, q.number.data()) == 1) holds.insert({i, j});
      if (vesica_contains_f64(q.kind, q.number.data(), p.kind, p.number.data()) == 1) lies_in.insert({i, j});
    }
  }
  EXPECT_GT(holds.size(), 100U);
  EXPECT_GT(lies_in.size(), 10U);
  ASSERT_GT(join(VESICA_JOIN_CONTAINS, a, b, contained), 0);
  ASSERT_GT(join(VESICA_JOIN_INSIDE, a, b, inside), 0);
  EXPECT_EQ(contained, holds);
  EXPECT_EQ(inside, lies_in);
}

/// A join takes the kinds that the function about two shapes takes, whichever set of either side they are in.
TEST(InflatedIndex, JoinsByContainmentTakeTheKindsThatContainsTakes) {
  Random random(properties::seed());
  for (std::int32_t kind_a = 0; kind_a < 8; ++kind_a) {
    for (std::int32_t kind_b = 0; kind_b < 8; ++kind_b) {
      const Many a({VESICA_RECT, kind_a}, random), b({VESICA_POINT, kind_b}, random);
      const Shape p = shape(kind_a, random), q = shape(kind_b, random);
      const bool known = vesica_contains_f64(kind_a, p.number.data(), kind_b, q.number.data()) >= 0;
      Pairs found;
      for (const std::int32_t query : {VESICA_JOIN_CONTAINS, VESICA_JOIN_INSIDE}) {
        const std::int64_t n = join(query, a, b, found);
        EXPECT_EQ(n >= 0, known) << kind_a << ' ' << kind_b;
        EXPECT_EQ(n < 0 ? n : VESICA_E_KIND, VESICA_E_KIND);
      }
    }
  }
}

TEST(InflatedIndex, NearestOfASegment) {
  Random random(properties::seed());
  const Columns<double> capsules(VESICA_CAPSULE, 200, random), rects(VESICA_ROUND_RECT, 200, random);
  const std::vector<vesica_shapes_f64> sets{array(capsules), array(rects)};
  const Room index = index_of(sets, 400);
  const Columns<double> one(VESICA_SEGMENT, 1, random);
  const auto asked = array(one);
  std::vector<std::int64_t> out(3);
  std::vector<double> distance(3);
  ASSERT_EQ(vesica_index_nearest_f64(index.memory.get(), sets.data(), 2, &asked, 3, 100, out.data(), distance.data()),
            3);
  std::vector<double> all;
  for (std::size_t i = 0; i < 400; ++i) {
    const Shape s = i < 200 ? capsules.at(i) : rects.at(i - 200), t = one.at(0);
    vesica_closest_points_f64 points;
    ASSERT_EQ(vesica_nearest_f64(t.kind, t.number.data(), s.kind, s.number.data(), &points), 0);
    all.push_back(points.distance);
  }
  std::ranges::sort(all);
  EXPECT_EQ(distance, std::vector<double>(all.begin(), all.begin() + 3));
}

}  // namespace
