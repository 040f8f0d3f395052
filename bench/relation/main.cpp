// SPDX-License-Identifier: Apache-2.0
/// Relation, containment and areas: every table, or those named.
///
///     vesica_bench_relation [relation | area | matrix | aabbs | suppression]...
///
/// Matrices are asked for on every instruction set, each in a process of its own: the library chooses at load.
#include <stdlib.h>
#include <vesica.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "relation/report.hpp"

namespace {

using namespace vesica::bench;

constexpr std::string_view on_one_set = "on-one-set";

void report_on_all_sets(const std::string& program, const std::string& part) {
  for (const char* set : {"portable", "sse2", "neon", "avx2", "avx512"}) {
    setenv("VESICA_ISA", set, 1);
    const std::string command = "'" + program + "' " + part + " " + std::string(on_one_set) + " " + set;
    if (std::system(command.c_str()) != 0) std::printf("%s: failed\n", set);
  }
  unsetenv("VESICA_ISA");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> parts(argv + 1, argv + argc);
  if (parts.size() == 3 && parts[1] == on_one_set) {
    if (parts[2] != vesica_isa_name()) return 0;  // the processor has no such set
    parts[0] == "aabbs" ? report_iou_of_aabbs(stdout) : report_iou_matrix(stdout);
    return 0;
  }
  const auto wanted = [&](std::string_view part) { return parts.empty() || std::ranges::count(parts, part) > 0; };
  if (wanted("relation")) report_relation(stdout);
  if (wanted("area")) report_area(stdout);
  if (wanted("matrix")) {
    print_iou_matrix_heading(stdout);
    report_on_all_sets(argv[0], "matrix");
  }
  if (wanted("aabbs")) {
    print_iou_of_aabbs_heading(stdout);
    report_on_all_sets(argv[0], "aabbs");
  }
  if (wanted("suppression")) report_suppression(stdout);
}
