// SPDX-License-Identifier: Apache-2.0
/// Discs, exactly, by the low degrees they allow: touching discs on integer grids are everyday input.
#pragma once

#include <vesica/exact/form.hpp>

namespace vesica::exact {

/// Whether the offset (dx, dy) is at most r long. Degree 2.
inline bool within(const Length& dx, const Length& dy, const Length& r) noexcept {
  return compare(square(dx) + square(dy), square(r)) <= 0;
}

/// Whether a box and a disc share a point: the distance from the disc's centre to the box is at most r. Degree 6.
inline bool overlap(const Box& box, const Circle<double>& disc) noexcept {
  const Length dx = from_double(disc.cx) - box.cx, dy = from_double(disc.cy) - box.cy;
  const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
  auto x = abs(dot(box.ux, box.uy, dx, dy)) - box.hx * uu;
  auto y = abs(cross(box.ux, box.uy, dx, dy)) - box.hy * uu;
  if (x.sign < 0) x = {};
  if (y.sign < 0) y = {};
  return compare(square(x) + square(y), square(from_double(disc.r)) * uu) <= 0;
}

}  // namespace vesica::exact
