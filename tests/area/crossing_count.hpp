// SPDX-License-Identifier: Apache-2.0
/// How many places two outlines meet at, in exact integers, by other formulas than the library's: polynomials along one
/// outline and Sturm's theorem, and rational points of edges.
#pragma once

namespace reference {

struct Meeting {
  int count;
  bool shared;
};

/// Valid shapes, kinds and numbers as in vesica.h; as vesica_crossings counts.
Meeting meeting(int kind_a, const double* a, int kind_b, const double* b);

}  // namespace reference
