// SPDX-License-Identifier: Apache-2.0
/// The instruction sets batches are built for, and the cases every one of them has to pass.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "kernels/table.hpp"
#include "properties/pair.hpp"

namespace batch_tests {

struct InstructionSet {
  const char* name;
  const vesica::KernelTable* table;
  bool usable;          ///< has this processor the set?
  int floats, doubles;  ///< lanes of one vector
  int lanes(float) const { return floats; }
  int lanes(double) const { return doubles; }
};

/// The sets that the library chooses from, the plainest first.
std::span<const InstructionSet> instruction_sets();

/// One body of a test: an instruction set, a scalar type, two kinds in either order.
struct Case {
  const InstructionSet* set;
  properties::Scalar scalar;
  int kind_a, kind_b;
};

/// Every instruction set, with VESICA_TEST_PORTABLE the portable one too, both scalars, all 64 ordered pairs of kinds.
std::vector<Case> all_cases();

/// As in "avx2_f32_rect_ellipse".
std::string to_string(const Case& c);
inline void PrintTo(const Case& c, std::ostream* out) { *out << to_string(c); }
inline std::string test_name(const testing::TestParamInfo<Case>& info) { return to_string(info.param); }

/// A test of each case, skipped if the processor does not have the set.
class EveryCase : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (!GetParam().set->usable) GTEST_SKIP() << "this processor lacks " << GetParam().set->name;
  }

  /// Calls body with a value of the case's scalar type.
  template <class Body>
  void in_its_scalar(Body body) {
    if (GetParam().scalar == properties::Scalar::f32) {
      body(float{});
    } else {
      body(double{});
    }
  }
};

}  // namespace batch_tests
