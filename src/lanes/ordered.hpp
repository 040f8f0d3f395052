// SPDX-License-Identifier: Apache-2.0
// Two stored numbers, x and y, as integers in the order of the numbers. Comparisons of integers are no floating-point
// operations: they do not depend on the control register. For AVX-512.
#pragma once

#include <immintrin.h>

#include <cstdint>

namespace vesica {
namespace {  // a type of its own in each object: no instantiation may be shared with one for another instruction set

/// One bit for x and one for y.
using Both = __mmask8;
inline constexpr Both all_of_both = 3;
inline constexpr int nan_or_infinite = 0x99;

template <class T>
struct Ordered;

/// The sign is turned into that of two's complement, so that -0 and 0 become one integer.
template <>
struct Ordered<double> {
  __m128i key;
  Both not_finite;

  explicit Ordered(const double& x) {
    const __m128i bits = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&x)), sign = _mm_srai_epi64(bits, 63);
    const __m128i magnitude = _mm_and_si128(bits, _mm_set1_epi64x(INT64_MAX));
    key = _mm_sub_epi64(_mm_xor_si128(magnitude, sign), sign);
    not_finite = _mm_fpclass_pd_mask(_mm_castsi128_pd(bits), nan_or_infinite);
  }
  friend Both operator<=(Ordered a, Ordered b) { return _mm_cmple_epi64_mask(a.key, b.key); }
  friend Both operator==(Ordered a, Ordered b) { return _mm_cmpeq_epi64_mask(a.key, b.key); }
};
template <>
struct Ordered<float> {
  __m128i key;
  Both not_finite;

  explicit Ordered(const float& x) {
    const __m128i bits = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(&x)), sign = _mm_srai_epi32(bits, 31);
    const __m128i magnitude = _mm_and_si128(bits, _mm_set1_epi32(INT32_MAX));
    key = _mm_sub_epi32(_mm_xor_si128(magnitude, sign), sign);
    not_finite = _mm_fpclass_ps_mask(_mm_castsi128_ps(bits), nan_or_infinite);
  }
  friend Both operator<=(Ordered a, Ordered b) { return _mm_mask_cmple_epi32_mask(all_of_both, a.key, b.key); }
  friend Both operator==(Ordered a, Ordered b) { return _mm_mask_cmpeq_epi32_mask(all_of_both, a.key, b.key); }
};

/// Both bits of all.
template <class... Rest>
Both both_of(Both first, Rest... rest) {
  ((first = _kand_mask8(first, rest)), ...);
  return first;
}
template <class T, class... Rest>
Both finite(const Ordered<T>& first, const Rest&... rest) {
  Both not_finite = first.not_finite;
  ((not_finite = _kor_mask8(not_finite, rest.not_finite)), ...);
  return _knot_mask8(not_finite);
}

}  // namespace
}  // namespace vesica
