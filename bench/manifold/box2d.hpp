// SPDX-License-Identifier: Apache-2.0
/// Box2D's manifolds of rectangles, in float; without its package there are none.
#pragma once

#include <vesica.h>

#include <cstddef>
#include <memory>

namespace vesica::bench {

/// Pairs as Box2D has them, made beforehand.
class Box2dManifolds {
 public:
  Box2dManifolds();
  ~Box2dManifolds();
  void clear();
  void add(const vesica_rect_f64& a, const vesica_rect_f64& b);
  /// How many contacts there are.
  int ask(std::size_t pair) const;

 private:
  struct Pairs;
  std::unique_ptr<Pairs> pairs_;
};

}  // namespace vesica::bench
