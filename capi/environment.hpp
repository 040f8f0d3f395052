// SPDX-License-Identifier: Apache-2.0
// The floating-point environment a call is made in. A host may have set flush-to-zero, denormals-are-zero, a directed
// rounding or trapping exceptions for its whole process; each of them would change answers. So every function reads
// the control register, and if it is not the default, sets the default for its own duration. Overlap of two shapes runs
// its filter first, whose bounds hold in any rounding mode: to read the register takes 5 ns on Zen 5, and a point and a
// rectangle 4 ns.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#if defined(__SSE2__)
#include <xmmintrin.h>
#elif defined(__aarch64__) || defined(__arm__) || defined(__wasm__)
#else
#include <cfenv>
#endif

namespace vesica::capi {

#if defined(__SSE2__)

/// MXCSR. Bits 0 to 5 are flags that operations raise; the rest says how operations are done.
using FloatControl = std::uint32_t;
inline FloatControl float_control() noexcept { return _mm_getcsr(); }
inline void set_float_control(FloatControl control) noexcept { _mm_setcsr(control); }
inline constexpr FloatControl default_control = 0x1f80, control_settings = 0xffc0;

#elif defined(__aarch64__)

/// FPCR. All of it says how operations are done; flags are elsewhere.
using FloatControl = std::uint64_t;
inline FloatControl float_control() noexcept {
  FloatControl control;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  return control;
}
inline void set_float_control(FloatControl control) noexcept {
  asm volatile("msr fpcr, %0" : : "r"(control) : "memory");
}
inline constexpr FloatControl default_control = 0, control_settings = ~FloatControl{0};

#elif defined(__arm__)

/// FPSCR. Its low byte and its top five bits are flags; the rest says how operations are done.
using FloatControl = std::uint32_t;
inline FloatControl float_control() noexcept {
  FloatControl control;
  asm volatile("vmrs %0, fpscr" : "=r"(control));
  return control;
}
inline void set_float_control(FloatControl control) noexcept {
  asm volatile("vmsr fpscr, %0" : : "r"(control) : "memory");
}
inline constexpr FloatControl default_control = 0, control_settings = 0x07ffff00;

#elif defined(__wasm__)

/// WebAssembly has one environment.
using FloatControl = int;
inline FloatControl float_control() noexcept { return 0; }
inline void set_float_control(FloatControl) noexcept {}
inline constexpr FloatControl default_control = 0, control_settings = 0;

#else

/// Elsewhere the C library knows the rounding; the processors this was tried on (s390x, ppc64le, riscv64) flush no
/// subnormals.
using FloatControl = int;
inline FloatControl float_control() noexcept { return std::fegetround(); }
inline void set_float_control(FloatControl rounding) noexcept { std::fesetround(rounding); }
inline constexpr FloatControl default_control = FE_TONEAREST, control_settings = ~0;

#endif

/// True if subnormal operands and results are kept, as a sum shows: if they are flushed, it
/// is 0. Products of subnormals are slow on some processors.
inline bool keeps_subnormals() noexcept {
#if defined(__SSE2__) || defined(__aarch64__) || defined(__arm__)
  double least = 0x1p-1074;
#if defined(__SSE2__)
  asm("" : "+x"(least));  // or the compiler would compute the sum
#else
  asm("" : "+w"(least));
#endif
  return std::bit_cast<std::uint64_t>(least + least) != 0;
#else
  return true;
#endif
}

inline bool in_default_environment() noexcept {
  return (float_control() & control_settings) == (default_control & control_settings);
}

/// function(arguments...) in the default environment; the caller's is in force again afterwards, its flags as they
/// were. The compiler is kept from seeing which function it calls: it could otherwise move its operations out of the
/// environment that they need.
template <class Result, class... Parameters>
[[gnu::noinline, gnu::cold]] Result call_in_default_environment(
    Result (*function)(Parameters...), std::type_identity_t<Parameters>... arguments) noexcept {
  const FloatControl of_caller = float_control();
  set_float_control(default_control);
  asm volatile("" : "+r"(function) : : "memory");
  const Result result = function(arguments...);
  asm volatile("" : : : "memory");
  set_float_control(of_caller);
  return result;
}

}  // namespace vesica::capi

/// The first statement of each function of the C interface that computes: in another environment than the default the
/// function calls itself again in the default one.
#define VESICA_DEFAULT_ENVIRONMENT(function, ...)           \
  if (!vesica::capi::in_default_environment()) [[unlikely]] \
  return vesica::capi::call_in_default_environment(function, __VA_ARGS__)
