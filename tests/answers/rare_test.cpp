// SPDX-License-Identifier: Apache-2.0
// The same hashes, one a case, of what tools/stress/rare.txt and tools/slowest/slowest.txt ask. They are those of
// rare.txt; see answers_test.cpp. The stress test judges the same cases by all laws.
#include <gtest/gtest.h>

#include <bit>

#include "answers/answers.hpp"
#include "answers/table.hpp"
#include "stress/query.hpp"

namespace rare_test {
namespace {

class RareAnswers : public testing::TestWithParam<const char*> {};

TEST_P(RareAnswers, OfCases) {
  if (std::endian::native != std::endian::little) GTEST_SKIP() << "hashes are of bytes in the other order";
  answers::Table table = answers::read_table("rare.txt");
  std::map<std::string, std::size_t> asked;
  const std::string file = GetParam();
  for (const stress::Case& c : stress::read_cases(answers::path("../../tools/" + file))) {
    const std::string query = std::string(name(c.query)) + ' ' + properties::name(c.scalar);
    if (c.query == stress::Query::invalid || c.query == stress::Query::batch) continue;
    auto& line = table[query][file];
    const std::size_t i = asked[query]++;
    if (line.size() <= i) line.resize(i + 1);
    answers::Hash hash;
    hash.add(answers::bytes_of(stress::ask(c)));
    answers::judge(line[i], hash.value(), stress::notation(c));
  }
  EXPECT_GT(asked.size(), 10U);
  answers::write_table("rare.txt", table);
}

std::string test_name(const testing::TestParamInfo<const char*>& info) { return info.index == 0 ? "rare" : "slowest"; }

INSTANTIATE_TEST_SUITE_P(All, RareAnswers, testing::Values("stress/rare.txt", "slowest/slowest.txt"), test_name);

}  // namespace
}  // namespace rare_test
