// SPDX-License-Identifier: Apache-2.0
// The rows of the regression corpus that ask for an area or for intersection over union. corpus/README.md tells how the
// expected values were made.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

enum Column { id, source, kind_a, a0, kind_b = 9, b0, query = 16, expected, tolerance, note, column_count };

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  fields.resize(column_count);
  return fields;
}

double number(const std::string& field) {
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  EXPECT_TRUE(!field.empty() && *end == '\0') << '"' << field << "\" is no number";
  return value;
}

struct Shape {
  std::int32_t kind = VESICA_E_KIND;
  std::array<double, 6> number{};
};

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

using Query = std::int32_t (*)(std::int32_t, const double*, std::int32_t, const double*, double*);

/// In both orders, with the same bits.
int expect_rows(const char* wanted, Query ask) {
  std::ifstream file(VESICA_CORPUS);
  EXPECT_TRUE(file.is_open()) << "missing " << VESICA_CORPUS;
  int rows = 0;
  std::string line;
  std::getline(file, line);  // The names of the columns.
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = split(line);
    if (fields[query] != wanted) continue;
    SCOPED_TRACE(fields[id]);
    const Shape a = shape(fields, kind_a), b = shape(fields, kind_b);
    double out = -1, swapped = -2;
    EXPECT_EQ(ask(a.kind, a.number.data(), b.kind, b.number.data(), &out), 0);
    EXPECT_EQ(ask(b.kind, b.number.data(), a.kind, a.number.data(), &swapped), 0);
    EXPECT_EQ(out, swapped);
    EXPECT_LE(std::fabs(out - number(fields[expected])), number(fields[tolerance])) << out;
    ++rows;
  }
  return rows;
}

// Fewer rows mean a damaged file.
TEST(AreaCorpus, Area) { EXPECT_GE(expect_rows("area", vesica_area_f64), 70); }
TEST(AreaCorpus, Iou) { EXPECT_GE(expect_rows("iou", vesica_iou_f64), 43); }

}  // namespace
