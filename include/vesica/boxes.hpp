// SPDX-License-Identifier: Apache-2.0
/// Boxes as detectors write them, with centre, width, height and angle: to and from rectangles and ellipses; corners.
#pragma once

#include <vesica/construct.hpp>

namespace vesica {

/// A turned box: centre, full size along the angle and across it, and the angle.
template <class T>
struct TurnedBox {
  T cx, cy, width, height, angle;
};

namespace detail {

template <class T>
int check_box(const TurnedBox<T>& box) noexcept {
  if (!all_finite(box.cx, box.cy, box.width, box.height, box.angle)) return error_not_finite;
  return box.width < 0 || box.height < 0 ? error_negative_size : 0;
}

/// One coordinate of a rectangle's corners, c +- h0 u0 +- h1 u1, right to 1 roundoff of the coordinate plus 2^-98
/// of the largest of the three terms.
template <class V>
class CornerCoordinate {
 public:
  VESICA_INLINE CornerCoordinate(V c, V h0, V u0, V h1, V u1) noexcept
      : c_(c), along_(product(h0, u0)), across_(product(h1, u1)) {}

  /// Each product is added where its argument is set, and else subtracted.
  VESICA_INLINE V at(bool along, bool across) const noexcept {
    const Product p = turned(along_, along), q = turned(across_, across);
    return sum_of_four(c_, p.high, q.high, p.low + q.low);
  }

 private:
  using Product = arithmetic::Pair<V>;

  VESICA_INLINE static Product product(V h, V u) noexcept {
    using arithmetic::two_product_fused;
    return two_product_fused(h, u);
  }
  VESICA_INLINE static Product turned(const Product& p, bool keep) noexcept {
    return keep ? p : Product{-p.high, V(0.0) - p.low};
  }

  V c_;
  Product along_, across_;
};

/// C +- hx u +- hy perp(u)
class RectCorners {
 public:
  explicit RectCorners(const Rect<double>& s) noexcept
      : x_(s.cx, s.hx, s.ux, -s.hy, s.uy), y_(s.cy, s.hx, s.uy, s.hy, s.ux) {}

  VESICA_INLINE arithmetic::Direction at(bool along, bool across) const noexcept {
    return {x_.at(along, across), y_.at(along, across)};
  }

 private:
  CornerCoordinate<double> x_, y_;
};

/// Corners as numbers of the shape's own type. False where one is beyond the finite ones.
template <class T>
bool narrow_corners(const double (&from)[8], T (&out)[8]) noexcept {
  for (int i = 0; i < 8; ++i) out[i] = static_cast<T>(from[i]);
  const auto [x0, y0, x1, y1, x2, y2, x3, y3] = out;
  return all_finite(x0, y0, x1, y1, x2, y2, x3, y3);
}

}  // namespace detail

/// Errors: error_not_finite, error_negative_size.
template <class T>
int rect_from_box(const TurnedBox<T>& box, AngleUnit unit, Rect<T>& out) noexcept {
  const int error = detail::check_box(box);
  if (error != 0) return error;
  const auto u = detail::arithmetic::direction(static_cast<double>(box.angle), unit);
  out = detail::rect_along(box.cx, box.cy, static_cast<T>(u.x), static_cast<T>(u.y), box.width, box.height);
  return 0;
}

/// The ellipse that touches the box's sides at their middles. Errors as rect_from_box.
template <class T>
int ellipse_from_box(const TurnedBox<T>& box, AngleUnit unit, Ellipse<T>& out) noexcept {
  Rect<T> rect;
  const int error = rect_from_box(box, unit, rect);
  if (error == 0) out = {rect.cx, rect.cy, rect.ux, rect.uy, rect.hx, rect.hy};
  return error;
}

/// The box that a rectangle is, its angle from -180 to 180 degrees. Errors: error_shape, error_range.
template <class T>
int box_from_rect(const Rect<T>& s, AngleUnit unit, TurnedBox<T>& out) noexcept {
  if (check(s) != 0) return error_shape;
  const double ux = static_cast<double>(s.ux), uy = static_cast<double>(s.uy);
  const detail::arithmetic::Scaled length = detail::arithmetic::unit_and_length(ux, uy).length;
  const auto full = [&](T half) {
    const auto size = detail::take_apart(static_cast<double>(half));
    return detail::multiply<T>({2 * size.value, size.exponent}, length);
  };
  const TurnedBox<T> box{s.cx, s.cy, full(s.hx), full(s.hy), static_cast<T>(detail::arithmetic::angle(ux, uy, unit))};
  if (detail::check_box(box) != 0) return error_range;
  out = box;
  return 0;
}

/// The four corners x0 y0 ... x3 y3, counter-clockwise where y points up, from C - hx u - hy perp(u).
/// Errors: error_shape, error_range.
template <class T>
int corners(const Rect<T>& s, T (&out)[8]) noexcept {
  if (check(s) != 0) return error_shape;
  const detail::RectCorners of(widen(s));
  // One after the other with known signs: a loop would choose them anew for each.
  const detail::arithmetic::Direction c[] = {of.at(false, false), of.at(true, false), of.at(true, true),
                                             of.at(false, true)};
  const double wide[] = {c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y, c[3].x, c[3].y};
  T result[8];
  if (!detail::narrow_corners(wide, result)) return error_range;
  for (int i = 0; i < 8; ++i) out[i] = result[i];
  return 0;
}

}  // namespace vesica
