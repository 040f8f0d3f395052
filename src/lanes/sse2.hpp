// SPDX-License-Identifier: Apache-2.0
// Lanes of SSE2, the baseline of x86-64: 4 floats or 2 doubles; a mask is a register of all-ones and all-zeros lanes.
#pragma once

#include <emmintrin.h>

#include <cstdint>
#include <cstring>

#include "unaligned.hpp"

namespace vesica {
namespace {  // a type of its own in each object: no instantiation may be shared with one for another instruction set

struct FloatMask {
  __m128 v;
};
inline FloatMask both(FloatMask a, FloatMask b) { return {_mm_and_ps(a.v, b.v)}; }
inline FloatMask either(FloatMask a, FloatMask b) { return {_mm_or_ps(a.v, b.v)}; }
inline FloatMask and_not(FloatMask a, FloatMask b) { return {_mm_andnot_ps(b.v, a.v)}; }
inline std::uint32_t bits(FloatMask m) { return static_cast<std::uint32_t>(_mm_movemask_ps(m.v)); }
inline bool all(FloatMask m) { return bits(m) == 0xfu; }
inline int count(FloatMask m) {  // no popcnt in the baseline; sixteen cases in one constant, four bits each
  return static_cast<int>(0x4332322132212110u >> (4 * bits(m)) & 7u);
}
// One byte a lane, 1 or 0.
inline void store_bytes(FloatMask m, std::uint8_t* out) {
  const std::uint32_t bytes = (bits(m) * 0x00204081u) & 0x01010101u;
  std::memcpy(out, &bytes, 4);
}

struct Floats {
  using Element = float;
  static constexpr int width = 4;
  __m128 v;
  Floats() = default;
  Floats(__m128 x) : v(x) {}
  explicit Floats(float x) : v(_mm_set1_ps(x)) {}
  static Floats load(Unaligned<float> p) { return _mm_loadu_ps(reinterpret_cast<const float*>(p.bytes())); }
};
inline Floats operator+(Floats a, Floats b) { return _mm_add_ps(a.v, b.v); }
inline Floats operator-(Floats a, Floats b) { return _mm_sub_ps(a.v, b.v); }
inline Floats operator*(Floats a, Floats b) { return _mm_mul_ps(a.v, b.v); }
inline Floats operator-(Floats a) { return _mm_xor_ps(a.v, _mm_set1_ps(-0.0f)); }
inline Floats abs(Floats a) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), a.v); }
inline Floats max(Floats a, Floats b) { return _mm_max_ps(a.v, b.v); }
inline Floats min(Floats a, Floats b) { return _mm_min_ps(a.v, b.v); }
inline Floats positive_part(Floats a) { return max(a, Floats(0.0f)); }
inline FloatMask operator<(Floats a, Floats b) { return {_mm_cmplt_ps(a.v, b.v)}; }
inline FloatMask operator<=(Floats a, Floats b) { return {_mm_cmple_ps(a.v, b.v)}; }
inline FloatMask operator>(Floats a, Floats b) { return {_mm_cmpgt_ps(a.v, b.v)}; }
inline FloatMask operator>=(Floats a, Floats b) { return {_mm_cmpge_ps(a.v, b.v)}; }
inline FloatMask operator==(Floats a, Floats b) { return {_mm_cmpeq_ps(a.v, b.v)}; }
inline Floats select(FloatMask m, Floats yes, Floats no) {
  return _mm_or_ps(_mm_and_ps(m.v, yes.v), _mm_andnot_ps(m.v, no.v));
}
inline Floats flip_sign(Floats x, Floats y) { return _mm_xor_ps(x.v, _mm_and_ps(y.v, _mm_set1_ps(-0.0f))); }
inline Floats rough_sqrt(Floats a) { return _mm_sqrt_ps(a.v); }
inline Floats rough_quotient(Floats a, Floats b) { return _mm_div_ps(a.v, b.v); }

struct DoubleMask {
  __m128d v;
};
inline DoubleMask both(DoubleMask a, DoubleMask b) { return {_mm_and_pd(a.v, b.v)}; }
inline DoubleMask either(DoubleMask a, DoubleMask b) { return {_mm_or_pd(a.v, b.v)}; }
inline DoubleMask and_not(DoubleMask a, DoubleMask b) { return {_mm_andnot_pd(b.v, a.v)}; }
inline std::uint32_t bits(DoubleMask m) { return static_cast<std::uint32_t>(_mm_movemask_pd(m.v)); }
inline bool all(DoubleMask m) { return bits(m) == 3u; }
inline int count(DoubleMask m) { return static_cast<int>((bits(m) & 1u) + (bits(m) >> 1)); }
inline void store_bytes(DoubleMask m, std::uint8_t* out) {
  out[0] = static_cast<std::uint8_t>(bits(m) & 1u);
  out[1] = static_cast<std::uint8_t>(bits(m) >> 1);
}

struct Doubles {
  using Element = double;
  static constexpr int width = 2;
  __m128d v;
  Doubles() = default;
  Doubles(__m128d x) : v(x) {}
  explicit Doubles(double x) : v(_mm_set1_pd(x)) {}
  static Doubles load(Unaligned<double> p) { return _mm_loadu_pd(reinterpret_cast<const double*>(p.bytes())); }
  static Doubles load(Unaligned<float> p) {
    return _mm_cvtps_pd(_mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p.bytes()))));
  }
  void store(double* p) const { _mm_storeu_pd(p, v); }
};
inline Doubles operator+(Doubles a, Doubles b) { return _mm_add_pd(a.v, b.v); }
inline Doubles operator-(Doubles a, Doubles b) { return _mm_sub_pd(a.v, b.v); }
inline Doubles operator*(Doubles a, Doubles b) { return _mm_mul_pd(a.v, b.v); }
inline Doubles operator/(Doubles a, Doubles b) { return _mm_div_pd(a.v, b.v); }
inline Doubles operator-(Doubles a) { return _mm_xor_pd(a.v, _mm_set1_pd(-0.0)); }
inline Doubles abs(Doubles a) { return _mm_andnot_pd(_mm_set1_pd(-0.0), a.v); }
inline Doubles max(Doubles a, Doubles b) { return _mm_max_pd(a.v, b.v); }
inline Doubles min(Doubles a, Doubles b) { return _mm_min_pd(a.v, b.v); }
inline Doubles positive_part(Doubles a) { return max(a, Doubles(0.0)); }
inline DoubleMask operator<(Doubles a, Doubles b) { return {_mm_cmplt_pd(a.v, b.v)}; }
inline DoubleMask operator<=(Doubles a, Doubles b) { return {_mm_cmple_pd(a.v, b.v)}; }
inline DoubleMask operator>(Doubles a, Doubles b) { return {_mm_cmpgt_pd(a.v, b.v)}; }
inline DoubleMask operator>=(Doubles a, Doubles b) { return {_mm_cmpge_pd(a.v, b.v)}; }
inline DoubleMask operator==(Doubles a, Doubles b) { return {_mm_cmpeq_pd(a.v, b.v)}; }
inline Doubles select(DoubleMask m, Doubles yes, Doubles no) {
  return _mm_or_pd(_mm_and_pd(m.v, yes.v), _mm_andnot_pd(m.v, no.v));
}
inline Doubles or_bits(Doubles a, Doubles b) { return _mm_or_pd(a.v, b.v); }
inline Doubles flip_sign(Doubles x, Doubles y) { return _mm_xor_pd(x.v, _mm_and_pd(y.v, _mm_set1_pd(-0.0))); }
inline Doubles sqrt(Doubles a) { return _mm_sqrt_pd(a.v); }
inline Doubles rough_sqrt(Doubles a) { return _mm_sqrt_pd(a.v); }
inline Doubles rough_quotient(Doubles a, Doubles b) { return _mm_div_pd(a.v, b.v); }

}  // namespace
}  // namespace vesica
