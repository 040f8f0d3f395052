// SPDX-License-Identifier: Apache-2.0
/// Numbers to about 100 bits with a bound on their error and any exponent: most signs are known without the exact
/// number, whose limbs, where exponents are very unlike, are many.
#pragma once

#include <utility>
#include <vesica/crossings/points.hpp>
#include <vesica/exact/rounded.hpp>

namespace vesica::detail::crossings {

using exact::DifferenceOfProducts, exact::SumOfProducts;

/// Within error * 2^exponent of value * 2^exponent; value is 0 or between 1/4 and 4 in magnitude.
struct Rough {
  Real value;
  double error = 0;
  int exponent = 0;

  Rough() noexcept = default;
  Rough(const Real& v, double e, int scale) noexcept : value(v), error(e), exponent(scale) { normalise(); }
  template <int Degree>
  explicit Rough(const exact::Number<Degree>& x) noexcept {
    if (x.sign == 0) return;
    const auto [high, low] = exact::rounded_twice(x);
    value = {high.value, low};
    exponent = high.exponent;
    error = 0x1p-105;
  }
  bool sign_is_known() const noexcept { return std::fabs(rounded(value)) > error || error == 0; }
  /// To 2^-60 or better.
  bool is_precise() const noexcept { return std::fabs(rounded(value)) * 0x1p-60 >= error; }
  int sign() const noexcept { return rounded(value) > 0 ? 1 : rounded(value) < 0 ? -1 : 0; }
  Scaled scaled() const noexcept { return {rounded(value), exponent}; }

 private:
  void normalise() noexcept {
    const double size = std::fmax(std::fabs(rounded(value)), error);
    if (size == 0 || (size >= 0.25 && size < 4)) return;
    const int shift = arithmetic::exponent_of(size);
    value = {arithmetic::scale(value.high, -shift), arithmetic::scale(value.low, -shift)};
    error = arithmetic::scale(error, -shift);
    exponent += shift;
  }
};

inline Rough operator-(const Rough& a) noexcept { return {-a.value, a.error, a.exponent}; }
inline Rough operator*(const Rough& a, const Rough& b) noexcept {
  const Real product = a.value * b.value;
  const double x = std::fabs(rounded(a.value)), y = std::fabs(rounded(b.value));
  const double error = 1.01 * (x * b.error + y * a.error + a.error * b.error) + 0x1p-100 * (x * y);
  return {product, error, a.exponent + b.exponent};
}
inline Rough operator+(const Rough& a, const Rough& b) noexcept {
  if (rounded(a.value) == 0 && a.error == 0) return b;
  if (rounded(b.value) == 0 && b.error == 0) return a;
  if (a.exponent < b.exponent) return b + a;
  const int shift = b.exponent - a.exponent;
  // So far below it only adds to the error.
  if (shift < -300) return {a.value, a.error + 0x1p-290, a.exponent};
  const double factor = arithmetic::scale(1, shift);
  const Real other{b.value.high * factor, b.value.low * factor};
  const double size = std::fabs(rounded(a.value)) + std::fabs(rounded(other));
  return {a.value + other, 1.01 * (a.error + b.error * factor) + 0x1p-100 * size, a.exponent};
}
inline Rough operator-(const Rough& a, const Rough& b) noexcept { return a + -b; }
inline Rough square(const Rough& a) noexcept { return a * a; }
/// The root of a number whose error is below half of it.
inline Rough root(const Rough& a) noexcept {
  const bool odd = (a.exponent & 1) != 0;
  const double unit = odd ? 2 : 1;
  const Real value = a.value * unit, found = sqrt(value);
  // sqrt(x) - sqrt(x - e) < e / sqrt(x) for e < x / 2.
  const double x = std::sqrt(rounded(value));
  return {found, 1.01 * (unit * a.error / x) + 0x1p-98 * x, (a.exponent - (odd ? 1 : 0)) / 2};
}

/// a / b for a b whose error is below a quarter of it.
inline Rough operator/(const Rough& a, const Rough& b) noexcept {
  const Real quotient = a.value / b.value;
  const double y = std::fabs(rounded(b.value)), q = std::fabs(rounded(quotient));
  return {quotient, 1.4 * ((a.error + q * b.error) / y) + 0x1p-97 * q, a.exponent - b.exponent};
}
inline Rough times(double factor, const Rough& a) noexcept { return a * Rough(Real(factor), 0, 0); }

/// Of leading digits.
template <int limbs>
Rough rough(const exact::Leading<limbs>& x) noexcept {
  const auto kept = exact::detail::digits_of(x);
  Rough out(kept);
  if (x.error == x.nothing) return out;
  const int place = static_cast<int>(x.error);
  // Of digits that are all beyond what is known, only how great they may be.
  if (kept.sign == 0 || place > out.exponent + 60) return {{}, 2, place};
  return {out.value, out.error + arithmetic::scale(1.01, place - out.exponent), out.exponent};
}

/// The sign of a polynomial in exact numbers, from the rough one or else from these.
template <class Polynomial, int... Degree>
int sign_of(const Rough& rough, const Polynomial& value, const exact::Number<Degree>&... x) noexcept {
  return rough.sign_is_known() ? rough.sign() : exact::sign_of(value, x...);
}
/// The same, with another form between, in which less cancels.
template <class OtherForm, class Polynomial, int... Degree>
int sign_of_either(const Rough& rough, const OtherForm& other, const Polynomial& value,
                   const exact::Number<Degree>&... x) noexcept {
  return rough.sign_is_known() ? rough.sign() : sign_of(other(), value, x...);
}
/// The double that is nearest to the number, if the error leaves no doubt which that is.
inline bool rounds_surely(const Rough& x, Scaled& nearest) noexcept {
  const auto [high, low] = x.value;
  // Twice the error, as its sum with `low` is rounded.
  if (high == 0 || high + (low + 2 * x.error) != high || high + (low - 2 * x.error) != high) return false;
  const int shift = arithmetic::exponent_of(high);
  nearest = {arithmetic::scale(high, -shift), x.exponent + shift};
  return true;
}

/// A size and sign to 2^-52: the nearest number to the polynomial, from the rough one if that leaves no doubt.
template <class Polynomial, int... Degree>
Scaled nearest_size(const Rough& rough, const Polynomial& value, const exact::Number<Degree>&... x) noexcept {
  Scaled nearest;
  return rounds_surely(rough, nearest) ? nearest : exact::rounded_value(value, x...);
}

/// The same from a rough number that is precise; else from another form, in which less cancels.
template <class OtherForm, class Polynomial, int... Degree>
Scaled size_of_either(const Rough& rough, const OtherForm& other, const Polynomial& value,
                      const exact::Number<Degree>&... x) noexcept {
  return rough.is_precise() ? rough.scaled() : nearest_size(other(), value, x...);
}

/// Whether |a| > |b|.
template <int A, int B>
bool is_greater(const exact::Number<A>& a, const exact::Number<B>& b) noexcept {
  return exact::detail::compare_magnitude(a.span(), b.span()) > 0;
}

/// The sum of the squares of parts less whole^2, as (m - |whole|) (m + |whole|) and the squares of the others, m being
/// the greatest part: only the sum may cancel.
template <int A, int B, class... Same>
Rough squares_less(const exact::Number<A>& whole, const exact::Number<B>& first, const Same&... rest) noexcept {
  const exact::Number<B>* part[] = {&first, &rest...};
  for (auto& p : part) {
    if (is_greater(*p, *part[0])) std::swap(p, part[0]);
  }
  const auto all = exact::abs(whole);
  const auto m = exact::abs(*part[0]);
  Rough sum = Rough(m - all) * (Rough(m) + Rough(all));
  for (const auto* p : part) {
    if (p != part[0]) sum = sum + square(Rough(*p));
  }
  return sum;
}

}  // namespace vesica::detail::crossings
