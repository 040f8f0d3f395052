// SPDX-License-Identifier: Apache-2.0
// Lower bounds of the distances from a shape to nodes, leaves and items.
#pragma once

#include "index/frame.hpp"
#include "index/kernels.hpp"

namespace vesica::index {
namespace {  // an instantiation of its own in each object

inline double greater_of(double a, double b) noexcept { return a > b ? a : b; }
inline double lesser_of(double a, double b) noexcept { return a < b ? a : b; }

/// The library's distance errs by less than 4 u of the largest offset or half length, so of both shapes' common extent.
inline constexpr double error_of_extent = 0x1p-48;

inline void child_distances(const Node& node, const Bounding& shape, double* out) noexcept {
  const double(&box)[4] = shape.box;
  for (int i = 0; i < node_children; ++i) {
    const double min_x = node.min_x[i], min_y = node.min_y[i], max_x = node.max_x[i], max_y = node.max_y[i];
    const double x = greater_of(greater_of(min_x - box[2], box[0] - max_x), 0);
    const double y = greater_of(greater_of(min_y - box[3], box[1] - max_y), 0);
    const double extent = greater_of(greater_of(max_x, box[2]) - lesser_of(min_x, box[0]),
                                     greater_of(max_y, box[3]) - lesser_of(min_y, box[1]));
    const double most = greater_of(x, y);
    const bool usable = (most >= 0x1p-480) & (most <= 0x1p480);
    const double sx = usable ? x : 0, sy = usable ? y : 0;
    const double root = __builtin_sqrt(sx * sx + sy * sy), distance = usable ? root : most;
    const double bound = greater_of(distance * shape.factor - (extent * error_of_extent + shape.least), 0);
    out[i] = min_x <= max_x ? bound : __builtin_nan("");
  }
}

/// A shape's box on a block's grid, all lengths times 2^-e, at which nothing that matters over- or underflows.
struct Ruler {
  double unit[2], low[2], high[2];  // along an axis: a column, the shape's ends from the grid's column 0
  double factor, least;             // from such a length to a bound

  Ruler(const Block& block, const Bounding& shape) noexcept {
    const std::int32_t column[4] = {block.box.min_x, block.box.min_y, block.box.max_x + 1, block.box.max_y + 1};
    const Frame& frame = block.frame;
    double extent = 0;
    for (int a = 0; a < 2; ++a) {
      const double size = power_of_two(frame.p[a]);
      const double first = lesser_of(static_cast<double>(frame.k[a] + column[a]) * size, shape.box[a]);
      const double last = greater_of(static_cast<double>(frame.k[a] + column[a + 2]) * size, shape.box[a + 2]);
      extent = greater_of(extent, last - first);
    }
    constexpr int most = 900;
    const int exponent = static_cast<int>(__builtin_bit_cast(std::uint64_t, extent) >> 52) - 1022;
    const int e = exponent > most ? most : exponent < -most ? -most : exponent;
    for (int a = 0; a < 2; ++a) {
      const int p = frame.p[a] - e;
      unit[a] = p < -1022 ? 0 : power_of_two(p);
      low[a] = shape.box[a] * power_of_two(-e);
      high[a] = shape.box[a + 2] * power_of_two(-e);
    }
    factor = shape.factor * power_of_two(e);
    least = extent * error_of_extent + shape.least;
  }
};

/// `boxes` many, in the columns of a block's grid. (column + k) is exact, and so is its product with the unit: at least
/// half of the last place of a sum of such is left by the factor.
inline void column_distances(const Frame& frame, const Ruler& ruler, const std::uint16_t* min_x,
                             const std::uint16_t* min_y, const std::uint16_t* max_x, const std::uint16_t* max_y,
                             int boxes, double* out) noexcept {
  const double kx = static_cast<double>(frame.k[0]), ky = static_cast<double>(frame.k[1]);
  const double unit_x = ruler.unit[0], unit_y = ruler.unit[1], low_x = ruler.low[0], low_y = ruler.low[1];
  const double high_x = ruler.high[0], high_y = ruler.high[1], factor = ruler.factor, least = ruler.least;
  for (int i = 0; i < boxes; ++i) {
    const double x = greater_of((min_x[i] + kx) * unit_x - high_x, low_x - (max_x[i] + (kx + 1)) * unit_x);
    const double y = greater_of((min_y[i] + ky) * unit_y - high_y, low_y - (max_y[i] + (ky + 1)) * unit_y);
    const double apart_x = greater_of(x, 0), apart_y = greater_of(y, 0);
    const double length = __builtin_sqrt(apart_x * apart_x + apart_y * apart_y);
    out[i] = greater_of(length * factor - least, 0);
  }
}

inline void leaf_distances(const Block& block, const Bounding& shape, double* out) noexcept {
  column_distances(block.frame, Ruler(block, shape), leaf_boxes(block, 0), leaf_boxes(block, 1), leaf_boxes(block, 2),
                   leaf_boxes(block, 3), leaf_row(block.leaves), out);
}

/// The greatest width or height of a leaf's items, in columns.
inline double greatest_size(const std::uint16_t* low, const std::uint16_t* high) noexcept {
  std::uint16_t most = 0;
  for (int i = 0; i < leaf_items; ++i) {
    const auto size = static_cast<std::uint16_t>(high[i] < low[i] ? 0 : high[i] - low[i]);
    most = size > most ? size : most;
  }
  return most;
}

/// A side lies in its column, so an item's box is at most a column farther along each axis than the bound says. A shape
/// that is not its own box is farther from that by at most the box's sides.
inline double item_distances(const Block& block, const Leaf& leaf, const Bounding& shape, double* out) noexcept {
  const Ruler ruler(block, shape);
  column_distances(block.frame, ruler, leaf.min_x, leaf.min_y, leaf.max_x, leaf.max_y, leaf_items, out);
  double width = 1, height = 1;
  if (!shape.boxes_alone) {
    width += greatest_size(leaf.min_x, leaf.max_x) + 1;
    height += greatest_size(leaf.min_y, leaf.max_y) + 1;
  }
  const double sides = width * power_of_two(block.frame.p[0]) + height * power_of_two(block.frame.p[1]);
  return (sides + shape.sides) * (1 + 0x1p-20) + 4 * ruler.least;
}

}  // namespace
}  // namespace vesica::index
