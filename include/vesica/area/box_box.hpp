// SPDX-License-Identifier: Apache-2.0
/// The area that two boxes share. In the frame of one box, the outline of the other is clamped to the first box; the
/// shared area is the integral of -y dx along the clamped outline. There are no cases and nothing is sorted, so one
/// formula serves a double and lanes of doubles.
#pragma once

#include <type_traits>
#include <vesica/area/measure.hpp>
#include <vesica/exact/form.hpp>
#include <vesica/exact/rounded.hpp>
#include <vesica/filter/box.hpp>

namespace vesica::detail::area {

using namespace lane;  // for scalars; lanes of a vector bring the same names by argument-dependent lookup

/// An area, and whether it is settled. If not, the caller needs the exact predicates or more digits.
template <class V, class Mask>
struct Settled {
  V area;
  Mask settled;
};

/// The clamping box: |x| <= ex, |y| <= ey, in units that the caller knows.
template <class V>
struct Extents {
  V ex, ey;
};

/// The box that is followed, { low_0 <= w.X <= high_0, low_1 <= w x X <= high_1 } times |w|^2 for the X of the frame:
/// (c, s) is w there, and X = (i c - j s, i s + j c) for the coordinates i = w.X and j = w x X.
template <class V>
struct Strips {
  V c, s, low_0, high_0, low_1, high_1;
};

template <class V>
VESICA_INLINE V clamp(V x, V low, V high) noexcept {
  return max(min(x, high), low);
}

/// A line's direction (mx, my) with reciprocals of both, and the clamped y behind (t too small) where y rises with t.
template <class V>
struct Direction {
  V mx, my, over_x, over_y, behind;
};

/// 1 / x, but finite for 0: a line that is parallel to a clamp is far inside or far beyond, on the side it is on.
template <class V>
VESICA_INLINE V reciprocal(V x) noexcept {
  return clamp(V(1.0) / x, V(-0x1p1000), V(0x1p1000));
}

/// The integral of clamped y dx along (x0 + t mx, y0 + t my), low <= t <= high, x clamped too. t runs through where x
/// is inside, in up to three parts: y below, y inside, y above, or the other way round.
template <class V>
VESICA_INLINE V clamped_integral(const Extents<V>& e, const Direction<V>& d, V x0, V y0, V low, V high) noexcept {
  const V t0 = (-e.ex - x0) * d.over_x, t1 = (e.ex - x0) * d.over_x;
  const V from = max(low, min(t0, t1)), to = max(min(high, max(t0, t1)), from);
  const V s0 = (-e.ey - y0) * d.over_y, s1 = (e.ey - y0) * d.over_y;
  const V inside_from = clamp(min(s0, s1), from, to), inside_to = clamp(max(s0, s1), from, to);
  const V y_from = clamp(y0 + inside_from * d.my, -e.ey, e.ey), y_to = clamp(y0 + inside_to * d.my, -e.ey, e.ey);
  const V outside = d.behind * ((inside_from - from) - (to - inside_to));
  return d.mx * (outside + V(0.5) * (y_from + y_to) * (inside_to - inside_from));
}

/// The area shared, in units of the frame divided by |w|^2: four edges, the two pairs with a direction each.
template <class V>
VESICA_INLINE V clipped_area(const Extents<V>& e, const Strips<V>& b) noexcept {
  const V over_c = reciprocal(b.c), over_s = reciprocal(b.s);
  const Direction<V> along{b.c, b.s, over_c, over_s, -flip_sign(e.ey, b.s)};
  const Direction<V> across{-b.s, b.c, -over_s, over_c, -flip_sign(e.ey, b.c)};
  const V right = clamped_integral(e, across, b.high_0 * b.c, b.high_0 * b.s, b.low_1, b.high_1);
  const V left = clamped_integral(e, across, b.low_0 * b.c, b.low_0 * b.s, b.low_1, b.high_1);
  const V top = clamped_integral(e, along, -b.high_1 * b.s, b.high_1 * b.c, b.low_0, b.high_0);
  const V bottom = clamped_integral(e, along, -b.low_1 * b.s, b.low_1 * b.c, b.low_0, b.high_0);
  return (left - right) + (top - bottom);
}

/// The exponent of an axis: times 2^-exponent, its longer part is in [1/2, 1).
inline int axis_exponent(double ux, double uy) noexcept {
  return arithmetic::exponent_of(std::fmax(std::fabs(ux), std::fabs(uy)));
}

/// An order of two shapes about one centre by their numbers. A power of two may be moved between axis and sizes without
/// changing a shape, so the numbers are compared with the axes at one scale.
inline bool precedes(const filter::Box<double>& a, const filter::Box<double>& b) noexcept {
  using arithmetic::scale;
  const int i = axis_exponent(a.ux, a.uy), j = axis_exponent(b.ux, b.uy);
  const double numbers_a[] = {scale(a.hx, i), scale(a.hy, i), scale(a.ux, -i), scale(a.uy, -i)};
  const double numbers_b[] = {scale(b.hx, j), scale(b.hy, j), scale(b.ux, -j), scale(b.uy, -j)};
  for (int k = 0; k < 4; ++k) {
    if (numbers_a[k] != numbers_b[k]) return numbers_a[k] < numbers_b[k];
  }
  return false;
}

/// Which of two shapes goes first, so that exchanging the arguments, or another scale, changes no bit: the one of
/// lesser area; of equal areas the one to the left, or the lower one. Lanes leave shapes of equal area about one centre
/// to the scalar call.
template <class Mask>
struct Order {
  Mask first, known;
};

/// d: from a's centre to b's.
template <class V>
VESICA_INLINE auto order(const filter::Box<V>& a, const filter::Box<V>& b, const filter::Centre<V>& d, V area_a,
                         V area_b) noexcept {
  const V zero(0.0);
  if constexpr (std::is_same_v<V, double>) {
    const bool concentric = d.x == zero && d.y == zero;
    const bool first = area_a != area_b ? area_a < area_b
                       : concentric     ? precedes(a, b)
                                        : d.x > zero || (d.x == zero && d.y > zero);
    return Order<bool>{first, true};
  } else {
    const auto equal = area_a == area_b, level = d.x == zero;
    const auto first = either(area_a < area_b, both(equal, either(d.x > zero, both(level, d.y > zero))));
    const auto concentric = both(equal, both(level, d.y == zero));
    return Order<std::remove_const_t<decltype(equal)>>{first, and_not(zero == zero, concentric)};
  }
}

/// The first or the second of two boxes.
template <class Mask, class V>
VESICA_INLINE filter::Box<V> choose(Mask first, const filter::Box<V>& a, const filter::Box<V>& b) noexcept {
  if constexpr (std::is_same_v<V, double>) {
    const filter::Box<V> boxes[2] = {b, a};
    return boxes[first];  // no jump: which it is cannot be predicted
  } else {
    return {select(first, a.ux, b.ux), select(first, a.uy, b.uy), select(first, a.hx, b.hx), select(first, a.hy, b.hy)};
  }
}

/// Sizes and distances between 2^-200 and 2^200, squared axes between 2^-100 and 2^100. What is not a number, not
/// positive or not finite is not in range.
template <class V>
VESICA_INLINE auto in_clip_range(const filter::Box<V>& a, const filter::Box<V>& b, V distances, V uu, V ww) noexcept {
  const V least = min(min(a.hx, a.hy), min(b.hx, b.hy));
  const V most = (a.hx + a.hy) + (b.hx + b.hy) + distances;
  const auto axes = both(filter::in_range(uu, V(0x1p-100), V(0x1p100)), filter::in_range(ww, V(0x1p-100), V(0x1p100)));
  return both(axes, both(least >= V(0x1p-200), most <= V(0x1p200)));
}

/// The area of two boxes, d from a's centre to b's. Settled where it is certain that they cross and that enough digits
/// are left.
///
/// In the units used, in which a's corners are at (ex, ey) and a squared length of 1 is U W^2, let T be the sum of the
/// terms of w.D, w x D and of b's sizes times W, R = |c| + |s| >= |u||w|, and E = u T R (ex + ey), u = 2^-53. A line of
/// b is at most 7u T / |w| from its place, and four lines of at most 2 |u| (hx + hy) run within the first box; the
/// integral's own rounding is less: so the error is below 64 E, and where the area is further than that from 0 and from
/// the lesser shape's, the boxes cross. Observed on 80,000 pairs of aspects to 10^4 and sizes to 30-fold: at most 2.3
/// E. The promised 64u aspect * area are 2.6 E or more where T R <= 48 max(ex, ey), that is for sizes to about 10-fold.
template <class V>
VESICA_INLINE auto crossing_area(const filter::Box<V>& a, const filter::Box<V>& b,
                                 const filter::Centre<V>& offset) noexcept {
  const V uu_a = a.ux * a.ux + a.uy * a.uy, uu_b = b.ux * b.ux + b.uy * b.uy;
  const auto [keep, ordered] = order(a, b, offset, a.hx * a.hy * uu_a, b.hx * b.hy * uu_b);
  const filter::Box<V> frame = choose(keep, a, b), other = choose(keep, b, a);
  const V turn = select(keep, V(1.0), V(-1.0)), dx = offset.x * turn, dy = offset.y * turn;
  const V vv = frame.ux * frame.ux + frame.uy * frame.uy, ww = other.ux * other.ux + other.uy * other.uy;
  const V scale = vv * ww;
  const Extents<V> e{frame.hx * scale, frame.hy * scale};

  const V xx = other.ux * dx, yy = other.uy * dy, xy = other.ux * dy, yx = other.uy * dx;
  const V along = xx + yy, across = xy - yx, reach_0 = other.hx * ww, reach_1 = other.hy * ww;
  const V c = frame.ux * other.ux + frame.uy * other.uy, s = frame.ux * other.uy - frame.uy * other.ux;
  const Strips<V> strips{c, s, along - reach_0, along + reach_0, across - reach_1, across + reach_1};
  const V area = clipped_area(e, strips), least = V(4.0) * e.ex * e.ey;

  const V terms = (abs(xx) + abs(yy)) + (abs(xy) + abs(yx)) + (reach_0 + reach_1);
  const V spread = terms * (abs(c) + abs(s)), error = V(0x1p-47) * spread * (e.ex + e.ey);
  const auto accurate = spread <= V(48.0) * max(e.ex, e.ey);
  const auto crossing = both(area > error, least - area > error);
  const auto settled = both(both(both(accurate, ordered), crossing), in_clip_range(a, b, abs(dx) + abs(dy), vv, ww));
  return Settled<V, decltype(a.hx < a.hx)>{area / (scale * ww), settled};
}

template <class V>
VESICA_INLINE auto crossing_area(const Rect<V>& a, const Rect<V>& b) noexcept {
  return crossing_area(filter::box(a), filter::box(b), filter::offset(filter::place(a), filter::place(b)));
}

/// m * 2^-exponent, kept within bounds so that no product overflows.
inline double bounded(const arithmetic::Scaled& m, int exponent, double bound) noexcept {
  return clamp(arithmetic::scale(m.value, m.exponent - exponent), -bound, bound);
}

/// A line w.X = 4 passes by a box in units of its own: no X is longer than 2, no w than 2^(1/2). No line need be
/// further off, and integrals along lines much further off would keep few digits.
inline constexpr double out_of_sight = 4;

/// A box's axis and sizes as doubles, its axis about 1 and its longer side about 1: one length is 2^exponent.
struct UnitBox {
  double ux, uy, hx, hy;
  int axis, exponent;
};

inline UnitBox unit_box(const exact::Box& s) noexcept {
  using arithmetic::scale;
  using arithmetic::Scaled;
  const Scaled ux = exact::rounded(s.ux), uy = exact::rounded(s.uy), hx = exact::rounded(s.hx),
               hy = exact::rounded(s.hy);
  const auto exponent = [](const Scaled& m) { return m.value == 0 ? -10000 : m.exponent; };
  const int axis = exponent(ux) > exponent(uy) ? exponent(ux) : exponent(uy);
  const int length = exponent(hx) > exponent(hy) ? exponent(hx) : exponent(hy);
  return {scale(ux.value, ux.exponent - axis),
          scale(uy.value, uy.exponent - axis),
          scale(hx.value, hx.exponent - length),
          scale(hy.value, hy.exponent - length),
          axis,
          length + axis};
}

/// The length that two intervals have in common, which overlap: from half of theirs and the distance of their centres.
inline arithmetic::Scaled common_length(const exact::Number<3>& half_a, const exact::Number<3>& half_b,
                                        const exact::Number<3>& distance) noexcept {
  const exact::Number<3>& lesser = exact::compare(half_a, half_b) < 0 ? half_a : half_b;
  const exact::Number<3> within = lesser + lesser, aside = half_a + half_b - exact::abs(distance);
  return exact::rounded(exact::compare(aside, within) < 0 ? aside : within);
}

/// The area of two boxes that cross, from exact distances between a's centre and b's edges, a being the lesser. What is
/// left to round is relative to a alone, however much greater or however far b is, at any magnitude. Of parallel boxes
/// it is relative to the area, at any aspect ratio.
inline Measure crossing_area_exact(const exact::Box& a, const exact::Box& b) noexcept {
  const exact::Length dx = b.cx - a.cx, dy = b.cy - a.cy;
  const auto ww = exact::dot(b.ux, b.uy, b.ux, b.uy);
  const auto reach_0 = b.hx * ww, reach_1 = b.hy * ww;
  const auto along = exact::dot(b.ux, b.uy, dx, dy), across = exact::cross(b.ux, b.uy, dx, dy);
  const auto dot = exact::abs(exact::dot(a.ux, a.uy, b.ux, b.uy)),
             cross = exact::abs(exact::cross(a.ux, a.uy, b.ux, b.uy));
  if (dot.sign == 0 || cross.sign == 0) {
    const bool same = cross.sign == 0;
    const arithmetic::Scaled length = common_length(same ? a.hx * dot : a.hy * cross, reach_0, along),
                             width = common_length(same ? a.hy * dot : a.hx * cross, reach_1, across),
                             squared = exact::rounded(ww);
    return {length.value * width.value / squared.value, length.exponent + width.exponent - squared.exponent};
  }
  const UnitBox frame = unit_box(a), other = unit_box(b);
  const int unit = other.axis + frame.exponent;
  const auto place = [&](const exact::Number<3>& x) { return bounded(exact::rounded(x), unit, out_of_sight); };

  const double c = frame.ux * other.ux + frame.uy * other.uy, s = frame.ux * other.uy - frame.uy * other.ux;
  const double vv = frame.ux * frame.ux + frame.uy * frame.uy, w2 = other.ux * other.ux + other.uy * other.uy;
  const Extents<double> e{frame.hx * vv * w2, frame.hy * vv * w2};
  const Strips<double> strips{
      c, s, place(along - reach_0), place(along + reach_0), place(across - reach_1), place(across + reach_1)};
  return {clipped_area(e, strips) / (vv * w2 * w2), 2 * frame.exponent};
}

}  // namespace vesica::detail::area
