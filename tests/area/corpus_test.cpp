// SPDX-License-Identifier: Apache-2.0
// The rows of the regression corpus that ask for an area or for intersection over union. corpus/README.md says how the
// expected values were made.
#include "corpus/corpus.hpp"

#include <gtest/gtest.h>
#include <vesica.h>

#include <cmath>
#include <vector>

namespace {

using Query = std::int32_t (*)(std::int32_t, const void*, std::int32_t, const void*, double*);

/// In both orders, with the same bits.
void expect_rows(const std::vector<corpus::Row>& rows, Query ask) {
  for (const corpus::Row& row : rows) {
    SCOPED_TRACE(row.id);
    const auto& [kind_a, kind_b, a, b] = row.pair;
    double out = -1, swapped = -2;
    EXPECT_EQ(ask(kind_a, a.data(), kind_b, b.data(), &out), 0);
    EXPECT_EQ(ask(kind_b, b.data(), kind_a, a.data(), &swapped), 0);
    EXPECT_EQ(out, swapped);
    EXPECT_LE(std::fabs(out - row.expected), row.tolerance) << out;
  }
}

// Fewer rows mean a damaged file.
TEST(AreaCorpus, Area) {
  const std::vector<corpus::Row> rows = corpus::rows("area");
  EXPECT_GE(rows.size(), 83U);
  expect_rows(rows, vesica_area_f64);
}

TEST(AreaCorpus, Iou) {
  const std::vector<corpus::Row> rows = corpus::rows("iou");
  EXPECT_GE(rows.size(), 52U);
  expect_rows(rows, vesica_iou_f64);
}

}  // namespace
