// SPDX-License-Identifier: Apache-2.0
// The regression corpus asked for relations: each row against the oracle, against its own expected answer (no overlap,
// a distance or an area says something about the relation), and where the reported relation is known, against that.
#include "corpus/corpus.hpp"

#include <gtest/gtest.h>
#include <vesica.h>

#include <map>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
#include "relation/answers.hpp"

namespace {

using properties::has_area;
using properties::Pair;
using properties::Scalar;

constexpr std::size_t rows_in_file = 323;

/// The ten positions of two ellipses, and others whose reports are about touching or containment.
const std::map<std::string, std::int32_t> known{
    {"eeover-test-file-10testcases-1", VESICA_CROSS},
    {"eeover-test-file-10testcases-3", VESICA_CROSS},
    {"eeover-test-file-10testcases-5", VESICA_DISJOINT},
    {"eeover-test-file-10testcases-7", VESICA_CONTAINS},
    {"eeover-test-file-10testcases-9", VESICA_INSIDE},
    {"eeover-test-file-10testcases-11", VESICA_CROSS},
    {"eeover-test-file-10testcases-13", VESICA_CROSS},
    {"eeover-test-file-10testcases-15", VESICA_TOUCH},
    {"eeover-test-file-10testcases-21", VESICA_CONTAINS_TOUCH},
    {"eeover-test-file-10testcases-23", VESICA_INSIDE_TOUCH},
    {"eeover-test-file-10testcases-25", VESICA_EQUAL},
    {"rotated-iou-8-1", VESICA_TOUCH},
    {"rotated-iou-8-7", VESICA_CROSS},
    {"rotated-iou-8-10", VESICA_EQUAL},
    {"mmcv-2621-1", VESICA_EQUAL},
    {"rotated-maskrcnn-46-1", VESICA_EQUAL},
    {"opencv-18520-1", VESICA_DISJOINT},
    {"detectron2-1266-1", VESICA_DISJOINT},
};

/// The relation that follows from the row's own answer.
void expect_agreement(const corpus::Row& row, std::int32_t code) {
  const Pair& pair = row.pair;
  const bool overlapping = code != VESICA_DISJOINT, crossing = overlapping && code != VESICA_TOUCH;
  const bool areal = has_area(pair.kind_a, pair.a) && has_area(pair.kind_b, pair.b);
  if (row.query == "overlap") {
    EXPECT_EQ(overlapping, row.expected == 1);
  } else if (row.query == "distance") {
    EXPECT_EQ(overlapping, row.expected == 0);
  } else if (areal) {
    EXPECT_EQ(crossing, row.expected > 0);
  }
  if (pair.kind_a == pair.kind_b && pair.a == pair.b) {
    EXPECT_EQ(code, VESICA_EQUAL);
  }
}

TEST(RelationCorpus, EveryRow) {
  const std::vector<corpus::Row> rows = corpus::rows();
  std::size_t met = 0;
  for (const corpus::Row& row : rows) {
    SCOPED_TRACE(row.id);
    const Pair& pair = row.pair;
    const std::int32_t code = relations::relation(Scalar::f64, pair);
    EXPECT_EQ(code, oracle::relation(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data()));
    EXPECT_EQ(relations::contains(Scalar::f64, pair), relations::says_contains(code));
    expect_agreement(row, code);
    if (const auto reported = known.find(row.id); reported != known.end()) {
      EXPECT_EQ(code, reported->second);
      ++met;
    }
  }
  EXPECT_EQ(rows.size(), rows_in_file);
  EXPECT_EQ(met, known.size());
}

}  // namespace
