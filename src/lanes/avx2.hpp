// SPDX-License-Identifier: Apache-2.0
// Lanes of AVX2 and FMA: 8 floats or 4 doubles; a mask is a register of all-ones and all-zeros lanes.
#pragma once

#include <immintrin.h>

#include <cstdint>
#include <cstring>

#include "unaligned.hpp"

namespace vesica {
namespace {  // a type of its own in each object: no instantiation may be shared with one for another instruction set

struct FloatMask {
  __m256 v;
};
inline FloatMask both(FloatMask a, FloatMask b) { return {_mm256_and_ps(a.v, b.v)}; }
inline FloatMask either(FloatMask a, FloatMask b) { return {_mm256_or_ps(a.v, b.v)}; }
inline FloatMask and_not(FloatMask a, FloatMask b) { return {_mm256_andnot_ps(b.v, a.v)}; }
inline std::uint32_t bits(FloatMask m) { return static_cast<std::uint32_t>(_mm256_movemask_ps(m.v)); }
inline bool all(FloatMask m) { return bits(m) == 0xffu; }
inline int count(FloatMask m) { return __builtin_popcount(bits(m)); }
// One byte a lane, 1 or 0.
inline void store_bytes(FloatMask m, std::uint8_t* out) {
  const std::uint64_t bytes = _pdep_u64(bits(m), 0x0101010101010101u);
  std::memcpy(out, &bytes, 8);
}

struct Floats {
  using Element = float;
  static constexpr int width = 8;
  __m256 v;
  Floats() = default;
  Floats(__m256 x) : v(x) {}
  explicit Floats(float x) : v(_mm256_set1_ps(x)) {}
  static Floats load(Unaligned<float> p) { return _mm256_loadu_ps(reinterpret_cast<const float*>(p.bytes())); }
  void store(float* p) const { _mm256_storeu_ps(p, v); }
};
inline Floats operator+(Floats a, Floats b) { return _mm256_add_ps(a.v, b.v); }
inline Floats operator-(Floats a, Floats b) { return _mm256_sub_ps(a.v, b.v); }
inline Floats operator*(Floats a, Floats b) { return _mm256_mul_ps(a.v, b.v); }
inline Floats operator/(Floats a, Floats b) { return _mm256_div_ps(a.v, b.v); }
inline Floats operator-(Floats a) { return _mm256_xor_ps(a.v, _mm256_set1_ps(-0.0f)); }
inline Floats abs(Floats a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v); }
inline Floats max(Floats a, Floats b) { return _mm256_max_ps(a.v, b.v); }
inline Floats min(Floats a, Floats b) { return _mm256_min_ps(a.v, b.v); }
inline Floats positive_part(Floats a) { return max(a, Floats(0.0f)); }
inline FloatMask operator<(Floats a, Floats b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
inline FloatMask operator<=(Floats a, Floats b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
inline FloatMask operator>(Floats a, Floats b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)}; }
inline FloatMask operator>=(Floats a, Floats b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)}; }
inline FloatMask operator==(Floats a, Floats b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_EQ_OQ)}; }
inline Floats select(FloatMask m, Floats yes, Floats no) { return _mm256_blendv_ps(no.v, yes.v, m.v); }
inline Floats flip_sign(Floats x, Floats y) { return _mm256_xor_ps(x.v, _mm256_and_ps(y.v, _mm256_set1_ps(-0.0f))); }
inline Floats rough_sqrt(Floats a) { return _mm256_sqrt_ps(a.v); }
inline Floats rough_quotient(Floats a, Floats b) { return _mm256_div_ps(a.v, b.v); }

struct DoubleMask {
  __m256d v;
};
inline DoubleMask both(DoubleMask a, DoubleMask b) { return {_mm256_and_pd(a.v, b.v)}; }
inline DoubleMask either(DoubleMask a, DoubleMask b) { return {_mm256_or_pd(a.v, b.v)}; }
inline DoubleMask and_not(DoubleMask a, DoubleMask b) { return {_mm256_andnot_pd(b.v, a.v)}; }
inline std::uint32_t bits(DoubleMask m) { return static_cast<std::uint32_t>(_mm256_movemask_pd(m.v)); }
inline bool all(DoubleMask m) { return bits(m) == 0xfu; }
inline int count(DoubleMask m) { return __builtin_popcount(bits(m)); }
inline void store_bytes(DoubleMask m, std::uint8_t* out) {
  const std::uint32_t bytes = _pdep_u32(bits(m), 0x01010101u);
  std::memcpy(out, &bytes, 4);
}

struct Doubles {
  using Element = double;
  static constexpr int width = 4;
  __m256d v;
  Doubles() = default;
  Doubles(__m256d x) : v(x) {}
  explicit Doubles(double x) : v(_mm256_set1_pd(x)) {}
  static Doubles load(Unaligned<double> p) { return _mm256_loadu_pd(reinterpret_cast<const double*>(p.bytes())); }
  static Doubles load(Unaligned<float> p) {
    return _mm256_cvtps_pd(_mm_loadu_ps(reinterpret_cast<const float*>(p.bytes())));
  }
  void store(double* p) const { _mm256_storeu_pd(p, v); }
};
inline Doubles operator+(Doubles a, Doubles b) { return _mm256_add_pd(a.v, b.v); }
inline Doubles operator-(Doubles a, Doubles b) { return _mm256_sub_pd(a.v, b.v); }
inline Doubles operator*(Doubles a, Doubles b) { return _mm256_mul_pd(a.v, b.v); }
inline Doubles operator/(Doubles a, Doubles b) { return _mm256_div_pd(a.v, b.v); }
inline Doubles fused_difference(Doubles a, Doubles b, Doubles c) { return _mm256_fmsub_pd(a.v, b.v, c.v); }
inline Doubles operator-(Doubles a) { return _mm256_xor_pd(a.v, _mm256_set1_pd(-0.0)); }
inline Doubles abs(Doubles a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v); }
inline Doubles max(Doubles a, Doubles b) { return _mm256_max_pd(a.v, b.v); }
inline Doubles min(Doubles a, Doubles b) { return _mm256_min_pd(a.v, b.v); }
inline Doubles positive_part(Doubles a) { return max(a, Doubles(0.0)); }
inline DoubleMask operator<(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)}; }
inline DoubleMask operator<=(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)}; }
inline DoubleMask operator>(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)}; }
inline DoubleMask operator>=(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GE_OQ)}; }
inline DoubleMask operator==(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)}; }
inline Doubles select(DoubleMask m, Doubles yes, Doubles no) { return _mm256_blendv_pd(no.v, yes.v, m.v); }
inline Doubles or_bits(Doubles a, Doubles b) { return _mm256_or_pd(a.v, b.v); }
inline Doubles flip_sign(Doubles x, Doubles y) { return _mm256_xor_pd(x.v, _mm256_and_pd(y.v, _mm256_set1_pd(-0.0))); }
inline Doubles sqrt(Doubles a) { return _mm256_sqrt_pd(a.v); }
inline Doubles rough_sqrt(Doubles a) { return _mm256_sqrt_pd(a.v); }
inline Doubles rough_quotient(Doubles a, Doubles b) { return _mm256_div_pd(a.v, b.v); }

// The bits of lanes, for checks of ranges and signs beside the arithmetic.
template <int Width>
struct Integers {
  __m256i v;
};
template <int W>
Integers<W> operator|(Integers<W> a, Integers<W> b) {
  return {_mm256_or_si256(a.v, b.v)};
}
template <int W>
Integers<W> operator&(Integers<W> a, Integers<W> b) {
  return {_mm256_and_si256(a.v, b.v)};
}
inline Integers<8> operator-(Integers<8> a, Integers<8> b) { return {_mm256_sub_epi32(a.v, b.v)}; }
inline Integers<4> operator-(Integers<4> a, Integers<4> b) { return {_mm256_sub_epi64(a.v, b.v)}; }
inline Integers<8> in_all_lanes(std::int32_t bits) { return {_mm256_set1_epi32(bits)}; }
inline Integers<4> in_all_lanes(std::int64_t bits) { return {_mm256_set1_epi64x(bits)}; }
inline Integers<8> to_bits(Floats a) { return {_mm256_castps_si256(a.v)}; }
inline Integers<4> to_bits(Doubles a) { return {_mm256_castpd_si256(a.v)}; }
inline Floats from_bits(Integers<8> a) { return _mm256_castsi256_ps(a.v); }
inline Doubles from_bits(Integers<4> a) { return _mm256_castsi256_pd(a.v); }
inline FloatMask is_zero(Integers<8> a) {
  return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(a.v, _mm256_setzero_si256()))};
}
inline DoubleMask is_zero(Integers<4> a) {
  return {_mm256_castsi256_pd(_mm256_cmpeq_epi64(a.v, _mm256_setzero_si256()))};
}

}  // namespace
}  // namespace vesica
