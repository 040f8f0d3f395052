// SPDX-License-Identifier: Apache-2.0
// Lanes of AVX-512: 16 floats or 8 doubles, masks in their own registers.
#pragma once

#include <immintrin.h>

#include <cstdint>
#include <cstring>

#include "unaligned.hpp"

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

#if defined(__clang__)
// By Clang's own masks: between these and integers Clang 19 moves to and fro, for minutes in long kernels.
inline Mask<16> both(Mask<16> a, Mask<16> b) { return {_kand_mask16(a.bits, b.bits)}; }
inline Mask<8> both(Mask<8> a, Mask<8> b) { return {_kand_mask8(a.bits, b.bits)}; }
inline Mask<16> either(Mask<16> a, Mask<16> b) { return {_kor_mask16(a.bits, b.bits)}; }
inline Mask<8> either(Mask<8> a, Mask<8> b) { return {_kor_mask8(a.bits, b.bits)}; }
inline Mask<16> and_not(Mask<16> a, Mask<16> b) { return {_kandn_mask16(b.bits, a.bits)}; }
inline Mask<8> and_not(Mask<8> a, Mask<8> b) { return {_kandn_mask8(b.bits, a.bits)}; }
#else
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
#endif
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
  static Floats load(Unaligned<float> p) { return _mm512_loadu_ps(reinterpret_cast<const float*>(p.bytes())); }
  void store(float* p) const { _mm512_storeu_ps(p, v); }
};
inline Floats operator+(Floats a, Floats b) { return _mm512_add_ps(a.v, b.v); }
inline Floats operator-(Floats a, Floats b) { return _mm512_sub_ps(a.v, b.v); }
inline Floats operator*(Floats a, Floats b) { return _mm512_mul_ps(a.v, b.v); }
inline Floats operator/(Floats a, Floats b) { return _mm512_div_ps(a.v, b.v); }
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
  static Doubles load(Unaligned<double> p) { return _mm512_loadu_pd(reinterpret_cast<const double*>(p.bytes())); }
  static Doubles load(Unaligned<float> p) {
    return _mm512_cvtps_pd(_mm256_loadu_ps(reinterpret_cast<const float*>(p.bytes())));
  }
  void store(double* p) const { _mm512_storeu_pd(p, v); }
};
inline Doubles operator+(Doubles a, Doubles b) { return _mm512_add_pd(a.v, b.v); }
inline Doubles operator-(Doubles a, Doubles b) { return _mm512_sub_pd(a.v, b.v); }
inline Doubles operator*(Doubles a, Doubles b) { return _mm512_mul_pd(a.v, b.v); }
inline Doubles operator/(Doubles a, Doubles b) { return _mm512_div_pd(a.v, b.v); }
inline Doubles fused_difference(Doubles a, Doubles b, Doubles c) { return _mm512_fmsub_pd(a.v, b.v, c.v); }
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
inline Doubles or_bits(Doubles a, Doubles b) { return _mm512_or_pd(a.v, b.v); }
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

// The bits of lanes, for checks of ranges and signs beside the arithmetic.
template <int Width>
struct Integers {
  __m512i v;
};
template <int W>
Integers<W> operator|(Integers<W> a, Integers<W> b) {
  return {_mm512_or_si512(a.v, b.v)};
}
template <int W>
Integers<W> operator&(Integers<W> a, Integers<W> b) {
  return {_mm512_and_si512(a.v, b.v)};
}
inline Integers<16> operator-(Integers<16> a, Integers<16> b) { return {_mm512_sub_epi32(a.v, b.v)}; }
inline Integers<8> operator-(Integers<8> a, Integers<8> b) { return {_mm512_sub_epi64(a.v, b.v)}; }
inline Integers<16> in_all_lanes(std::int32_t bits) { return {_mm512_set1_epi32(bits)}; }
inline Integers<8> in_all_lanes(std::int64_t bits) { return {_mm512_set1_epi64(bits)}; }
inline Integers<16> to_bits(Floats a) { return {_mm512_castps_si512(a.v)}; }
inline Integers<8> to_bits(Doubles a) { return {_mm512_castpd_si512(a.v)}; }
inline Floats from_bits(Integers<16> a) { return _mm512_castsi512_ps(a.v); }
inline Doubles from_bits(Integers<8> a) { return _mm512_castsi512_pd(a.v); }
inline Mask<16> is_zero(Integers<16> a) { return {_mm512_testn_epi32_mask(a.v, a.v)}; }
inline Mask<8> is_zero(Integers<8> a) { return {_mm512_testn_epi64_mask(a.v, a.v)}; }

inline Mask<16> greater_where(Mask<16> mask, Floats a, Floats b) {
  return {_mm512_mask_cmp_ps_mask(mask.bits, a.v, b.v, _CMP_GT_OQ)};
}
inline Mask<8> greater_where(Mask<8> mask, Doubles a, Doubles b) {
  return {_mm512_mask_cmp_pd_mask(mask.bits, a.v, b.v, _CMP_GT_OQ)};
}

}  // namespace
}  // namespace vesica
