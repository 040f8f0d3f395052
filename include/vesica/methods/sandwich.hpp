// SPDX-License-Identifier: Apache-2.0
/// An ellipse between an inscribed and a circumscribed polygon, against a disc: what the polygonal methods share.
///
/// The disc overlaps the ellipse if it reaches a side of the inner polygon, and does not if a corner of the outer one,
/// extended to a wedge, misses it. Only the arc that holds the outline's nearest point matters; but whatever arc is
/// looked at, both answers are true: the side is in the ellipse, and the ellipse in the wedge. No division, no root.
///
/// Rounding, in each coordinate by itself, for a plane may be stretched. With N the sum of what p, q and the centre
/// were summed of, S the same for p and q alone and u the roundoff, places are wrong by at most 6 u N, a test's own
/// arithmetic is worth 10 u N, and n halvings displace points and tangents by 5 n u S, which may displace a wedge 6
/// times as much. So every answer must hold wherever the centre is within e = 24 u N + 32 n u S of where it seems to
/// be.
#pragma once

#include <limits>
#include <vesica/methods/bisected_arc.hpp>
#include <vesica/methods/verdict.hpp>

namespace vesica::methods {

/// How far an approximate method went: halvings done, and the bound on the outline's error they reached.
///
/// outline_error: 2^(0.303 - 2 iterations) times the larger half length (times the axis's), from Niemitalo; 0 when the
/// answer comes from the exact overlap(). No point of the polygons is farther from the outline.
template <class T>
struct Approximation {
  T outline_error;
  std::int32_t iterations;
};

namespace detail {

/// The ellipse cos(t) p + sin(t) q and a disc, at a fit scale.
template <class T>
struct EllipseAndDisc {
  Vector<T> p, q, centre;  ///< cross(p, q) >= 0
  T rr;                    ///< the squared radius, right to 16 roundoffs
  Vector<T> size;          ///< what p and q were summed of: at least |p| + |q|
  Vector<T> distance;      ///< what the centre was summed of
  Vector<T> axis_error;    ///< 0 when each number of p and q is right to a few roundoffs, else what they may be off by
};

/// The numbers that the tests use.
template <class T>
struct Disc {
  Vector<T> centre, error;    ///< the centre is within +-error of where it seems
  Vector<T> growth;           ///< of the error, with each halving
  T squared_yes, squared_no;  ///< at most, at least the squared radius
  bool keeps_turning;         ///< tangents are known well enough to tell the ellipse's side of them, however thin it is

  /// Products of two squares below this may have underflowed.
  static constexpr T floor = ScalarTraits<T>::power(-100 * ScalarTraits<T>::range);
};

template <class T>
VESICA_INLINE Vector<T> magnitude(const Vector<T>& p) noexcept {
  return {std::fabs(p.x), std::fabs(p.y)};
}
/// |p.x| |q.y| + |p.y| |q.x|, of q >= 0.
template <class T>
VESICA_INLINE T cross_magnitude(const Vector<T>& p, const Vector<T>& q) noexcept {
  return std::fabs(p.x) * q.y + std::fabs(p.y) * q.x;
}

template <class T>
VESICA_INLINE Disc<T> disc(const EllipseAndDisc<T>& s, std::int32_t n) noexcept {
  constexpr T u = ScalarTraits<T>::roundoff;
  const Vector<T> error = times(24 * u, plus(s.distance, s.size)), growth = times(32 * u, s.size);
  const bool keeps_turning = cross(s.p, s.q) >= static_cast<T>(4 + 4 * n) * cross_magnitude(s.axis_error, s.size);
  return {s.centre, error, growth, s.rr * (1 - 32 * u), s.rr * (1 + 32 * u), keeps_turning};
}

/// True if the disc's centre is certainly in the ellipse.
template <class T>
VESICA_INLINE bool holds_centre(const EllipseAndDisc<T>& s, const Disc<T>& d) noexcept {
  const Vector<T>& x = s.centre;
  const T off = cross_magnitude(x, s.axis_error);
  const T along = std::fabs(cross(x, s.q)) + cross_magnitude(s.q, d.error) + off;
  const T across = std::fabs(cross(s.p, x)) + cross_magnitude(s.p, d.error) + off;
  const T area = cross(s.p, s.q) * (1 - 32 * ScalarTraits<T>::roundoff) - 2 * cross_magnitude(s.axis_error, s.size);
  return lane::both(area > 0, along * along + across * across + Disc<T>::floor <= area * area);
}

/// True if the disc certainly lies beyond a line across `out` that its centre seems to be `beyond` / |out| away from.
template <class T>
VESICA_INLINE bool is_beyond(T beyond, const Vector<T>& out, const Disc<T>& d) noexcept {
  const T least = beyond - dot(magnitude(out), d.error);
  return lane::both(least > 0, least * least > d.squared_no * dot(out, out) + Disc<T>::floor);
}

/// True if a line across the line of centres certainly separates disc and ellipse.
template <class T>
VESICA_INLINE bool is_far(const EllipseAndDisc<T>& s, const Disc<T>& d) noexcept {
  const Vector<T>& x = s.centre;
  return is_beyond(dot(x, x) - (std::fabs(dot(s.p, x)) + std::fabs(dot(s.q, x))), x, d);
}

/// True if a point, seen from the disc's centre, is certainly in the disc.
template <class T>
VESICA_INLINE bool reaches(const Vector<T>& point, const Disc<T>& d) noexcept {
  const Vector<T> most = plus(magnitude(point), d.error);
  return dot(most, most) <= d.squared_yes;
}

/// True if the disc certainly reaches the chord of an arc.
template <class T>
VESICA_INLINE bool reaches_chord(const Arc<T>& arc, const Disc<T>& d) noexcept {
  const Vector<T> from = minus(arc.from.at, d.centre), to = minus(arc.to.at, d.centre), chord = minus(to, from);
  if (lane::either(reaches(from, d), reaches(to, d))) return true;
  const T square = dot(chord, chord), foot = -dot(chord, from), off = dot(magnitude(chord), d.error);
  const T beside = std::fabs(cross(chord, from)) + cross_magnitude(chord, d.error);
  const bool within = lane::both(foot > off, foot < square - off);
  return lane::both(within, beside * beside + Disc<T>::floor <= d.squared_yes * square);
}

/// True if the tangent at an end of an arc certainly has the disc beyond it, the ellipse on this side.
template <class T>
VESICA_INLINE bool tangent_separates(const ArcEnd<T>& end, const Disc<T>& d) noexcept {
  const Vector<T> out{end.tangent.y, -end.tangent.x};
  const bool separates = is_beyond(dot(minus(d.centre, end.at), out), out, d);
  return separates && (d.keeps_turning || cross_magnitude(end.at, d.error) <= dot(magnitude(out), d.error));
}

/// True if the disc certainly misses the wedge between the tangents at the ends of an arc halved `depth` times.
template <class T>
VESICA_INLINE bool misses_wedge(const Arc<T>& arc, const Disc<T>& d, std::int32_t depth) noexcept {
  if (tangent_separates(arc.from, d) || tangent_separates(arc.to, d)) return true;
  const Vector<T> corner = tip(arc, depth), out = minus(d.centre, corner);
  const bool corner_is_nearest = lane::both(dot(out, arc.from.tangent) >= 0, dot(out, arc.to.tangent) <= 0);
  return corner_is_nearest && dot(out, corner) >= 0 && is_beyond(dot(out, out), out, d);
}

/// True if p and q lie along the coordinate axes and the disc's centre between them.
template <class T>
VESICA_INLINE bool is_upright(const EllipseAndDisc<T>& s) noexcept {
  return s.p.y == 0 && s.q.x == 0 && s.p.x >= 0 && s.q.y >= 0 && s.centre.x >= 0 && s.centre.y >= 0;
}

/// The answer after at most n halvings; `iterations` is set to those done.
template <class T>
std::int32_t sandwich(const EllipseAndDisc<T>& s, std::int32_t n, std::int32_t& iterations) noexcept {
  iterations = 0;
  Disc<T> d = disc(s, n);
  if (holds_centre(s, d)) return yes;
  if (is_far(s, d)) return no;
  Arc<T> arc = is_upright(s) ? quarter(s.p, s.q) : nearest_quarter(s.p, s.q, s.centre);
  for (;; ++iterations) {
    if (reaches_chord(arc, d)) return yes;
    if (misses_wedge(arc, d, iterations)) return no;
    if (iterations == n) return uncertain;
    arc = nearest_half(arc, middle(arc, iterations), s.centre);
    d.error = plus(d.error, d.growth);
  }
}

/// 2^(0.303 - 2 iterations) times the larger half length.
template <class T>
T outline_error(const Ellipse<T>& ellipse, std::int32_t iterations) noexcept {
  using vesica::detail::take_apart;
  using vesica::detail::arithmetic::power_of_two;
  constexpr double ratio = 0x1.3bd43bab2c296p+0;  // 2^0.303
  const Ellipse<double> e = widen(ellipse);
  const double factor = ratio * power_of_two(-2 * iterations), half = larger(e.a, e.b),
               square = e.ux * e.ux + e.uy * e.uy, share = factor * half;
  if (square > 0x1p-900 && square < 0x1p900 && share <= std::numeric_limits<double>::max()) {
    return static_cast<T>(share * std::sqrt(square));
  }
  const auto axis = vesica::detail::arithmetic::unit_and_length(e.ux, e.uy).length;
  return vesica::detail::multiply<T>(take_apart(factor * take_apart(half).value),
                                     {axis.value, axis.exponent + take_apart(half).exponent});
}

/// An ellipse and a disc turned so that the ellipse lies along the coordinate axes, its larger half length on x, and
/// the disc's centre in the first quadrant; all lengths times the length of the ellipse's axis.
template <class T>
struct UprightPair {
  T x, y, w, h, rr;
  Vector<T> distance;  ///< what x and y were summed of
};

template <class T>
VESICA_INLINE UprightPair<T> upright_pair(const Circle<T>& circle, const Ellipse<T>& ellipse) noexcept {
  const auto p = rescaled_pair(Rect<T>{circle.cx, circle.cy, 1, 0, circle.r, circle.r}, box_of(ellipse));
  const Vector<T> axis{p.wx, p.wy}, d{p.dx, p.dy}, whole = magnitude(axis);
  const T x = std::fabs(dot(axis, d)), y = std::fabs(cross(axis, d)), ww = dot(axis, axis);
  const T r = p.h0 * p.ux, rr = r * r * ww;
  const T sum_x = dot(whole, magnitude(d)), sum_y = cross_magnitude(d, whole);
  if (p.g0 >= p.g1) return {x, y, p.g0 * ww, p.g1 * ww, rr, {sum_x, sum_y}};
  return {y, x, p.g1 * ww, p.g0 * ww, rr, {sum_y, sum_x}};
}

template <class T>
VESICA_INLINE EllipseAndDisc<T> ellipse_and_disc(const UprightPair<T>& p) noexcept {
  return {{p.w, 0}, {0, p.h}, {p.x, p.y}, p.rr, {p.w, p.h}, p.distance, {0, 0}};
}

}  // namespace detail
}  // namespace vesica::methods
