// SPDX-License-Identifier: Apache-2.0
/// The arithmetic the filters are written in, for double and float; batch kernels supply the same names for lanes
/// of a vector. A filter is one template over such a type, so scalar and batch code cannot drift apart.
#pragma once

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vesica/square_root.hpp>

// Error bounds and checks for NaN hold only in IEEE arithmetic. So flags that change it are an error, if the compiler
// defines a macro for them. Clang has none for reassociation, reciprocals and signed zeros: pragmas turn these off for
// the rest of the source.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "Vesica needs IEEE arithmetic: compile without -ffast-math, -Ofast and the flags that these stand for."
#endif
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas"  // on targets without it
#pragma float_control(precise, on)
#pragma clang diagnostic pop
#pragma clang fp reassociate(off) contract(off)
#endif
#if FLT_EVAL_METHOD != 0
#error "Vesica needs arithmetic in the operands' own precision: on 32-bit x86 compile with -msse2 -mfpmath=sse."
#endif

/// A filter is one expression spread over several functions, which must be inlined: a call in the middle would cost as
/// much as the whole filter (VESICA_INLINE). Code for undecided pairs is kept out of the hot code (VESICA_COLD). Long
/// functions with several callers are not inlined: a call costs less than a copy.
#if defined(__GNUC__)
#ifndef VESICA_INLINE  // src/kernels/flatten.hpp has another for the library's kernels
#define VESICA_INLINE [[gnu::always_inline]] inline
#endif
#define VESICA_COLD [[gnu::noinline, gnu::cold]]
#define VESICA_CALLED [[gnu::noinline]]
#else
#define VESICA_INLINE inline
#define VESICA_COLD
#define VESICA_CALLED
#endif

/// Code that is constexpr runs on a GPU too (docs/cuda.md). This marks the few functions of the filters that cannot be.
#if defined(__CUDACC__)
#define VESICA_DEVICE __host__ __device__
#else
#define VESICA_DEVICE
#endif

namespace vesica {

/// Constants of a scalar type that error bounds are made of.
template <class T>
struct ScalarTraits;

template <>
struct ScalarTraits<double> {
  /// Half a unit in the last place of 1: the largest relative error of one rounding.
  static constexpr double roundoff = 0x1p-53;
  /// 2^e for an e within the normal range.
  static consteval double power(int e) noexcept {
    double p = 1;
    for (; e > 0; --e) p *= 2;
    for (; e < 0; ++e) p /= 2;
    return p;
  }
  /// The exponent range in units of float's. Guards are 2^(range * e) with e chosen for float.
  static constexpr int range = 8;
};
template <>
struct ScalarTraits<float> {
  static constexpr float roundoff = 0x1p-24f;
  static consteval float power(int e) noexcept { return static_cast<float>(ScalarTraits<double>::power(e)); }
  static constexpr int range = 1;
};

namespace lane {

// max and min as SSE has them: NaN in either argument yields the second. Filters do not rely on it, since NaN reaches
// their bounds by addition; but src/kernels/unit_contact_cubic.hpp does, and says so.
constexpr double max(double a, double b) noexcept { return a > b ? a : b; }
constexpr double min(double a, double b) noexcept { return a < b ? a : b; }
constexpr float max(float a, float b) noexcept { return a > b ? a : b; }
constexpr float min(float a, float b) noexcept { return a < b ? a : b; }
// In constant expressions the C library's functions are not to be had.
constexpr double abs(double a) noexcept {
  if (std::is_constant_evaluated()) return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) << 1 >> 1);
  return std::fabs(a);
}
constexpr float abs(float a) noexcept {
  if (std::is_constant_evaluated()) return std::bit_cast<float>(std::bit_cast<std::uint32_t>(a) << 1 >> 1);
  return std::fabs(a);
}

// Correctly rounded, for results rather than filters.
constexpr double sqrt(double a) noexcept {
  if (std::is_constant_evaluated()) return detail::square_root(a);
  return std::sqrt(a);
}
constexpr float sqrt(float a) noexcept {
  if (std::is_constant_evaluated()) return detail::square_root(a);
  return std::sqrt(a);
}

// Within 2^-13 (float) or 2^-26 (double) of the true value, which is all their callers need; lanes may be that rough.
constexpr double rough_sqrt(double a) noexcept { return sqrt(a); }
constexpr float rough_sqrt(float a) noexcept { return sqrt(a); }
constexpr double rough_quotient(double a, double b) noexcept { return a / b; }
constexpr float rough_quotient(float a, float b) noexcept { return a / b; }

// Masks without short circuits: on fresh data a branch costs more than the work it saves.
constexpr bool both(bool a, bool b) noexcept { return static_cast<bool>(static_cast<int>(a) & static_cast<int>(b)); }
constexpr bool either(bool a, bool b) noexcept { return static_cast<bool>(static_cast<int>(a) | static_cast<int>(b)); }
constexpr bool and_not(bool a, bool b) noexcept { return both(a, !b); }

// By bit masks: a compiler may turn a ternary into a branch, which is mispredicted on fresh data.
constexpr double select(bool m, double yes, double no) noexcept {
  const std::uint64_t mask = std::uint64_t{0} - static_cast<std::uint64_t>(m);
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(yes) & mask) | (std::bit_cast<std::uint64_t>(no) & ~mask));
}
constexpr float select(bool m, float yes, float no) noexcept {
  const std::uint32_t mask = std::uint32_t{0} - static_cast<std::uint32_t>(m);
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(yes) & mask) | (std::bit_cast<std::uint32_t>(no) & ~mask));
}

/// max(x, 0); exact. Lanes may turn NaN into 0.
constexpr double positive_part(double x) noexcept { return 0.5 * (x + abs(x)); }
constexpr float positive_part(float x) noexcept { return 0.5f * (x + abs(x)); }

/// x, or -x where the sign bit of y is set.
constexpr double flip_sign(double x, double y) noexcept {
  const std::uint64_t sign = std::bit_cast<std::uint64_t>(y) & 0x8000000000000000u;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ sign);
}
constexpr float flip_sign(float x, float y) noexcept {
  const std::uint32_t sign = std::bit_cast<std::uint32_t>(y) & 0x80000000u;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) ^ sign);
}

/// The bits set in either: 0, of any sign, where both are.
constexpr double or_bits(double a, double b) noexcept {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) | std::bit_cast<std::uint64_t>(b));
}

#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(__CUDA_ARCH__)
#define VESICA_HAS_FUSED 1
/// a b - c, rounded once; only where it is one instruction.
VESICA_DEVICE inline double fused_difference(double a, double b, double c) noexcept { return std::fma(a, b, -c); }
#endif

}  // namespace lane

namespace detail {

/// The lesser and the greater of finite numbers, the first of two that are equal: of zeros too, whose sign fmin and
/// fmax leave open.
template <class T>
constexpr T lesser(T a, T b) noexcept {
  return b < a ? b : a;
}
template <class T>
constexpr T greater(T a, T b) noexcept {
  return a < b ? b : a;
}

constexpr bool has_finite_bits(double x) noexcept { return (std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) != 0x7ff; }

/// True if all numbers are finite, scalars or lanes: x - x is 0 for a finite x and NaN for any other, and NaN survives
/// the sum. In constant expressions, the bits are tested.
template <class V, class... W>
VESICA_INLINE constexpr auto all_finite(V first, W... rest) noexcept {
  if constexpr (std::is_arithmetic_v<V>) {
    if (std::is_constant_evaluated())
      return has_finite_bits(static_cast<double>(first)) && (has_finite_bits(static_cast<double>(rest)) && ...);
  }
  return ((first - first) + ... + (rest - rest)) == V(0.0f);
}

}  // namespace detail
}  // namespace vesica
