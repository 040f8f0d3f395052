// SPDX-License-Identifier: Apache-2.0
/// Products of numbers whose exponents are wildly unlike: few of their many limbs matter.
///
/// Such a number is a sum of a few stored ones far apart. Between them lie limbs that are all zeros, or all ones where
/// a small number was subtracted. In balanced form, with digits from -2^63 to 2^63, both are zeros.
#pragma once

#include <vesica/exact/limbs.hpp>
#include <vesica/scalar.hpp>

namespace vesica::exact::detail {

/// The digits that are not zero, the least first, if they are few.
struct Digits {
  static constexpr int most = 128;

  Limb size[most];
  std::int16_t place[most];
  bool negative[most];
  int count = 0;

  /// False where there are more than fit.
  bool set(const Limb* a, int n) noexcept {
    Limb carry = 0;
    for (int i = 0; i < n; ++i) {
      const Limb x = a[i] + carry;
      if (x == 0) continue;  // a carry stays one: the limb was all ones
      carry = x >> 63;
      if (!add(carry != 0 ? Limb{0} - x : x, i, carry != 0)) return false;
    }
    return carry == 0 || add(1, n, false);
  }

 private:
  bool add(Limb x, int i, bool minus) noexcept {
    if (count == most) return false;
    size[count] = x;
    place[count] = static_cast<std::int16_t>(i);
    negative[count++] = minus;
    return true;
  }
};

/// Adds x * y at a place; the sum has room for it.
inline void add_product(Limb x, Limb y, Limb* sum) noexcept {
  const LimbPair first = multiply_add(x, y, sum[0], 0);
  sum[0] = first.low;
  sum[1] += first.high;
  Limb carry = sum[1] < first.high;
  for (int i = 2; carry != 0; ++i) carry = ++sum[i] == 0;
}

/// Numbers of fewer limbs are multiplied limb by limb.
inline constexpr int least_sparse = 12;
/// Products of longer numbers too: more than those of degree 32 have.
inline constexpr int most_sparse = 1100;

/// out = a * b, two limbs longer than both together, where few digits matter; false where limb by limb is as quick.
VESICA_COLD inline bool multiply_sparse(const Span& a, const Span& b, Limb* out) noexcept {
  const int n = a.size + b.size + 2;
  Digits x, y;
  if (n > most_sparse || !x.set(a.limb, a.size) || !y.set(b.limb, b.size)) return false;
  if (4 * x.count * y.count > a.size * b.size) return false;
  Limb minus[most_sparse];
  for (int i = 0; i < n; ++i) out[i] = minus[i] = 0;
  Limb* const sums[2] = {out, minus};
  for (int i = 0; i < x.count; ++i) {
    for (int j = 0; j < y.count; ++j) {
      add_product(x.size[i], y.size[j], sums[x.negative[i] != y.negative[j]] + (x.place[i] + y.place[j]));
    }
  }
  Limb borrow = 0;
  for (int i = 0; i < n; ++i) {
    const Limb difference = out[i] - minus[i], total = difference - borrow;
    borrow = static_cast<Limb>(out[i] < minus[i]) | static_cast<Limb>(difference < borrow);
    out[i] = total;
  }
  return true;
}

}  // namespace vesica::exact::detail
