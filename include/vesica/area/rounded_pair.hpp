// SPDX-License-Identifier: Apache-2.0
/// Pairs with a capsule or a rounded rectangle: each shape as a rounded box, as stored or in standard units.
#pragma once

#include <algorithm>
#include <vesica/area/rounded_boxes.hpp>
#include <vesica/area/standard.hpp>
#include <vesica/form/inflated.hpp>
#include <vesica/form/placement.hpp>

namespace vesica::detail::area {

/// True if a shape has no radius or no size, and so is a shape of another kind.
inline bool is_plain(const Capsule<double>& s) noexcept { return s.r == 0 || (s.x0 == s.x1 && s.y0 == s.y1); }
inline bool is_plain(const RoundRect<double>& s) noexcept { return s.r == 0 || (s.hx == 0 && s.hy == 0); }

/// action(shape) with the same set of points as a shape without a radius, or as a circle.
template <class Action>
std::int32_t with_plain(const Capsule<double>& s, const Action& action) noexcept {
  return s.r == 0 ? action(Segment<double>{s.x0, s.y0, s.x1, s.y1}) : action(Circle<double>{s.x0, s.y0, s.r});
}
template <class Action>
std::int32_t with_plain(const RoundRect<double>& s, const Action& action) noexcept {
  return s.r == 0 ? action(Rect<double>{s.cx, s.cy, s.ux, s.uy, s.hx, s.hy}) : action(Circle<double>{s.cx, s.cy, s.r});
}

inline bool is_flat(const Capsule<double>& s) noexcept { return s.r == 0; }
inline bool is_flat(const RoundRect<double>& s) noexcept { return s.r == 0 && (s.hx == 0 || s.hy == 0); }

/// From the core's axis and sizes, which are multiples of it. Not a number if there is no axis.
template <class V>
RoundedBox<V> rounded_box(const V& ux, const V& uy, const V& hx, const V& hy, const V& r) noexcept {
  const V length = sqrt(ux * ux + uy * uy), over = V(1.0) / length;
  return {ux * over, uy * over, hx * length, hy * length, r};
}

template <class Shape>
inline constexpr bool is_oval = ShapeTraits<Shape>::kind == Kind::ellipse;

template <class Shape>
RoundedBox<double> rounded_box(const Shape& s) noexcept {
  const auto [core, radius] = form::inflated(s);
  const filter::Box<double> box = filter::box(core);
  RoundedBox<double> result = rounded_box(box.ux, box.uy, box.hx, box.hy, radius);
  result.is_oval = is_oval<Shape>;
  return result;
}

inline bool in_clip_range(const RoundedBox<double>& s) noexcept {
  const double hx = s.hx, hy = s.hy, r = s.r;
  return hx >= 0 && hy >= 0 && r >= 0 && hx + r >= 0x1p-200 && hy + r >= 0x1p-200 && hx + hy + r <= 0x1p200 &&
         filter::in_range(s.ux * s.ux + s.uy * s.uy, 0.5, 2.0);
}

template <class V>
V approximate_area(const RoundedBox<V>& s) noexcept {
  const V four(4.0), pi(pi_high);
  return s.is_oval ? pi * (s.hx * s.hy) : four * (s.hx * s.hy + s.r * (s.hx + s.hy)) + pi * (s.r * s.r);
}

/// Which is the frame, so that exchanging the two changes no bit: the one of lesser area; of equal areas the one to the
/// left, or the lower one; of these the one with the lesser numbers. d: from a's centre to b's.
template <class V>
bool is_frame(const RoundedBox<V>& a, const RoundedBox<V>& b, const filter::Centre<V>& d) noexcept {
  const V zero(0.0);
  const V numbers_a[] = {approximate_area(a), zero, zero, a.hx, a.hy, a.r, a.ux, a.uy};
  const V numbers_b[] = {approximate_area(b), d.x, d.y, b.hx, b.hy, b.r, b.ux, b.uy};
  for (int i = 0; i < 8; ++i) {
    if (numbers_a[i] < numbers_b[i]) return true;
    if (numbers_b[i] < numbers_a[i]) return false;
  }
  return true;
}

/// The area of two rounded boxes, d from a's centre to b's. Settled as for boxes: T is the sum of the lengths that b's
/// outline in the frame is made of, and no place of it is off by more than 16u T. Four lengths of the frame's shape
/// around bound the part of it that counts.
inline Settled<double, bool> crossing_area(const RoundedBox<double>& a, const RoundedBox<double>& b,
                                           const filter::Centre<double>& d) noexcept {
  const double apart = std::fabs(d.x) + std::fabs(d.y);
  if (!(in_clip_range(a) && in_clip_range(b) && apart <= 0x1p200)) return {0, false};
  const bool first = is_frame(a, b, d);
  const RoundedBox<double>&frame = first ? a : b, &other = first ? b : a;
  const double ex = frame.hx + frame.r, ey = frame.hy + frame.r, terms = apart + (other.hx + other.hy + other.r);
  if (!(terms <= 48 * max(ex, ey))) return {0, false};
  const double area = first ? area_in_rounded_box(a, b, d) : area_in_rounded_box(b, a, {-d.x, -d.y});
  const double error = 0x1p-46 * (terms + ex + ey) * (ex + ey);
  return {area, area > error && approximate_area(frame) - area > error};
}

template <class A, class B>
Settled<double, bool> quick_rounded_area(const A& a, const B& b) noexcept {
  if constexpr (form::is_inflated<A>) {
    if (is_plain(a)) return {0, false};
  }
  if (is_plain(b)) return {0, false};
  const auto place_a = filter::place(form::inflated(a).core);
  return crossing_area(rounded_box(a), rounded_box(b), filter::offset(place_a, filter::place(form::inflated(b).core)));
}

// ---- In standard units.

inline Size size(form::Constant c, int) noexcept { return {static_cast<double>(c.x), 0}; }
inline Size size(form::WidthAxis, int) noexcept { return {0.5, 0}; }
inline Size size(const form::Difference<double>& d, int lift) noexcept {
  return size(form::HalfWidth<double>{d.to, d.from}, lift);
}

/// A core's numbers, each times a power of two, and the radius. The longer part of an axis is in [1/2, 1).
struct Core {
  form::Corners<double> place;
  DoubleDouble ux, uy;
  Size hx, hy;
  double radius;
  bool is_oval;

  int exponent() const noexcept {
    using arithmetic::exponent_of;
    const auto of = [](const Size& s) {
      return s.value.high == 0 ? form::no_exponent : exponent_of(s.value.high) + s.exponent;
    };
    return std::max({of(hx), of(hy), radius == 0 ? form::no_exponent : exponent_of(radius)});
  }
  template <class V>
  RoundedBox<V> in_units(int unit) const noexcept {
    const auto scaled = [&](const Size& s) { return scaled_to(number<V>(s.value), s.exponent - unit); };
    RoundedBox<V> box =
        rounded_box<V>(number<V>(ux), number<V>(uy), scaled(hx), scaled(hy), V(arithmetic::scale(radius, -unit)));
    box.is_oval = is_oval;
    return box;
  }
};

template <class Shape>
VESICA_CALLED Core core(const Shape& s, int lift) noexcept {
  const auto inflated = form::inflated(s);
  const auto f = form::of(inflated.core);
  const Size ux = size(f.ux, lift), uy = size(f.uy, lift);
  const int axis = axis_exponent(ux.value.high, uy.value.high), unit = axis + ux.exponent;
  Core c{form::corners(f.place), scaled_to(ux.value, -axis), scaled_to(uy.value, -axis),
         size(f.hx, lift),       size(f.hy, lift),           inflated.radius,
         area::is_oval<Shape>};
  c.hx.exponent += unit;
  c.hy.exponent += unit;
  return c;
}

template <class V>
filter::Centre<V> offset_in_units(const Core& a, const Core& b, int lift, int unit) noexcept {
  const Lift both{lift, lift};
  const filter::Centre<V> d = filter::offset(lifted<V>(a.place, both), lifted<V>(b.place, both));
  return {scaled_to(d.x, -lift - unit), scaled_to(d.y, -lift - unit)};
}

/// For two that certainly cross.
VESICA_CALLED inline Measure precise_rounded_area(const Core& a, const Core& b, int lift) noexcept {
  const int unit = std::max(a.exponent(), b.exponent());
  const RoundedBox<double> p = a.in_units<double>(unit), q = b.in_units<double>(unit);
  const filter::Centre<double> d = offset_in_units<double>(a, b, lift, unit);
  const auto quick = crossing_area(p, q, d);
  if (quick.settled) return {quick.area, 2 * unit};
  const RoundedBox<DoubleDouble> s = a.in_units<DoubleDouble>(unit), t = b.in_units<DoubleDouble>(unit);
  const filter::Centre<DoubleDouble> apart = offset_in_units<DoubleDouble>(a, b, lift, unit);
  const bool first = is_frame(s, t, apart);
  return {first ? area_in_rounded_box(s, t, apart) : area_in_rounded_box(t, s, {-apart.x, -apart.y}), 2 * unit};
}

template <class A, class B>
Measure precise_rounded_area(const A& a, const B& b) noexcept {
  const auto most = [](const form::Corners<double>& p) { return std::fmax(reach_x(p), reach_y(p)); };
  const auto place = [](const auto& s) { return form::corners(filter::place(form::inflated(s).core)); };
  const int lift = lift_for(std::fmax(most(place(a)), most(place(b))));
  return precise_rounded_area(core(a, lift), core(b, lift), lift);
}

}  // namespace vesica::detail::area
