// SPDX-License-Identifier: Apache-2.0
/// The rounded corners of straight shapes, in the order of their exact ones (crossings/points.hpp).
#pragma once

#include <vesica/boxes.hpp>
#include <vesica/intersection/polygons.hpp>

namespace vesica::detail::intersection {

/// Room for as many as a shape may have.
using Rounded = Vertex[4];

inline void corners(const Point<double>& s, Rounded& out) noexcept { out[0] = {s.x, s.y}; }
inline void corners(const Segment<double>& s, Rounded& out) noexcept {
  out[0] = {s.x0, s.y0};
  out[1] = {s.x1, s.y1};
}

/// low, high: along one size, or across it where that is 0.
template <class At>
void corners_of_sizes(bool wide, bool high, Rounded& out, const At& at) noexcept {
  const int count = (wide ? 2 : 1) * (high ? 2 : 1);
  for (int i = 0; i < count; ++i) {
    const bool right = wide && (i == 1 || i == 2), top = high && (count == 2 ? i == 1 : i >= 2);
    out[i] = at(right, top);
  }
}

inline void corners(const Aabb<double>& s, Rounded& out) noexcept {
  corners_of_sizes(s.min_x < s.max_x, s.min_y < s.max_y, out, [&](bool right, bool top) -> Vertex {
    return {right ? s.max_x : s.min_x, top ? s.max_y : s.min_y};
  });
}

inline void corners(const Rect<double>& s, Rounded& out) noexcept {
  const RectCorners of(s);
  corners_of_sizes(s.hx > 0, s.hy > 0, out, [&](bool right, bool top) -> Vertex {
    const auto corner = of.at(right, top);
    return {corner.x, corner.y};
  });
}

}  // namespace vesica::detail::intersection
