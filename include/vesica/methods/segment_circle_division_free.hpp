// SPDX-License-Identifier: Apache-2.0
/// Segment against circle without a division or a square root.
///
/// Idea: with the segment from 0 to e and the circle's centre at c, multiplying by the conjugate of e as complex
/// numbers lays the segment along the real axis from 0 to |e|^2 and makes the radius r |e|. They meet iff an end is in
/// the circle, or the centre, c.e + i (e x c) by now, is above or below the segment, no farther than the radius:
/// compare squares. Source: Olli Niemitalo, "Ellipse-circle and ellipse-ellipse collision detection" (2012).
/// Wrong in print: a segment of length 0 meets every circle, as 0 <= c.e <= |e|^2 and (e x c)^2 <= r^2 |e|^2 hold, all
/// of them 0. Differs: the foot must be within the segment, its ends apart, which are tried by themselves; the nearer
/// end is the origin, so that a long segment costs no digits at its far end.
/// Cost: about 15 ns. May err within a few roundings of contact. Where squares would underflow (the circle and its
/// distance from an end below about 2^-320 of the largest length, float 2^-40, or the segment's line as near as that to
/// the centre of as small a circle), it is left to the exact overlap().
#pragma once

#include <vesica/methods/rect_ellipse_metric.hpp>

namespace vesica::methods {

namespace detail {

/// A segment seen from a circle's centre, of whose ends the first one is the nearer.
template <class T>
struct SegmentAndCircle {
  Vector<T> nearer, farther;
  Vector<T> along;  ///< farther - nearer, from the stored numbers
  T r;
};

template <class T>
VESICA_INLINE T largest(const Vector<T>& p) noexcept {
  return larger(std::fabs(p.x), std::fabs(p.y));
}

template <class T>
VESICA_INLINE T largest_length(const SegmentAndCircle<T>& s) noexcept {
  return larger(larger(largest(s.nearer), largest(s.farther)), larger(largest(s.along), s.r));
}

/// Any magnitudes, and the nearer end first; the largest length comes to lie in [1/2, 1).
template <class T>
SegmentAndCircle<T> rescale(const Segment<double>& s, const Circle<double>& c) noexcept {
  using vesica::detail::arithmetic::Scaled;
  const Scaled lengths[7] = {difference(s.x0, c.cx), difference(s.y0, c.cy), difference(s.x1, c.cx),
                             difference(s.y1, c.cy), difference(s.x1, s.x0), difference(s.y1, s.y0),
                             size_of(c.r, 0)};
  int unit = INT_MIN;
  for (const Scaled& length : lengths) unit = larger_exponent(length, unit);
  if (unit == INT_MIN) unit = 0;
  const auto in = [unit](const Scaled& x) { return in_unit<T>(x, unit); };
  return {{in(lengths[0]), in(lengths[1])},
          {in(lengths[2]), in(lengths[3])},
          {in(lengths[4]), in(lengths[5])},
          in(lengths[6])};
}

/// At a fit scale: the largest length within 2^+-10 (double: 2^+-80).
template <class T>
VESICA_INLINE SegmentAndCircle<T> segment_and_circle(const Segment<T>& s, const Circle<T>& c) noexcept {
  using Traits = ScalarTraits<T>;
  SegmentAndCircle<T> p{{s.x0 - c.cx, s.y0 - c.cy}, {s.x1 - c.cx, s.y1 - c.cy}, {s.x1 - s.x0, s.y1 - s.y0}, c.r};
  const T length = largest_length(p);
  const bool moderate = length >= Traits::power(-10 * Traits::range) && length <= Traits::power(10 * Traits::range);
  if (!moderate) p = rescale<T>(widen(s), widen(c));
  if (dot(p.farther, p.farther) < dot(p.nearer, p.nearer)) return {p.farther, p.nearer, {-p.along.x, -p.along.y}, p.r};
  return p;
}

}  // namespace detail

/// 1 when they share a point, 0 when not, error_shape when either is invalid.
template <class T>
std::int32_t division_free(const Segment<T>& segment, const Circle<T>& circle) noexcept {
  using Traits = ScalarTraits<T>;
  if (check(segment) != 0 || check(circle) != 0) return error_shape;
  const auto s = detail::segment_and_circle(segment, circle);
  constexpr T least = Traits::power(-40 * Traits::range);
  const T size = detail::largest(s.nearer);
  const T beside = detail::cross(s.along, s.nearer), reach = s.r * detail::largest(s.along);
  const bool underflows = (size < least && s.r < least) || (beside != 0 && std::fabs(beside) < least && reach < least);
  if (underflows) return overlap_or_error(segment, circle);
  const T rr = s.r * s.r, square = detail::dot(s.along, s.along), foot = -detail::dot(s.along, s.nearer);
  const bool end = detail::dot(s.nearer, s.nearer) <= rr;
  const bool within = lane::both(foot > 0, foot < square);
  return lane::either(end, lane::both(within, beside * beside <= rr * square)) ? 1 : 0;
}

}  // namespace vesica::methods
