// SPDX-License-Identifier: Apache-2.0
// A double whose operations round to nearest and raise no exception, whatever the control register says: instructions
// of AVX-512 can hold their rounding themselves, and suppress exceptions (tests/batch/steady.sh looks that all do). Two
// bits of the register are left that change results, flush-to-zero and denormals-are-zero. keeps_subnormals() finds out
// about them by an operation; to read the register takes 5 ns on Zen 4, and waits for all operations before.
#pragma once

#include <immintrin.h>

#include <cstdint>
#include <vesica/scalar.hpp>

namespace vesica {
namespace {  // a type of its own in each object: no instantiation may be shared with one for another instruction set

inline constexpr int to_nearest = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;

/// The result of a comparison: a register of one bit, which is cheaper to combine than a processor's flags.
struct Bit {
  __mmask8 k;
  Bit() = default;
  Bit(__mmask8 bits) : k(bits) {}
  constexpr explicit Bit(bool b) : k(b) {}
  explicit operator bool() const { return k != 0; }
  explicit operator std::int32_t() const { return static_cast<std::int32_t>(_cvtmask8_u32(k)); }
};
inline Bit both(Bit a, Bit b) { return _kand_mask8(a.k, b.k); }
inline Bit either(Bit a, Bit b) { return _kor_mask8(a.k, b.k); }

struct Steady {
  using Element = double;
  __m128d v;
  Steady() = default;
  Steady(__m128d x) : v(x) {}
  constexpr explicit Steady(double x) : v{x, 0} {}
  static Steady load(const double& x) { return _mm_load_sd(&x); }
  static Steady load(const float& x) {
    return _mm_cvt_roundss_sd(_mm_setzero_pd(), _mm_load_ss(&x), _MM_FROUND_NO_EXC);
  }
};
/// A product that is not rounded yet: in a sum it is fused. Lanes of AVX-512 fuse too, and what filters decide is
/// certain either way.
struct Product {
  __m128d x, y;
  operator Steady() const { return _mm_mul_round_sd(x, y, to_nearest); }
};
inline Product operator*(Steady a, Steady b) { return {a.v, b.v}; }
inline Steady operator+(Steady a, Steady b) { return _mm_add_round_sd(a.v, b.v, to_nearest); }
inline Steady operator-(Steady a, Steady b) { return _mm_sub_round_sd(a.v, b.v, to_nearest); }
inline Steady operator+(Product p, Steady a) { return _mm_fmadd_round_sd(p.x, p.y, a.v, to_nearest); }
inline Steady operator-(Product p, Steady a) { return _mm_fmsub_round_sd(p.x, p.y, a.v, to_nearest); }
inline Steady operator+(Steady a, Product p) { return p + a; }
inline Steady operator-(Steady a, Product p) { return _mm_fnmadd_round_sd(p.x, p.y, a.v, to_nearest); }
inline Steady operator+(Product p, Product q) { return p + Steady(q); }
inline Steady operator-(Product p, Product q) { return p - Steady(q); }
inline Steady operator/(Steady a, Steady b) { return _mm_div_round_sd(a.v, b.v, to_nearest); }
inline Steady operator-(Steady a) { return _mm_xor_pd(a.v, _mm_set1_pd(-0.0)); }
inline Steady abs(Steady a) { return _mm_andnot_pd(_mm_set1_pd(-0.0), a.v); }
inline Steady max(Steady a, Steady b) { return _mm_max_round_sd(a.v, b.v, _MM_FROUND_NO_EXC); }
inline Steady min(Steady a, Steady b) { return _mm_min_round_sd(a.v, b.v, _MM_FROUND_NO_EXC); }
inline Steady positive_part(Steady a) { return max(a, Steady(0.0)); }
inline Steady sqrt(Steady a) { return _mm_sqrt_round_sd(a.v, a.v, to_nearest); }
inline Steady rough_sqrt(Steady a) { return sqrt(a); }
inline Steady rough_quotient(Steady a, Steady b) { return a / b; }
template <int predicate>
inline Bit compare(Steady a, Steady b) {
  return _mm_cmp_round_sd_mask(a.v, b.v, predicate, _MM_FROUND_NO_EXC);
}
inline Bit operator<(Steady a, Steady b) { return compare<_CMP_LT_OQ>(a, b); }
inline Bit operator<=(Steady a, Steady b) { return compare<_CMP_LE_OQ>(a, b); }
inline Bit operator>(Steady a, Steady b) { return compare<_CMP_GT_OQ>(a, b); }
inline Bit operator>=(Steady a, Steady b) { return compare<_CMP_GE_OQ>(a, b); }
inline Steady select(Bit m, Steady yes, Steady no) { return _mm_mask_move_sd(no.v, m.k, no.v, yes.v); }
inline Steady flip_sign(Steady x, Steady y) { return _mm_xor_pd(x.v, _mm_and_pd(y.v, _mm_set1_pd(-0.0))); }

/// True if subnormal operands and results are what they are: with denormals-are-zero this sum is 0 + 0, and with
/// flush-to-zero it is 0. A sum, since products of subnormals are slow on some processors.
inline bool keeps_subnormals() {
  Steady least(0x1p-1074);
  asm("" : "+x"(least.v));  // or the compiler would compute it
  return _mm_cvtsi128_si64(_mm_castpd_si128((least + least).v)) != 0;
}

// The bits of a number, for checks of ranges and signs beside the arithmetic.
struct Integer {
  __m128i v;
};
inline Integer operator|(Integer a, Integer b) { return {_mm_or_si128(a.v, b.v)}; }
inline Integer operator&(Integer a, Integer b) { return {_mm_and_si128(a.v, b.v)}; }
inline Integer operator-(Integer a, Integer b) { return {_mm_sub_epi64(a.v, b.v)}; }
inline Integer in_all_lanes(std::int64_t bits) { return {_mm_set_epi64x(0, bits)}; }
inline Integer to_bits(Steady a) { return {_mm_castpd_si128(a.v)}; }
inline Steady from_bits(Integer a) { return _mm_castsi128_pd(a.v); }
inline Bit is_zero(Integer a) { return _mm_mask_testn_epi64_mask(1, a.v, a.v); }
inline Bit greater_where(Bit mask, Steady a, Steady b) {
  return _mm_mask_cmp_round_sd_mask(mask.k, a.v, b.v, _CMP_GT_OQ, _MM_FROUND_NO_EXC);
}

}  // namespace
}  // namespace vesica
