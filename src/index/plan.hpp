// SPDX-License-Identifier: Apache-2.0
// The plan of a tier: a k-d tree over a sample, and a grid for each of its cells. Arithmetic of +, -, *, /, comparisons
// and exponents alone, in one order, so that it is the same on every machine.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"

namespace vesica::index {

/// Centre and extent of a sampled shape.
struct Sample {
  double centre[2], extent[2];
};

/// The output of a plan: room for cells() - 1 nodes and cells() cells and frames.
struct PlanRoom {
  int levels;
  double* node;
  Cell* cell;
  Frame* frame;
};

/// Plans 2^levels cells from n finite samples, which are put in another order; `spare` has room for as many.
void make_plan(Sample* sample, Sample* spare, std::int64_t n, const PlanRoom& room) noexcept;

/// The grid that holds a box with room to spare; where that is infinite, the one that holds every double.
Frame frame_around(const double (&box)[4]) noexcept;

/// A frame as kernels apply it.
Cell cell_of(const Frame& frame) noexcept;

}  // namespace vesica::index
