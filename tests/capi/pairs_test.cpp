// SPDX-License-Identifier: Apache-2.0
// VESICA_EACH_PAIR is the list of pairs. The names that the library exports cannot be made from it, and are compared
// with it here.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>
#include <vesica/each_shape.hpp>
#include <vesica/shapes.hpp>

namespace {

using Names = std::vector<std::string>;

#define VESICA_NAME(name, Name) #name,
const Names shapes{VESICA_EACH_SHAPE(VESICA_NAME)};
#undef VESICA_NAME

#define VESICA_STEM(a, A, b, B) #a "_" #b,
const Names pairs{VESICA_EACH_PAIR(VESICA_STEM)};
const Names pairs_with_functions{VESICA_EACH_PAIR_OF_FORMS(VESICA_STEM)};
#undef VESICA_STEM

/// The first group of each match, in order.
Names matches(const std::string& text, const std::regex& pattern) {
  Names found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

TEST(Pairs, AreEveryTwoShapesInTheirOrder) {
  Names expected;
  for (std::size_t a = 0; a < shapes.size(); ++a) {
    for (std::size_t b = a; b < shapes.size(); ++b) expected.push_back(shapes[a] + "_" + shapes[b]);
  }
  // The list has shapes with a form first.
  Names sorted = pairs;
  std::ranges::sort(sorted);
  std::ranges::sort(expected);
  EXPECT_EQ(sorted, expected);
  EXPECT_EQ(shapes.size(), static_cast<std::size_t>(vesica::kind_count));
}

TEST(Pairs, AreThoseThatCMakeReads) { EXPECT_EQ(matches(VESICA_PAIRS, std::regex("(\\w+)")), pairs); }

TEST(Pairs, HaveTheirExportedFunctions) {
  std::ifstream map(VESICA_MAP);
  ASSERT_TRUE(map) << VESICA_MAP;
  std::stringstream text;
  text << map.rdbuf();
  std::string kinds = shapes[0];
  for (const std::string& shape : shapes) kinds += "|" + shape;
  for (const std::string scalar : {"f64", "f32"}) {
    const std::string kind = "(?:" + kinds + ")";
    Names exported = matches(text.str(), std::regex("vesica_overlap_(" + kind + "_" + kind + ")_" + scalar + ";"));
    Names expected = pairs_with_functions;
    std::ranges::sort(exported);
    std::ranges::sort(expected);
    EXPECT_EQ(exported, expected) << scalar;
  }
}

}  // namespace
