// SPDX-License-Identifier: Apache-2.0
/// The nine-intersection matrix in exact integers, by other formulas than the library's.
#pragma once

#include <string>

namespace oracle {

/// For two valid shapes without a curve: neither a circle nor an ellipse with an area. Kinds and numbers as in
/// vesica.h. Nine characters of F, 0, 1 and 2.
std::string de9im(int kind_a, const double* a, int kind_b, const double* b);

}  // namespace oracle
