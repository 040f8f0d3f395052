// SPDX-License-Identifier: Apache-2.0
/// Floating-point environments that a host may have set: subnormal numbers flushed, other roundings.
#pragma once

#include <span>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace stress {

/// Bits of MXCSR beside the default ones.
struct Environment {
  const char* name;
  unsigned bits;
};

inline constexpr Environment default_environment{"default", 0};

/// Every other one that the stress test tries; none where the processor has no MXCSR.
std::span<const Environment> environments();

/// Runs call() in an environment and goes back to the default one. changed: whether call() left other control bits
/// than it met.
template <class Call>
auto run_in(const Environment& environment, bool& changed, Call call) {
#if defined(__x86_64__)
  constexpr unsigned all_but_flags = ~0x3Fu;
  const unsigned before = _mm_getcsr(), set = (before & all_but_flags) | environment.bits;
  _mm_setcsr(set);
  const auto result = call();
  changed = (_mm_getcsr() & all_but_flags) != (set & all_but_flags);
  _mm_setcsr(before);
  return result;
#else
  static_cast<void>(environment);
  changed = false;
  return call();
#endif
}

}  // namespace stress
