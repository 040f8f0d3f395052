// SPDX-License-Identifier: Apache-2.0
#include "corpus/corpus.hpp"

#include <vesica.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace corpus {
namespace {

constexpr const char* header =
    "id,source,kind_a,a0,a1,a2,a3,a4,a5,kind_b,b0,b1,b2,b3,b4,b5,query,expected,tolerance,note";
enum Column { id, source, kind_a, a0, kind_b = 9, b0, query = 16, expected, tolerance, note, column_count };

constexpr std::size_t most_numbers = 6;

using Fields = std::vector<std::string>;

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(std::string(VESICA_CORPUS) + ": " + what);
}

// No field holds a comma.
Fields split(const std::string& line) {
  Fields fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  require(fields.size() == column_count, "not 20 fields: " + line);
  return fields;
}

double number(const Fields& fields, std::size_t column) {
  const std::string& text = fields[column];
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  require(!text.empty() && *end == '\0' && std::isfinite(value), fields[id] + ": \"" + text + "\" is no number");
  return value;
}

int kind(const Fields& fields, std::size_t column) {
  for (int k = VESICA_POINT; k <= VESICA_ELLIPSE; ++k) {
    if (fields[column] == vesica_kind_name(k)) return k;
  }
  throw std::runtime_error(fields[id] + ": unknown kind " + fields[column]);
}

// Columns that a kind does not use are empty.
properties::Numbers numbers(const Fields& fields, std::size_t kind_column) {
  properties::Numbers result{};
  const auto used = static_cast<std::size_t>(vesica_field_count(kind(fields, kind_column)));
  for (std::size_t i = 0; i < most_numbers; ++i) {
    const std::size_t column = kind_column + 1 + i;
    if (i < used) {
      result[i] = number(fields, column);
    } else {
      require(fields[column].empty(), fields[id] + ": a number too many");
    }
  }
  return result;
}

Row row(const Fields& fields) {
  return {fields[id],
          fields[query],
          {kind(fields, kind_a), kind(fields, kind_b), numbers(fields, kind_a), numbers(fields, kind_b)},
          number(fields, expected),
          number(fields, tolerance)};
}

}  // namespace

std::vector<Row> rows() {
  std::ifstream file(VESICA_CORPUS);
  std::string line;
  require(static_cast<bool>(std::getline(file, line)), "cannot be read");
  require(line == header, "other columns than expected");
  std::vector<Row> result;
  while (std::getline(file, line)) result.push_back(row(split(line)));
  return result;
}

std::vector<Row> rows(const std::string& query) {
  std::vector<Row> result = rows();
  std::erase_if(result, [&](const Row& row) { return row.query != query; });
  return result;
}

}  // namespace corpus
