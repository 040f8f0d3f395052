// SPDX-License-Identifier: Apache-2.0
/// The parts of a row: sets of shapes, memory for their indexes, and one join in its phases.
#pragma once

#include <vesica.h>

#include <cstdint>
#include <string>
#include <vector>

#include "index/workloads.hpp"
#include "join/peers.hpp"

namespace vesica::bench {

/// Fresh pages of the system's, so that what is touched can be counted.
struct Memory {
  explicit Memory(std::int64_t bytes);
  ~Memory();
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  std::int64_t size;
  void* data;
};

/// Rectangles of a workload.
std::vector<RectRecord> draw(const std::string& workload, std::int64_t n, std::uint64_t seed);

vesica_shapes_f64 view(const std::vector<RectRecord>& shapes);

/// Sets laid end to end, with room for their index.
struct Operand {
  explicit Operand(std::vector<vesica_shapes_f64> shapes);
  std::vector<vesica_shapes_f64> sets;
  std::int64_t items;
  Memory index;
  std::int32_t set_count() const { return static_cast<std::int32_t>(sets.size()); }
};

/// Scratch for the build of an index of that many items, and for joins.
struct Scratch {
  explicit Scratch(std::int64_t items) : build(vesica_index_scratch(items)), join(vesica_join_scratch()) {}
  Memory build, join;
};

/// Seconds: the build's steps, candidates alone, and the whole join.
struct Times {
  double step[5] = {}, candidates = 0, join = 0;
  std::int64_t pairs = 0, candidate_count = 0, bytes = 0;
  double build() const { return step[0] + step[1] + step[2] + step[3] + step[4]; }
  double total() const { return build() + join; }
  double decide_each() const;
};

/// Builds an index, and adds what its steps took.
void build(const Operand& operand, const Scratch& scratch, Times& times);

/// Takes all pairs of a part; returns how many.
std::int64_t join(const Operand& a, const Operand& b, std::int64_t part, std::int64_t parts, const Memory& scratch);

/// The least of `repeats` builds and joins; a and b may be the same.
Times least(const Operand& a, const Operand& b, const Scratch& scratch, int repeats);

}  // namespace vesica::bench
