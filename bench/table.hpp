// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

namespace vesica::bench {

/// Prints every row that was timed: medians, the ratio to the yardstick with its quartiles, the target, and the peers.
/// Prints nothing when none was.
void print_table(std::FILE* out);

}  // namespace vesica::bench
