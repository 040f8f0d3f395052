// SPDX-License-Identifier: Apache-2.0
/// Index and join of rectangles: phases in ns a shape of both sides, and peers' time over the library's in the same
/// run.
///
///     vesica_bench_join [n] [repeats] [row]...
///
/// A row is a workload of tests/index/workloads.cpp, or identical, windows, nearest, turning, kinds, growth, memory,
/// threads or frame; all by default.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "join/measure.hpp"
#include "join/rows.hpp"

namespace {

using namespace vesica::bench;

/// Rows that are not a workload.
constexpr const char* questions[] = {"identical", "windows", "nearest", "turning", "kinds",
                                     "growth",    "memory",  "threads", "frame"};

bool is_row(const std::string& name) {
  return std::ranges::find(questions, name) != std::end(questions) ||
         std::ranges::find(index_tests::rect_workloads(), name) != index_tests::rect_workloads().end();
}

void report(const std::string& row, std::int64_t n, int repeats) {
  if (row == "identical") {
    report_identical(repeats);
  } else if (row == "windows") {
    report_windows(n, repeats);
  } else if (row == "nearest") {
    report_nearest(n, repeats);
  } else if (row == "turning") {
    report_turning(n, repeats);
  } else if (row == "kinds") {
    report_kinds(n, repeats);
  } else if (row == "growth") {
    report_growth(n, repeats);
  } else if (row == "memory") {
    report_memory(n);
  } else if (row == "threads") {
    report_threads(n, repeats);
  } else if (row == "frame") {
    report_frame();
  } else {
    report_join(row, n, repeats);
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t n = argc > 1 ? static_cast<std::int64_t>(std::atof(argv[1])) : 1000000;
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 9;
  std::vector<std::string> rows(argv + std::min(argc, 3), argv + argc);
  if (rows.empty()) {
    // Nearly all pairs of the whole range overlap: no join for a bench.
    std::ranges::copy_if(index_tests::rect_workloads(), std::back_inserter(rows),
                         [](const auto& name) { return name != "whole_range"; });
    rows.insert(rows.end(), std::begin(questions), std::end(questions));
  }
  for (const std::string& row : rows) {
    if (is_row(row)) continue;
    std::fprintf(stderr, "no such row: %s\n", row.c_str());
    return 2;
  }
  std::printf("%s, %lld shapes a side, least of %d; peers' time over the library's\n", vesica_isa_name(),
              static_cast<long long>(n), repeats);
  for (const std::string& row : rows) report(row, n, repeats);
}
