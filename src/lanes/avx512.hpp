// SPDX-License-Identifier: Apache-2.0
// Lanes of AVX-512: 16 floats or 8 doubles, masks in their own registers.
#pragma once

#include <immintrin.h>

#include <cstdint>
#include <cstring>

namespace vesica {
namespace {  // a type of its own in each object: no instantiation may be shared with one for another instruction set

template <int Width>
struct Mask;

template <>
struct Mask<16> {
  __mmask16 bits;
};
template <>
struct Mask<8> {
  __mmask8 bits;
};

template <int W>
Mask<W> both(Mask<W> a, Mask<W> b) {
  return {static_cast<decltype(a.bits)>(a.bits & b.bits)};
}
template <int W>
Mask<W> either(Mask<W> a, Mask<W> b) {
  return {static_cast<decltype(a.bits)>(a.bits | b.bits)};
}
template <int W>
Mask<W> and_not(Mask<W> a, Mask<W> b) {
  return {static_cast<decltype(a.bits)>(a.bits & ~b.bits)};
}
template <int W>
std::uint32_t bits(Mask<W> m) {
  return m.bits;
}
inline bool all(Mask<16> m) { return m.bits == 0xffffu; }
inline bool all(Mask<8> m) { return m.bits == 0xffu; }
template <int W>
int count(Mask<W> m) {
  return __builtin_popcount(m.bits);
}
// One byte a lane, 1 or 0.
inline void store_bytes(Mask<16> m, std::uint8_t* out) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out), _mm_maskz_mov_epi8(m.bits, _mm_set1_epi8(1)));
}
inline void store_bytes(Mask<8> m, std::uint8_t* out) {
  _mm_storel_epi64(reinterpret_cast<__m128i*>(out), _mm_maskz_mov_epi8(m.bits, _mm_set1_epi8(1)));
}

struct Floats {
  using Element = float;
  static constexpr int width = 16;
  __m512 v;
  Floats() = default;
  Floats(__m512 x) : v(x) {}
  explicit Floats(float x) : v(_mm512_set1_ps(x)) {}
  static Floats load(const float* p) { return _mm512_loadu_ps(p); }
};
inline Floats operator+(Floats a, Floats b) { return _mm512_add_ps(a.v, b.v); }
inline Floats operator-(Floats a, Floats b) { return _mm512_sub_ps(a.v, b.v); }
inline Floats operator*(Floats a, Floats b) { return _mm512_mul_ps(a.v, b.v); }
inline Floats operator-(Floats a) { return _mm512_xor_ps(a.v, _mm512_set1_ps(-0.0f)); }
inline Floats abs(Floats a) { return _mm512_abs_ps(a.v); }
inline Floats max(Floats a, Floats b) { return _mm512_max_ps(a.v, b.v); }
inline Floats min(Floats a, Floats b) { return _mm512_min_ps(a.v, b.v); }
inline Floats positive_part(Floats a) { return max(a, Floats(0.0f)); }
inline Mask<16> operator<(Floats a, Floats b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)}; }
inline Mask<16> operator<=(Floats a, Floats b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)}; }
inline Mask<16> operator>(Floats a, Floats b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)}; }
inline Mask<16> operator>=(Floats a, Floats b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GE_OQ)}; }
inline Mask<16> operator==(Floats a, Floats b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_EQ_OQ)}; }
inline Floats select(Mask<16> m, Floats yes, Floats no) { return _mm512_mask_blend_ps(m.bits, no.v, yes.v); }
inline Floats flip_sign(Floats x, Floats y) { return _mm512_xor_ps(x.v, _mm512_and_ps(y.v, _mm512_set1_ps(-0.0f))); }
inline Floats rough_sqrt(Floats a) {
  return _mm512_mul_ps(a.v, _mm512_rsqrt14_ps(_mm512_max_ps(a.v, _mm512_set1_ps(0x1p-126f))));
}
inline Floats rough_quotient(Floats a, Floats b) { return _mm512_mul_ps(a.v, _mm512_rcp14_ps(b.v)); }

struct Doubles {
  using Element = double;
  static constexpr int width = 8;
  __m512d v;
  Doubles() = default;
  Doubles(__m512d x) : v(x) {}
  explicit Doubles(double x) : v(_mm512_set1_pd(x)) {}
  static Doubles load(const double* p) { return _mm512_loadu_pd(p); }
  static Doubles load(const float* p) { return _mm512_cvtps_pd(_mm256_loadu_ps(p)); }
  void store(double* p) const { _mm512_storeu_pd(p, v); }
};
inline Doubles operator+(Doubles a, Doubles b) { return _mm512_add_pd(a.v, b.v); }
inline Doubles operator-(Doubles a, Doubles b) { return _mm512_sub_pd(a.v, b.v); }
inline Doubles operator*(Doubles a, Doubles b) { return _mm512_mul_pd(a.v, b.v); }
inline Doubles operator/(Doubles a, Doubles b) { return _mm512_div_pd(a.v, b.v); }
inline Doubles operator-(Doubles a) { return _mm512_xor_pd(a.v, _mm512_set1_pd(-0.0)); }
inline Doubles abs(Doubles a) { return _mm512_abs_pd(a.v); }
inline Doubles max(Doubles a, Doubles b) { return _mm512_max_pd(a.v, b.v); }
inline Doubles min(Doubles a, Doubles b) { return _mm512_min_pd(a.v, b.v); }
inline Doubles positive_part(Doubles a) { return max(a, Doubles(0.0)); }
inline Mask<8> operator<(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)}; }
inline Mask<8> operator<=(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)}; }
inline Mask<8> operator>(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)}; }
inline Mask<8> operator>=(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GE_OQ)}; }
inline Mask<8> operator==(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)}; }
inline Doubles select(Mask<8> m, Doubles yes, Doubles no) { return _mm512_mask_blend_pd(m.bits, no.v, yes.v); }
inline Doubles flip_sign(Doubles x, Doubles y) { return _mm512_xor_pd(x.v, _mm512_and_pd(y.v, _mm512_set1_pd(-0.0))); }
// The 14-bit estimates and one Newton step each: 2^-26.
inline Doubles sqrt(Doubles a) { return _mm512_sqrt_pd(a.v); }
inline Doubles rough_sqrt(Doubles a) {
  const __m512d x = _mm512_max_pd(a.v, _mm512_set1_pd(0x1p-1022));
  const __m512d r = _mm512_rsqrt14_pd(x), root = _mm512_mul_pd(x, r);
  const __m512d rest = _mm512_fnmadd_pd(root, r, _mm512_set1_pd(1.0));
  return _mm512_fmadd_pd(_mm512_mul_pd(root, _mm512_set1_pd(0.5)), rest, root);
}
inline Doubles rough_quotient(Doubles a, Doubles b) {
  const __m512d r = _mm512_rcp14_pd(b.v), q = _mm512_mul_pd(a.v, r);
  return _mm512_fmadd_pd(_mm512_fnmadd_pd(q, b.v, a.v), r, q);
}

// In bits: of a number in [1/2, 2) the difference to 1/2 leaves the upper part, sign and exponent, clear; a gap too
// large, infinite or NaN turns the sign of its difference to the bound.
inline Mask<16> near_unit_boxes(Floats uu, Floats ww, Floats a_hx, Floats a_hy, Floats b_hx, Floats b_hy,
                                Floats abs_gap) {
  const __m512i lowest = _mm512_set1_epi32(0x3f000000), upper = _mm512_set1_epi32(~0xffffff);
  const __m512i beyond = _mm512_or_si512(_mm512_sub_epi32(_mm512_castps_si512(uu.v), lowest),
                                         _mm512_sub_epi32(_mm512_castps_si512(ww.v), lowest));
  const __m512i room = _mm512_sub_epi32(_mm512_castps_si512(_mm512_set1_ps(0x1p100f)), _mm512_castps_si512(abs_gap.v));
  const __m512i sizes = _mm512_castps_si512(_mm512_or_ps(_mm512_or_ps(a_hx.v, a_hy.v), _mm512_or_ps(b_hx.v, b_hy.v)));
  const __m512i sign = _mm512_castps_si512(_mm512_set1_ps(-0.0f));
  const __m512i wrong =
      _mm512_or_si512(_mm512_and_si512(beyond, upper), _mm512_and_si512(_mm512_or_si512(sizes, room), sign));
  return {_mm512_testn_epi32_mask(wrong, wrong)};
}
inline Mask<8> near_unit_boxes(Doubles uu, Doubles ww, Doubles a_hx, Doubles a_hy, Doubles b_hx, Doubles b_hy,
                               Doubles abs_gap) {
  const __m512i lowest = _mm512_set1_epi64(0x3fe0000000000000), upper = _mm512_set1_epi64(~0x1fffffffffffff);
  const __m512i beyond = _mm512_or_si512(_mm512_sub_epi64(_mm512_castpd_si512(uu.v), lowest),
                                         _mm512_sub_epi64(_mm512_castpd_si512(ww.v), lowest));
  const __m512i room = _mm512_sub_epi64(_mm512_castpd_si512(_mm512_set1_pd(0x1p800)), _mm512_castpd_si512(abs_gap.v));
  const __m512i sizes = _mm512_castpd_si512(_mm512_or_pd(_mm512_or_pd(a_hx.v, a_hy.v), _mm512_or_pd(b_hx.v, b_hy.v)));
  const __m512i sign = _mm512_castpd_si512(_mm512_set1_pd(-0.0));
  const __m512i wrong =
      _mm512_or_si512(_mm512_and_si512(beyond, upper), _mm512_and_si512(_mm512_or_si512(sizes, room), sign));
  return {_mm512_testn_epi64_mask(wrong, wrong)};
}
template <int e>
Floats divide_by_power(Floats x) {
  return _mm512_castsi512_ps(_mm512_sub_epi32(_mm512_castps_si512(x.v), _mm512_set1_epi32(e << 23)));
}
template <int e>
Doubles divide_by_power(Doubles x) {
  return _mm512_castsi512_pd(_mm512_sub_epi64(_mm512_castpd_si512(x.v), _mm512_set1_epi64(std::int64_t{e} << 52)));
}
inline Mask<16> greater_where(Mask<16> mask, Floats a, Floats b) {
  return {_mm512_mask_cmp_ps_mask(mask.bits, a.v, b.v, _CMP_GT_OQ)};
}
inline Mask<8> greater_where(Mask<8> mask, Doubles a, Doubles b) {
  return {_mm512_mask_cmp_pd_mask(mask.bits, a.v, b.v, _CMP_GT_OQ)};
}

}  // namespace
}  // namespace vesica
