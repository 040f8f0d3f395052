// SPDX-License-Identifier: Apache-2.0
// The vector code of the index: one source for all instruction sets, included after lanes/<set>.hpp. Loops over
// doubles are left to the compiler; they are compiled without contraction, so that every set writes the same bytes.
#pragma once

#include "index/kernel/blocks.hpp"
#include "index/kernel/bounds.hpp"
#include "index/kernel/cells.hpp"
#include "index/kernel/distances.hpp"
#include "index/kernel/meetings.hpp"

namespace vesica::index {
namespace {  // an instantiation of its own in each object

consteval Kernels make_kernels() noexcept {
  return {bounds,     assign,    finish,          meeting_blocks, meet,
          candidates, in_window, child_distances, leaf_distances, item_distances};
}

}  // namespace
}  // namespace vesica::index
