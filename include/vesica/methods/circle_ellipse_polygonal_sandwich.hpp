// SPDX-License-Identifier: Apache-2.0
/// Circle against ellipse by a polygonal sandwich.
///
/// Idea: an inscribed and a circumscribed polygon enclose the outline in triangles. A circle that reaches a side of the
/// inner one overlaps the ellipse, one that misses the outer one does not; in doubt the one triangle that matters is
/// halved into two smaller ones. n iterations amount to polygons of 2^(2 + n) sides. Source: Olli Niemitalo,
/// "Ellipse-circle and ellipse-ellipse collision detection" (2012), as is the bound on their error.
/// Wrong in print: out of iterations the answer is "no collision" though it is not known, and of two triangles that the
/// circle reaches only the first is looked into; 2 to 10 of 100,000 random pairs are misjudged with 10 iterations, of
/// those at 1e-9 of their size from contact nearly half. Differs: the third answer, uncertain, with the bound reached;
/// the triangle is the one that holds the outline's nearest point; the circle's centre in the ellipse is asked of the
/// ellipse itself; every answer keeps a margin for rounding (sandwich.hpp).
/// Cost: about 35 ns, and 10 ns for each iteration; of random pairs few need any. No division; the reported bound, not
/// the answer, takes a root. Never errs. Bound: uncertain means that the outlines touch when the circle's radius
/// changes by less than outline_error, and 50 + 64 iterations roundoffs of the pair's size.
#pragma once

#include <vesica/methods/sandwich.hpp>

namespace vesica::methods {

/// 1 when certainly overlapping, 0 when certainly not, else 2 (uncertain). n, the iterations allowed: 0 to
/// most_sandwich_iterations. Errors, which leave `out` untouched: error_shape, error_argument (n).
template <class T>
std::int32_t polygonal_sandwich(const Circle<T>& circle, const Ellipse<T>& ellipse, std::int32_t n,
                                Approximation<T>& out) noexcept {
  if (check(circle) != 0 || check(ellipse) != 0) return error_shape;
  if (n < 0 || n > most_sandwich_iterations) return error_argument;
  const auto pair = detail::ellipse_and_disc(detail::upright_pair(circle, ellipse));
  const std::int32_t answer = detail::sandwich(pair, n, out.iterations);
  out.outline_error = detail::outline_error(ellipse, out.iterations);
  return answer;
}

}  // namespace vesica::methods
