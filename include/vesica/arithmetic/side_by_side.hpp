// SPDX-License-Identifier: Apache-2.0
/// Two roots or two quotients at once. They are the slowest operations that there are, and where the processor has
/// vectors of two doubles, two take the time of one. The bits are those of two single operations.
#pragma once

#include <vesica/scalar.hpp>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace vesica::detail::arithmetic {

struct Two {
  double x, y;
};

#if defined(__SSE2__)
VESICA_INLINE Two both_of(__m128d v) noexcept { return {_mm_cvtsd_f64(v), _mm_cvtsd_f64(_mm_unpackhi_pd(v, v))}; }
VESICA_INLINE Two sqrt(const Two& a) noexcept { return both_of(_mm_sqrt_pd(_mm_set_pd(a.y, a.x))); }
VESICA_INLINE Two operator/(const Two& a, const Two& b) noexcept {
  return both_of(_mm_div_pd(_mm_set_pd(a.y, a.x), _mm_set_pd(b.y, b.x)));
}
#else
VESICA_INLINE Two sqrt(const Two& a) noexcept { return {lane::sqrt(a.x), lane::sqrt(a.y)}; }
VESICA_INLINE Two operator/(const Two& a, const Two& b) noexcept { return {a.x / b.x, a.y / b.y}; }
#endif

}  // namespace vesica::detail::arithmetic
