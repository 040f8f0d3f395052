// SPDX-License-Identifier: Apache-2.0
/// Rectangle against rectangle by sample points: yes or unknown.
///
/// Idea: a corner of one, or one of k points spaced evenly along the middle of its long side, that lies in the other
/// proves that they overlap. Source: "Rectangle intersection at 60fps" (blitcurve).
/// Wrong in print: that one rectangle's samples make the answer exact once its width w > l / (k + 1). They do not, for
/// any k: the other's corner may stand between them (a quarter of such overlaps is missed one way round).
/// Differs: both ways round are tried. That missed none of 4 million random overlaps whose widths both keep the
/// condition, contacts apart; but it is measured, not proved, so no point inside is `uncertain`, never a no. A point
/// counts as inside only by more than the rounding of its place, so a `yes` is true of the stored numbers. Touching is
/// uncertain.
/// Cost: 2 (4 + k) points at worst: about 30 ns, and 2 ns for each k. Never errs. Bound: with k >= 1, uncertain means
/// that no stretch of l / (k + 1) of either rectangle's middle line (the longer one, of length l) lies in the other
/// rectangle made smaller by 50 roundoffs of the sum of distance and sizes.
#pragma once

#include <vesica/methods/rescaled_pair.hpp>
#include <vesica/methods/verdict.hpp>

namespace vesica::methods {

/// The largest k: enough for rectangles a thousand times as long as wide.
inline constexpr std::int32_t most_sample_points = 1000;

namespace detail {

/// The frame of the rectangle that samples are sought in, seen from the one they belong to: a sample s along and t
/// across lies at (x + s c - t n, y + s n + t c), known to within `error`, and inside when within +-(e0, e1).
template <class T>
struct SampleFrame {
  T x, y, c, n, e0, e1;

  VESICA_INLINE bool holds(T s, T t) const noexcept {
    return lane::both(std::fabs(x + s * c - t * n) <= e0, std::fabs(y + s * n + t * c) <= e1);
  }
};

/// From a rectangle of axis u and sizes h0, h1 to one of axis w and sizes g0, g1, whose centre is at d.
///
/// With N = |d||w| + (h0 + h1) |u||w| + (g0 + g1) w.w in sums of absolute components, the coordinates of a sample have
/// an error of at most 7 roundoffs of N (d 1, its products 2, c and n 2 and their products 1, the sums 2), e0 and e1 of
/// 3; numbers that underflow cost less than the 100th (800th) power of 1/2.
template <class T>
VESICA_INLINE SampleFrame<T> sample_frame(T dx, T dy, T ux, T uy, T h0, T h1, T wx, T wy, T g0, T g1) noexcept {
  using Traits = ScalarTraits<T>;
  const T u = std::fabs(ux) + std::fabs(uy), w = std::fabs(wx) + std::fabs(wy), ww = wx * wx + wy * wy;
  const T n = (std::fabs(dx) + std::fabs(dy)) * w + (h0 + h1) * (u * w) + (g0 + g1) * ww;
  const T error = 16 * Traits::roundoff * n + Traits::power(-100 * Traits::range);
  return {-(wx * dx + wy * dy), wy * dx - wx * dy, wx * ux + wy * uy,
          wx * uy - wy * ux,    g0 * ww - error,   g1 * ww - error};
}

/// True if one of the samples of a rectangle of half extents h0, h1 is in the other one. Each |s| <= h0, |t| <= h1 in
/// spite of rounding, so every sample is a point of its rectangle.
template <class T>
bool holds_a_sample(const SampleFrame<T>& f, T h0, T h1, std::int32_t k) noexcept {
  const bool corner =
      lane::either(lane::either(f.holds(-h0, -h1), f.holds(h0, -h1)), lane::either(f.holds(h0, h1), f.holds(-h0, h1)));
  if (corner) return true;
  for (std::int32_t i = 1; i <= k; ++i) {
    const T fraction = static_cast<T>(2 * i - (k + 1)) / static_cast<T>(k + 1);
    if (h0 >= h1 ? f.holds(h0 * fraction, 0) : f.holds(0, h1 * fraction)) return true;
  }
  return false;
}

}  // namespace detail

/// 1 when certainly overlapping, else 2 (uncertain). k: 0 to most_sample_points. error_shape when either is invalid,
/// error_argument when k is out of range.
template <class T>
std::int32_t sample_points(const Rect<T>& a, const Rect<T>& b, std::int32_t k) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  if (k < 0 || k > most_sample_points) return error_argument;
  const auto p = detail::rescaled_pair(a, b);
  const auto in_b = detail::sample_frame(p.dx, p.dy, p.ux, p.uy, p.h0, p.h1, p.wx, p.wy, p.g0, p.g1);
  if (detail::holds_a_sample(in_b, p.h0, p.h1, k)) return yes;
  const auto in_a = detail::sample_frame(-p.dx, -p.dy, p.wx, p.wy, p.g0, p.g1, p.ux, p.uy, p.h0, p.h1);
  return detail::holds_a_sample(in_a, p.g0, p.g1, k) ? yes : uncertain;
}

}  // namespace vesica::methods
