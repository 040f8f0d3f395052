// SPDX-License-Identifier: Apache-2.0
/// Products of numbers whose exponents are wildly unlike: few of their many limbs matter.
///
/// Such a number is a sum of a few stored ones, or products of them, far apart. Between them lie limbs that are all
/// zeros, or all ones where a small number was subtracted. Those from place i up to place j are 2^(64 j) - 2^(64 i).
#pragma once

#include <vesica/exact/limbs.hpp>
#include <vesica/scalar.hpp>

namespace vesica::exact::detail {

/// A magnitude as a sum of runs of limbs, some of them to be subtracted.
class Runs {
 public:
  struct Run {
    Span span;
    bool negative;
  };
  Run run[24];
  int count = 0;
  int limbs = 0;  ///< of all runs

  /// False where it falls into more runs than are worth while.
  bool set(const Limb* a, int n) noexcept {
    int from = 0;  // of limbs that are in no run yet
    for (int i = 0; i < n;) {
      const int end = end_of_filling(a, i, n);
      if (end - i < least_filling) {
        i = end > i ? end : i + 1;
        continue;
      }
      if (!add({a + from, from, i - from}, false)) return false;
      if (a[i] != 0 && (!add({&one, i, 1}, true) || !add({&one, end, 1}, false))) return false;
      from = i = end;
    }
    return add({a + from, from, n - from}, false);
  }

 private:
  static constexpr Limb one = 1;
  static constexpr int least_filling = 2;

  /// Where limbs that are all zeros, or all ones, end that begin at i.
  static int end_of_filling(const Limb* a, int i, int n) noexcept {
    if (a[i] + 1 > 1) return i;
    int end = i + 1;
    while (end < n && a[end] == a[i]) ++end;
    return end;
  }
  bool add(const Span& span, bool negative) noexcept {
    if (span.size == 0) return true;
    if (count == static_cast<int>(sizeof run / sizeof run[0])) return false;
    run[count++] = {span, negative};
    limbs += span.size;
    return true;
  }
};

/// sum += a * b, both of at least one limb. The sum has room for it.
inline void add_product(const Span& a, const Span& b, Limb* sum) noexcept {
  for (int i = 0; i < a.size; ++i) {
    if (a.limb[i] == 0) continue;
    Limb* out = sum + (a.low + i + b.low);
    Limb carry = 0;
    for (int j = 0; j < b.size; ++j, ++out) {
      const LimbPair total = multiply_add(a.limb[i], b.limb[j], *out, carry);
      *out = total.low;
      carry = total.high;
    }
    *out += carry;
    for (carry = *out < carry; carry != 0; carry = *out == 0) ++*++out;
  }
}

inline void double_all(Limb* a, int n) noexcept {
  for (int i = n - 1; i > 0; --i) a[i] = a[i] << 1 | a[i - 1] >> 63;
  a[0] <<= 1;
}

/// The products of all runs in `plus` and `minus`, of a number by itself in half as many.
inline void add_products(const Runs& x, const Runs& y, bool same, int n, Limb* plus, Limb* minus) noexcept {
  for (int i = 0; i < x.count; ++i) {
    for (int j = same ? i + 1 : 0; j < y.count; ++j) {
      const auto &p = x.run[i], &q = y.run[j];
      Limb* const sum = p.negative == q.negative ? plus : minus;
      p.span.size < q.span.size ? add_product(p.span, q.span, sum) : add_product(q.span, p.span, sum);
    }
  }
  if (!same) return;
  double_all(plus, n);
  double_all(minus, n);
  for (int i = 0; i < x.count; ++i) add_product(x.run[i].span, x.run[i].span, plus);
}

/// Numbers of fewer limbs are multiplied limb by limb.
inline constexpr int least_sparse = 12;
/// Limbs of the longest product that is tried here. Those of degree 32 are shorter.
inline constexpr int most_sparse = 1100;

/// out = a * b, two limbs longer than both together, where few limbs matter; false where limb by limb is as quick.
VESICA_COLD inline bool multiply_sparse(const Span& a, const Span& b, Limb* out) noexcept {
  const int n = a.size + b.size + 2;
  Runs x, y;
  if (n > most_sparse || !x.set(a.limb, a.size) || !y.set(b.limb, b.size)) return false;
  if (2 * x.limbs * y.limbs > a.size * b.size) return false;
  Limb minus[most_sparse];
  for (int i = 0; i < n; ++i) out[i] = minus[i] = 0;
  add_products(x, y, a.limb == b.limb, n, out, minus);
  Limb borrow = 0;
  for (int i = 0; i < n; ++i) {
    const Limb difference = out[i] - minus[i], total = difference - borrow;
    borrow = static_cast<Limb>(out[i] < minus[i]) | static_cast<Limb>(difference < borrow);
    out[i] = total;
  }
  return true;
}

}  // namespace vesica::exact::detail
