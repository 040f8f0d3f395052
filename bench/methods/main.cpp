// SPDX-License-Identifier: Apache-2.0
/// vesica_bench_methods [PART...]: the named methods whose names hold every PART, beside the exact default.
#include <algorithm>
#include <cinttypes>
#include <string>

#include "methods/measure.hpp"
#include "methods/table.hpp"

using namespace vesica::bench;

int main(int argc, char** argv) {
  const auto chosen = [&](const methods::Method& method) {
    return std::all_of(argv + 1, argv + argc,
                       [&](const char* part) { return method.name.find(part) != std::string::npos; });
  };
  std::printf(
      "Nanoseconds a test in double, medians over passes of %zu fresh pairs, through the shared library, validity "
      "included;\nwrong and uncertain answers of 65,536 pairs, distances 4,096, by the exact default. Seed %" PRIu64
      ".\n",
      pairs_per_pass, seed_of_run());
  std::vector<methods::Method> all;
  methods::add_rect_rect(all);
  methods::add_rect_ellipse(all);
  methods::add_segment_circle(all);
  methods::add_circle_ellipse(all);
  methods::add_ellipse_ellipse(all);
  methods::add_ellipse_ellipse_distance(all);
  std::vector<methods::Method*> asked;
  for (methods::Method& method : all) {
    if (chosen(method)) asked.push_back(&method);
  }
  methods::measure(asked);
  methods::print_tables(stdout, all);
  return 0;
}
