// SPDX-License-Identifier: Apache-2.0
/// Box2D's casts and times of impact of rectangles, in float; without its package there are none.
#pragma once

#include <vesica.h>

#include <cstddef>
#include <memory>

namespace vesica::bench {

/// Pairs as Box2D has them, made beforehand.
class Box2dCasts {
 public:
  Box2dCasts();
  ~Box2dCasts();
  void clear();
  void add(const vesica_rect_f64& a, const vesica_rect_f64& b, double vx, double vy, double angle);
  /// True if b hits a by the time 1. Only time_of_impact() turns it.
  bool shape_cast(std::size_t pair) const;
  bool time_of_impact(std::size_t pair) const;

 private:
  struct Pairs;
  std::unique_ptr<Pairs> pairs_;
};

}  // namespace vesica::bench
