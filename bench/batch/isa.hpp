// SPDX-License-Identifier: Apache-2.0
/// The instruction sets that are compared: the library's kernels of each, and the yardsticks built with the same flags.
#pragma once

#include <string_view>
#include <vector>

#include "batch/unfiltered/table.hpp"
#include "kernels/table.hpp"

namespace vesica::bench {

struct Isa {
  std::string_view name;
  const KernelTable* kernels;
  const unfiltered::Table* unfiltered;
};

/// The sets that this processor has, the best last.
const std::vector<Isa>& instruction_sets();

}  // namespace vesica::bench
