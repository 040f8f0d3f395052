// SPDX-License-Identifier: Apache-2.0
// The cell of the plan that a box belongs to, and the box's columns on that cell's grid.
#pragma once

#include "index/frame.hpp"
#include "index/kernels.hpp"

namespace vesica::index {
namespace {  // an instantiation of its own in each object

/// A box's middle; NaN where it has none, which falls into some cell and does not fit there.
inline double middle(double low, double high) noexcept { return low * 0.5 + high * 0.5; }

/// Level by level, so that no item waits for its last step. By single loads, as compilers that make vectors of this
/// take them apart again for each load; and without branches, which would be mispredicted.
inline void descend(const Plan& plan, const double* x, const double* y, int n, std::uint32_t* cell) noexcept {
  const double* const along[2] = {x, y};
  for (int level = descend_first_levels(plan, x, y, n, cell); level < plan.levels; ++level) {
    for (int i = 0; i < n; ++i) {
      std::uint32_t node = cell[i];
      asm("" : "+r"(node));
      const double cut = plan.node[node];
      const bool upper = along[__builtin_bit_cast(std::uint64_t, cut) & 1][i] >= cut;
      cell[i] = 2 * node + 1 + upper;
    }
  }
  const std::uint32_t inner = plan.cells() - 1;
  for (int i = 0; i < n; ++i) cell[i] -= inner;
}

/// A record of four columns below 2^16.
inline Record record_of(std::uint32_t min_x, std::uint32_t min_y, std::uint32_t max_x, std::uint32_t max_y) noexcept {
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  const std::uint64_t low = min_x | min_y << 16, high = max_x | max_y << 16;
  return __builtin_bit_cast(Record, low | high << 32);
#else
  return {{static_cast<std::uint16_t>(min_x), static_cast<std::uint16_t>(min_y), static_cast<std::uint16_t>(max_x),
           static_cast<std::uint16_t>(max_y)}};
#endif
}

/// The columns of one side; what lies outside of 0 to 65535 is limited to it, and does not fit.
inline void quantise(const double* v, const double* scale, const double* k, int n, std::uint32_t* out) noexcept {
  for (int i = 0; i < n; ++i) {
    constexpr double low = below_all, high = above_all;
    double q = grid_floor(v[i], scale[i]) - k[i];
    q = q < high ? q : high;
    q = q > low ? q : low;
    out[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(q));
  }
}

inline void assign(const Plan& plan, const Boxes& b, int n, std::uint32_t* cell, Record* out) noexcept {
  alignas(64) double x[chunk], y[chunk], scale[2][chunk], k[2][chunk];
  alignas(64) std::uint32_t side[4][chunk], place[chunk];
  for (int i = 0; i < n; ++i) {
    x[i] = middle(b.min_x[i], b.max_x[i]);
    y[i] = middle(b.min_y[i], b.max_y[i]);
  }
  descend(plan, x, y, n, place);
  for (int i = 0; i < n; ++i) {
    const Cell& c = plan.cell[place[i]];
    scale[0][i] = c.scale[0];
    scale[1][i] = c.scale[1];
    k[0][i] = c.k[0];
    k[1][i] = c.k[1];
  }
  quantise(b.min_x, scale[0], k[0], n, side[0]);
  quantise(b.min_y, scale[1], k[1], n, side[1]);
  quantise(b.max_x, scale[0], k[0], n, side[2]);
  quantise(b.max_y, scale[1], k[1], n, side[3]);
  const std::uint32_t cells = plan.cells();
  for (int i = 0; i < n; ++i) {
    const std::uint32_t outside =
        (side[0][i] < column_low) | (side[1][i] < column_low) | (side[2][i] > column_high) | (side[3][i] > column_high);
    const std::uint32_t wide = b.max_x[i] - b.min_x[i] > b.max_y[i] - b.min_y[i];
    const std::uint32_t misfit = cells + (wide != 0 ? residue_wide : residue_tall);
    const std::uint32_t to = outside != 0 ? misfit : place[i];
    cell[i] = b.valid[i] == 1 ? to : cells + left_out;
  }
  for (int i = 0; i < n; ++i) out[i] = record_of(side[0][i], side[1][i], side[2][i], side[3][i]);
}

}  // namespace
}  // namespace vesica::index
