// SPDX-License-Identifier: Apache-2.0
/// Fixed-point fractions of 384 bits, and quartics in Bernstein form whose coefficients they are.
#pragma once

#include <algorithm>
#include <utility>
#include <vesica/exact/rounded.hpp>

namespace vesica::detail::crossings {

/// Calls f(i) for i from 0 to n - 1, unrolled: with loops over limbs, which g++ leaves as they are, a search for zeros
/// takes a tenth longer.
template <int n, class Function>
VESICA_INLINE void each(const Function& f) noexcept {
  [&]<int... i>(std::integer_sequence<int, i...>) { (f(i), ...); }
  (std::make_integer_sequence<int, n>{});
}

/// A value below 1 in magnitude: limbs in two's complement, the least first, over 2^383. Callers keep values below 1/4,
/// so that sums and differences fit.
struct Fixed {
  static constexpr int limbs = 6;
  exact::Limb limb[limbs];

  bool is_zero() const noexcept {
    exact::Limb any = 0;
    for (const exact::Limb l : limb) any |= l;
    return any == 0;
  }
  bool negative() const noexcept { return limb[limbs - 1] >> 63 != 0; }
  /// Below 2^-319: no larger than what rounding may have left. Of a number that the lowest n limbs hold.
  template <int n = limbs>
  bool negligible() const noexcept {
    const exact::Limb fill = exact::Limb{0} - limb[n - 1] / (exact::Limb{1} << 63);
    exact::Limb differing = 0;
    each<n - 1>([&](int i) { differing |= limb[i + 1] ^ fill; });
    return differing == 0;
  }
  /// The magnitude, with a relative error of at most 2^-52.
  double size() const noexcept;
  /// The limbs above the lowest n repeat the sign, as in numbers that these hold.
  template <int n>
  void extend_sign() noexcept {
    const exact::Limb fill = exact::Limb{0} - (limb[n - 1] >> 63);
    for (int i = n; i < limbs; ++i) limb[i] = fill;
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

inline double Fixed::size() const noexcept {
  const Fixed m = negative() ? -*this : *this;
  int top = limbs - 1;
  while (top > 0 && m.limb[top] == 0) --top;
  const auto digit = [&m](int i) {
    return static_cast<double>(m.limb[i]) * arithmetic::power_of_two(64 * (i - limbs) + 1);
  };
  return top > 0 ? digit(top) + digit(top - 1) : digit(0);
}

/// a = (a + b) / 2, rounded down, for numbers that the lowest n limbs hold; those above are left as they are.
template <int n>
void move_halfway(Fixed& a, const Fixed& b) noexcept {
  exact::Limb carry = 0, below = 0;
  each<n>([&](int i) {
    const auto sum = exact::detail::add_limbs(a.limb[i], b.limb[i], carry);
    carry = sum.high;
    if (i > 0) a.limb[i - 1] = below >> 1 | sum.low << 63;
    below = sum.low;
  });
  a.limb[n - 1] = below >> 1 | (below & exact::Limb{1} << 63);
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

  /// No coefficient is negligible.
  bool has_digits() const noexcept {
    for (const Fixed& c : coefficient) {
      if (c.negligible()) return false;
    }
    return true;
  }
  /// The most changes of sign there can be, negligible coefficients having either sign. Without branches: which are
  /// negligible cannot be foreseen.
  template <int n = Fixed::limbs>
  int sign_changes() const noexcept {
    unsigned changes = 0, known = 0, last = 0;
    for (const Fixed& c : coefficient) {
      const unsigned tiny = c.negligible<n>() ? 1 : 0, negative = c.negative() ? 1 : 0;
      changes += tiny | (known & (negative ^ last));
      known |= tiny ^ 1;
      last = (tiny & ~last) | (~tiny & negative);
    }
    return known != 0 ? static_cast<int>(changes) : 4;
  }
  template <int n>
  void extend_signs() noexcept {
    for (Fixed& c : coefficient) c.extend_sign<n>();
  }
};

/// Calls f<n>(...) for a number of limbs that is at least 2: where the zeros of a quartic lie close together its
/// coefficients are small, and the limbs above are not computed with. No result depends on n.
template <class Function>
void with_limbs(int n, const Function& f) noexcept {
  switch (n) {
    case 2:
      return f.template operator()<2>();
    case 3:
      return f.template operator()<3>();
    case 4:
      return f.template operator()<4>();
    case 5:
      return f.template operator()<5>();
    default:
      return f.template operator()<6>();
  }
}

/// a = a + (b - a) s / 2^64 for s > 0, rounded down: a (2^64 - s) + b s over 2^64. Of the lowest n limbs, which hold
/// both; so they hold the result.
template <int n>
void move_towards(Fixed& a, const Fixed& b, exact::Limb s) noexcept {
  const exact::Limb rest = exact::Limb{0} - s;
  // A number that is negative is 2^(64 n) less than its limbs.
  const exact::Limb excess =
      ((exact::Limb{0} - (a.limb[n - 1] >> 63)) & rest) + ((exact::Limb{0} - (b.limb[n - 1] >> 63)) & s);
  exact::Limb carry_a = 0, carry_b = 0;
  each<n>([&](int i) {
    const auto part = exact::detail::multiply_add(a.limb[i], rest, carry_a, 0);
    const auto sum = exact::detail::multiply_add(b.limb[i], s, carry_b, part.low);
    carry_a = part.high;
    carry_b = sum.high;
    if (i > 0) a.limb[i - 1] = sum.low;
  });
  a.limb[n - 1] = carry_a + carry_b - excess;
}

/// One stage of de Casteljau's construction: count + 1 coefficients become count.
template <int n>
void interpolate(Fixed* c, int count, exact::Limb s) noexcept {
  for (int i = 0; i < count; ++i) move_towards<n>(c[i], c[i + 1], s);
}

/// part() from an end, which is at c[0], to s / 2^64 of the way to the other.
template <int n, class Coefficient>
void set_part_from_end(Fixed* c, exact::Limb s, const Coefficient& coefficient) noexcept {
  for (int i = 0; i <= 4; ++i) {
    coefficient(i) = c[0];
    interpolate<n>(c, 4 - i, s);
  }
}

/// part() of coefficients that the lowest n limbs hold.
template <int n>
int set_part(const Quartic& q, exact::Limb from, exact::Limb to, Quartic& out) noexcept {
  Quartic at_from = q;
  Fixed* c = at_from.coefficient;
  if (from == 0) {
    set_part_from_end<n>(c, to, [&](int i) -> Fixed& { return out.coefficient[i]; });
  } else if (to == 0) {
    std::reverse(c, c + 5);
    const exact::Limb way = exact::Limb{0} - from;
    set_part_from_end<n>(c, way, [&](int i) -> Fixed& { return out.coefficient[4 - i]; });
  } else {
    for (int i = 4; i >= 0; --i) {
      Quartic rest = at_from;
      for (int k = i; k > 0; --k) interpolate<n>(rest.coefficient, k, to);
      out.coefficient[i] = rest.coefficient[0];
      if (i > 0) interpolate<n>(c, i, from);
    }
  }
  out.extend_signs<n>();
  return out.sign_changes<n>();
}

/// The same quartic from t = from / 2^64 to t = to / 2^64, or to t = 1 for a `to` of 0, but not all of it, by its polar
/// form: coefficient i takes i times `to` and 4 - i times `from`. The lowest `limbs` limbs hold the coefficients.
/// Returns its changes of sign.
inline int part(const Quartic& q, exact::Limb from, exact::Limb to, int limbs, Quartic& out) noexcept {
  int changes = 0;
  with_limbs(limbs, [&]<int n>() { changes = set_part<n>(q, from, to, out); });
  return changes;
}

/// The sizes of a quartic's derivatives about a point, each over its order's factorial: right to 2^-50 of themselves
/// and 2^-374, whatever cancels in doubles.
struct Derivatives {
  double size[5];

  /// The coefficients must fit the lowest `limbs` limbs; 0 <= t <= 1.
  Derivatives(const Quartic& q, double t, int limbs) noexcept {
    Quartic beyond = q;  // from t to the farther end
    Fixed* const c = beyond.coefficient;
    if (t > 0.5) std::reverse(c, c + 5);
    const double way = t > 0.5 ? 1 - t : t;
    const auto s = static_cast<exact::Limb>(way * 0x1p64);
    with_limbs(limbs, [&]<int n>() {
      for (int count = s == 0 ? 0 : 4; count > 0; --count) interpolate<n>(c, count, s);
      beyond.extend_signs<n>();
    });
    double scale = 1;
    for (int order = 0; order <= 4; ++order) {
      constexpr double choices[] = {1, 4, 6, 4, 1};
      size[order] = choices[order] * scale * c[order].size();
      scale /= 1 - way;
      for (int i = 4; i > order; --i) c[i] = c[i] - c[i - 1];
    }
  }
};

/// The changes of sign of a quartic's halves.
struct HalvesChanges {
  int low, high;
};

/// Cuts a quartic whose coefficients the lowest `limbs` limbs hold into halves: in place, since copies would take as
/// long. Returns their changes of sign.
inline HalvesChanges halve(Quartic& to_high, Quartic& low, int limbs) noexcept {
  HalvesChanges changes{};
  with_limbs(limbs, [&]<int n>() {
    Fixed* high = to_high.coefficient;
    for (int i = 0; i < 5; ++i) {
      each<n>([&](int k) { low.coefficient[i].limb[k] = high[0].limb[k]; });
      for (int k = 0; k < 4 - i; ++k) move_halfway<n>(high[k], high[k + 1]);
    }
    low.extend_signs<n>();
    to_high.extend_signs<n>();
    changes = {low.sign_changes<n>(), to_high.sign_changes<n>()};
  });
  return changes;
}

/// A quartic's coefficients as doubles over 2^exponent, which makes the greatest about 1: between 1/2 and 1, or 0. Each
/// is right to a relative 2^-53 plus 2^-63.
struct InDoubles {
  double coefficient[5];
  int exponent;
  int limbs;  ///< this many of the lowest hold the coefficients with two bits to spare; at least 2

  /// The coefficients must fit the lowest `most_limbs` limbs.
  explicit InDoubles(const Quartic& q, int most_limbs = Fixed::limbs) noexcept {
    Fixed magnitude[5];
    exact::Limb seen[Fixed::limbs] = {};
    with_limbs(most_limbs, [&]<int n>() { set_magnitudes<n>(q, magnitude, seen); });
    int top = most_limbs - 1;
    while (top > 0 && seen[top] == 0) --top;
    const int shift = std::countl_zero(seen[top]);
    for (int i = 0; i < 5; ++i) {
      const exact::Limb* m = magnitude[i].limb;
      const exact::Limb below = top > 0 && shift > 0 ? m[top - 1] >> (64 - shift) : 0;
      const exact::Limb kept = shift == 64 ? 0 : m[top] << shift | below;
      // By halves, which are doubles, so that the sum is rounded once: a limb's top bit cannot be foreseen.
      const double high = static_cast<double>(static_cast<std::int64_t>(kept >> 32)) * 0x1p-32;
      const double low = static_cast<double>(static_cast<std::int64_t>(kept & 0xffffffffu)) * 0x1p-64;
      const exact::Limb sign = q.coefficient[i].limb[Fixed::limbs - 1] >> 63 << 63;
      coefficient[i] = std::bit_cast<double>(std::bit_cast<exact::Limb>(high + low) | sign);
    }
    exponent = 64 * (top + 1) - shift - (64 * Fixed::limbs - 1);
    const int needed = top + (shift >= 2 ? 1 : 2);
    limbs = needed < 2 ? 2 : needed;
  }

 private:
  template <int n>
  static void set_magnitudes(const Quartic& q, Fixed* magnitude, exact::Limb* seen) noexcept {
    for (int i = 0; i < 5; ++i) {
      const exact::Limb* c = q.coefficient[i].limb;
      const exact::Limb flip = exact::Limb{0} - (c[n - 1] >> 63);
      exact::Limb carry = flip & 1;
      each<n>([&](int k) {
        const exact::Limb m = (c[k] ^ flip) + carry;
        carry &= static_cast<exact::Limb>(m == 0);
        magnitude[i].limb[k] = m;
        seen[k] |= m;
      });
    }
  }
};

}  // namespace vesica::detail::crossings
