// SPDX-License-Identifier: Apache-2.0
/// Products of numbers that are sums of terms of very different magnitudes: few of their many limbs matter.
///
/// Such a number is a sum of a few stored ones, or products of them, far apart. Between them lie limbs that are all
/// zeros, or all ones where a small number was subtracted: then that is what is left out too, and the small number is
/// written as what is subtracted.
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
  static constexpr int most_runs = 48, most_limbs = 256;

  Run run[most_runs];
  int count = 0;
  int limbs = 0;  ///< of all runs

  /// False where it falls into more runs or limbs than are worth while.
  constexpr bool set(const Limb* a, int n) noexcept {
    Limb carry = 0;  // into limb i: 1 above a run that is subtracted
    for (int i = 0; i < n;) {
      if (a[i] + carry == 0) {
        ++i;
        continue;
      }
      const int end = end_of_run(a, i, n);
      const bool negative = end < n && a[end] != 0;
      Limb* const out = add(i, end - i, negative);
      if (out == nullptr) return false;
      // A negative run is what lacks to the next power of 2^64. With the carry its lowest limb is not 0.
      for (int k = i; k < end; ++k) out[k - i] = negative ? ~a[k] : a[k];
      out[0] = negative ? 0 - (a[i] + carry) : a[i] + carry;
      carry = negative ? 1 : 0;
      i = end;
    }
    if (carry == 0) return true;
    Limb* const top = add(n, 1, false);
    if (top != nullptr) *top = carry;
    return top != nullptr;
  }
  /// What multiplying by it takes, in limbs: to begin a run takes as long as two.
  constexpr int cost() const noexcept { return limbs + 2 * count; }

 private:
  Limb limb_[most_limbs];

  /// Where two limbs or more begin, above limb i, that are all zeros or all ones.
  static constexpr int end_of_run(const Limb* a, int i, int n) noexcept {
    int end = i + 1;
    while (end < n && (a[end] + 1 > 1 || end + 1 == n || a[end + 1] != a[end])) ++end;
    return end;
  }
  /// Room for another run's limbs, or null.
  constexpr Limb* add(int low, int size, bool negative) noexcept {
    if (count == most_runs || limbs + size > most_limbs) return nullptr;
    Limb* const room = limb_ + limbs;
    run[count++] = {{room, low, size}, negative};
    limbs += size;
    return room;
  }
};

/// sum += a * b, both of at least one limb. The sum has room for it.
VESICA_CALLED constexpr void add_product(const Span& a, const Span& b, Limb* sum) noexcept {
  for (int i = 0; i < a.size; ++i) {
    const Limb factor = a.limb[i];
    if (factor == 0) continue;
    Limb* out = sum + (a.low + i + b.low);
    Limb carry = add_multiple(factor, b.limb, b.size, out);
    out += b.size;
    *out += carry;
    for (carry = *out < carry; carry != 0; carry = *out == 0) ++*++out;
  }
}

/// sum -= a * b, for a sum that is not less.
VESICA_CALLED constexpr void subtract_product(const Span& a, const Span& b, Limb* sum) noexcept {
  for (int i = 0; i < a.size; ++i) {
    const Limb factor = a.limb[i];
    if (factor == 0) continue;
    Limb* out = sum + (a.low + i + b.low);
    Limb carry = 0;
    for (int j = 0; j < b.size; ++j, ++out) {
      const LimbPair product = multiply_add(factor, b.limb[j], carry, 0);
      carry = product.high + static_cast<Limb>(*out < product.low);
      *out -= product.low;
    }
    Limb borrow = *out < carry;
    *out -= carry;
    while (borrow != 0) borrow = (*++out)-- == 0;
  }
}

/// Numbers of fewer limbs are multiplied limb by limb.
inline constexpr int least_sparse = 12;
/// Limbs of the longest product that is tried here. Those of degree 32 are shorter.
inline constexpr int most_sparse = 1100;

/// The runs of a number, and the same twice as great, whose limbs are put into `room`.
constexpr void double_runs(const Runs& x, Runs& twice, Limb* room) noexcept {
  twice.count = x.count;
  for (int i = 0; i < x.count; ++i) {
    const Span& s = x.run[i].span;
    Limb below = 0;
    for (int k = 0; k < s.size; ++k) {
      room[k] = s.limb[k] << 1 | below >> 63;
      below = s.limb[k];
    }
    room[s.size] = below >> 63;
    twice.run[i] = {{room, s.low, s.size + static_cast<int>(below >> 63)}, x.run[i].negative};
    room += s.size + 1;
  }
}

/// All products of a run of x and one of y that have this sign; of a number by itself, x being twice y, those of
/// different runs alone. Negative ones are taken away last: then the sum never is negative.
template <bool negative>
constexpr void take_products(const Runs& x, const Runs& y, bool same, Limb* out) noexcept {
  for (int i = 0; i < x.count; ++i) {
    for (int j = same ? i + 1 : 0; j < y.count; ++j) {
      const auto &p = x.run[i], &q = y.run[j];
      if ((p.negative != q.negative) != negative) continue;
      const bool in_order = p.span.size < q.span.size;
      const Span &a = in_order ? p.span : q.span, &b = in_order ? q.span : p.span;
      negative ? subtract_product(a, b, out) : add_product(a, b, out);
    }
  }
}

/// out = a * b, two limbs longer than both together, where few limbs matter; false where limb by limb is as quick.
VESICA_CALLED constexpr bool multiply_sparse(const Span& a, const Span& b, Limb* out) noexcept {
  const int n = a.size + b.size + 2;
  Runs x, y;
  if (n > most_sparse || !x.set(a.limb, a.size) || !y.set(b.limb, b.size)) return false;
  if (x.cost() * y.cost() > a.size * b.size) return false;
  for (int i = 0; i < n; ++i) out[i] = 0;
  take_products<false>(x, y, false, out);
  take_products<true>(x, y, false, out);
  return true;
}

/// sum += a * a, of which it has room for two limbs more, where few limbs matter; false where limb by limb is as quick.
/// No square that is asked for is longer than most_sparse.
VESICA_CALLED constexpr bool add_square_sparse(const Span& a, Limb* sum) noexcept {
  Runs x, twice;
  if (!x.set(a.limb, a.size) || x.cost() > a.size) return false;
  Limb room[Runs::most_limbs + Runs::most_runs];
  double_runs(x, twice, room);
  for (int i = 0; i < x.count; ++i) add_product(x.run[i].span, x.run[i].span, sum);
  take_products<false>(twice, x, true, sum);
  take_products<true>(twice, x, true, sum);
  return true;
}

/// out = a * a where few limbs matter; false where limb by limb is as quick.
VESICA_CALLED constexpr bool square_sparse(const Span& a, Limb* out) noexcept {
  for (int i = 0; i < 2 * a.size + 2; ++i) out[i] = 0;
  return add_square_sparse(a, out);
}

/// The sum of the squares from `low` on; returns how many limbs it has. Of zeros no limb is set.
VESICA_CALLED constexpr int sum_squares(const Span* part, int count, Limb* out, int& low) noexcept {
  low = INT32_MAX;
  int top = INT32_MIN;
  for (const Span* p = part; p != part + count; ++p) {
    if (p->size == 0) continue;
    low = low < 2 * p->low ? low : 2 * p->low;
    top = top > 2 * (p->low + p->size) ? top : 2 * (p->low + p->size);
  }
  const int size = top < low ? 0 : top - low + 2;
  for (int i = 0; i < size; ++i) out[i] = 0;
  for (const Span* p = part; p != part + count; ++p) {
    if (p->size == 0) continue;
    const Span own{p->limb, 0, p->size};
    Limb* const sum = out + (2 * p->low - low);
    if (own.size < least_sparse || !add_square_sparse(own, sum)) add_product(own, own, sum);
  }
  return size;
}

}  // namespace vesica::exact::detail
