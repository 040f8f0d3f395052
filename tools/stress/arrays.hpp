// SPDX-License-Identifier: Apache-2.0
/// Functions of arrays other than a query's batch and matrix: against the scalar functions, on every instruction set.
#pragma once

#include <span>
#include <vector>

#include "stress/batches.hpp"

namespace stress {

/// Ratios, casts, bounds, selection, suppression, and an index: of pairs as for judge_batches().
void judge_arrays(Scalar scalar, std::span<const Pair> pairs, unsigned layout, const Environment& environment,
                  std::vector<BatchFault>& faults);

}  // namespace stress
