// SPDX-License-Identifier: Apache-2.0
/// The 36 pairs of kinds in both scalar types, as parameters of a GoogleTest suite.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "properties/pair.hpp"
#include "properties/refused.hpp"

namespace properties {

struct Kinds {
  int a, b;
  Scalar scalar;
};

/// As in "rect_ellipse_f64".
inline std::string to_string(const Kinds& k) {
  return std::string(kind_name(k.a)) + '_' + kind_name(k.b) + '_' + name(k.scalar);
}

/// How GoogleTest shows a parameter.
inline void PrintTo(const Kinds& k, std::ostream* out) { *out << to_string(k); }

/// The pairs of the first `count` kinds.
inline std::vector<Kinds> all_pairs_of_kinds(int count = kinds) {
  std::vector<Kinds> result;
  for (int a = 0; a < count; ++a) {
    for (int b = a; b < count; ++b) {
      for (const Scalar scalar : {Scalar::f64, Scalar::f32}) result.push_back({a, b, scalar});
    }
  }
  return result;
}

/// The pairs that a question answers.
inline std::vector<Kinds> pairs_that_answer(Question question) {
  std::vector<Kinds> result = all_pairs_of_kinds();
  std::erase_if(result, [question](const Kinds& k) { return refuses(question, k.a, k.b); });
  return result;
}

inline std::string test_name(const testing::TestParamInfo<Kinds>& info) { return to_string(info.param); }

}  // namespace properties
