// SPDX-License-Identifier: Apache-2.0
/// Magnitudes as limbs: sums, differences, products.
#pragma once

#include <cassert>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace vesica::exact {

/// Limbs are 64 bits: value = sum of limb[i] * 2^(64 (low + i)).
using Limb = std::uint64_t;

namespace detail {

struct LimbPair {
  Limb low, high;
};

/// Moves n limbs, in place only downwards.
constexpr void move_limbs(const Limb* from, int n, Limb* to) noexcept {
  if (std::is_constant_evaluated()) {
    for (int i = 0; i < n; ++i) to[i] = from[i];
  } else {
    std::memmove(to, from, static_cast<std::size_t>(n) * sizeof(Limb));
  }
}

/// a * b + c + d, which cannot overflow two limbs.
constexpr LimbPair multiply_add(Limb a, Limb b, Limb c, Limb d) noexcept {
#if defined(__SIZEOF_INT128__)
  __extension__ using Wide = unsigned __int128;
  const Wide sum = Wide{a} * b + c + d;
  return {static_cast<Limb>(sum), static_cast<Limb>(sum >> 64)};
#else
  constexpr Limb half = 0xffffffffu;
  const Limb low_low = (a & half) * (b & half), low_high = (a & half) * (b >> 32);
  const Limb high_low = (a >> 32) * (b & half), high_high = (a >> 32) * (b >> 32);
  const Limb middle = (low_low >> 32) + (low_high & half) + (high_low & half);
  LimbPair sum{(middle << 32) | (low_low & half), high_high + (low_high >> 32) + (high_low >> 32) + (middle >> 32)};
  sum.low += c;
  sum.high += sum.low < c;
  sum.low += d;
  sum.high += sum.low < d;
  return sum;
#endif
}

/// a + b + carry, the latter 0 or 1. Of sums one after the other it stays in the processor's flag where it has one.
constexpr LimbPair add_limbs(Limb a, Limb b, Limb carry) noexcept {
#if defined(__x86_64__) && !defined(__CUDA_ARCH__)
  if (!std::is_constant_evaluated()) {
    unsigned long long sum = 0;
    const unsigned char carried = __builtin_ia32_addcarryx_u64(static_cast<unsigned char>(carry), a, b, &sum);
    return {sum, carried};
  }
#endif
  return multiply_add(1, a, b, carry);
}
/// a - b - borrow; `high` is what is borrowed from the limb above.
constexpr LimbPair subtract_limbs(Limb a, Limb b, Limb borrow) noexcept {
  const LimbPair sum = add_limbs(~a, b, borrow);
  return {~sum.low, sum.high};
}

/// out[0, 4) += a[0, 4) + carry; returns what is carried out of it.
constexpr Limb add_four(const Limb* a, Limb carry, Limb* out) noexcept {
  const LimbPair s = add_limbs(out[0], a[0], carry), t = add_limbs(out[1], a[1], s.high);
  const LimbPair u = add_limbs(out[2], a[2], t.high), v = add_limbs(out[3], a[3], u.high);
  out[0] = s.low, out[1] = t.low, out[2] = u.low, out[3] = v.low;
  return v.high;
}
/// out[0, 4) -= a[0, 4) + borrow; returns what is borrowed.
constexpr Limb subtract_four(const Limb* a, Limb borrow, Limb* out) noexcept {
  const LimbPair s = subtract_limbs(out[0], a[0], borrow), t = subtract_limbs(out[1], a[1], s.high);
  const LimbPair u = subtract_limbs(out[2], a[2], t.high), v = subtract_limbs(out[3], a[3], u.high);
  out[0] = s.low, out[1] = t.low, out[2] = u.low, out[3] = v.low;
  return v.high;
}

/// out[0, n) += factor * a; returns what is carried out of it.
constexpr Limb add_multiple(Limb factor, const Limb* a, int n, Limb* out) noexcept {
  Limb carry = 0;
  for (const Limb* const end = a + n; a != end; ++a, ++out) {
    const LimbPair sum = multiply_add(factor, *a, *out, carry);
    *out = sum.low;
    carry = sum.high;
  }
  return carry;
}

/// out[0, n) = factor * a; returns what is carried out of it.
constexpr Limb set_multiple(Limb factor, const Limb* a, int n, Limb* out) noexcept {
  Limb carry = 0;
  for (const Limb* const end = a + n; a != end; ++a, ++out) {
    const LimbPair product = multiply_add(factor, *a, carry, 0);
    *out = product.low;
    carry = product.high;
  }
  return carry;
}

/// out[0, na + nb) = a * b, schoolbook, na > 0. Zero limbs of a are skipped.
constexpr void multiply(const Limb* a, int na, const Limb* b, int nb, Limb* out) noexcept {
  out[nb] = set_multiple(a[0], b, nb, out);
  for (int i = 1; i < na; ++i) out[i + nb] = a[i] == 0 ? 0 : add_multiple(a[i], b, nb, out + i);
}

/// out[0, 2 n) = a * a: products of different limbs once, doubled, and the squares.
constexpr void multiply_by_itself(const Limb* a, int n, Limb* out) noexcept {
  for (int i = 0; i <= n; ++i) out[i] = 0;
  for (int i = 0; i < n; ++i) {
    out[i + n] = a[i] == 0 ? 0 : add_multiple(a[i], a + i + 1, n - i - 1, out + 2 * i + 1);
  }
  Limb carry = 0, shifted_out = 0;
  for (int i = 0; i < n; ++i) {
    const Limb low = out[2 * i] << 1 | shifted_out, high = out[2 * i + 1] << 1 | out[2 * i] >> 63;
    shifted_out = out[2 * i + 1] >> 63;
    const LimbPair sum = multiply_add(a[i], a[i], low, carry);
    out[2 * i] = sum.low;
    out[2 * i + 1] = sum.high + high;
    carry = out[2 * i + 1] < high;
  }
}

/// A magnitude placed on the limb grid; zeros surround it.
struct Span {
  const Limb* limb;
  int low, size;
  constexpr Limb at(int i) const noexcept {
    const unsigned k = static_cast<unsigned>(i - low);  // below `low` greater than any size
    return k < static_cast<unsigned>(size) ? limb[k] : 0;
  }
};

/// Sign of |a| - |b|; both stripped of leading zeros.
constexpr int compare_magnitude(const Span& a, const Span& b) noexcept {
  const int top_a = a.low + a.size, top_b = b.low + b.size;
  if (top_a != top_b) return top_a < top_b ? -1 : 1;
  const int bottom = a.low < b.low ? a.low : b.low;
  for (int i = top_a - 1; i >= bottom; --i) {
    if (a.at(i) != b.at(i)) return a.at(i) < b.at(i) ? -1 : 1;
  }
  return 0;
}

/// The limbs of a magnitude from a place on the grid up.
constexpr Span from(const Span& a, int low) noexcept {
  const int cut = low > a.low ? low - a.low : 0;
  return cut >= a.size ? Span{a.limb, low, 0} : Span{a.limb + cut, a.low + cut, a.size - cut};
}

/// out[0, n) = |a| on the grid from low on.
constexpr void place_magnitude(const Span& a, int low, int n, Limb* out) noexcept {
  const Span kept = from(a, low);
  const int zeros = kept.low - low;
  for (int i = 0; i < zeros; ++i) out[i] = 0;
  move_limbs(kept.limb, kept.size, out + zeros);
  for (int i = zeros + kept.size; i < n; ++i) out[i] = 0;
}

constexpr bool are_zero(const Limb* four) noexcept { return (four[0] | four[1] | four[2] | four[3]) == 0; }

/// out[0, n) = |a| + |b| on the grid from low on; n leaves room for the carry.
constexpr void add_magnitude(const Span& a, const Span& b, int low, int n, Limb* out) noexcept {
  place_magnitude(a, low, n, out);
  const Span added = from(b, low);
  Limb* sum = out + (added.low - low);
  Limb carry = 0;
  int k = 0;
  for (; k + 4 <= added.size; k += 4, sum += 4) {
    if (carry != 0 || !are_zero(added.limb + k)) carry = add_four(added.limb + k, carry, sum);
  }
  for (; k < added.size; ++k, ++sum) {
    if ((added.limb[k] | carry) == 0) continue;
    const LimbPair total = add_limbs(*sum, added.limb[k], carry);
    *sum = total.low;
    carry = total.high;
  }
  for (; carry != 0; ++sum) carry = ++*sum == 0;
}

/// out[0, n) = |a| - |b|, which must not be negative.
constexpr void subtract_magnitude(const Span& a, const Span& b, int low, int n, Limb* out) noexcept {
  place_magnitude(a, low, n, out);
  const Span taken = from(b, low);
  Limb* difference = out + (taken.low - low);
  Limb borrow = 0;
  int k = 0;
  for (; k + 4 <= taken.size; k += 4, difference += 4) {
    if (borrow != 0 || !are_zero(taken.limb + k)) borrow = subtract_four(taken.limb + k, borrow, difference);
  }
  for (; k < taken.size; ++k, ++difference) {
    if ((taken.limb[k] | borrow) == 0) continue;
    const LimbPair total = subtract_limbs(*difference, taken.limb[k], borrow);
    *difference = total.low;
    borrow = total.high;
  }
  for (; borrow != 0; ++difference) borrow = (*difference)-- == 0;
}

/// out[0, n) = |a b| on the grid from low on, a and b not zero.
constexpr void place_product(const Span& a, const Span& b, int low, int n, Limb* out) noexcept {
  const int zeros = a.low + b.low - low, end = zeros + a.size + b.size;
  for (int i = 0; i < zeros; ++i) out[i] = 0;
  if (a.limb == b.limb) {
    multiply_by_itself(a.limb, a.size, out + zeros);
  } else {
    const Span &shorter = a.size <= b.size ? a : b, &longer = a.size <= b.size ? b : a;
    multiply(shorter.limb, shorter.size, longer.limb, longer.size, out + zeros);
  }
  for (int i = end; i < n; ++i) out[i] = 0;
}

/// out[0, n) += |a b| on the grid from low on. Returns true if the sum does not fit.
constexpr bool add_product(const Span& a, const Span& b, int low, int n, Limb* out) noexcept {
  const Span &shorter = a.size <= b.size ? a : b, &longer = a.size <= b.size ? b : a;
  const Limb* const end = out + n;
  Limb* row = out + (a.low + b.low - low);
  bool overflows = false;
  for (int i = 0; i < shorter.size; ++i, ++row) {
    if (shorter.limb[i] == 0) continue;
    Limb carry = add_multiple(shorter.limb[i], longer.limb, longer.size, row);
    for (Limb* above = row + longer.size; carry != 0 && above != end; ++above) {
      *above += carry;
      carry = *above < carry ? 1 : 0;
    }
    overflows = overflows || carry != 0;
  }
  return overflows;
}

/// out[0, n) = the difference of out and |a b|, on the grid from low on. Returns true if |a b| is the greater. With
/// ~x = 2^(64 n) - 1 - x, ~out + |a b| overflows iff |a b| is the greater.
constexpr bool subtract_product(const Span& a, const Span& b, int low, int n, Limb* out) noexcept {
  for (int i = 0; i < n; ++i) out[i] = ~out[i];
  if (!add_product(a, b, low, n, out)) {
    for (int i = 0; i < n; ++i) out[i] = ~out[i];
    return false;
  }
  for (Limb* limb = out; ++*limb == 0; ++limb) {
  }
  return true;
}

}  // namespace detail

}  // namespace vesica::exact
