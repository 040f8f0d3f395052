// SPDX-License-Identifier: Apache-2.0
// The regression corpus asked for relations: each row against the oracle, against its own expected answer (no overlap,
// a distance or an area says something about the relation), and where the reported relation is known, against that.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
#include "relation/answers.hpp"

namespace {

using properties::Pair;
using properties::Scalar;

constexpr std::size_t rows_in_file = 267;

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

enum Column { id, source, kind_a, a0, kind_b = 9, b0, query = 16, expected, tolerance, note, column_count };

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  fields.resize(column_count);
  return fields;
}

void read_shape(const std::vector<std::string>& fields, std::size_t column, int& kind, properties::Numbers& numbers) {
  kind = -1;
  for (int k = VESICA_POINT; k <= VESICA_ELLIPSE; ++k) {
    if (fields[column] == vesica_kind_name(k)) kind = k;
  }
  ASSERT_GE(kind, 0) << fields[column];
  numbers = {};
  for (int i = 0; i < vesica_field_count(kind); ++i) {
    numbers[static_cast<std::size_t>(i)] =
        std::strtod(fields[column + 1 + static_cast<std::size_t>(i)].c_str(), nullptr);
  }
}

bool has_area(int kind, const properties::Numbers& n) {
  if (kind == VESICA_CIRCLE) return n[2] > 0;
  if (kind == VESICA_AABB) return n[0] < n[2] && n[1] < n[3];
  return kind >= VESICA_RECT && n[4] > 0 && n[5] > 0;
}

/// What the row's own answer says about the relation.
void expect_agreement(const std::vector<std::string>& fields, const Pair& pair, std::int32_t code) {
  const double answer = std::strtod(fields[expected].c_str(), nullptr);
  const bool overlapping = code != VESICA_DISJOINT, crossing = overlapping && code != VESICA_TOUCH;
  const bool areal = has_area(pair.kind_a, pair.a) && has_area(pair.kind_b, pair.b);
  if (fields[query] == "overlap") {
    EXPECT_EQ(overlapping, answer == 1);
  } else if (fields[query] == "distance") {
    EXPECT_EQ(overlapping, answer == 0);
  } else if (areal) {
    EXPECT_EQ(crossing, answer > 0);
  }
  if (pair.kind_a == pair.kind_b && pair.a == pair.b) {
    EXPECT_EQ(code, VESICA_EQUAL);
  }
}

TEST(RelationCorpus, EveryRow) {
  std::ifstream file(VESICA_CORPUS);
  ASSERT_TRUE(file.is_open()) << "missing " << VESICA_CORPUS;
  std::string line;
  std::getline(file, line);  // The names of the columns.
  std::size_t rows = 0, met = 0;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = split(line);
    SCOPED_TRACE(fields[id]);
    Pair pair{};
    read_shape(fields, kind_a, pair.kind_a, pair.a);
    read_shape(fields, kind_b, pair.kind_b, pair.b);
    const std::int32_t code = relations::relation(Scalar::f64, pair);
    EXPECT_EQ(code, oracle::relation(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data()));
    EXPECT_EQ(relations::contains(Scalar::f64, pair), relations::says_contains(code));
    expect_agreement(fields, pair, code);
    if (const auto row = known.find(fields[id]); row != known.end()) {
      EXPECT_EQ(code, row->second);
      ++met;
    }
    ++rows;
  }
  EXPECT_EQ(rows, rows_in_file);
  EXPECT_EQ(met, known.size());
}

}  // namespace
