// SPDX-License-Identifier: Apache-2.0
// All pairs of two indexes, or of one, that a query holds for. The order of pairs, by block of A, block of B, item of a
// and item of b in their blocks, depends on neither instruction set, parts, capacity nor kinds.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"
#include "join/decide.hpp"

namespace vesica::index {

struct JoinSide {
  const void* index;
  const Sets* sets;  // null where nothing is decided
};

/// Decides up to decided_at_once pairs in columns by their ratios: out[i] = 1 or 0, and value[i] the ratio if 1.
/// May change the columns.
struct RatioTest {
  void (*decide)(const RatioTest& asked, std::int32_t kind_a, Columns& a, std::int32_t kind_b, Columns& b,
                 std::int64_t n, std::uint8_t* out, double* value) = nullptr;
  std::int32_t ratio = 0;
  double threshold = 0;
};

struct Join {
  const Kernels& kernels;
  JoinSide a, b;
  Decide decide;        // null: boxes that meet are pairs
  bool reversed;        // asks whether b holds for a
  std::uint32_t query;  // only to tell apart what a state belongs to
  std::int64_t part, parts;
  void* scratch;      // of join_scratch_bytes, aligned to 64
  RatioTest ratio{};  // decides if its function is set, in place of `decide`
};

std::int64_t join_scratch_bytes() noexcept;

/// Pairs of the whole part.
std::int64_t count_pairs(const Join& join) noexcept;

/// True if a state is one that such a join returns.
bool state_is_sound(const Join& join, const std::int64_t* state) noexcept;

/// Writes up to `capacity` > 0 pairs; returns how many, and moves the state on. A ratio test writes the ratios too, in
/// the scalar of the sets.
std::int64_t write_pairs(const Join& join, std::int64_t* out_a, std::int64_t* out_b, void* values,
                         std::int64_t capacity, std::int64_t* state) noexcept;

}  // namespace vesica::index
