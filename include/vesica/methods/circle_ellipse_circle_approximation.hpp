// SPDX-License-Identifier: Apache-2.0
/// Circle against ellipse, the ellipse's outline between circle segments.
///
/// Idea: as the polygonal sandwich, with circle segments in place of the triangles. Source: Olli Niemitalo,
/// "Ellipse-circle and ellipse-ellipse collision detection" (2012), which leaves the method as a sketch. From a vertex
/// of the longer axis to one of the shorter the curvature only falls. So of the two circles through both ends of an
/// arc, each tangent to it at one of them, that at the flatter end stays inside and that at the rounder end outside
/// (Kneser's theorem on spirals). With conjugate half diameters, whose cross product is always w h, their radii are
/// t_m^2 t / (w h), t and t_m the derivative's length at that end and in the middle: no cancellation however short the
/// arc. Differs: a `no` is said of discs only whose centre is certainly outside the ellipse, as it rests on the nearest
/// point.
/// Cost: about 45 ns, and 8 ns for each iteration with its two square roots; no division. Never errs. Bound: as for
/// the polygons, with three times the rounding. Once arcs are short beside the ellipse's roundest part each iteration
/// gains a factor of 8, not 4.
#pragma once

#include <vesica/methods/sandwich.hpp>

namespace vesica::methods {

namespace detail {

/// A disc with certain radii instead of their squares.
template <class T>
struct RoundedDisc {
  Vector<T> centre;
  T yes, no;  ///< certainly at most, certainly at least the radius; `yes` may be negative
};

/// Above 0 iff a disc about x lies beyond the circle through the origin with the outward normal `out` there and the
/// radius m |out| / wh: the squared distance of the centres less the square of the radii's sum, times wh.
template <class T>
VESICA_INLINE T beyond_circle(const Vector<T>& x, T radius, const Vector<T>& out, T m, T wh) noexcept {
  const T distance = dot(x, out) - radius * std::sqrt(dot(out, out));
  return wh * (dot(x, x) - radius * radius) + 2 * m * distance;
}

template <class T>
VESICA_INLINE Vector<T> normal(const ArcEnd<T>& end) noexcept {
  return {end.tangent.y, -end.tangent.x};
}

/// True if the disc certainly reaches the inner circle segment of an arc that grows flatter.
template <class T>
VESICA_INLINE bool reaches_inner_segment(const Arc<T>& arc, const RoundedDisc<T>& d, T m, T wh) noexcept {
  if (d.yes < 0) return false;
  const Vector<T> from = minus(d.centre, arc.from.at), to = minus(d.centre, arc.to.at);
  const T rr = d.yes * d.yes;
  if (lane::either(dot(from, from) <= rr, dot(to, to) <= rr)) return true;
  // The centre is before the inner circle's radius to `to`, the ellipse's normal: in its quadrant, or else before the
  // middle that this arc was cut at.
  const T after_from = wh * cross(minus(arc.from.at, arc.to.at), to) + m * dot(arc.to.tangent, from);
  const T beyond = beyond_circle(to, d.yes, normal(arc.to), m, wh);
  return lane::both(after_from >= 0, beyond <= -Disc<T>::floor);
}

/// True if the disc certainly misses the outer circle of an arc that grows flatter. Of a disc whose centre is outside
/// the ellipse, with the nearest point on this arc, that proves that it misses the ellipse.
template <class T>
VESICA_INLINE bool misses_outer_circle(const Arc<T>& arc, const RoundedDisc<T>& d, T m, T wh) noexcept {
  return beyond_circle(minus(d.centre, arc.from.at), d.no, normal(arc.from), m, wh) > Disc<T>::floor;
}

/// True if the disc's centre is certainly outside the ellipse.
template <class T>
VESICA_INLINE bool is_outside(const UprightPair<T>& p, const Vector<T>& error) noexcept {
  const T x = (p.x - error.x) * p.h, y = (p.y - error.y) * p.w, wh = p.w * p.h * (1 + 16 * ScalarTraits<T>::roundoff);
  const T along = x > 0 ? x : 0, across = y > 0 ? y : 0;
  return along * along + across * across > wh * wh + Disc<T>::floor;
}

/// The half with the point nearest to x, which must be in the first quadrant, as the arc is, and outside the ellipse:
/// from one end of the quadrant to the other the distance then falls once and rises once.
template <class T>
VESICA_INLINE Arc<T> nearest_half_of_quadrant(const Arc<T>& arc, const ArcEnd<T>& half, const Vector<T>& x) noexcept {
  return dot(minus(x, half.at), half.tangent) >= 0 ? Arc<T>{half, arc.to} : Arc<T>{arc.from, half};
}

/// An ellipse that is a segment from the origin to (w, 0) and its mirror image: either bound is that segment.
template <class T>
VESICA_INLINE std::int32_t segment_and_disc(T w, const RoundedDisc<T>& d) noexcept {
  const T beyond = d.centre.x - w, x = beyond > 0 ? beyond : 0, square = x * x + d.centre.y * d.centre.y;
  if (d.yes >= 0 && square <= d.yes * d.yes) return yes;
  return square > d.no * d.no ? no : uncertain;
}

template <class T>
std::int32_t circle_sandwich(const UprightPair<T>& p, std::int32_t n, std::int32_t& iterations) noexcept {
  iterations = 0;
  const auto s = ellipse_and_disc(p);
  const Disc<T> d = disc(s, n);
  if (holds_centre(s, d)) return yes;
  if (is_far(s, d)) return no;
  constexpr T u = ScalarTraits<T>::roundoff;
  const T radius = std::sqrt(p.rr);
  // So flat an ellipse is a segment within the rounding, once its width is added to that.
  const bool flat = p.h <= 8 * u * p.w;
  const T error = d.error.x + d.error.y + 16 * u * radius + (flat ? p.h : T{0});
  // Three times as much for `no`: within the error of a normal the nearest half is a guess, and the end it leaves out
  // may be that much nearer than the one it keeps.
  RoundedDisc<T> rounded{d.centre, radius - error, radius + 3 * error};
  if (flat) return segment_and_disc(p.w, rounded);
  Arc<T> arc = quarter(s.p, s.q);
  const T wh = p.w * p.h, growth = d.growth.x + d.growth.y;
  const bool outside = is_outside(p, d.error);
  for (;; ++iterations) {
    const ArcEnd<T> half = middle(arc, iterations);
    const T m = dot(half.tangent, half.tangent);
    if (reaches_inner_segment(arc, rounded, m, wh)) return yes;
    if (outside && misses_outer_circle(arc, rounded, m, wh)) return no;
    if (iterations == n) return uncertain;
    arc = nearest_half_of_quadrant(arc, half, d.centre);
    rounded.yes -= growth;
    rounded.no += 3 * growth;
  }
}

}  // namespace detail

/// 1 when certainly overlapping, 0 when certainly not, else 2 (uncertain). n, the iterations allowed: 0 to
/// most_sandwich_iterations. Errors, which leave `out` untouched: error_shape, error_argument (n).
template <class T>
std::int32_t circle_approximation(const Circle<T>& circle, const Ellipse<T>& ellipse, std::int32_t n,
                                  Approximation<T>& out) noexcept {
  if (check(circle) != 0 || check(ellipse) != 0) return error_shape;
  if (n < 0 || n > most_sandwich_iterations) return error_argument;
  const std::int32_t answer = detail::circle_sandwich(detail::upright_pair(circle, ellipse), n, out.iterations);
  out.outline_error = detail::outline_error(ellipse, out.iterations);
  return answer;
}

}  // namespace vesica::methods
