// SPDX-License-Identifier: Apache-2.0
/// shape_area() of polygons: the sum of trapezoids between each edge and a level line, each ring with its own sense.
#pragma once

#include <vesica/polygon/sense.hpp>
#include <vesica/shape_area.hpp>

namespace vesica {

namespace detail::polygon {

using area::Measure;

/// A sum whose partial sums are not rounded.
struct Sum {
  double high = 0, low = 0;

  VESICA_INLINE Sum& operator+=(double x) noexcept {
    const auto s = arithmetic::two_sum(high, x);
    high = s.high;
    low += s.low;
    return *this;
  }
  double value() const noexcept { return high + low; }
};

/// Multiplies coordinates of unusual magnitudes by powers of two, so that areas neither overflow nor underflow: the
/// greatest is then about 1. Usual ones stay as they are.
struct Scale {
  double x, y;
  int exponent;  // an area is as many powers of two greater than computed

  explicit Scale(const Box& box) noexcept : x(1), y(1), exponent(0) {
    const double most_x = greater(lane::abs(box.min_x), lane::abs(box.max_x));
    const double most_y = greater(lane::abs(box.min_y), lane::abs(box.max_y));
    if (is_usual(most_x) && is_usual(most_y)) [[likely]]
      return;
    x = factor(most_x);
    y = factor(most_y);
  }

  VESICA_INLINE Edge operator()(const Edge& e) const noexcept { return {e.x0 * x, e.y0 * y, e.x1 * x, e.y1 * y}; }
  VESICA_INLINE Box operator()(const Box& b) const noexcept {
    return {b.min_x * x, b.min_y * y, b.max_x * x, b.max_y * y};
  }

 private:
  static bool is_usual(double most) noexcept { return most == 0 || (most >= 0x1p-150 && most <= 0x1p150); }
  double factor(double most) noexcept {
    const int up = std::clamp(-arithmetic::exponent_of(most), -1000, 1000);
    exponent -= up;
    return arithmetic::power_of_two(up);
  }
};

/// Do all vertices of each ring lie on one line? Exact.
template <class T>
bool is_flat(const Edges<T>& edges) noexcept {
  for (std::int64_t j = 0; j < edges.rings(); ++j) {
    Edge line{};
    bool found = false;
    const bool turns = edges.for_edges(edges.ring(j), [&](const Edge& e, std::int64_t) {
      if (found) return side(e.x1, e.y1, line) != 0;
      found = e.x0 != e.x1 || e.y0 != e.y1;
      line = e;
      return false;
    });
    if (turns) return false;
  }
  return true;
}

/// The area of a valid polygon, and 0 for a polyline. 0 means exactly none.
///
/// Each trapezoid is off by at most 2u times its width times the height of the box, u = 2^-53, and the sum by less: in
/// all 8u times the height times the widths of all edges, for a convex polygon 16u times the area of its box.
template <class T>
Measure measure(const Edges<T>& edges, const Box& box, Senses<T>& senses) noexcept {
  if (!edges.closed()) return {0, 0};
  const Scale scale(box);
  const Box scaled = scale(box);
  const double level = 0.5 * scaled.min_y + 0.5 * scaled.max_y;
  Sum doubled;
  double widths = 0;
  senses.for_edges(edges.all(), [&](const Edge& stored, double sense) {
    const Edge e = scale(stored);
    const double width = e.x1 - e.x0;
    doubled += (sense * width) * ((e.y0 - level) + (e.y1 - level));
    widths += lane::abs(width);
  });
  const double area = 0.5 * lane::abs(doubled.value()), error = 0x1p-50 * widths * (scaled.max_y - scaled.min_y);
  if (area > error) [[likely]]
    return {area, scale.exponent};
  if (is_flat(edges)) return {0, 0};
  return {area > 0 ? area : 0x1p-60 * error, scale.exponent};
}

}  // namespace detail::polygon

/// As for other shapes: 0, error_shape or error_range. The error of a polygon's area is at most 8u (u = 2^-53) times
/// the height of its box times the sum of its edges' widths. Edges must not cross.
template <template <class> class Shape, class T>
requires Path<Shape<T>> std::int32_t shape_area_or_error(const Shape<T>& s, T& out)
noexcept {
  using namespace detail::polygon;
  const Edges<T> edges(s);
  Box box;
  if (edges.check(box) != 0) return error_shape;
  Senses<T> senses(edges);
  return detail::area::store(measure(edges, box, senses), out);
}

}  // namespace vesica
