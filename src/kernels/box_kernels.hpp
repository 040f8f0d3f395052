// SPDX-License-Identifier: Apache-2.0
// Bounds and corners of rectangles and ellipses, a vector of shapes at a time, by the functions of vesica/bounds.hpp
// and vesica/boxes.hpp. Included by query_loop.hpp, for lanes that have a fused multiply-add.
#pragma once

#include <limits>
#include <vesica/bounds.hpp>
#include <vesica/boxes.hpp>

#include "kernels/guard.hpp"

namespace vesica {
namespace {

/// As the scalar of this name.
template <class V>
requires detail::arithmetic::HasFused<V> VESICA_INLINE detail::arithmetic::Pair<V> two_product_fused(V a, V b)
noexcept {
  const V high = a * b;
  return {high, fused_difference(a, b, high)};
}

/// As the scalar of this name: the next number above x where `up` is set, not for the negative one next to 0.
template <class Mask, HasBits V>
VESICA_INLINE V above_if(Mask up, V x) noexcept {
  const V zero(0.0);
  return select(up, select(x < zero, with_bits_added(x, -1), with_bits_added(x, 1)), x);
}

/// A shape's extent along a coordinate, as the scalars' estimate() has it.
template <class V>
VESICA_INLINE detail::arithmetic::Estimate<V> extent_of(bool is_ellipse, const detail::arithmetic::Pair<V>& x,
                                                        const detail::arithmetic::Pair<V>& y) noexcept {
  const auto sum = detail::bounds::estimate_sum(x, y);
  if (!is_ellipse) return sum;
  const V zero(0.0);
  const auto flat = either(x.high == zero, y.high == zero);
  const auto root = detail::bounds::estimate_root(x, y);
  return {select(flat, sum.high, root.high), select(flat, sum.low, root.low), select(flat, sum.error, root.error)};
}

/// The interval from c - extent to c + extent, rounded outwards, where the returned mask is set.
template <class V>
VESICA_INLINE auto interval_of(bool is_ellipse, V c, V p0, V q0, V p1, V q1, V& low, V& high) noexcept {
  namespace bounds = detail::bounds;
  using detail::arithmetic::add, detail::arithmetic::round_up;
  const auto x = two_product_fused(abs(p0), q0), y = two_product_fused(abs(p1), q1);
  const auto usable =
      both(both(bounds::in_range(p0, q0, x.high), bounds::in_range(p1, q1, y.high)), abs(c) <= V(0x1p400));
  const auto extent = extent_of(is_ellipse, x, y);
  V minus_low;
  const auto has_high = round_up(add(c, extent), high), has_low = round_up(add(-c, extent), minus_low);
  low = V(0.0) - minus_low;
  return both(usable, both(has_high, has_low));
}

/// Leaves results[0] where `known` is set; elsewhere the scalar function must be asked.
template <class V, class Mask>
VESICA_INLINE void mark_unknown(Mask known, double* results) noexcept {
  select(known, V::load(results), V(std::numeric_limits<double>::quiet_NaN())).store(results);
}

/// Writes min_x, min_y, max_x and max_y: first those of x, then by the same code those of y.
template <class V>
VESICA_KERNEL void find_bounds(const double* const* number, bool is_ellipse, std::int32_t n,
                               double* const* results) noexcept {
  for (int axis = 0; axis < 2; ++axis) {
    const double* const centre = number[axis];
    const double *const u0 = number[2 + axis], *const u1 = number[3 - axis];
    for (std::int32_t i = 0; i < n; i += V::width) {
      const auto s = load_shape<Rect, V>(number, i);
      V low, high;
      const auto known =
          interval_of(is_ellipse, V::load(centre + i), V::load(u0 + i), s.hx, V::load(u1 + i), s.hy, low, high);
      low.store(results[axis] + i);
      high.store(results[2 + axis] + i);
      mark_unknown<V>(both(valid(s), known), results[0] + i);
    }
  }
}

/// Writes x0, y0 and so on to y3: first those of x, then by the same code those of y.
template <class V>
VESICA_KERNEL void find_corners(const double* const* number, std::int32_t n, double* const* results) noexcept {
  for (int axis = 0; axis < 2; ++axis) {
    const double* const centre = number[axis];
    const double *const u0 = number[2 + axis], *const u1 = number[3 - axis];
    const V sign(axis == 0 ? -1.0 : 1.0);
    for (std::int32_t i = 0; i < n; i += V::width) {
      const auto s = load_shape<Rect, V>(number, i);
      const detail::CornerCoordinate<V> of(V::load(centre + i), s.hx, V::load(u0 + i), flip_sign(s.hy, sign),
                                           V::load(u1 + i));
      of.at(false, false).store(results[axis] + i);
      of.at(true, false).store(results[2 + axis] + i);
      of.at(true, true).store(results[4 + axis] + i);
      of.at(false, true).store(results[6 + axis] + i);
      mark_unknown<V>(valid(s), results[0] + i);
    }
  }
}

constinit const BoxKernels box_kernels{find_bounds<Doubles>, find_corners<Doubles>};

}  // namespace
}  // namespace vesica
