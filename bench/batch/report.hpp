// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "batch/run.hpp"

namespace vesica::bench {

/// Explains the columns and prints their names.
void print_heading();

/// One line, as soon as it is measured. scalar_nanoseconds: of the scalar call on such pairs.
void print_row(const Spec& spec, const Result& result, double scalar_nanoseconds);

/// True if the row reaches its target; one without a target does.
bool reaches_target(const Spec& spec, const Result& result);

}  // namespace vesica::bench
