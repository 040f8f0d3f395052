// SPDX-License-Identifier: Apache-2.0
// No bit of any answer changes unnoticed: hashes of what every function answers to the cases of cases.txt, one for each
// function, scalar type and ordered pair of kinds, are those of hashes.txt. They say nothing about whether an answer is
// right, which other tests do, but find any change at all, in little time. Where a change is meant:
//
//     VESICA_ANSWERS=update answers_test   writes hashes.txt and scenes.txt; `git diff` shows what changed
//     VESICA_ANSWERS=list answers_test     prints a hash for each function and case, to be compared between builds
#include "answers/answers.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>

#include "answers/table.hpp"
#include "properties/pair.hpp"

namespace {

using answers::Case;
using answers::Functions;
using answers::Hash;
using answers::mode;
using answers::Table;

constexpr std::size_t array_size = 20;

struct Kinds {
  int a, b;
};

class Answers : public testing::TestWithParam<Kinds> {
 protected:
  void SetUp() override {
    if (std::endian::native != std::endian::little) GTEST_SKIP() << "hashes are of bytes in the other order";
  }
  std::string kinds() const {
    return std::string(properties::kind_name(GetParam().a)) + '-' + properties::kind_name(GetParam().b);
  }
  std::vector<Case> cases() const {
    return answers::read_cases(answers::path("cases.txt"), GetParam().a, GetParam().b);
  }

  void ask_pairs(Functions which) {
    const std::vector<Case> all = cases();
    ASSERT_GT(all.size(), array_size);
    for (std::size_t i = 0; i < all.size(); ++i) {
      answers::ask(which, all[i], [&](const std::string& name, const answers::Bytes& answer) {
        take(name, answer, "case " + std::to_string(i));
      });
    }
    compare();
  }

  void ask_arrays(Functions which) {
    const std::vector<Case> all = cases();
    ASSERT_GT(all.size(), array_size);
    std::vector<Case> some;
    for (std::size_t i = 0; i < array_size; ++i) some.push_back(all[i * all.size() / array_size]);
    answers::ask_arrays(which, some,
                        [&](const std::string& name, const answers::Bytes& answer) { take(name, answer, ""); });
    compare();
  }

 private:
  void take(const std::string& name, const answers::Bytes& answer, const std::string& of) {
    hashes_[name].add(answer);
    if (mode() != "list") return;
    Hash one;
    one.add(answer);
    std::printf("%08x %s %s %s\n", one.value(), name.c_str(), kinds().c_str(), of.c_str());
  }

  void compare() const {
    static Table pinned = answers::read_table("hashes.txt");
    for (const auto& [name, hash] : hashes_) {
      auto& line = pinned[name][properties::kind_name(GetParam().a)];
      line.resize(properties::kinds);
      answers::judge(line[static_cast<std::size_t>(GetParam().b)], hash.value(), name + " of " + kinds());
    }
    answers::write_table("hashes.txt", pinned);
  }

  std::map<std::string, Hash> hashes_;
};

TEST_P(Answers, OfPairs) { ask_pairs(Functions::own); }
TEST_P(Answers, OfArrays) { ask_arrays(Functions::own); }

/// Sines, cosines and hypotenuses of this C library, whose hash is pinned: where it is another one, so may answers be.
std::uint32_t hash_of_the_c_library() {
  Hash hash;
  for (int i = 1; i <= 20000; ++i) {
    const double x = i * 0.00037, values[] = {std::sin(x),  std::cos(x),  std::hypot(x, 3 - x),
                                              std::cbrt(x), std::atan(x), std::acos(x / 8)};
    hash.add_values(values, std::size(values));
  }
  return hash.value();
}

TEST_P(Answers, ByTheCLibrary) {
  static const std::uint32_t here = hash_of_the_c_library();
  constexpr std::uint32_t where_hashes_were_made = 0x39f6c738;  // glibc 2.36, x86-64 with FMA
  if (here != where_hashes_were_made) GTEST_SKIP() << "another C library: " << std::hex << here;
  ask_pairs(Functions::by_the_c_library);
  ask_arrays(Functions::by_the_c_library);
}

std::vector<Kinds> ordered_pairs() {
  std::vector<Kinds> pairs;
  for (int a = 0; a < properties::kinds; ++a) {
    for (int b = 0; b < properties::kinds; ++b) pairs.push_back({a, b});
  }
  return pairs;
}

std::string test_name(const testing::TestParamInfo<Kinds>& info) {
  return std::string(properties::kind_name(info.param.a)) + '_' + properties::kind_name(info.param.b);
}

INSTANTIATE_TEST_SUITE_P(All, Answers, testing::ValuesIn(ordered_pairs()), test_name);

}  // namespace
