// SPDX-License-Identifier: Apache-2.0
// Items of an index that a moving shape hits: the first, or all of them.
#pragma once

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {

/// Callbacks about items. ask() returns whether the moving shape hits an item by the time `end` (1, 0, or an error),
/// and writes the time of the hit, rounded down. meets() returns the same of the whole motion, but without a time.
/// prefetch() fetches the numbers of an item that ask() may be called for; keep() says that the item of the last ask()
/// is the first hit so far.
struct Targets {
  void* context;
  std::int32_t (*ask)(void* context, std::uint32_t item, double end, double& t);
  std::int32_t (*meets)(const void* context, std::uint32_t item);
  void (*prefetch)(const void* context, std::uint32_t item);
  void (*keep)(void* context);
};

struct Cast {
  const void* index;
  Targets targets;
  const double (&box)[4];  // bounds of the moving shape at the start
  double vx, vy, end;
  bool is_float;  // times are floats
};

struct FirstItem {
  std::int64_t item;  // the number of items where none is hit
  double t;
  std::int32_t error;
};

/// The item that is hit first; of several at the same time the lowest.
FirstItem find_first_hit(const Cast& cast) noexcept;

bool cast_state_is_sound(const void* index, const std::int64_t* state) noexcept;

/// Writes the items that are hit, in the index's order, and returns how many. With capacity 0 all are counted, and
/// there is no state. Where an item's answer is an error, a call that has written some ends before it, and the next one
/// returns the error; the state then is behind the item.
std::int64_t write_hits(const Cast& cast, std::int64_t* out, std::int64_t capacity, std::int64_t* state) noexcept;

}  // namespace vesica::index
