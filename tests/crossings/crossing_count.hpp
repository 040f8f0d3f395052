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

/// For two ellipses or circles with area: at how many places b's outline meets a's between two of
/// its angles, less than a full turn from `from` on to `to`; radians from the end of the axis, as cos and sin are of
/// them.
int meetings_between(int kind_a, const double* a, int kind_b, const double* b, double from, double to);

}  // namespace reference
