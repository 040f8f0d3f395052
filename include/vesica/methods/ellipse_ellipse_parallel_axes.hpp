// SPDX-License-Identifier: Apache-2.0
/// Ellipse against ellipse with parallel axes, by scaling the second to a circle.
///
/// Idea: lengths along one axis times the second ellipse's half length along the other, and the other way round, leave
/// the axes parallel and make the second ellipse a circle; then the polygonal sandwich decides. Source: Olli Niemitalo,
/// "Ellipse-circle and ellipse-ellipse collision detection" (2012). Differs as the sandwich does; axes may have any
/// common direction; a second ellipse without a half length, which no scaling makes a circle, changes places with the
/// first, and two such are left to the exact overlap().
/// Cost: about 45 ns, and 10 ns for each iteration. Never errs. Bound: uncertain means that b, its half lengths times 1
/// + e, overlaps a, and times 1 - e, if that is positive, does not: e is outline_error over b's smaller half length,
/// and the rounding, 50 + 64 iterations roundoffs of the stretched pair's size.
#pragma once

#include <vesica/arithmetic/rounding.hpp>
#include <vesica/methods/sandwich.hpp>

namespace vesica::methods {

namespace detail {

/// a b == c d, exactly, products that differ by less than the smallest numbers apart.
inline bool equal_products(double a, double b, double c, double d) noexcept {
  if (a * b != c * d) return false;
  const auto first = vesica::detail::arithmetic::two_product_fused(a, b),
             second = vesica::detail::arithmetic::two_product_fused(c, d);
  return first.low == second.low;
}
inline bool equal_products(float a, float b, float c, float d) noexcept {
  return widen(a) * widen(b) == widen(c) * widen(d);
}

/// True if the ellipses' axes, as stored, are parallel or at right angles.
template <class T>
bool have_parallel_axes(const Ellipse<T>& a, const Ellipse<T>& b) noexcept {
  const auto p = rescaled_pair(Rect<T>{0, 0, a.ux, a.uy, 1, 1}, Rect<T>{0, 0, b.ux, b.uy, 1, 1});
  return equal_products(p.ux, p.wy, p.uy, p.wx) || equal_products(p.ux, p.wx, -p.uy, p.wy);
}

/// The terms whose sum is the stretched centre.
template <class T>
VESICA_INLINE Vector<T> stretched_distance(const RescaledPair<T>& p, const Stretch<T>& by) noexcept {
  const Vector<T> axis = magnitude(Vector<T>{p.wx, p.wy}), d{p.dx, p.dy};
  return {by.b * dot(axis, magnitude(d)), by.a * cross_magnitude(d, axis)};
}

/// Both ellipses stretched so that the second is a disc; their axes are parallel.
template <class T>
VESICA_INLINE EllipseAndDisc<T> stretched_upright(const Metric<T>& m, const Vector<T>& distance) noexcept {
  const T w = m.hx * std::fabs(m.f0.x) + m.hy * std::fabs(m.f1.x);
  const T h = m.hx * std::fabs(m.f0.y) + m.hy * std::fabs(m.f1.y);
  return {{w, 0}, {0, h}, magnitude(m.centre), m.r * m.r, {w, h}, distance, {0, 0}};
}

/// a's polygons against b as a disc; or the other way round, when b is none. `stretched(pair, by, metric)` gives the
/// pair with the second as a disc.
template <class T, class Stretched>
std::int32_t sandwich_ellipses(const Ellipse<T>& a, const Ellipse<T>& b, std::int32_t n, Approximation<T>& out,
                               Stretched stretched) noexcept {
  const auto attempt = [&](const Ellipse<T>& first, const Ellipse<T>& second, std::int32_t& answer) {
    const auto pair = rescaled_pair(box_of(first), box_of(second));
    const auto by = stretch(pair, second);
    const auto m = metric(pair, by);
    if (!m.usable) return false;
    answer = sandwich(stretched(pair, by, m), n, out.iterations);
    out.outline_error = outline_error(first, out.iterations);
    return true;
  };
  std::int32_t answer;
  if (attempt(a, b, answer) || attempt(b, a, answer)) return answer;
  out = {0, 0};
  return overlap_or_error(a, b);
}

}  // namespace detail

/// 1 when certainly overlapping, 0 when certainly not, else 2 (uncertain). n, the iterations allowed: 0 to
/// most_sandwich_iterations. Errors, which leave `out` untouched: error_shape, error_argument (n, or axes that as
/// stored are neither parallel nor at right angles).
template <class T>
std::int32_t parallel_axes(const Ellipse<T>& a, const Ellipse<T>& b, std::int32_t n, Approximation<T>& out) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  if (n < 0 || n > most_sandwich_iterations) return error_argument;
  if (!detail::have_parallel_axes(a, b)) return error_argument;
  return detail::sandwich_ellipses(a, b, n, out, [](const auto& pair, const auto& by, const auto& m) {
    return detail::stretched_upright(m, detail::stretched_distance(pair, by));
  });
}

}  // namespace vesica::methods
