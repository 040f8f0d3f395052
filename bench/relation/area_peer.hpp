// SPDX-License-Identifier: Apache-2.0
/// Another library's shared areas.
#pragma once

#include <cstddef>
#include <memory>

#include "shapes.hpp"

namespace vesica::bench {

/// Pairs as Boost.Geometry has them: rectangles' corners and ellipses' inscribed 64-gons, made beforehand.
class BoostPairs {
 public:
  BoostPairs();
  ~BoostPairs();
  void add(std::int32_t kind_a, const Numbers& a, std::int32_t kind_b, const Numbers& b);
  double area(std::size_t pair) const;

 private:
  struct Polygons;
  std::unique_ptr<Polygons> polygons_;
};

/// Rectangles as rows and columns of a matrix of ratios. Areas too are found beforehand.
class BoostRows {
 public:
  BoostRows();
  BoostRows(BoostRows&&) noexcept;
  BoostRows& operator=(BoostRows&&) noexcept;
  ~BoostRows();
  void add_row(const Numbers& rect);
  void add_column(const Numbers& rect);
  double iou(std::size_t row, std::size_t column) const;

 private:
  struct Polygons;
  std::unique_ptr<Polygons> polygons_;
};

}  // namespace vesica::bench
