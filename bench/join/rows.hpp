// SPDX-License-Identifier: Apache-2.0
/// The rows of the table, one function each.
#pragma once

#include <cstdint>
#include <string>

namespace vesica::bench {

/// One workload of rectangles, n a side: its phases, and peers in the same run.
void report_join(const std::string& workload, std::int64_t n, int repeats);

/// 3,000 times the same rectangle a side.
void report_identical(int repeats);

/// Windows of three sizes, one at a time, on n rectangles.
void report_windows(std::int64_t n, int repeats);

/// The nearest and the ten nearest to a point, of n points and of n boxes.
void report_nearest(std::int64_t n, int repeats);

/// Moving and turning rectangles, one at a time, against n at rest; beside asking each of the n.
void report_turning(std::int64_t n, int repeats);

/// All six kinds against rectangles alone: a candidate's decision.
void report_kinds(std::int64_t n, int repeats);

/// Ten times as many shapes: the cost of one.
void report_growth(std::int64_t n, int repeats);

/// Bytes a shape that a join makes resident.
void report_memory(std::int64_t n);

/// One thread and two, handing out parts.
void report_threads(std::int64_t n, int repeats);

/// How many moving rectangles can be indexed and joined with themselves in a 60th of a second.
void report_frame();

}  // namespace vesica::bench
