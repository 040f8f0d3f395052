// SPDX-License-Identifier: Apache-2.0
// The dearest input of every query and pair of kinds that a search finds, from random ones or from those of the file
// that VESICA_FROM names. --replay measures inputs found before, one a line as in dearest.txt, and fails where one
// takes longer than it may.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cost/climb.hpp"
#include "cost/measure.hpp"
#include "properties/random.hpp"

namespace {

using hammer::Query;

void print(const hammer::Case& input, double microseconds, double yardstick) {
  std::printf("%8.1f us %7.1f x  %s\n", microseconds, microseconds / yardstick, hammer::notation(input).c_str());
  std::fflush(stdout);
}

/// VESICA_FROM names a file of inputs to climb from.
void search(Query query, int kind_a, int kind_b, double seconds) {
  const char* const from = std::getenv("VESICA_FROM");
  const auto known = from != nullptr ? hammer::read_cases(from) : std::vector<hammer::Case>();
  const auto dearest = cost::climb(query, kind_a, kind_b, seconds, properties::seed(), known);
  print(dearest.input, dearest.microseconds, cost::yardstick_microseconds());
}

std::optional<int> kind_of(const char* name) {
  for (int kind = 0; kind < properties::kinds; ++kind) {
    if (std::strcmp(name, properties::kind_name(kind)) == 0) return kind;
  }
  return std::nullopt;
}

int search_all(int count, char** words) {
  const double seconds = count > 0 ? std::strtod(words[0], nullptr) : 10;
  const auto only = count > 1 ? hammer::find_query(words[1]) : std::nullopt;
  const auto kind_a = count > 3 ? kind_of(words[2]) : std::nullopt,
             kind_b = count > 3 ? kind_of(words[3]) : std::nullopt;
  if (!(seconds > 0) || (count > 1 && !only) || (count > 3 && (!kind_a || !kind_b))) {
    std::fputs("usage: vesica_cost [SECONDS a search] [QUERY [KIND KIND]] | --replay FILE [YARDSTICKS]\n", stderr);
    return 2;
  }
  for (const Query query : hammer::all_queries) {
    if (query == Query::invalid || query == Query::batch || (only && query != *only)) continue;
    for (int a = 0; a < properties::kinds; ++a) {
      for (int b = hammer::of_one_shape(query) ? properties::kinds - 1 : a; b < properties::kinds; ++b) {
        if (!kind_a || (a == *kind_a && b == *kind_b)) search(query, a, b, seconds);
      }
    }
  }
  return 0;
}

/// Returns 1 where an input takes more than `most` yardsticks, or where there is none.
int replay(const char* file, double most) {
  const auto inputs = hammer::read_cases(file);
  int dear = 0;
  for (const hammer::Case& input : inputs) {
    const double yardstick = cost::yardstick_microseconds(), time = cost::microseconds(input, 500);
    print(input, time, yardstick);
    dear += time > most * yardstick;
  }
  std::printf("%zu inputs, %d of them dearer than %g yardsticks\n", inputs.size(), dear, most);
  return !inputs.empty() && dear == 0 ? 0 : 1;
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
