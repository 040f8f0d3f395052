// SPDX-License-Identifier: Apache-2.0
/// Fixed-point fractions of 384 bits, and quartics in Bernstein form whose coefficients they are.
#pragma once

#include <vesica/exact/rounded.hpp>

namespace vesica::detail::crossings {

/// A value below 1 in magnitude: limbs in two's complement, the least first, over 2^383. Callers keep values below 1/4,
/// so that sums and differences fit.
struct Fixed {
  static constexpr int limbs = 6;
  exact::Limb limb[limbs];

  bool negative() const noexcept { return limb[limbs - 1] >> 63 != 0; }
  /// Below 2^-319: no larger than what rounding may have left.
  bool negligible() const noexcept {
    const exact::Limb fill = exact::Limb{0} - limb[limbs - 1] / (exact::Limb{1} << 63);
    exact::Limb differing = 0;
    for (int i = 1; i < limbs; ++i) differing |= limb[i] ^ fill;
    return differing == 0;
  }
};

inline Fixed operator+(const Fixed& a, const Fixed& b) noexcept {
  Fixed sum;
  exact::Limb carry = 0;
  for (int i = 0; i < Fixed::limbs; ++i) {
    const exact::Limb part = a.limb[i] + b.limb[i], total = part + carry;
    carry = static_cast<exact::Limb>(part < a.limb[i]) | static_cast<exact::Limb>(total < part);
    sum.limb[i] = total;
  }
  return sum;
}

inline Fixed operator-(const Fixed& a, const Fixed& b) noexcept {
  Fixed difference;
  exact::Limb borrow = 0;
  for (int i = 0; i < Fixed::limbs; ++i) {
    const exact::Limb part = a.limb[i] - b.limb[i], total = part - borrow;
    borrow = static_cast<exact::Limb>(a.limb[i] < b.limb[i]) | static_cast<exact::Limb>(part < borrow);
    difference.limb[i] = total;
  }
  return difference;
}

inline Fixed operator-(const Fixed& a) noexcept { return Fixed{} - a; }

/// a = (a + b) / 2, rounded down.
inline void move_halfway(Fixed& a, const Fixed& b) noexcept {
  exact::Limb carry = 0, below = 0;
  for (int i = 0; i < Fixed::limbs; ++i) {
    const exact::Limb part = a.limb[i] + b.limb[i], total = part + carry;
    carry = static_cast<exact::Limb>(part < b.limb[i]) | static_cast<exact::Limb>(total < part);
    if (i > 0) a.limb[i - 1] = below >> 1 | total << 63;
    below = total;
  }
  a.limb[Fixed::limbs - 1] = below >> 1 | (below & exact::Limb{1} << 63);
}

/// x / 2^exponent, rounded towards 0, for |x| < 2^exponent.
template <int Degree>
Fixed fixed(const exact::Number<Degree>& x, std::int64_t exponent) noexcept {
  Fixed out{};
  if (x.sign == 0) return out;
  // The bit of weight 2^(exponent - 383) becomes bit 0.
  const std::int64_t bottom = exponent - (64 * Fixed::limbs - 1);
  const int shift = static_cast<int>(bottom & 63);
  const std::int64_t first = (bottom - shift) / 64;
  const auto at = [&x](std::int64_t i) {
    return i < x.low || i >= std::int64_t{x.low} + x.size ? exact::Limb{0} : x.limb[i - x.low];
  };
  for (int i = 0; i < Fixed::limbs; ++i) {
    out.limb[i] = shift == 0 ? at(first + i) : at(first + i) >> shift | at(first + i + 1) << (64 - shift);
  }
  return x.sign < 0 ? -out : out;
}

/// The sum of coefficient[i] B_i(t), B_i the Bernstein polynomials of degree 4. Between 0 and 1 it has as many zeros as
/// its coefficients have changes of sign, or fewer by an even number.
struct Quartic {
  Fixed coefficient[5];

  /// No digits are left.
  bool negligible() const noexcept {
    for (const Fixed& c : coefficient) {
      if (!c.negligible()) return false;
    }
    return true;
  }
  /// The most changes of sign there can be, negligible coefficients having either sign.
  int sign_changes() const noexcept {
    int changes = 0;
    bool known = false, last = false;
    for (const Fixed& c : coefficient) {
      if (c.negligible()) {
        ++changes;
        last = !last;
        continue;
      }
      if (known && c.negative() != last) ++changes;
      known = true;
      last = c.negative();
    }
    return known ? changes : 4;
  }
};

/// a = a + (b - a) s / 2^64 for s > 0, rounded down: a (2^64 - s) + b s over 2^64.
inline void move_towards(Fixed& a, const Fixed& b, exact::Limb s) noexcept {
  const exact::Limb rest = exact::Limb{0} - s;
  // A number that is negative is 2^384 less than its limbs.
  const exact::Limb excess = (a.negative() ? rest : 0) + (b.negative() ? s : 0);
  exact::Limb carry_a = 0, carry_b = 0;
  for (int i = 0; i < Fixed::limbs; ++i) {
    const auto part = exact::detail::multiply_add(a.limb[i], rest, carry_a, 0);
    const auto sum = exact::detail::multiply_add(b.limb[i], s, carry_b, part.low);
    carry_a = part.high;
    carry_b = sum.high;
    if (i > 0) a.limb[i - 1] = sum.low;
  }
  a.limb[Fixed::limbs - 1] = carry_a + carry_b - excess;
}

/// One stage of de Casteljau's construction: n + 1 coefficients become n.
inline void interpolate(Fixed* c, int n, exact::Limb s) noexcept {
  if (s == 0) return;
  for (int i = 0; i < n; ++i) move_towards(c[i], c[i + 1], s);
}

/// The same quartic from t = from / 2^64 to t = to / 2^64, or to t = 1 for a `to` of 0, by its polar form: coefficient
/// i is that of i times `to` and 4 - i times `from`.
inline Quartic part(const Quartic& q, exact::Limb from, exact::Limb to) noexcept {
  Quartic out, at_from = q;
  for (int i = 4; i >= 0; --i) {
    if (to == 0) {
      out.coefficient[i] = at_from.coefficient[i];
    } else {
      Quartic rest = at_from;
      for (int n = i; n > 0; --n) interpolate(rest.coefficient, n, to);
      out.coefficient[i] = rest.coefficient[0];
    }
    if (i > 0) interpolate(at_from.coefficient, i, from);
  }
  return out;
}

/// Both halves.
struct Halves {
  Quartic low, high;
  explicit Halves(const Quartic& q) noexcept : high(q) {
    for (int i = 0; i < 5; ++i) {
      low.coefficient[i] = high.coefficient[0];
      for (int k = 0; k < 4 - i; ++k) move_halfway(high.coefficient[k], high.coefficient[k + 1]);
    }
  }
};

/// Its coefficients as doubles over 2^exponent, which makes the greatest about 1. Returns the exponent.
inline int to_doubles(const Quartic& q, double* out) noexcept {
  Fixed magnitude[5];
  int top = 0, shift = 64;
  for (int i = 0; i < 5; ++i) {
    const Fixed& c = q.coefficient[i];
    magnitude[i] = c.negative() ? -c : c;
    for (int k = Fixed::limbs - 1; k >= top; --k) {
      if (magnitude[i].limb[k] == 0) continue;
      const int zeros = std::countl_zero(magnitude[i].limb[k]);
      shift = k > top || zeros < shift ? zeros : shift;
      top = k;
      break;
    }
  }
  for (int i = 0; i < 5; ++i) {
    const exact::Limb* m = magnitude[i].limb;
    const exact::Limb below = top > 0 && shift > 0 ? m[top - 1] >> (64 - shift) : 0;
    const double value = static_cast<double>((shift == 64 ? 0 : m[top] << shift) | (shift == 64 ? 0 : below)) * 0x1p-64;
    out[i] = q.coefficient[i].negative() ? -value : value;
  }
  return 64 * (top + 1) - shift - (64 * Fixed::limbs - 1);
}

}  // namespace vesica::detail::crossings
