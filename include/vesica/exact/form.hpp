// SPDX-License-Identifier: Apache-2.0
/// The two forms the exact stage knows, and how each shape becomes one, without rounding.
#pragma once

#include <vesica/exact/number.hpp>
#include <vesica/shapes.hpp>

namespace vesica::exact {

using Length = Number<1>;

/// { C + s u + t perp(u) : |s| <= hx, |t| <= hy }. Points, segments and AABBs are boxes too.
struct Box {
  Length cx, cy, ux, uy, hx, hy;
};

/// { C + s u + t perp(u) : (s/a)^2 + (t/b)^2 <= 1 }. A circle is one with a = b.
struct Ellipse {
  Length cx, cy, ux, uy, a, b;
};

inline Length half(double x) noexcept { return from_double(x, -1); }

inline Box form(const Point<double>& s) noexcept {
  return {from_double(s.x), from_double(s.y), from_double(1), from_double(0), from_double(0), from_double(0)};
}

/// The axis is the difference of the end points and the half extent 1/2; a segment of no length needs some axis.
inline Box form(const Segment<double>& s) noexcept {
  if (s.x0 == s.x1 && s.y0 == s.y1) return form(Point<double>{s.x0, s.y0});
  return {half(s.x0) + half(s.x1),
          half(s.y0) + half(s.y1),
          from_double(s.x1) - from_double(s.x0),
          from_double(s.y1) - from_double(s.y0),
          from_double(0.5),
          from_double(0)};
}

inline Box form(const Aabb<double>& s) noexcept {
  return {half(s.min_x) + half(s.max_x), half(s.min_y) + half(s.max_y), from_double(1), from_double(0),
          half(s.max_x) - half(s.min_x), half(s.max_y) - half(s.min_y)};
}

inline Box form(const Rect<double>& s) noexcept {
  return {from_double(s.cx), from_double(s.cy), from_double(s.ux),
          from_double(s.uy), from_double(s.hx), from_double(s.hy)};
}

inline Ellipse form(const Circle<double>& s) noexcept {
  return {from_double(s.cx), from_double(s.cy), from_double(1), from_double(0), from_double(s.r), from_double(s.r)};
}

inline Ellipse form(const vesica::Ellipse<double>& s) noexcept {
  return {from_double(s.cx), from_double(s.cy), from_double(s.ux),
          from_double(s.uy), from_double(s.a),  from_double(s.b)};
}

/// With a half length of zero an ellipse is the segment or point that the box of the same numbers is.
inline bool degenerate(const Ellipse& e) noexcept { return e.a.sign == 0 || e.b.sign == 0; }
inline Box as_box(const Ellipse& e) noexcept { return {e.cx, e.cy, e.ux, e.uy, e.a, e.b}; }

/// u.w
template <int A, int B>
Number<A + B> dot(const Number<A>& ux, const Number<A>& uy, const Number<B>& wx, const Number<B>& wy) noexcept {
  return ux * wx + uy * wy;
}

/// u x w
template <int A, int B>
Number<A + B> cross(const Number<A>& ux, const Number<A>& uy, const Number<B>& wx, const Number<B>& wy) noexcept {
  return ux * wy - uy * wx;
}

}  // namespace vesica::exact
