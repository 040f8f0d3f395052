// SPDX-License-Identifier: Apache-2.0
/// The two forms the exact stage knows. Each shape becomes one without rounding, by the mapping of form/form.hpp.
#pragma once

#include <vesica/contact.hpp>
#include <vesica/exact/compare.hpp>
#include <vesica/form/form.hpp>

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

constexpr Length half(double x) noexcept { return from_double(x, -1); }

namespace detail {

namespace parts = vesica::detail::form;

constexpr Length number(const parts::Length<double>& l) noexcept { return from_double(l.x); }
constexpr Length number(const parts::Ratio<double>& r) noexcept { return from_double(r.x); }
constexpr Length number(const parts::Difference<double>& d) noexcept { return from_double(d.to) - from_double(d.from); }
constexpr Length number(const parts::HalfWidth<double>& w) noexcept { return half(w.to) - half(w.from); }
constexpr Length number(parts::Constant c) noexcept { return from_double(static_cast<double>(c.x)); }
constexpr Length number(parts::WidthAxis) noexcept { return from_double(1); }

constexpr Length centre_x(const parts::Centre<double>& p) noexcept { return from_double(p.x); }
constexpr Length centre_y(const parts::Centre<double>& p) noexcept { return from_double(p.y); }
constexpr Length centre_x(const parts::Corners<double>& p) noexcept { return half(p.x0) + half(p.x1); }
constexpr Length centre_y(const parts::Corners<double>& p) noexcept { return half(p.y0) + half(p.y1); }

template <class Exact, class Form>
constexpr Exact exact_form(const Form& f) noexcept {
  return {centre_x(f.place), centre_y(f.place), number(f.ux), number(f.uy), number(f.hx), number(f.hy)};
}

}  // namespace detail

/// A shape, exactly. Where its axis vanishes it is the point it starts at.
template <class Shape>
constexpr auto form(const Shape& s) noexcept {
  const auto f = vesica::detail::form::of(s);
  if constexpr (f.outline != vesica::detail::form::Outline::straight) {
    return detail::exact_form<Ellipse>(f);
  } else {
    if constexpr (f.axis_may_vanish) {
      if (f.ux.to == f.ux.from && f.uy.to == f.uy.from) {
        return detail::exact_form<Box>(vesica::detail::form::of(Point<double>{f.place.x0, f.place.y0}));
      }
    }
    return detail::exact_form<Box>(f);
  }
}

/// With a half length of zero an ellipse is the segment or point that the box of the same numbers is.
constexpr bool degenerate(const Ellipse& e) noexcept { return e.a.sign == 0 || e.b.sign == 0; }
constexpr Box as_box(const Ellipse& e) noexcept { return {e.cx, e.cy, e.ux, e.uy, e.a, e.b}; }

/// u.w
template <int A, int B>
constexpr Number<A + B> dot(const Number<A>& ux, const Number<A>& uy, const Number<B>& wx,
                            const Number<B>& wy) noexcept {
  return detail::sum_of_products(ux, wx, 1, uy, wy);
}

/// u x w
template <int A, int B, int C, int D>
constexpr auto cross(const Number<A>& ux, const Number<B>& uy, const Number<C>& wx, const Number<D>& wy) noexcept {
  return detail::sum_of_products(ux, wy, -1, uy, wx);
}

/// How far a point is beyond the rim of the disc of radius r about the origin: x^2 + y^2 - r^2 as
/// (|x| - r) (|x| + r) + y^2, or with x and y exchanged, so that only the sum may cancel.
template <int A, int R>
constexpr Number<2 * (A > R ? A : R)> beyond_rim(const Number<A>& x, const Number<A>& y,
                                                 const Number<R>& radius) noexcept {
  const bool x_is_greater = detail::compare_magnitude(x.span(), y.span()) > 0;
  const Number<A> greater = abs(x_is_greater ? x : y);
  return (greater - radius) * (greater + radius) + square(x_is_greater ? y : x);
}

/// 1 inside that disc, 0 on its rim, -1 outside.
template <int A, int R>
VESICA_CALLED constexpr int side_of_rim(const Number<A>& x, const Number<A>& y, const Number<R>& radius) noexcept {
  return -beyond_rim(x, y, radius).sign;
}

}  // namespace vesica::exact
