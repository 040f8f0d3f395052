// SPDX-License-Identifier: Apache-2.0
// The regression corpus asked for overlaps and distances. corpus/README.md says where each row comes from.
#include "corpus/corpus.hpp"

#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cmath>
#include <vector>

namespace {

// The rows of each query; fewer means a damaged file.
constexpr std::size_t overlap_rows = 143;
constexpr std::size_t distance_rows = 45;

bool narrow(const properties::Numbers& numbers, properties::NumbersOf<float>& out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = static_cast<float>(numbers[i]);
    if (static_cast<double>(out[i]) != numbers[i]) return false;
  }
  return true;
}

/// Asks a row in both orders, in double and, where its numbers are floats, in float.
void expect_overlap(const corpus::Row& row, std::int32_t answer) {
  const auto& [kind_a, kind_b, a, b] = row.pair;
  EXPECT_EQ(vesica_overlap_f64(kind_a, a.data(), kind_b, b.data()), answer) << row.id;
  EXPECT_EQ(vesica_overlap_f64(kind_b, b.data(), kind_a, a.data()), answer) << row.id << " in the other order";
  properties::NumbersOf<float> a_f32{}, b_f32{};
  if (!narrow(a, a_f32) || !narrow(b, b_f32)) return;
  EXPECT_EQ(vesica_overlap_f32(kind_a, a_f32.data(), kind_b, b_f32.data()), answer) << row.id << " in float";
  EXPECT_EQ(vesica_overlap_f32(kind_b, b_f32.data(), kind_a, a_f32.data()), answer) << row.id << " in float, swapped";
}

/// In both orders, with the same bits.
void expect_distance(const corpus::Row& row) {
  const auto& [kind_a, kind_b, a, b] = row.pair;
  vesica_closest_points_f64 out{-1, 0, 0, 0, 0}, swapped{-2, 0, 0, 0, 0};
  EXPECT_EQ(vesica_nearest_f64(kind_a, a.data(), kind_b, b.data(), &out), 0) << row.id;
  EXPECT_EQ(vesica_nearest_f64(kind_b, b.data(), kind_a, a.data(), &swapped), 0) << row.id;
  EXPECT_EQ(out.distance, swapped.distance) << row.id;
  EXPECT_LE(std::fabs(out.distance - row.expected), row.tolerance) << row.id << ": " << out.distance;
}

TEST(Corpus, Overlap) {
  const std::vector<corpus::Row> rows = corpus::rows("overlap");
  ASSERT_GE(rows.size(), overlap_rows);
  for (const corpus::Row& row : rows) {
    ASSERT_TRUE(row.expected == 0 || row.expected == 1) << row.id;
    expect_overlap(row, static_cast<std::int32_t>(row.expected));
  }
}

TEST(Corpus, Distance) {
  const std::vector<corpus::Row> rows = corpus::rows("distance");
  ASSERT_GE(rows.size(), distance_rows);
  for (const corpus::Row& row : rows) expect_distance(row);
}

// A distance is 0 exactly where the shapes overlap.
TEST(Corpus, DistanceSaysWhetherTheyOverlap) {
  const std::vector<corpus::Row> rows = corpus::rows("distance");
  ASSERT_GE(rows.size(), distance_rows);
  for (const corpus::Row& row : rows) expect_overlap(row, row.expected == 0 ? 1 : 0);
}

}  // namespace
