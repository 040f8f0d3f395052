// SPDX-License-Identifier: Apache-2.0
// Pairs of kinds that are refused today: no more and no fewer, in both orders. Other tests leave them out, so a line
// goes when a question learns a pair.
#include "properties/refused.hpp"

#include <gtest/gtest.h>

#include <string>

#include "properties/pair.hpp"

namespace refused_test {
namespace {

using properties::Question;

struct Pinned {
  Question question;
  const char* pairs;  ///< the lower kind first
};
constexpr Pinned pinned[] = {
    {Question::boundary_distance, ""},
    {Question::crossings, ""},
    {Question::intersection,
     "circle-circle circle-aabb circle-rect circle-ellipse circle-capsule circle-round_rect aabb-ellipse aabb-capsule "
     "aabb-round_rect rect-ellipse rect-capsule rect-round_rect ellipse-ellipse ellipse-capsule ellipse-round_rect "
     "capsule-capsule capsule-round_rect round_rect-round_rect "}};

TEST(Refused, PairsOfKinds) {
  for (const auto& [question, pairs] : pinned) {
    std::string refused;
    for (int a = 0; a < properties::kinds; ++a) {
      for (int b = a; b < properties::kinds; ++b) {
        const bool is_refused = properties::refuses(question, a, b);
        EXPECT_EQ(properties::refuses(question, b, a), is_refused) << name(question) << ", exchanged";
        if (is_refused) refused += std::string(properties::kind_name(a)) + '-' + properties::kind_name(b) + ' ';
      }
    }
    EXPECT_EQ(refused, pairs) << name(question);
  }
}

}  // namespace
}  // namespace refused_test
