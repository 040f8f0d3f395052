// SPDX-License-Identifier: Apache-2.0
/// Two doubles in one register. The filter of one pair of shapes often computes the same for both shapes, or along two
/// axes. With this type for its numbers each operation does both.
#pragma once

#include <bit>
#include <cstdint>
#include <vesica/scalar.hpp>

// Compilers without vector types compute the two one after the other, and so does WebAssembly: for it Clang 14 takes
// minutes for what it compiles in seconds without them.
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__wasm__)
#define VESICA_HAS_TWO_DOUBLES 1
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace vesica::lane {

struct TwoDoubles {
  using Element = double;
  using Numbers [[gnu::vector_size(16)]] = double;
  using Bits [[gnu::vector_size(16)]] = long long;
  /// All bits of a number are set where the mask holds.
  struct Mask {
    Numbers v;
  };
  Numbers v;

  VESICA_INLINE TwoDoubles(Numbers numbers) noexcept : v(numbers) {}
  VESICA_INLINE explicit TwoDoubles(double both) noexcept : v{both, both} {}
  VESICA_INLINE explicit TwoDoubles(float both) noexcept : TwoDoubles(static_cast<double>(both)) {}
  VESICA_INLINE TwoDoubles(double first, double second) noexcept : v{first, second} {}
  VESICA_INLINE double first() const noexcept { return v[0]; }
  VESICA_INLINE double second() const noexcept { return v[1]; }
};

VESICA_INLINE TwoDoubles::Bits bits(TwoDoubles a) noexcept { return reinterpret_cast<TwoDoubles::Bits>(a.v); }
VESICA_INLINE TwoDoubles::Bits bits(TwoDoubles::Mask m) noexcept { return reinterpret_cast<TwoDoubles::Bits>(m.v); }
VESICA_INLINE TwoDoubles::Numbers numbers(TwoDoubles::Bits b) noexcept {
  return reinterpret_cast<TwoDoubles::Numbers>(b);
}

VESICA_INLINE TwoDoubles operator+(TwoDoubles a, TwoDoubles b) noexcept { return a.v + b.v; }
VESICA_INLINE TwoDoubles operator-(TwoDoubles a, TwoDoubles b) noexcept { return a.v - b.v; }
VESICA_INLINE TwoDoubles operator*(TwoDoubles a, TwoDoubles b) noexcept { return a.v * b.v; }

// min(NaN, x) and max(NaN, x) are x, as for scalars.
#if defined(__SSE2__)
// Without intrinsics g++ 12 takes masks and shuffled numbers apart, and puts them together again.
VESICA_INLINE TwoDoubles max(TwoDoubles a, TwoDoubles b) noexcept { return _mm_max_pd(a.v, b.v); }
VESICA_INLINE TwoDoubles min(TwoDoubles a, TwoDoubles b) noexcept { return _mm_min_pd(a.v, b.v); }
VESICA_INLINE TwoDoubles::Mask operator<(TwoDoubles a, TwoDoubles b) noexcept { return {_mm_cmplt_pd(a.v, b.v)}; }
VESICA_INLINE TwoDoubles::Mask operator<=(TwoDoubles a, TwoDoubles b) noexcept { return {_mm_cmple_pd(a.v, b.v)}; }
VESICA_INLINE TwoDoubles::Mask operator==(TwoDoubles a, TwoDoubles b) noexcept { return {_mm_cmpeq_pd(a.v, b.v)}; }
VESICA_INLINE TwoDoubles::Mask both(TwoDoubles::Mask a, TwoDoubles::Mask b) noexcept { return {_mm_and_pd(a.v, b.v)}; }
VESICA_INLINE TwoDoubles::Mask either(TwoDoubles::Mask a, TwoDoubles::Mask b) noexcept { return {_mm_or_pd(a.v, b.v)}; }
/// The first numbers of a and b, and the second ones.
VESICA_INLINE TwoDoubles firsts(TwoDoubles a, TwoDoubles b) noexcept { return _mm_unpacklo_pd(a.v, b.v); }
VESICA_INLINE TwoDoubles seconds(TwoDoubles a, TwoDoubles b) noexcept { return _mm_unpackhi_pd(a.v, b.v); }
/// Bit 0 of the first number, bit 1 of the second: the signs.
VESICA_INLINE int signs(TwoDoubles a) noexcept { return _mm_movemask_pd(a.v); }
#else
VESICA_INLINE TwoDoubles max(TwoDoubles a, TwoDoubles b) noexcept { return a.v > b.v ? a.v : b.v; }
VESICA_INLINE TwoDoubles min(TwoDoubles a, TwoDoubles b) noexcept { return a.v < b.v ? a.v : b.v; }
VESICA_INLINE TwoDoubles::Mask operator<(TwoDoubles a, TwoDoubles b) noexcept { return {numbers(a.v < b.v)}; }
VESICA_INLINE TwoDoubles::Mask operator<=(TwoDoubles a, TwoDoubles b) noexcept { return {numbers(a.v <= b.v)}; }
VESICA_INLINE TwoDoubles::Mask operator==(TwoDoubles a, TwoDoubles b) noexcept { return {numbers(a.v == b.v)}; }
VESICA_INLINE TwoDoubles::Mask both(TwoDoubles::Mask a, TwoDoubles::Mask b) noexcept {
  return {numbers(bits(a) & bits(b))};
}
VESICA_INLINE TwoDoubles::Mask either(TwoDoubles::Mask a, TwoDoubles::Mask b) noexcept {
  return {numbers(bits(a) | bits(b))};
}
VESICA_INLINE TwoDoubles firsts(TwoDoubles a, TwoDoubles b) noexcept { return {a.first(), b.first()}; }
VESICA_INLINE TwoDoubles seconds(TwoDoubles a, TwoDoubles b) noexcept { return {a.second(), b.second()}; }
VESICA_INLINE int signs(TwoDoubles a) noexcept {
  return static_cast<int>(std::bit_cast<std::uint64_t>(a.first()) >> 63) |
         static_cast<int>(std::bit_cast<std::uint64_t>(a.second()) >> 63) << 1;
}
#endif
VESICA_INLINE TwoDoubles::Mask operator>=(TwoDoubles a, TwoDoubles b) noexcept { return b <= a; }

VESICA_INLINE TwoDoubles exchanged(TwoDoubles a) noexcept { return {a.second(), a.first()}; }
VESICA_INLINE double sum(TwoDoubles a) noexcept { return a.first() + a.second(); }
/// The sum of a's numbers, and the sum of b's.
VESICA_INLINE TwoDoubles sums(TwoDoubles a, TwoDoubles b) noexcept { return firsts(a, b) + seconds(a, b); }

VESICA_INLINE TwoDoubles abs(TwoDoubles a) noexcept {
  return numbers(bits(a) & TwoDoubles::Bits{INT64_MAX, INT64_MAX});
}
VESICA_INLINE TwoDoubles positive_part(TwoDoubles a) noexcept { return max(a, TwoDoubles(0.0)); }
/// x, or -x where the sign bit of y is set.
VESICA_INLINE TwoDoubles flip_sign(TwoDoubles x, TwoDoubles y) noexcept {
  return numbers(bits(x) ^ (bits(y) & TwoDoubles::Bits{INT64_MIN, INT64_MIN}));
}
VESICA_INLINE TwoDoubles or_bits(TwoDoubles a, TwoDoubles b) noexcept { return numbers(bits(a) | bits(b)); }

VESICA_INLINE TwoDoubles select(TwoDoubles::Mask m, TwoDoubles yes, TwoDoubles no) noexcept {
  return numbers((bits(yes) & bits(m)) | (bits(no) & ~bits(m)));
}
VESICA_INLINE bool in_both(TwoDoubles::Mask m) noexcept { return signs(m.v) == 3; }
/// The mask holds for both numbers, and both are positive, by their signs.
VESICA_INLINE bool in_both_and_positive(TwoDoubles::Mask m, TwoDoubles a) noexcept {
  return signs(numbers(bits(m) & ~bits(a))) == 3;
}

}  // namespace vesica::lane
#endif
