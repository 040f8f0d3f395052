// SPDX-License-Identifier: Apache-2.0
/// The one reader of cases.csv: inputs other libraries got wrong. README.md says what its columns mean.
#pragma once

#include <string>
#include <vector>

#include "properties/pair.hpp"

namespace corpus {

struct Row {
  std::string id, query;
  properties::Pair pair;
  double expected, tolerance;
};

/// All rows. Throws std::runtime_error where the file is missing or damaged.
std::vector<Row> rows();

/// The rows that ask this query.
std::vector<Row> rows(const std::string& query);

}  // namespace corpus
