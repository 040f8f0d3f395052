// SPDX-License-Identifier: Apache-2.0
// Lanes of WebAssembly's simd128: 4 floats or 2 doubles; a mask is a register of all-ones and all-zeros lanes.
#pragma once

#include <wasm_simd128.h>

#include <cstdint>
#include <cstring>

#include "unaligned.hpp"

namespace vesica {
namespace {  // a type of its own in each object: no instantiation may be shared with one for another instruction set

struct FloatMask {
  v128_t v;
};
inline FloatMask both(FloatMask a, FloatMask b) { return {wasm_v128_and(a.v, b.v)}; }
inline FloatMask either(FloatMask a, FloatMask b) { return {wasm_v128_or(a.v, b.v)}; }
inline FloatMask and_not(FloatMask a, FloatMask b) { return {wasm_v128_andnot(a.v, b.v)}; }
inline std::uint32_t bits(FloatMask m) { return wasm_i32x4_bitmask(m.v); }
inline bool all(FloatMask m) { return wasm_i32x4_all_true(m.v); }
inline int count(FloatMask m) { return __builtin_popcount(bits(m)); }
// One byte a lane, 1 or 0.
inline void store_bytes(FloatMask m, std::uint8_t* out) {
  const std::uint32_t bytes = (bits(m) * 0x00204081u) & 0x01010101u;
  std::memcpy(out, &bytes, 4);
}

struct Floats {
  using Element = float;
  static constexpr int width = 4;
  v128_t v;
  Floats() = default;
  Floats(v128_t x) : v(x) {}
  explicit Floats(float x) : v(wasm_f32x4_splat(x)) {}
  static Floats load(Unaligned<float> p) { return wasm_v128_load(p.bytes()); }
};
inline Floats operator+(Floats a, Floats b) { return wasm_f32x4_add(a.v, b.v); }
inline Floats operator-(Floats a, Floats b) { return wasm_f32x4_sub(a.v, b.v); }
inline Floats operator*(Floats a, Floats b) { return wasm_f32x4_mul(a.v, b.v); }
inline Floats operator-(Floats a) { return wasm_f32x4_neg(a.v); }
inline Floats abs(Floats a) { return wasm_f32x4_abs(a.v); }
// One instruction on x86-64, as max and min with their rules for NaN and zeros are not.
inline Floats max(Floats a, Floats b) { return wasm_f32x4_pmax(b.v, a.v); }
inline Floats min(Floats a, Floats b) { return wasm_f32x4_pmin(b.v, a.v); }
inline Floats positive_part(Floats a) { return max(a, Floats(0.0f)); }
inline FloatMask operator<(Floats a, Floats b) { return {wasm_f32x4_lt(a.v, b.v)}; }
inline FloatMask operator<=(Floats a, Floats b) { return {wasm_f32x4_le(a.v, b.v)}; }
inline FloatMask operator>(Floats a, Floats b) { return {wasm_f32x4_gt(a.v, b.v)}; }
inline FloatMask operator>=(Floats a, Floats b) { return {wasm_f32x4_ge(a.v, b.v)}; }
inline FloatMask operator==(Floats a, Floats b) { return {wasm_f32x4_eq(a.v, b.v)}; }
inline Floats select(FloatMask m, Floats yes, Floats no) { return wasm_v128_bitselect(yes.v, no.v, m.v); }
inline Floats flip_sign(Floats x, Floats y) { return wasm_v128_xor(x.v, wasm_v128_and(y.v, wasm_f32x4_splat(-0.0f))); }
inline Floats rough_sqrt(Floats a) { return wasm_f32x4_sqrt(a.v); }
inline Floats rough_quotient(Floats a, Floats b) { return wasm_f32x4_div(a.v, b.v); }

struct DoubleMask {
  v128_t v;
};
inline DoubleMask both(DoubleMask a, DoubleMask b) { return {wasm_v128_and(a.v, b.v)}; }
inline DoubleMask either(DoubleMask a, DoubleMask b) { return {wasm_v128_or(a.v, b.v)}; }
inline DoubleMask and_not(DoubleMask a, DoubleMask b) { return {wasm_v128_andnot(a.v, b.v)}; }
inline std::uint32_t bits(DoubleMask m) { return wasm_i64x2_bitmask(m.v); }
inline bool all(DoubleMask m) { return wasm_i64x2_all_true(m.v); }
inline int count(DoubleMask m) { return __builtin_popcount(bits(m)); }
inline void store_bytes(DoubleMask m, std::uint8_t* out) {
  out[0] = static_cast<std::uint8_t>(bits(m) & 1u);
  out[1] = static_cast<std::uint8_t>(bits(m) >> 1);
}

struct Doubles {
  using Element = double;
  static constexpr int width = 2;
  v128_t v;
  Doubles() = default;
  Doubles(v128_t x) : v(x) {}
  explicit Doubles(double x) : v(wasm_f64x2_splat(x)) {}
  static Doubles load(Unaligned<double> p) { return wasm_v128_load(p.bytes()); }
  static Doubles load(Unaligned<float> p) { return wasm_f64x2_promote_low_f32x4(wasm_v128_load64_zero(p.bytes())); }
  void store(double* p) const { wasm_v128_store(p, v); }
};
inline Doubles operator+(Doubles a, Doubles b) { return wasm_f64x2_add(a.v, b.v); }
inline Doubles operator-(Doubles a, Doubles b) { return wasm_f64x2_sub(a.v, b.v); }
inline Doubles operator*(Doubles a, Doubles b) { return wasm_f64x2_mul(a.v, b.v); }
inline Doubles operator/(Doubles a, Doubles b) { return wasm_f64x2_div(a.v, b.v); }
inline Doubles operator-(Doubles a) { return wasm_f64x2_neg(a.v); }
inline Doubles abs(Doubles a) { return wasm_f64x2_abs(a.v); }
inline Doubles max(Doubles a, Doubles b) { return wasm_f64x2_pmax(b.v, a.v); }
inline Doubles min(Doubles a, Doubles b) { return wasm_f64x2_pmin(b.v, a.v); }
inline Doubles positive_part(Doubles a) { return max(a, Doubles(0.0)); }
inline DoubleMask operator<(Doubles a, Doubles b) { return {wasm_f64x2_lt(a.v, b.v)}; }
inline DoubleMask operator<=(Doubles a, Doubles b) { return {wasm_f64x2_le(a.v, b.v)}; }
inline DoubleMask operator>(Doubles a, Doubles b) { return {wasm_f64x2_gt(a.v, b.v)}; }
inline DoubleMask operator>=(Doubles a, Doubles b) { return {wasm_f64x2_ge(a.v, b.v)}; }
inline DoubleMask operator==(Doubles a, Doubles b) { return {wasm_f64x2_eq(a.v, b.v)}; }
inline Doubles select(DoubleMask m, Doubles yes, Doubles no) { return wasm_v128_bitselect(yes.v, no.v, m.v); }
inline Doubles or_bits(Doubles a, Doubles b) { return wasm_v128_or(a.v, b.v); }
inline Doubles flip_sign(Doubles x, Doubles y) {
  return wasm_v128_xor(x.v, wasm_v128_and(y.v, wasm_f64x2_splat(-0.0)));
}
inline Doubles sqrt(Doubles a) { return wasm_f64x2_sqrt(a.v); }
inline Doubles rough_sqrt(Doubles a) { return wasm_f64x2_sqrt(a.v); }
inline Doubles rough_quotient(Doubles a, Doubles b) { return wasm_f64x2_div(a.v, b.v); }

}  // namespace
}  // namespace vesica
