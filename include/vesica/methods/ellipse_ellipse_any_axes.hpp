// SPDX-License-Identifier: Apache-2.0
/// Ellipse against ellipse, any axes, by turning and stretching until the second is a circle.
///
/// Idea: the linear map that makes the second ellipse a circle leaves the first one an ellipse whose new axes are hard
/// to find. They are not needed: the polygonal sandwich only ever adds and scales points, so it may start from the
/// images of the old axes. Source: Olli Niemitalo, "Ellipse-circle and ellipse-ellipse collision detection" (2012),
/// with ellipses as centre, radius vector and the ratio of the other radius to it.
/// Wrong in print: single precision where double is meant, and all that is wrong with its sandwich. Differs: without
/// the turning back, which changes nothing that is asked; the first arc is the one that holds the outline's nearest
/// point (bisected_arc.hpp); a second ellipse without a half length, which no map makes a circle, changes places with
/// the first, and two such are left to the exact overlap().
/// Cost: about 65 ns, and 10 ns for each iteration. Never errs. Bound: uncertain means that b, its half lengths times 1
/// + e, overlaps a, and times 1 - e, if that is positive, does not: e is outline_error over b's smaller half length,
/// and the rounding, as there, but of the images: where both are thin, of the larger half lengths' product over b's
/// smaller one.
#pragma once

#include <vesica/methods/ellipse_ellipse_parallel_axes.hpp>

namespace vesica::methods {

/// An ellipse as centre, radius vector w (half an axis) and the ratio of the other radius to |w|. Valid when finite,
/// with ratio >= 0. A zero vector makes it a point.
template <class T>
struct RadiusVectorEllipse {
  T cx, cy, wx, wy, ratio;
};

namespace detail {

/// Both ellipses stretched so that the second is a disc.
template <class T>
VESICA_INLINE EllipseAndDisc<T> stretched(const RescaledPair<T>& p, const Stretch<T>& by, const Metric<T>& m) noexcept {
  const Vector<T> u{p.ux, p.uy}, w = magnitude(Vector<T>{p.wx, p.wy});
  const T along = dot(w, magnitude(u)), across = cross_magnitude(u, w);
  const Vector<T> size{by.b * (m.hx * along + m.hy * across), by.a * (m.hx * across + m.hy * along)};
  return {times(m.hx, m.f0),
          times(m.hy, m.f1),
          {-m.centre.x, -m.centre.y},
          m.r * m.r,
          size,
          stretched_distance(p, by),
          times(8 * ScalarTraits<T>::roundoff, size)};
}

}  // namespace detail

/// 1 when certainly overlapping, 0 when certainly not, else 2 (uncertain). n, the iterations allowed: 0 to
/// most_sandwich_iterations. Errors, which leave `out` untouched: error_shape, error_argument (n).
template <class T>
std::int32_t any_axes(const Ellipse<T>& a, const Ellipse<T>& b, std::int32_t n, Approximation<T>& out) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  if (n < 0 || n > most_sandwich_iterations) return error_argument;
  return detail::sandwich_ellipses(a, b, n, out, detail::stretched<T>);
}

/// The same of ellipses given by centre, radius vector and ratio, as vesica::ellipse_from_radius_vector() makes them.
template <class T>
std::int32_t any_axes(const RadiusVectorEllipse<T>& a, const RadiusVectorEllipse<T>& b, std::int32_t n,
                      Approximation<T>& out) noexcept {
  Ellipse<T> first, second;
  if (ellipse_from_radius_vector(a.cx, a.cy, a.wx, a.wy, a.ratio, first) != 0) return error_shape;
  if (ellipse_from_radius_vector(b.cx, b.cy, b.wx, b.wy, b.ratio, second) != 0) return error_shape;
  return any_axes(first, second, n, out);
}

}  // namespace vesica::methods
