// SPDX-License-Identifier: Apache-2.0
// Items of an index that one shape overlaps, in the index's order.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"
#include "join/decide.hpp"

namespace vesica::index {

struct Selection {
  const Kernels& kernels;
  const void* index;
  const Sets* sets;  // null with decide
  const Sets& one;   // a single shape
  Decide decide;     // null: boxes that meet
};

std::int64_t count_selected(const Selection& selection, const double (&box)[4]) noexcept;

bool selection_state_is_sound(const Selection& selection, const std::int64_t* state) noexcept;

std::int64_t write_selected(const Selection& selection, const double (&box)[4], std::int64_t* out,
                            std::int64_t capacity, std::int64_t* state) noexcept;

}  // namespace vesica::index
