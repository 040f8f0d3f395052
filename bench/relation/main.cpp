// SPDX-License-Identifier: Apache-2.0
/// Relation, containment and areas: every table, or those named.
///
///     vesica_bench_relation [relation | area | matrix | suppression]...
///
/// The matrix is asked for on every instruction set, each in a process of its own: the library chooses at load.
#include <stdlib.h>
#include <vesica.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "relation/report.hpp"

namespace {

using namespace vesica::bench;

constexpr std::string_view on_one_set = "matrix-on-one-set";

void report_matrices(const std::string& program) {
  print_iou_matrix_heading(stdout);
  for (const char* set : {"portable", "sse2", "neon", "avx2", "avx512"}) {
    setenv("VESICA_ISA", set, 1);
    const std::string command = "'" + program + "' " + std::string(on_one_set) + " " + set;
    if (std::system(command.c_str()) != 0) std::printf("%s: failed\n", set);
  }
  unsetenv("VESICA_ISA");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> parts(argv + 1, argv + argc);
  if (parts.size() == 2 && parts[0] == on_one_set) {
    if (parts[1] == vesica_isa_name()) report_iou_matrix(stdout);  // else the processor lacks it
    return 0;
  }
  const auto wanted = [&](std::string_view part) { return parts.empty() || std::ranges::count(parts, part) > 0; };
  if (wanted("relation")) report_relation(stdout);
  if (wanted("area")) report_area(stdout);
  if (wanted("matrix")) report_matrices(argv[0]);
  if (wanted("suppression")) report_suppression(stdout);
}
