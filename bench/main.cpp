// SPDX-License-Identifier: Apache-2.0
/// Google Benchmark as usual, then a table of ratios. All of --benchmark_... works; VESICA_SEED chooses the pairs.
///
/// A benchmark is named pair/scalar/workload/who, who being vesica, textbook or a peer; Google Benchmark adds that the
/// time is measured by hand, so that drawing fresh pairs is not in it. A row of the table is pair/scalar/workload.
/// Names with a part between scalar and workload are left for batches (layout, count, instruction set).
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string_view>
#include <vector>

#include "row.hpp"
#include "table.hpp"
#include "timing.hpp"

namespace {

// The table's medians need hundreds of passes, not half a second of them. An argument given later overrides it.
char short_runs[] = "--benchmark_min_time=0.1";

/// Machine-readable formats own the standard output.
std::FILE* table_output(const std::vector<char*>& arguments) {
  constexpr std::string_view option = "--benchmark_format=";
  for (const std::string_view argument : arguments) {
    if (argument.starts_with(option) && argument.substr(option.size()) != "console") return stderr;
  }
  return stdout;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  std::FILE* const out = table_output(arguments);
  arguments.insert(arguments.begin() + 1, short_runs);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  vesica::bench::sort_rows();
  vesica::bench::register_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  vesica::bench::print_table(out);
  return 0;
}
