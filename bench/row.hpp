// SPDX-License-Identifier: Apache-2.0
/// A row of the benchmark's table: one pair of kinds, one scalar type, one workload.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "workloads.hpp"

namespace vesica::bench {

/// The target of a row. A missed target is printed, never a failure: timings are no test.
struct Target {
  double ratio = 0;        ///< of the library's time to the yardstick's; 0 for none
  double nanoseconds = 0;  ///< a call; 0 for none
  double above = 0;        ///< nanoseconds above a yardstick that takes less than 5; 0 for none
};

constexpr Target ratio_at_most(double ratio) { return {.ratio = ratio}; }
constexpr Target nanoseconds_at_most(double nanoseconds) { return {.nanoseconds = nanoseconds}; }
constexpr Target nanoseconds_above(double above) { return {.above = above}; }

/// The typed code of a row: the loops that are timed, over buffers it fills with fresh pairs.
class Passes {
 public:
  virtual ~Passes() = default;
  /// Takes the pool over; a pass may now be drawn.
  virtual void load(const Pool& pool) = 0;
  virtual void unload() = 0;
  /// Copies `count` pairs drawn at random from the pool into the hot buffers.
  virtual void draw(Random& random, std::size_t count) = 0;
  /// How many of the drawn pairs overlap.
  virtual std::int64_t library_hits() const = 0;
  virtual std::int64_t yardstick_hits() const = 0;
  /// On how many of the drawn pairs the yardstick and the library differ.
  virtual std::int64_t disagreements() const = 0;
};

/// Nanoseconds a test of the library and of the yardstick on the same pairs, one straight after the other.
struct Sample {
  double library, yardstick;
};

/// A peer's results in one row.
struct PeerResult {
  std::string name;
  std::vector<double> nanoseconds;  ///< a test, one entry a timed pass
  std::int64_t wrong = 0, asked = 0;
};

struct Row {
  std::int32_t kind_a, kind_b;
  const char* scalar;
  Workload workload;
  Target target;
  bool has_yardstick;
  std::unique_ptr<Passes> passes;

  std::vector<Sample> samples;
  std::int64_t hits = 0, tests = 0;
  std::int64_t yardstick_wrong = 0, yardstick_asked = 0;
  std::vector<PeerResult> peers;

  std::string pair() const;
  /// pair/scalar/workload.
  std::string name() const;
};

/// Workloads the exact stage answers; an unfiltered yardstick has no right answers there.
constexpr bool is_exact(Workload workload) { return workload >= Workload::tangent; }

/// All rows, filled by the files of overlap/ before main starts.
std::vector<Row>& rows();

/// Puts rows in the order of shapes, scalars (double first) and workloads.
void sort_rows();

}  // namespace vesica::bench
