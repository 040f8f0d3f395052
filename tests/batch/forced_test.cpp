// SPDX-License-Identifier: Apache-2.0
// The library itself under VESICA_ISA: it names the set it was asked to use, ignores a name it does not know or a set
// the processor does not have, and answers the same on every one.
#include <gtest/gtest.h>
#include <vesica.h>

#include <cstdlib>
#include <string>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "capi/face.hpp"

namespace forced_test {
namespace {

using namespace batch_tests;
using capi_tests::Face;

std::string asked_for() {
  const char* text = std::getenv("VESICA_ISA");
  return text != nullptr ? text : "";
}

const InstructionSet* find(const std::string& name) {
  for (const InstructionSet& set : instruction_sets()) {
    if (set.name == name) return &set;
  }
  return nullptr;
}

const InstructionSet& best() {
  const InstructionSet* result = nullptr;
  for (const InstructionSet& set : instruction_sets()) {
    if (set.usable) result = &set;
  }
  return *result;
}

TEST(ForcedInstructionSet, IsTheOneNamedOrTheBest) {
  const InstructionSet* set = find(asked_for());
  EXPECT_STREQ(vesica_isa_name(), set != nullptr && set->usable ? set->name : best().name);
}

class Forced : public testing::TestWithParam<std::pair<int, int>> {
 protected:
  void SetUp() override {
    const InstructionSet* set = find(asked_for());
    if (set != nullptr && !set->usable) GTEST_SKIP() << "this processor lacks " << set->name;
  }
};

std::int64_t returned(const Expected& expected) { return expected.invalid ? VESICA_E_SHAPE : expected.overlaps; }

template <class T>
void check(const Pairs<T>& pairs, std::size_t n, Layout layout_a, Layout layout_b) {
  const Stretch<T> s(pairs, n, n);
  const Stored<T> a(pairs.kind_a, s.a, layout_a), b(pairs.kind_b, s.b, layout_b);
  const auto c_a = c_shapes(a), c_b = c_shapes(b);
  const bool one_a = one_shape(layout_a);
  const Expected in_pairs = one_a ? in_step<T>(pairs.kind_a, s.a, true, pairs.kind_b, s.b, false) : s.expected;
  Output out(n);
  EXPECT_EQ(Face<T>::overlap_many(&c_a, &c_b, out.data()), returned(in_pairs));
  EXPECT_EQ(first_difference(out, in_pairs), -1) << name(layout_a) << " with " << name(layout_b) << ", " << n;
  EXPECT_TRUE(out.margins_untouched());
}

template <class T>
void check_one(const Pairs<T>& pairs, std::size_t n) {
  const Stretch<T> s(pairs, n, n);
  const Stored<T> a(pairs.kind_a, s.a, Layout::single), b(pairs.kind_b, s.b, Layout::columns);
  const auto one = c_shapes(a), many = c_shapes(b);
  const Expected expected = in_step<T>(pairs.kind_a, s.a, true, pairs.kind_b, s.b, false);
  Output out(n);
  EXPECT_EQ(Face<T>::overlap_matrix(&one, &many, out.data(), 0), returned(expected));
  EXPECT_EQ(first_difference(out, expected), -1);
  std::vector<std::int64_t> indices(n + 1, -77), wanted = indices;
  std::size_t found = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (expected.bytes[i] == 1) wanted[found++] = static_cast<std::int64_t>(i);
  }
  wanted[found] = -1;
  EXPECT_EQ(Face<T>::overlap_select(&one, &many, indices.data(), static_cast<std::int64_t>(n + 1)), returned(expected));
  EXPECT_EQ(indices, wanted);
}

template <class T>
void check_all(int kind_a, int kind_b) {
  const Pairs<T>& pairs = mixed_pairs<T>(kind_a, kind_b);
  for (const std::size_t n : {0, 1, 2, 7, 33, 1025}) {
    check(pairs, n, Layout::columns, Layout::columns);
    check(pairs, n, Layout::packed, Layout::odd_records);
    check(pairs, n, Layout::repeated, Layout::backward_columns);
    if (n > 0) check_one(pairs, n);
  }
}

TEST_P(Forced, AgreesWithScalarCalls) {
  const auto [kind_a, kind_b] = GetParam();
  check_all<float>(kind_a, kind_b);
  check_all<double>(kind_a, kind_b);
}

std::vector<std::pair<int, int>> ordered_pairs() {
  std::vector<std::pair<int, int>> pairs;
  for (int a = 0; a < properties::kinds; ++a) {
    for (int b = 0; b < properties::kinds; ++b) pairs.emplace_back(a, b);
  }
  return pairs;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Forced, testing::ValuesIn(ordered_pairs()), [](const auto& kinds) {
  return std::string(properties::kind_name(kinds.param.first)) + '_' + properties::kind_name(kinds.param.second);
});

}  // namespace
}  // namespace forced_test
