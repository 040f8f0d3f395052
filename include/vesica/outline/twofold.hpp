// SPDX-License-Identifier: Apache-2.0
/// Numbers as unevaluated sums of two, about 106 bits, for the few sums whose terms cancel. Plain additions and
/// multiplications only, so that every processor and every lane gets the same bits.
///
/// T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971) 224; sums
/// by D. E. Knuth. Exact while products stay within 2^-900 and 2^900; below, what is lost is less than 2^-1000.
#pragma once

#include <vesica/scalar.hpp>

namespace vesica::outline {

template <class V>
struct Twofold {
  V high, low;
};

template <class V>
VESICA_INLINE V rounded(const Twofold<V>& a) noexcept {
  return a.high + a.low;
}

/// a + b, exactly.
template <class V>
VESICA_INLINE Twofold<V> sum(V a, V b) noexcept {
  const V high = a + b, part = high - a;
  return {high, (a - (high - part)) + (b - part)};
}

/// a + b, exactly, where a is 0 or has at least the exponent of b.
template <class V>
VESICA_INLINE Twofold<V> sum_in_order(V a, V b) noexcept {
  const V high = a + b;
  return {high, b - (high - a)};
}

/// The upper 26 bits of a, and the rest.
template <class V>
VESICA_INLINE Twofold<V> halves(V a) noexcept {
  const V shifted = V(0x1p27 + 1) * a, high = shifted - (shifted - a);
  return {high, a - high};
}

/// a * b, exactly.
template <class V>
VESICA_INLINE Twofold<V> product(V a, V b) noexcept {
  const V high = a * b;
  const Twofold<V> x = halves(a), y = halves(b);
  return {high, ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

template <class V>
VESICA_INLINE Twofold<V> operator+(const Twofold<V>& a, const Twofold<V>& b) noexcept {
  const Twofold<V> top = sum(a.high, b.high);
  return sum_in_order(top.high, top.low + (a.low + b.low));
}
template <class V>
VESICA_INLINE Twofold<V> operator-(const Twofold<V>& a) noexcept {
  return {-a.high, -a.low};
}
template <class V>
VESICA_INLINE Twofold<V> operator-(const Twofold<V>& a, const Twofold<V>& b) noexcept {
  return a + -b;
}
template <class V>
VESICA_INLINE Twofold<V> operator*(const Twofold<V>& a, V b) noexcept {
  const Twofold<V> top = product(a.high, b);
  return sum_in_order(top.high, top.low + a.low * b);
}
template <class V>
VESICA_INLINE Twofold<V> operator*(const Twofold<V>& a, const Twofold<V>& b) noexcept {
  const Twofold<V> top = product(a.high, b.high);
  return sum_in_order(top.high, top.low + (a.high * b.low + a.low * b.high));
}

template <class V>
VESICA_INLINE Twofold<V> magnitude(const Twofold<V>& a) noexcept {
  using namespace lane;
  return {flip_sign(a.high, a.high), flip_sign(a.low, a.high)};
}

/// The square root of a number >= 0: a rounded root and one Newton step.
template <class V>
VESICA_INLINE Twofold<V> root(const Twofold<V>& a) noexcept {
  using namespace lane;
  const V guess = sqrt(a.high);
  const Twofold<V> square = product(guess, guess);
  const V rest = ((a.high - square.high) - square.low) + a.low;
  return sum_in_order(guess, rest / ((guess + guess) + V(0x1p-1000)));  // the root of 0 has nothing to divide by
}

/// A vector of such numbers.
template <class V>
struct TwofoldVector {
  Twofold<V> x, y;
};

/// Of exact vectors, and of an exact one with another.
template <class V>
VESICA_INLINE Twofold<V> dot(V ux, V uy, V vx, V vy) noexcept {
  return product(ux, vx) + product(uy, vy);
}
template <class V>
VESICA_INLINE Twofold<V> cross(V ux, V uy, V vx, V vy) noexcept {
  return product(ux, vy) - product(uy, vx);
}
template <class V>
VESICA_INLINE Twofold<V> dot(V ux, V uy, const TwofoldVector<V>& v) noexcept {
  return v.x * ux + v.y * uy;
}
template <class V>
VESICA_INLINE Twofold<V> cross(V ux, V uy, const TwofoldVector<V>& v) noexcept {
  return v.y * ux - v.x * uy;
}

}  // namespace vesica::outline
