// SPDX-License-Identifier: Apache-2.0
/// Cases of tests/answers/cases.txt, and every function's answers to them as bytes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cast/face.hpp"
#include "properties/pair.hpp"
#include "stress/call.hpp"

namespace answers {

using Bytes = std::vector<unsigned char>;

struct Case {
  properties::Pair pair;
  cast_test::Motion motion;
};

Bytes bytes_of(const stress::Answer& answer);

/// The cases of two kinds, in the file's order.
std::vector<Case> read_cases(const std::string& path, int kind_a, int kind_b);

/// Takes what one function answers to one case or to one array. Named as its row of the table: "nearest f64".
using Take = std::function<void(const std::string& name, const Bytes& answer)>;

/// Functions that ask the C library for a sine, a cosine or the like are apart, and so are the named methods: its last
/// places differ from one to another.
enum class Functions { own, by_the_c_library };

/// The answers of every function that takes one pair.
void ask(Functions which, const Case& c, const Take& take);

/// The answers of every function that takes arrays, with the index and the join.
void ask_arrays(Functions which, const std::vector<Case>& cases, const Take& take);

}  // namespace answers
