// SPDX-License-Identifier: Apache-2.0
/// Numbers to about 100 bits with a bound on their error and any exponent: most signs are known without the exact
/// number, whose limbs, where exponents are very unlike, are many.
#pragma once

#include <vesica/crossings/points.hpp>
#include <vesica/exact/rounded.hpp>

namespace vesica::detail::crossings {

/// Within error * 2^exponent of value * 2^exponent; value is 0 or between 1/4 and 4 in magnitude.
struct Estimate {
  Real value;
  double error = 0;
  int exponent = 0;

  Estimate() noexcept = default;
  Estimate(const Real& v, double e, int scale) noexcept : value(v), error(e), exponent(scale) { normalise(); }
  template <int Degree>
  explicit Estimate(const exact::Number<Degree>& x) noexcept {
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

inline Estimate operator-(const Estimate& a) noexcept { return {-a.value, a.error, a.exponent}; }
inline Estimate operator*(const Estimate& a, const Estimate& b) noexcept {
  const Real product = a.value * b.value;
  const double x = std::fabs(rounded(a.value)), y = std::fabs(rounded(b.value));
  const double error = 1.01 * (x * b.error + y * a.error + a.error * b.error) + 0x1p-100 * (x * y);
  return {product, error, a.exponent + b.exponent};
}
inline Estimate operator+(const Estimate& a, const Estimate& b) noexcept {
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
inline Estimate operator-(const Estimate& a, const Estimate& b) noexcept { return a + -b; }
inline Estimate square(const Estimate& a) noexcept { return a * a; }
/// The root of a number whose error is below half of it.
inline Estimate root(const Estimate& a) noexcept {
  const bool odd = (a.exponent & 1) != 0;
  const double unit = odd ? 2 : 1;
  const Real value = a.value * unit, found = sqrt(value);
  // sqrt(x) - sqrt(x - e) < e / sqrt(x) for e < x / 2.
  const double x = std::sqrt(rounded(value));
  return {found, 1.01 * (unit * a.error / x) + 0x1p-98 * x, (a.exponent - (odd ? 1 : 0)) / 2};
}

/// a / b for a b whose error is below a quarter of it.
inline Estimate operator/(const Estimate& a, const Estimate& b) noexcept {
  const Real quotient = a.value / b.value;
  const double y = std::fabs(rounded(b.value)), q = std::fabs(rounded(quotient));
  return {quotient, 1.4 * ((a.error + q * b.error) / y) + 0x1p-97 * q, a.exponent - b.exponent};
}
inline Estimate times(double factor, const Estimate& a) noexcept { return a * Estimate(Real(factor), 0, 0); }

}  // namespace vesica::detail::crossings
