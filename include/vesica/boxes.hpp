// SPDX-License-Identifier: Apache-2.0
/// Boxes as detectors write them, with centre, width, height and angle: to and from rectangles and ellipses; corners.
#pragma once

#include <vesica/arithmetic/turn.hpp>
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

/// The corners of a rectangle: each coordinate to 1 roundoff of itself plus 2^-98 of the largest of its three terms.
class RectCorners {
 public:
  template <class T>
  explicit RectCorners(const Rect<T>& s) noexcept
      : cx_(static_cast<double>(s.cx)),
        cy_(static_cast<double>(s.cy)),
        along_x_(product(s.hx, s.ux)),
        along_y_(product(s.hx, s.uy)),
        across_x_(product(-s.hy, s.uy)),
        across_y_(product(s.hy, s.ux)) {}

  /// C +- hx u +- hy perp(u)
  VESICA_INLINE arithmetic::Direction at(bool along, bool across) const noexcept {
    return {sum(cx_, turned(along_x_, along), turned(across_x_, across)),
            sum(cy_, turned(along_y_, along), turned(across_y_, across))};
  }

 private:
  using Product = arithmetic::Pair<double>;

  template <class T>
  VESICA_INLINE static Product product(T h, T u) noexcept {
    return arithmetic::two_product_fused(static_cast<double>(h), static_cast<double>(u));
  }
  VESICA_INLINE static Product turned(const Product& p, bool keep) noexcept {
    return keep ? p : Product{-p.high, 0 - p.low};
  }
  VESICA_INLINE static double sum(double x, const Product& p, const Product& q) noexcept {
    return sum_of_four(x, p.high, q.high, p.low + q.low);
  }

  double cx_, cy_;
  Product along_x_, along_y_, across_x_, across_y_;
};

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
  const auto [x, y, length] = detail::arithmetic::unit_and_length(ux, uy);
  const auto full = [&, length = length](T half) {
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
  const detail::RectCorners of(s);
  // One after the other with known signs: a loop would choose them anew for each.
  const detail::arithmetic::Direction c[] = {of.at(false, false), of.at(true, false), of.at(true, true),
                                             of.at(false, true)};
  T result[8];
  for (int i = 0; i < 4; ++i) {
    result[2 * i] = static_cast<T>(c[i].x);
    result[2 * i + 1] = static_cast<T>(c[i].y);
  }
  const auto [x0, y0, x1, y1, x2, y2, x3, y3] = result;
  if (!detail::all_finite(x0, y0, x1, y1, x2, y2, x3, y3)) return error_range;
  for (int i = 0; i < 8; ++i) out[i] = result[i];
  return 0;
}

}  // namespace vesica
