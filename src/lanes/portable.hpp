// SPDX-License-Identifier: Apache-2.0
// One lane, of the scalar arithmetic of the core: for processors without vectors that the library knows.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vesica/scalar.hpp>

#include "unaligned.hpp"

namespace vesica {
namespace {  // a type of its own in each object: no instantiation may be shared with one for another instruction set

struct LaneMask {
  bool v;
};
inline LaneMask both(LaneMask a, LaneMask b) { return {lane::both(a.v, b.v)}; }
inline LaneMask either(LaneMask a, LaneMask b) { return {lane::either(a.v, b.v)}; }
inline LaneMask and_not(LaneMask a, LaneMask b) { return {lane::and_not(a.v, b.v)}; }
inline std::uint32_t bits(LaneMask m) { return m.v; }
inline bool all(LaneMask m) { return m.v; }
inline int count(LaneMask m) { return m.v; }
inline void store_bytes(LaneMask m, std::uint8_t* out) { *out = m.v; }

template <class T>
struct One {
  using Element = T;
  static constexpr int width = 1;
  T v;
  One() = default;
  explicit One(T x) : v(x) {}
  static One load(Unaligned<T> p) { return One(p[0]); }
  static One load(Unaligned<float> p) requires(!std::is_same_v<T, float>) { return One(T{p[0]}); }
  void store(T* p) const { __builtin_memcpy(p, &v, sizeof v); }
  friend One operator+(One a, One b) { return One(a.v + b.v); }
  friend One operator-(One a, One b) { return One(a.v - b.v); }
  friend One operator*(One a, One b) { return One(a.v * b.v); }
  friend One operator/(One a, One b) { return One(a.v / b.v); }
#if defined(VESICA_HAS_FUSED)
  friend One fused_difference(One a, One b, One c) { return One(lane::fused_difference(a.v, b.v, c.v)); }
#endif
  friend One operator-(One a) { return One(-a.v); }
  friend LaneMask operator<(One a, One b) { return {a.v < b.v}; }
  friend LaneMask operator<=(One a, One b) { return {a.v <= b.v}; }
  friend LaneMask operator>(One a, One b) { return {a.v > b.v}; }
  friend LaneMask operator>=(One a, One b) { return {a.v >= b.v}; }
  friend LaneMask operator==(One a, One b) { return {a.v == b.v}; }
  friend One abs(One a) { return One(lane::abs(a.v)); }
  friend One max(One a, One b) { return One(lane::max(a.v, b.v)); }
  friend One min(One a, One b) { return One(lane::min(a.v, b.v)); }
  friend One positive_part(One a) { return One(lane::positive_part(a.v)); }
  friend One select(LaneMask m, One yes, One no) { return m.v ? yes : no; }
  friend One flip_sign(One x, One y) { return One(lane::flip_sign(x.v, y.v)); }
  friend One or_bits(One a, One b) { return One(lane::or_bits(a.v, b.v)); }
  friend One sqrt(One a) { return One(lane::sqrt(a.v)); }
  friend One rough_sqrt(One a) { return One(lane::rough_sqrt(a.v)); }
  friend One rough_quotient(One a, One b) { return One(lane::rough_quotient(a.v, b.v)); }
};
using Floats = One<float>;
using Doubles = One<double>;

}  // namespace
}  // namespace vesica
