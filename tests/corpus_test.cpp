// SPDX-License-Identifier: Apache-2.0
// The regression corpus: inputs other libraries got wrong. corpus/README.md says where each row comes from.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

// The rows of each query; fewer means a damaged file.
constexpr std::size_t overlap_rows = 119;
constexpr std::size_t distance_rows = 35;

struct Shape {
  std::int32_t kind = VESICA_E_KIND;
  std::array<double, 6> number{};
};

struct Row {
  std::string id, query;
  Shape a, b;
  double expected = 0;
};

// Columns: id, source, kind_a, a0..a5, kind_b, b0..b5, query, expected, tolerance, note. No field holds a comma.
enum Column { id, source, kind_a, a0, kind_b = 9, b0, query = 16, expected, tolerance, note, column_count };

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  fields.resize(column_count);
  return fields;
}

/// The whole field as a number; a field that is none fails the test.
double number(const std::string& field) {
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  EXPECT_TRUE(!field.empty() && *end == '\0') << '"' << field << "\" is no number";
  return value;
}

Shape shape(const std::vector<std::string>& fields, std::size_t kind_column) {
  Shape result;
  for (std::int32_t kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) {
    if (fields[kind_column] == vesica_kind_name(kind)) result.kind = kind;
  }
  EXPECT_GE(result.kind, 0) << "unknown kind \"" << fields[kind_column] << '"';
  for (int i = 0; i < vesica_field_count(result.kind); ++i) {
    const auto place = static_cast<std::size_t>(i);
    result.number[place] = number(fields[kind_column + 1 + place]);
  }
  return result;
}

std::vector<Row> rows_of(const std::string& wanted) {
  std::ifstream file(VESICA_CORPUS);
  EXPECT_TRUE(file.is_open()) << "missing " << VESICA_CORPUS;
  std::vector<Row> rows;
  std::string line;
  std::getline(file, line);  // The names of the columns.
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = split(line);
    if (fields[query] != wanted) continue;
    SCOPED_TRACE(fields[id]);
    rows.push_back({fields[id], fields[query], shape(fields, kind_a), shape(fields, kind_b), number(fields[expected])});
  }
  return rows;
}

bool narrow(const Shape& s, std::array<float, 6>& out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = static_cast<float>(s.number[i]);
    if (static_cast<double>(out[i]) != s.number[i]) return false;
  }
  return true;
}

/// Asks a row in both orders, in double and, where its numbers are floats, in float.
void expect_overlap(const Row& row, std::int32_t answer) {
  const auto& [kind_a, a] = row.a;
  const auto& [kind_b, b] = row.b;
  EXPECT_EQ(vesica_overlap_f64(kind_a, a.data(), kind_b, b.data()), answer) << row.id;
  EXPECT_EQ(vesica_overlap_f64(kind_b, b.data(), kind_a, a.data()), answer) << row.id << " in the other order";
  std::array<float, 6> a_f32{}, b_f32{};
  if (!narrow(row.a, a_f32) || !narrow(row.b, b_f32)) return;
  EXPECT_EQ(vesica_overlap_f32(kind_a, a_f32.data(), kind_b, b_f32.data()), answer) << row.id << " in float";
  EXPECT_EQ(vesica_overlap_f32(kind_b, b_f32.data(), kind_a, a_f32.data()), answer) << row.id << " in float, swapped";
}

TEST(Corpus, Overlap) {
  const std::vector<Row> rows = rows_of("overlap");
  ASSERT_GE(rows.size(), overlap_rows);
  for (const Row& row : rows) {
    ASSERT_TRUE(row.expected == 0 || row.expected == 1) << row.id;
    expect_overlap(row, static_cast<std::int32_t>(row.expected));
  }
}

// A distance is 0 exactly where the shapes overlap.
TEST(Corpus, DistanceSaysWhetherTheyOverlap) {
  const std::vector<Row> rows = rows_of("distance");
  ASSERT_GE(rows.size(), distance_rows);
  for (const Row& row : rows) expect_overlap(row, row.expected == 0 ? 1 : 0);
}

}  // namespace
