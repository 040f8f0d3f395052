// SPDX-License-Identifier: Apache-2.0
/// The floating-point environments that a host may set for its whole process, and a scope that sets one.
#pragma once

#include <cfenv>
#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace environment {

struct Environment {
  const char* name;
  unsigned control;  ///< on x86, bits of MXCSR to be set; FTZ 0x8000, rounding 0x6000, DAZ 0x40
  int rounding;      ///< elsewhere, as std::fesetround() takes it
  bool traps;        ///< every exception is unmasked
};

inline constexpr Environment all_environments[] = {
    {"flush to zero", 0x8000, FE_TONEAREST, false}, {"denormals are zero", 0x0040, FE_TONEAREST, false},
    {"both", 0x8040, FE_TONEAREST, false},          {"downward", 0x2000, FE_DOWNWARD, false},
    {"upward", 0x4000, FE_UPWARD, false},           {"toward zero, both", 0xe040, FE_TOWARDZERO, false},
    {"trapping", 0x0000, FE_TONEAREST, true},
};

#if defined(__SSE2__)
using Control = unsigned;
inline Control control() { return _mm_getcsr(); }
inline void set_control(Control value) { _mm_setcsr(value); }
inline Control with(const Environment& e) { return (e.traps ? 0x0000u : 0x1f80u) | e.control; }
#else
using Control = int;
inline Control control() { return std::fegetround(); }
inline void set_control(Control rounding) { std::fesetround(rounding); }
inline Control with(const Environment& e) { return e.rounding; }
#endif

/// Calls ask() in an environment; returns whether the environment was the same afterwards. Tests compute in the
/// default one.
template <class Ask>
[[gnu::noinline]] bool ask_in(const Environment& e, Ask ask) {
  const Control before = control(), set = with(e);
  set_control(set);
  ask();
  const Control after = control();
  set_control(before);
#if defined(__SSE2__)
  constexpr Control settings = ~Control{0x3f};  // flags may be raised
  return (after & settings) == (set & settings);
#else
  return after == set;
#endif
}

}  // namespace environment
