// SPDX-License-Identifier: Apache-2.0
// For mutants that no test finds: which cases show a difference? Of a build of ./run mutate; see
// tests/mutants/README.md.
//
//     answers_hunt CASES mark COUNT   asks all cases, writes their hashes to CASES.hashes and, for each of COUNT
//                                     mutants, the cases to which it makes a difference inside to CASES.reached
//     answers_hunt CASES compare I... asks these cases and prints those of which an answer is another
//     answers_hunt CASES list I...    prints what each function answers to these cases
//
// A number from 1000000 on is that of an array of cases.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "answers/answers.hpp"
#include "answers/table.hpp"

namespace {

using answers::Case;
using answers::Functions;

constexpr std::size_t first_array = 1000000, array_size = 20, most_of_a_mutant = 400;

struct Cases {
  std::vector<Case> all;
  std::vector<std::vector<Case>> arrays;

  explicit Cases(const std::string& path) {
    for (int a = 0; a < properties::kinds; ++a) {
      for (int b = 0; b < properties::kinds; ++b) {
        const std::vector<Case> those = answers::read_cases(path, a, b);
        all.insert(all.end(), those.begin(), those.end());
        for (std::size_t i = 0; i + array_size <= those.size(); i += 3 * array_size) {
          arrays.emplace_back(those.begin() + static_cast<std::ptrdiff_t>(i),
                              those.begin() + static_cast<std::ptrdiff_t>(i + array_size));
        }
      }
    }
  }

  std::uint64_t hash(std::size_t i) const {
    answers::Hash hash;
    ask(i, [&](const std::string&, const answers::Bytes& bytes) { hash.add(bytes); });
    return hash.value();
  }

  void ask(std::size_t i, const answers::Take& take) const {
    for (const Functions which : {Functions::own, Functions::by_the_c_library}) {
      if (i >= first_array) {
        answers::ask_arrays(which, arrays[i - first_array], take);
      } else {
        answers::ask(which, all[i], take);
      }
    }
  }

  std::vector<std::size_t> numbers() const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < all.size(); ++i) result.push_back(i);
    for (std::size_t i = 0; i < arrays.size(); ++i) result.push_back(first_array + i);
    return result;
  }
};

int mark(const Cases& cases, const std::string& path, std::size_t count) {
  const int file = open(std::getenv("VESICA_MUTANT_REACHED"), O_RDWR);
  auto* marks = static_cast<unsigned char*>(mmap(nullptr, count + 1, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0));
  if (marks == MAP_FAILED) return 2;
  std::vector<std::vector<std::size_t>> reached(count + 1);
  std::ofstream hashes(path + ".hashes"), out(path + ".reached");
  for (const std::size_t i : cases.numbers()) {
    std::memset(marks, 0, count + 1);
    hashes << i << ' ' << cases.hash(i) << '\n';
    for (std::size_t m = 1; m <= count; ++m) {
      if (marks[m] != 0 && reached[m].size() < most_of_a_mutant) reached[m].push_back(i);
    }
  }
  for (std::size_t m = 1; m <= count; ++m) {
    out << m;
    for (const std::size_t i : reached[m]) out << ' ' << i;
    out << '\n';
  }
  return 0;
}

int compare(const Cases& cases, const std::string& path, const std::vector<std::string>& wanted) {
  std::ifstream in(path + ".hashes");
  std::vector<std::pair<std::size_t, std::uint64_t>> expected;
  for (std::size_t i = 0, hash = 0; in >> i >> hash;) expected.emplace_back(i, hash);
  int left = 3;
  for (const std::string& text : wanted) {
    const std::size_t i = std::strtoull(text.c_str(), nullptr, 10);
    const std::size_t at = i >= first_array ? cases.all.size() + i - first_array : i;
    if (cases.hash(i) == expected[at].second) continue;
    std::printf("%zu\n", i);
    if (--left == 0) break;
  }
  return 0;
}

int list(const Cases& cases, const std::vector<std::string>& wanted) {
  for (const std::string& text : wanted) {
    cases.ask(std::strtoull(text.c_str(), nullptr, 10), [&](const std::string& name, const answers::Bytes& bytes) {
      std::printf("%s %s:", text.c_str(), name.c_str());
      for (const unsigned char byte : bytes) std::printf(" %02x", byte);
      std::printf("\n");
    });
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const Cases cases(words.at(0));
  if (words.at(1) == "mark") return mark(cases, words[0], std::strtoull(words.at(2).c_str(), nullptr, 10));
  if (words[1] == "list") return list(cases, {words.begin() + 2, words.end()});
  return compare(cases, words[0], {words.begin() + 2, words.end()});
}
