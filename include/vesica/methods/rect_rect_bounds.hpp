// SPDX-License-Identifier: Apache-2.0
/// Rectangle against rectangle by their bounds: a first pass.
///
/// Idea: boxes along the coordinate axes are compared by their ends alone, and shapes whose boxes are apart are apart.
/// Source: "Rectangle intersection at 60fps" (blitcurve). In print the boxes' answer may be mistaken for the
/// rectangles'; here boxes that meet say no more than uncertain.
/// Differs: half widths carry a bound on their rounding, so a `no` is true of the stored numbers.
/// Cost: about 5 ns. Never errs. Bound: uncertain means that the boxes meet, or their centres are along both
/// coordinates apart by less than the sum of their half widths and 22 roundoffs of it (and 9 of the smallest numbers),
/// or that the sum is beyond the finite numbers.
#pragma once

#include <cmath>
#include <limits>
#include <vesica/check.hpp>
#include <vesica/methods/verdict.hpp>
#include <vesica/scalar.hpp>

namespace vesica::methods {

namespace detail {

/// True if two intervals about centres, with half lengths p0 q0 + p1 q1 and r0 s0 + r1 s1, are certainly apart. All but
/// the centres are at least 0.
///
/// The sum of four products has a relative error of 4 roundoffs, the difference of the centres 1, the factor below 2;
/// and each product may lose half the smallest number. What overflows is not finite, and claims nothing: a difference
/// beyond the range does exceed a finite sum.
template <class T>
bool apart(T from, T to, T p0, T q0, T p1, T q1, T r0, T s0, T r1, T s1) noexcept {
  const T reach = (p0 * q0 + p1 * q1) + (r0 * s0 + r1 * s1);
  const T bound = reach * (1 + 16 * ScalarTraits<T>::roundoff) + 8 * std::numeric_limits<T>::denorm_min();
  return std::fabs(to - from) > bound;
}

}  // namespace detail

/// 0 when certainly disjoint, else 2 (uncertain); error_shape when either is invalid.
template <class T>
std::int32_t bounds(const Rect<T>& a, const Rect<T>& b) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  const T ux = std::fabs(a.ux), uy = std::fabs(a.uy), wx = std::fabs(b.ux), wy = std::fabs(b.uy);
  const bool along_x = detail::apart(a.cx, b.cx, ux, a.hx, uy, a.hy, wx, b.hx, wy, b.hy);
  const bool along_y = detail::apart(a.cy, b.cy, uy, a.hx, ux, a.hy, wy, b.hx, wx, b.hy);
  return lane::either(along_x, along_y) ? no : uncertain;
}

}  // namespace vesica::methods
