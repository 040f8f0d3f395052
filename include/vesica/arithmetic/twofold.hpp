// SPDX-License-Identifier: Apache-2.0
/// Twofolds: numbers of about twice the precision, as an unevaluated sum that is not renormalised (compensated
/// arithmetic). The closest features of two shapes are found in plain arithmetic; the distance is then evaluated in
/// twofolds, so that it is right to its own last place or two even where two large numbers nearly cancel.
///
/// Without renormalising an operation has half the latency of a double-double's (double_double.hpp), but the error of a
/// result is relative to its largest term. That is enough for a few sums of products. Only plain operations are used,
/// so every instruction set gives the same bits.
#pragma once

#include <vesica/arithmetic/error_free.hpp>

namespace vesica::detail::arithmetic {

/// high + low, where low is a few roundoffs of high or of the terms that cancelled in it. The error of a result is a
/// few 2^-106 of its largest term.
template <class V>
struct Twofold {
  V high, low;
};

template <class V>
VESICA_INLINE V rounded(const Twofold<V>& x) noexcept {
  return x.high + x.low;
}

/// a + b exactly.
template <class V>
VESICA_INLINE Twofold<V> exact_sum(V a, V b) noexcept {
  Pair<V> sum = two_sum(a, b);
  return {sum.high, sum.low};
}
template <class V>
VESICA_INLINE Twofold<V> exact_difference(V a, V b) noexcept {
  return exact_sum(a, -b);
}

/// The same number, with high nearest to it.
template <class V>
VESICA_INLINE Twofold<V> renormalised(const Twofold<V>& x) noexcept {
  return exact_sum(x.high, x.low);
}

/// A Twofold as a factor (see Factor).
template <class V>
struct TwofoldFactor {
  V high, upper, lower, low;
};

template <class V>
VESICA_INLINE TwofoldFactor<V> factor(const Twofold<V>& x) noexcept {
  Factor<V> f = factor(x.high);
  return {f.high, f.upper, f.lower, x.low};
}

template <class V>
VESICA_INLINE Twofold<V> operator*(const Factor<V>& a, const Factor<V>& b) noexcept {
  Pair<V> p = two_product<V>(a, b);
  return {p.high, p.low};
}
template <class V>
VESICA_INLINE Twofold<V> operator*(const Factor<V>& a, const TwofoldFactor<V>& b) noexcept {
  Pair<V> p = two_product<V>(a, b);
  return {p.high, p.low + a.high * b.low};
}
template <class V>
VESICA_INLINE Twofold<V> operator*(const TwofoldFactor<V>& a, const Factor<V>& b) noexcept {
  return b * a;
}
template <class V>
VESICA_INLINE Twofold<V> operator*(const TwofoldFactor<V>& a, const TwofoldFactor<V>& b) noexcept {
  Pair<V> p = two_product<V>(a, b);
  return {p.high, p.low + ((a.high * b.low + a.low * b.high) + a.low * b.low)};
}

template <class V>
VESICA_INLINE Twofold<V> square(const Factor<V>& a) noexcept {
  Pair<V> p = two_square<V>(a);
  return {p.high, p.low};
}
template <class V>
VESICA_INLINE Twofold<V> square(const TwofoldFactor<V>& a) noexcept {
  Pair<V> p = two_square<V>(a);
  V cross = a.high * a.low;
  return {p.high, p.low + ((cross + cross) + a.low * a.low)};
}

template <class V>
VESICA_INLINE Twofold<V> operator-(const Twofold<V>& x) noexcept {
  return {-x.high, -x.low};
}
template <class V>
VESICA_INLINE Twofold<V> operator+(const Twofold<V>& x, const Twofold<V>& y) noexcept {
  Twofold<V> sum = exact_sum(x.high, y.high);
  return {sum.high, sum.low + (x.low + y.low)};
}
template <class V>
VESICA_INLINE Twofold<V> operator-(const Twofold<V>& x, const Twofold<V>& y) noexcept {
  return x + -y;
}

/// A square root and 1 / high of it, which is the one division that it takes.
template <class V>
struct Root {
  Twofold<V> value;
  V inverse;
};

/// sqrt(x) for x > 0: one Newton step from the rounded root.
template <class V>
VESICA_INLINE Root<V> root(const Twofold<V>& x) noexcept {
  V high = sqrt(x.high), inverse = V(1.0) / high;
  Twofold<V> s = square(factor(high));
  return {{high, ((x.high - s.high) + (x.low - s.low)) * (V(0.5) * inverse)}, inverse};
}

/// 1 / x, from a rounded 1 / x.high.
template <class V>
VESICA_INLINE Twofold<V> inverse(const Twofold<V>& x, V high) noexcept {
  Twofold<V> p = factor(high) * factor(x.high);
  return {high, ((V(1.0) - p.high) - (p.low + high * x.low)) * high};
}
template <class V>
VESICA_INLINE Twofold<V> inverse(const Twofold<V>& x) noexcept {
  return inverse(x, V(1.0) / x.high);
}
template <class V>
VESICA_INLINE Twofold<V> inverse(const Root<V>& r) noexcept {
  return inverse(r.value, r.inverse);
}
/// The same, rounded.
template <class V>
VESICA_INLINE V rounded_inverse(const Root<V>& r) noexcept {
  return r.inverse - r.inverse * (r.value.low * r.inverse);
}

template <class Mask, class V>
VESICA_INLINE Twofold<V> choose(Mask m, const Twofold<V>& yes, const Twofold<V>& no) noexcept {
  return {select(m, yes.high, no.high), select(m, yes.low, no.low)};
}

/// x, or -x where the sign bit of y is set.
template <class V>
VESICA_INLINE Twofold<V> flipped(const Twofold<V>& x, V y) noexcept {
  return {flip_sign(x.high, y), flip_sign(x.low, y)};
}

/// A vector of such numbers, and one as factors.
template <class V>
struct Vector {
  Twofold<V> x, y;
};
template <class F>
struct VectorFactor {
  F x, y;
};
template <class V>
VESICA_INLINE VectorFactor<TwofoldFactor<V>> factor(const Vector<V>& v) noexcept {
  return {factor(v.x), factor(v.y)};
}
template <class V>
VESICA_INLINE VectorFactor<Factor<V>> factor(V x, V y) noexcept {
  return {factor(x), factor(y)};
}
template <class V>
VESICA_INLINE Vector<V> operator+(const Vector<V>& a, const Vector<V>& b) noexcept {
  return {a.x + b.x, a.y + b.y};
}
template <class V>
VESICA_INLINE Vector<V> operator-(const Vector<V>& a, const Vector<V>& b) noexcept {
  return {a.x - b.x, a.y - b.y};
}
template <class V>
VESICA_INLINE Vector<V> renormalised(const Vector<V>& v) noexcept {
  return {renormalised(v.x), renormalised(v.y)};
}
template <class F, class G>
VESICA_INLINE auto dot(const VectorFactor<F>& a, const VectorFactor<G>& b) noexcept {
  return a.x * b.x + a.y * b.y;
}
template <class F, class G>
VESICA_INLINE auto cross(const VectorFactor<F>& a, const VectorFactor<G>& b) noexcept {
  return a.x * b.y - a.y * b.x;
}

}  // namespace vesica::detail::arithmetic
