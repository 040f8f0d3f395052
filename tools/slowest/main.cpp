// SPDX-License-Identifier: Apache-2.0
// The slowest input of every query and pair of kinds that a search finds, from random ones or from those of the file
// that VESICA_FROM names. --replay measures inputs found before, one a line as in slowest.txt, and fails where one
// takes longer than it may.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "properties/random.hpp"
#include "slowest/climb.hpp"
#include "slowest/measure.hpp"

namespace {

using stress::Query;

void print(const stress::Case& input, double microseconds, double yardstick) {
  std::printf("%8.1f us %7.1f x  %s\n", microseconds, microseconds / yardstick, stress::notation(input).c_str());
  std::fflush(stdout);
}

/// VESICA_FROM names a file of inputs to climb from.
void search(Query query, int kind_a, int kind_b, double seconds) {
  const char* const from = std::getenv("VESICA_FROM");
  const auto known = from != nullptr ? stress::read_cases(from) : std::vector<stress::Case>();
  const auto found = slowest::climb(query, kind_a, kind_b, seconds, properties::seed(), known);
  print(found.input, found.microseconds, slowest::yardstick_microseconds());
}

std::optional<int> kind_of(const char* name) {
  for (int kind = 0; kind < properties::kinds; ++kind) {
    if (std::strcmp(name, properties::kind_name(kind)) == 0) return kind;
  }
  return std::nullopt;
}

int search_all(int count, char** words) {
  const double seconds = count > 0 ? std::strtod(words[0], nullptr) : 10;
  const auto only = count > 1 ? stress::find_query(words[1]) : std::nullopt;
  const auto kind_a = count > 3 ? kind_of(words[2]) : std::nullopt,
             kind_b = count > 3 ? kind_of(words[3]) : std::nullopt;
  if (!(seconds > 0) || (count > 1 && !only) || (count > 3 && (!kind_a || !kind_b))) {
    std::fputs("usage: vesica_slowest [SECONDS a search] [QUERY [KIND KIND]] | --replay FILE [YARDSTICKS]\n", stderr);
    return 2;
  }
  for (const Query query : stress::all_queries) {
    if (query == Query::invalid || query == Query::batch || (only && query != *only)) continue;
    for (int a = 0; a < properties::kinds; ++a) {
      for (int b = stress::of_one_shape(query) ? properties::kinds - 1 : a; b < properties::kinds; ++b) {
        if (stress::is_refused(query, a, b)) continue;
        if (!kind_a || (a == *kind_a && b == *kind_b)) search(query, a, b, seconds);
      }
    }
  }
  return 0;
}

/// Returns 1 where an input takes more than `most` yardsticks, or where there is none.
int replay(const char* file, double most) {
  const auto inputs = stress::read_cases(file);
  int slow = 0;
  for (const stress::Case& input : inputs) {
    const double yardstick = slowest::yardstick_microseconds(), time = slowest::microseconds(input, 500);
    print(input, time, yardstick);
    slow += time > most * yardstick;
  }
  std::printf("%zu inputs, %d of them slower than %g yardsticks\n", inputs.size(), slow, most);
  return !inputs.empty() && slow == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc > 2 && std::strcmp(argv[1], "--replay") == 0) {
      return replay(argv[2], argc > 3 ? std::strtod(argv[3], nullptr) : std::numeric_limits<double>::infinity());
    }
    return search_all(argc - 1, argv + 1);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
