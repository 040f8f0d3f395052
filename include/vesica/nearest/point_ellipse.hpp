// SPDX-License-Identifier: Apache-2.0
/// A point outside an ellipse: the normal from the one to the other, and the distance along it.
#pragma once

#include <vesica/nearest/support.hpp>

namespace vesica::closest {

/// The secular equation of a point (x, y) in the first quadrant and the ellipse (x/a)^2 + (y/b)^2 = 1, a >= b > 0.
///
/// The closest point f has (x, y) - f = t (f_x / a^2, f_y / b^2), so f_x = a w0 and f_y = b w1 with w0 = a x / (t + a^2),
/// w1 = b y / (t + b^2) and w0^2 + w1^2 = 1; the largest root t is the one sought (D. Eberly, "Distance from a Point to
/// an Ellipse, an Ellipsoid, or a Hyperellipsoid", Geometric Tools). With tau = (t + b^2) / (a b), which keeps its
/// precision next to the pole at 0,
///     w0 = A / (tau + k),  w1 = B / tau,  A = x / b,  B = y / a,  k = (a - b)(a + b) / (a b).
template <class V>
struct SecularEquation {
  V A, B, k, least;  // least: tau of the outline itself, t = 0, which no point outside goes below
};

template <class V>
VESICA_INLINE SecularEquation<V> secular_equation(V a, V b, V x, V y) noexcept {
  const V inverse = V(1.0) / (a * b);
  return {x * (a * inverse), y * (b * inverse), ((a - b) * (a + b)) * inverse, (b * b) * inverse};
}

/// (w0, w1) at tau, and where Newton's method goes from there: on 1 / |w| - 1, which is nearly straight, so that a few
/// steps do, and from the left of the root never past it (J. J. More and D. C. Sorensen, "Computing a trust region
/// step", 1983).
template <class V>
struct SecularStep {
  V w0, w1, square, step;
};

template <class V>
VESICA_INLINE SecularStep<V> secular_step(const SecularEquation<V>& e, V tau) noexcept {
  const V other = tau + e.k, inverse = V(1.0) / (tau * other), over_tau = inverse * other, over_other = inverse * tau;
  const V w0 = e.A * over_other, w1 = e.B * over_tau;
  const V s0 = w0 * w0, s1 = w1 * w1, square = s0 + s1;
  return {w0, w1, square, (square * (sqrt(square) - V(1.0))) / (s0 * over_other + s1 * over_tau)};
}

/// A step below this share of tau is the last: the error after it is of the order of its square.
inline constexpr double last_secular_step = 0x1p-27;

/// No search has been seen to take more than 30 steps (tests/nearest fails at 48).
inline constexpr int secular_step_limit = 64;

template <class V>
struct SecularRoot {
  V w0, w1;
  MaskOf<V> found;
  int steps;
};

/// Each of the two terms alone, and both at once, bound the root: max(B, A - k) <= tau <= max(B, A - k) where both terms
/// are taken sqrt(2) times as large. Where the bounds lie far apart the middle exponent is tried first: Newton's method
/// would creep there. Lanes that are done stand still.
template <class V>
VESICA_INLINE SecularRoot<V> solve_secular(const SecularEquation<V>& e) noexcept {
  const V root_2(1.4142135623730952), far(64.0), one(1.0);
  V low = max(max(e.B, e.A - e.k), e.least), high = max(max(root_2 * e.B, root_2 * e.A - e.k), low);
  int steps = 0;
  for (; !all(high <= far * low) && steps < secular_step_limit; ++steps) [[unlikely]] {
      const V middle = sqrt(low) * sqrt(high);  // apart: the product may underflow
      const auto open = high > far * low, below = secular_step(e, middle).square >= one;
      low = select(both(open, below), middle, low);
      high = select(and_not(open, below), middle, high);
    }
  V tau = low;
  auto done = one > one;
  for (; steps < secular_step_limit && !all(done); ++steps) {
    const V step = positive_part(secular_step(e, tau).step);
    const V next = tau + step;
    tau = select(done, tau, next);
    done = either(done, step <= V(last_secular_step) * next);
  }
  const V other = tau + e.k, inverse = one / (tau * other);
  return {e.A * (inverse * tau), e.B * (inverse * other), done, steps};
}

template <class V>
struct NormalToEllipse {
  Direction<V> n;
  MaskOf<V> found;
  int steps;
};

/// The direction from a point outside an ellipse to the point of the ellipse closest to it; d from the point to the
/// ellipse's centre. About a unit vector.
template <class V>
VESICA_INLINE NormalToEllipse<V> normal_to_ellipse(const Axes<V>& e, V dx, V dy) noexcept {
  // In the ellipse's frame, in units of |u|, where the half lengths are a u.u and b u.u.
  const V uu = e.ux * e.ux + e.uy * e.uy, x = e.ux * dx + e.uy * dy, y = e.ux * dy - e.uy * dx;
  const V a = e.a * uu, b = e.b * uu, fx = abs(x), fy = abs(y);
  const auto upright = a < b;
  const SecularRoot<V> root = solve_secular(
      secular_equation(select(upright, b, a), select(upright, a, b), select(upright, fy, fx), select(upright, fx, fy)));
  const V p = flip_sign(b * select(upright, root.w1, root.w0), x);
  const V q = flip_sign(a * select(upright, root.w0, root.w1), y);
  const V nx = p * e.ux - q * e.uy, ny = p * e.uy + q * e.ux, scale = V(1.0) / (abs(nx) + abs(ny));
  return {{nx * scale, ny * scale}, root.found, root.steps};
}

/// The distance from a point to an ellipse that it lies outside of.
template <class V>
VESICA_INLINE ClosestOffsets<V> point_ellipse(const Axes<V>& e, const Vector<V>& d, V size, int& steps) noexcept {
  const NormalToEllipse<V> direction = normal_to_ellipse(e, d.x.high, d.y.high);
  const auto n = normal(factor(direction.n.x, direction.n.y));
  steps = direction.steps;
  ClosestOffsets<V> result = separation(d, n, no_support<V>(), support(e, n), size);
  result.settled = both(result.settled, direction.found);
  return result;
}

/// A circle is a point that reaches r farther.
template <class V>
VESICA_INLINE ClosestOffsets<V> circle_ellipse(V r, const Axes<V>& e, const Vector<V>& d, V size, int& steps) noexcept {
  ClosestOffsets<V> result = point_ellipse(e, d, size, steps);
  result.ax = r * result.nx;
  result.ay = r * result.ny;
  result.distance = result.distance - Twofold<V>{r, V(0.0)};
  return result;
}

}  // namespace vesica::closest
