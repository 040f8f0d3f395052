// SPDX-License-Identifier: Apache-2.0
// Lanes of NEON on aarch64: 4 floats or 2 doubles; a mask is a register of all-ones and all-zeros lanes.
#pragma once

#include <arm_neon.h>

#include <cstdint>
#include <cstring>

#include "unaligned.hpp"

namespace vesica {
namespace {  // a type of its own in each object: no instantiation may be shared with one for another instruction set

struct FloatMask {
  uint32x4_t v;
};
inline FloatMask both(FloatMask a, FloatMask b) { return {vandq_u32(a.v, b.v)}; }
inline FloatMask either(FloatMask a, FloatMask b) { return {vorrq_u32(a.v, b.v)}; }
inline FloatMask and_not(FloatMask a, FloatMask b) { return {vbicq_u32(a.v, b.v)}; }
inline std::uint32_t bits(FloatMask m) {
  const uint32x4_t weights = {1, 2, 4, 8};
  return vaddvq_u32(vandq_u32(m.v, weights));
}
inline bool all(FloatMask m) { return bits(m) == 0xfu; }
inline int count(FloatMask m) { return static_cast<int>(vaddvq_u32(vshrq_n_u32(m.v, 31))); }
// One byte a lane, 1 or 0.
inline void store_bytes(FloatMask m, std::uint8_t* out) {
  const uint16x4_t halves = vmovn_u32(vshrq_n_u32(m.v, 31));
  const std::uint32_t bytes = vget_lane_u32(vreinterpret_u32_u8(vmovn_u16(vcombine_u16(halves, halves))), 0);
  std::memcpy(out, &bytes, 4);
}

struct Floats {
  using Element = float;
  static constexpr int width = 4;
  float32x4_t v;
  Floats() = default;
  Floats(float32x4_t x) : v(x) {}
  explicit Floats(float x) : v(vdupq_n_f32(x)) {}
  static Floats load(Unaligned<float> p) {
    Floats lanes;
    p.copy_to(lanes.v);
    return lanes;
  }
};
inline Floats operator+(Floats a, Floats b) { return vaddq_f32(a.v, b.v); }
inline Floats operator-(Floats a, Floats b) { return vsubq_f32(a.v, b.v); }
inline Floats operator*(Floats a, Floats b) { return vmulq_f32(a.v, b.v); }
inline Floats operator-(Floats a) { return vnegq_f32(a.v); }
inline Floats abs(Floats a) { return vabsq_f32(a.v); }
inline Floats max(Floats a, Floats b) { return vmaxq_f32(a.v, b.v); }
inline Floats min(Floats a, Floats b) { return vminq_f32(a.v, b.v); }
inline Floats positive_part(Floats a) { return max(a, Floats(0.0f)); }
inline FloatMask operator<(Floats a, Floats b) { return {vcltq_f32(a.v, b.v)}; }
inline FloatMask operator<=(Floats a, Floats b) { return {vcleq_f32(a.v, b.v)}; }
inline FloatMask operator>(Floats a, Floats b) { return {vcgtq_f32(a.v, b.v)}; }
inline FloatMask operator>=(Floats a, Floats b) { return {vcgeq_f32(a.v, b.v)}; }
inline FloatMask operator==(Floats a, Floats b) { return {vceqq_f32(a.v, b.v)}; }
inline Floats select(FloatMask m, Floats yes, Floats no) { return vbslq_f32(m.v, yes.v, no.v); }
inline Floats flip_sign(Floats x, Floats y) {
  const uint32x4_t sign = vandq_u32(vreinterpretq_u32_f32(y.v), vdupq_n_u32(0x80000000u));
  return vreinterpretq_f32_u32(veorq_u32(vreinterpretq_u32_f32(x.v), sign));
}
inline Floats rough_sqrt(Floats a) { return vsqrtq_f32(a.v); }
inline Floats rough_quotient(Floats a, Floats b) { return vdivq_f32(a.v, b.v); }

struct DoubleMask {
  uint64x2_t v;
};
inline DoubleMask both(DoubleMask a, DoubleMask b) { return {vandq_u64(a.v, b.v)}; }
inline DoubleMask either(DoubleMask a, DoubleMask b) { return {vorrq_u64(a.v, b.v)}; }
inline DoubleMask and_not(DoubleMask a, DoubleMask b) { return {vbicq_u64(a.v, b.v)}; }
inline std::uint32_t bits(DoubleMask m) {
  return static_cast<std::uint32_t>((vgetq_lane_u64(m.v, 0) & 1u) | (vgetq_lane_u64(m.v, 1) & 2u));
}
inline bool all(DoubleMask m) { return bits(m) == 3u; }
inline int count(DoubleMask m) { return static_cast<int>(vaddvq_u64(vshrq_n_u64(m.v, 63))); }
inline void store_bytes(DoubleMask m, std::uint8_t* out) {
  out[0] = static_cast<std::uint8_t>(vgetq_lane_u64(m.v, 0) & 1u);
  out[1] = static_cast<std::uint8_t>(vgetq_lane_u64(m.v, 1) & 1u);
}

struct Doubles {
  using Element = double;
  static constexpr int width = 2;
  float64x2_t v;
  Doubles() = default;
  Doubles(float64x2_t x) : v(x) {}
  explicit Doubles(double x) : v(vdupq_n_f64(x)) {}
  static Doubles load(Unaligned<double> p) {
    Doubles lanes;
    p.copy_to(lanes.v);
    return lanes;
  }
  static Doubles load(Unaligned<float> p) {
    float32x2_t narrow;
    p.copy_to(narrow);
    return vcvt_f64_f32(narrow);
  }
  void store(double* p) const { vst1q_f64(p, v); }
};
inline Doubles operator+(Doubles a, Doubles b) { return vaddq_f64(a.v, b.v); }
inline Doubles operator-(Doubles a, Doubles b) { return vsubq_f64(a.v, b.v); }
inline Doubles operator*(Doubles a, Doubles b) { return vmulq_f64(a.v, b.v); }
inline Doubles operator/(Doubles a, Doubles b) { return vdivq_f64(a.v, b.v); }
inline Doubles fused_difference(Doubles a, Doubles b, Doubles c) { return vfmaq_f64(vnegq_f64(c.v), a.v, b.v); }
inline Doubles operator-(Doubles a) { return vnegq_f64(a.v); }
inline Doubles abs(Doubles a) { return vabsq_f64(a.v); }
inline Doubles max(Doubles a, Doubles b) { return vmaxq_f64(a.v, b.v); }
inline Doubles min(Doubles a, Doubles b) { return vminq_f64(a.v, b.v); }
inline Doubles positive_part(Doubles a) { return max(a, Doubles(0.0)); }
inline DoubleMask operator<(Doubles a, Doubles b) { return {vcltq_f64(a.v, b.v)}; }
inline DoubleMask operator<=(Doubles a, Doubles b) { return {vcleq_f64(a.v, b.v)}; }
inline DoubleMask operator>(Doubles a, Doubles b) { return {vcgtq_f64(a.v, b.v)}; }
inline DoubleMask operator>=(Doubles a, Doubles b) { return {vcgeq_f64(a.v, b.v)}; }
inline DoubleMask operator==(Doubles a, Doubles b) { return {vceqq_f64(a.v, b.v)}; }
inline Doubles select(DoubleMask m, Doubles yes, Doubles no) { return vbslq_f64(m.v, yes.v, no.v); }
inline Doubles or_bits(Doubles a, Doubles b) {
  return vreinterpretq_f64_u64(vorrq_u64(vreinterpretq_u64_f64(a.v), vreinterpretq_u64_f64(b.v)));
}
inline Doubles flip_sign(Doubles x, Doubles y) {
  const uint64x2_t sign = vandq_u64(vreinterpretq_u64_f64(y.v), vdupq_n_u64(0x8000000000000000u));
  return vreinterpretq_f64_u64(veorq_u64(vreinterpretq_u64_f64(x.v), sign));
}
inline Doubles sqrt(Doubles a) { return vsqrtq_f64(a.v); }
inline Doubles rough_sqrt(Doubles a) { return vsqrtq_f64(a.v); }
inline Doubles rough_quotient(Doubles a, Doubles b) { return vdivq_f64(a.v, b.v); }

}  // namespace
}  // namespace vesica
