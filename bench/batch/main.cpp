// SPDX-License-Identifier: Apache-2.0
/// The batch benchmark: a table of every pair, scalar, instruction set and layout, with ratios and targets.
///
///     vesica_bench_batch [PART...]      rows whose name contains every PART; all rows without one (about 2 minutes)
///
/// A row is named pair/scalar/instruction set/layout/workload. VESICA_SEED chooses the pairs.
#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "batch/report.hpp"
#include "batch/run.hpp"
#include "batch/scalar_calls.hpp"

namespace {

bool is_wanted(const vesica::bench::Spec& spec, const std::vector<std::string_view>& parts) {
  return std::ranges::all_of(parts, [&](std::string_view part) { return spec.name().find(part) != std::string::npos; });
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> parts(argv + 1, argv + argc);
  int rows = 0, missed = 0;
  vesica::bench::print_heading();
  for (const auto& spec : vesica::bench::all_specs()) {
    if (!is_wanted(spec, parts)) continue;
    const vesica::bench::Result result = vesica::bench::run(spec);
    vesica::bench::print_row(spec, result, vesica::bench::scalar_time(spec));
    missed += !vesica::bench::reaches_target(spec, result);
    ++rows;
  }
  std::printf("\n%d rows, %d targets missed\n", rows, missed);
  return rows > 0 ? 0 : 1;
}
