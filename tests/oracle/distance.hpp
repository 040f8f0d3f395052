// SPDX-License-Identifier: Apache-2.0
/// Distances in exact integers, by other formulas than the library's.
#pragma once

namespace oracle {

/// Are two valid shapes, not both of them ellipses with an area, at most a finite `distance` >= 0 apart? Otherwise as
/// overlap() in oracle.hpp.
bool within(int kind_a, const double* a, int kind_b, const double* b, double distance);

}  // namespace oracle
