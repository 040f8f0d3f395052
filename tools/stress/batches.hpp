// SPDX-License-Identifier: Apache-2.0
/// Batches against scalar answers, on every instruction set in one process. The library chooses its instruction set
/// when it is loaded, so one copy of it is loaded for each (libraries.hpp).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "stress/laws.hpp"

namespace stress {

/// The instruction sets this processor has, of those the library was built for.
std::vector<std::string> instruction_sets();

/// A batch's element that differs from the scalar answer.
struct BatchFault {
  std::size_t element;  ///< of the pairs; their number where what the batch returned is wrong
  Fault fault;
};

/// Every batch function on pairs of the same two kinds and one scalar type: in step, and as a matrix. What lies in
/// memory where depends on `layout`, any number. Shapes may be invalid.
std::vector<BatchFault> judge_batches(Scalar scalar, std::span<const Pair> pairs, unsigned layout,
                                      const Environment& environment = default_environment);

/// The same for many copies of one pair.
void judge_copies(Judge& j, const Case& c, bool environments);

}  // namespace stress
