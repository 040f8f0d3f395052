// SPDX-License-Identifier: Apache-2.0
/// Cases of tests/answers/cases.txt, and every function's answers to them as bytes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cast/face.hpp"
#include "properties/pair.hpp"

namespace answers {

using Bytes = std::vector<unsigned char>;

struct Case {
  properties::Pair pair;
  cast_test::Motion motion;
};

/// The cases of two kinds, in the file's order.
std::vector<Case> read_cases(const std::string& path, int kind_a, int kind_b);

/// Takes what one function answers to one case or to one array. Named as its row of the table: "nearest f64".
using Take = std::function<void(const std::string& name, const Bytes& answer)>;

/// What every function of one pair answers. No function that asks the C library for a sine: those are not the same
/// bits everywhere.
void ask(const Case& c, const Take& take);

/// What every function of arrays answers, the index and the join among them.
void ask_arrays(const std::vector<Case>& cases, const Take& take);

}  // namespace answers
