// SPDX-License-Identifier: Apache-2.0
/// The four pairs that batches run in lanes: one template over double and lanes of double. The scalar call is its
/// instance for double, so both give the same bits. Where that is not settled (see LaneAnswer), both take the general
/// path (disjoint.hpp, common_point.hpp).
#pragma once

#include <vesica/filter/estimate.hpp>
#include <vesica/nearest/box_ellipse.hpp>
#include <vesica/nearest/ellipse_ellipse.hpp>
#include <vesica/shapes.hpp>

namespace vesica::detail::nearest {

template <class A, class B>
inline constexpr bool has_lanes = false;
template <class T>
inline constexpr bool has_lanes<Rect<T>, Rect<T>> = true;
template <class T>
inline constexpr bool has_lanes<Rect<T>, Ellipse<T>> = true;
template <class T>
inline constexpr bool has_lanes<Circle<T>, Ellipse<T>> = true;
template <class T>
inline constexpr bool has_lanes<Ellipse<T>, Ellipse<T>> = true;

/// The answer where settled. Elsewhere it means nothing: numbers far from 1, no convergence, ties within rounding, or a
/// common point that is not a centre.
template <class V>
struct LaneAnswer {
  V distance, ax, ay, bx, by;
  MaskOf<V> settled;
};

/// Sizes from 2^-40 to 2^40, axes from 2^-10 to 2^10, offsets up to 2^50: nothing over- or underflows that matters.
template <class V>
VESICA_INLINE MaskOf<V> moderate_axis(V ux, V uy) noexcept {
  return filter::in_range(max(abs(ux), abs(uy)), V(0x1p-10), V(0x1p10));
}
template <class V>
VESICA_INLINE MaskOf<V> moderate_size(V size) noexcept {
  return filter::in_range(size, V(0x1p-40), V(0x1p40));
}
template <class V>
VESICA_INLINE MaskOf<V> moderate(const Vector<V>& d) noexcept {
  return abs(d.x.high) + abs(d.y.high) <= V(0x1p50);
}
/// And not so thin that a direction's last place counts.
template <class V>
VESICA_INLINE MaskOf<V> moderate(const Ellipse<V>& e) noexcept {
  const auto thick = min(e.a, e.b) >= V(0x1p-50) * max(e.a, e.b);
  return both(both(moderate_axis(e.ux, e.uy), thick), both(moderate_size(e.a), moderate_size(e.b)));
}
template <class V>
VESICA_INLINE MaskOf<V> moderate(const Rect<V>& r) noexcept {
  return both(moderate_axis(r.ux, r.uy), both(moderate_size(r.hx), moderate_size(r.hy)));
}

template <class V>
VESICA_INLINE Vector<V> offset(V ax, V ay, V bx, V by) noexcept {
  return {exact_difference(bx, ax), exact_difference(by, ay)};
}

template <class V>
VESICA_INLINE Axes<V> axes(const Ellipse<V>& e) noexcept {
  return {e.ux, e.uy, e.a, e.b};
}
template <class V>
VESICA_INLINE Box<V> box(const Rect<V>& r) noexcept {
  const V zero(0.0);
  return {{{r.ux, zero}, {r.uy, zero}}, {r.hx, zero}, {r.hy, zero}};
}

/// True if a shape holds the point at d from its centre, to rounding.
template <class V>
VESICA_INLINE MaskOf<V> holds(const Rect<V>& r, const Vector<V>& d) noexcept {
  const V uu = r.ux * r.ux + r.uy * r.uy;
  return both(abs(r.ux * d.x.high + r.uy * d.y.high) <= r.hx * uu, abs(r.ux * d.y.high - r.uy * d.x.high) <= r.hy * uu);
}
template <class V>
VESICA_INLINE MaskOf<V> holds(const Ellipse<V>& e, const Vector<V>& d) noexcept {
  const V p = e.b * (e.ux * d.x.high + e.uy * d.y.high), q = e.a * (e.ux * d.y.high - e.uy * d.x.high);
  const V area = (e.a * e.b) * (e.ux * e.ux + e.uy * e.uy);
  return p * p + q * q <= area * area;
}
template <class V>
VESICA_INLINE MaskOf<V> holds(const Circle<V>& c, const Vector<V>& d) noexcept {
  return d.x.high * d.x.high + d.y.high * d.y.high <= c.r * c.r;
}

/// If one of two overlapping shapes holds the other's centre: that centre; if each does, the one to the left.
template <class A, class B, class V>
VESICA_INLINE LaneAnswer<V> common_centre(const A& a, const B& b, const Vector<V>& d) noexcept {
  const V zero(0.0);
  const auto in_a = holds(a, d), in_b = holds(b, d),
             take_a = and_not(in_b, and_not(in_a, in_order(d.x.high, d.y.high)));
  // Centres that differ by the sign of a zero only are one place: it loses that sign.
  const V x = zero + select(take_a, a.cx, b.cx), y = zero + select(take_a, a.cy, b.cy);
  return {zero, x, y, x, y, either(in_a, in_b)};
}

template <class V>
VESICA_INLINE LaneAnswer<V> choose(MaskOf<V> m, const LaneAnswer<V>& yes, const LaneAnswer<V>& no) noexcept {
  return {select(m, yes.distance, no.distance),
          select(m, yes.ax, no.ax),
          select(m, yes.ay, no.ay),
          select(m, yes.bx, no.bx),
          select(m, yes.by, no.by),
          either(both(m, yes.settled), and_not(no.settled, m))};
}

/// Offsets from centres to places. A sum of zeros loses its sign, which would show the order of the shapes.
template <class A, class B, class V>
VESICA_INLINE LaneAnswer<V> located(const A& a, const B& b, const Twofold<V>& distance, V ax, V ay, V bx, V by,
                                    MaskOf<V> settled, V doubt = V(0.0)) noexcept {
  const V least = rounded(distance), zero(0.0);
  return {least,
          zero + (a.cx + ax),
          zero + (a.cy + ay),
          zero + (b.cx + bx),
          zero + (b.cy + by),
          both(settled, both(least > V(0.0), least >= doubt))};
}

template <class V>
VESICA_INLINE V extent(const Circle<V>& c) noexcept {
  return c.r;
}
template <class V>
VESICA_INLINE V extent(const Ellipse<V>& e) noexcept {
  return extent(e.ux, e.uy, e.a, e.b);
}
template <class V>
VESICA_INLINE V extent(const Rect<V>& r) noexcept {
  return extent(r.ux, r.uy, r.hx, r.hy);
}

/// At least the scale that error bounds speak of, at most some ten times that; up to powers of two ScaledPair::size.
template <class A, class B, class V>
VESICA_INLINE V size_of(const A& a, const B& b, const Vector<V>& d) noexcept {
  return (extent(a) + extent(b)) + (abs(d.x.high) + abs(d.y.high));
}

template <class V>
VESICA_INLINE LaneAnswer<V> apart(const Rect<V>& a, const Rect<V>& b, const Vector<V>& d) noexcept {
  const BoxBox<V> f = box_box(box(a), box(b), d);
  return located(a, b, f.distance, f.a.s * a.ux - f.a.t * a.uy, f.a.s * a.uy + f.a.t * a.ux,
                 f.b.s * b.ux - f.b.t * b.uy, f.b.s * b.uy + f.b.t * b.ux, f.settled);
}
template <class V>
VESICA_INLINE LaneAnswer<V> apart(const Rect<V>& a, const Ellipse<V>& b, const Vector<V>& d) noexcept {
  int steps;
  const BoxEllipse<V> f = box_ellipse(box(a), axes(b), d, size_of(a, b, d), steps);
  return located(a, b, f.distance, f.spot.s * a.ux - f.spot.t * a.uy, f.spot.s * a.uy + f.spot.t * a.ux, f.bx, f.by,
                 f.settled, f.doubt);
}
template <class V>
VESICA_INLINE LaneAnswer<V> apart(const Circle<V>& a, const Ellipse<V>& b, const Vector<V>& d) noexcept {
  int steps;
  const ClosestOffsets<V> f = circle_ellipse(a.r, axes(b), d, size_of(a, b, d), steps);
  return located(a, b, f.distance, f.ax, f.ay, f.bx, f.by, f.settled, f.doubt);
}
template <class V>
VESICA_INLINE LaneAnswer<V> apart(const Ellipse<V>& a, const Ellipse<V>& b, const Vector<V>& d) noexcept {
  int steps;
  const ClosestOffsets<V> f = ellipse_ellipse(axes(a), axes(b), d, size_of(a, b, d), steps);
  return located(a, b, f.distance, f.ax, f.ay, f.bx, f.by, f.settled, f.doubt);
}

template <class V>
VESICA_INLINE MaskOf<V> moderate(const Circle<V>& c) noexcept {
  return moderate_size(c.r);
}

/// True if the direction from centre to centre, where a search begins, shows already that moderate shapes are disjoint:
/// D.D > h_a + h_b along it, by far more than rounding.
inline bool apart_along_offset(const Ellipse<double>& a, const Ellipse<double>& b) noexcept {
  const Vector<double> offsets = offset(a.cx, a.cy, b.cx, b.cy);
  const Direction<double> d{offsets.x.high, offsets.y.high};
  const double dd = dot(d, d), ha = sqrt(image(semi_axes(axes(a)), d).square),
               hb = sqrt(image(semi_axes(axes(b)), d).square);
  return dd - (ha + hb) > 0x1p-30 * dd;
}
template <class A, class B>
bool apart_along_offset(const A&, const B&) noexcept {
  return false;
}

template <class A, class B, class V>
VESICA_INLINE MaskOf<V> moderate_pair(const A& a, const B& b, const Vector<V>& d) noexcept {
  return both(moderate(d), both(moderate(a), moderate(b)));
}
/// Scalar calls ask this first. For other shapes a search might take all its steps in vain.
template <class A, class B>
VESICA_INLINE bool moderate_pair(const A& a, const B& b) noexcept {
  return moderate_pair(a, b, offset(a.cx, a.cy, b.cx, b.cy));
}

/// overlapping: what the exact predicate says of the pair.
template <class A, class B, class V>
VESICA_INLINE LaneAnswer<V> lane_answer(const A& a, const B& b, MaskOf<V> overlapping, const Vector<V>& d) noexcept {
  const auto disjoint = negated<V>(overlapping);
  LaneAnswer<V> answer = all(overlapping) ? common_centre(a, b, d) : apart(a, b, d);
  if (!all(overlapping) && !all(disjoint)) answer = choose(overlapping, common_centre(a, b, d), answer);
  answer.settled = both(answer.settled, moderate_pair(a, b, d));
  return answer;
}
template <template <class> class A, template <class> class B, class V>
VESICA_INLINE LaneAnswer<V> lane_answer(const A<V>& a, const B<V>& b, MaskOf<V> overlapping) noexcept {
  return lane_answer(a, b, overlapping, offset(a.cx, a.cy, b.cx, b.cy));
}

}  // namespace vesica::detail::nearest
