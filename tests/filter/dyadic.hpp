// SPDX-License-Identifier: Apache-2.0
/// The truth filters are measured against: exact numbers over GMP integers, independent of the library's own.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace truth {

/// m 2^e. Polynomials of stored numbers need no other rationals, and these need no common divisors.
class Dyadic {
 public:
  Dyadic() = default;
  /// The value of any finite double or float.
  Dyadic(double x) {
    int exponent = 0;
    mantissa_ = std::ldexp(std::frexp(x, &exponent), 53);
    exponent_ = exponent - 53;
    if (mantissa_ == 0) return;
    const mp_bitcnt_t zeros = mpz_scan1(mantissa_.get_mpz_t(), 0);
    mantissa_ >>= zeros;
    exponent_ += static_cast<long>(zeros);
  }

  int sign() const { return sgn(mantissa_); }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    mpz_class sum = a.mantissa_ << static_cast<mp_bitcnt_t>(a.exponent_ - b.exponent_);
    sum += b.mantissa_;
    return {std::move(sum), b.exponent_};
  }
  friend Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend bool operator<(const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; }
  friend bool operator>(const Dyadic& a, const Dyadic& b) { return b < a; }

  /// a / b to double precision; b is not zero.
  friend double quotient(const Dyadic& a, const Dyadic& b) {
    long exponent_a = 0, exponent_b = 0;
    const double x = mpz_get_d_2exp(&exponent_a, a.mantissa_.get_mpz_t());
    const double y = mpz_get_d_2exp(&exponent_b, b.mantissa_.get_mpz_t());
    const long shift = exponent_a - exponent_b + a.exponent_ - b.exponent_;
    return std::ldexp(x / y, static_cast<int>(std::clamp(shift, -4000L, 4000L)));
  }

 private:
  Dyadic(mpz_class mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  mpz_class mantissa_ = 0;
  long exponent_ = 0;
};

inline Dyadic abs(const Dyadic& x) { return x.sign() < 0 ? -x : x; }
inline Dyadic max(const Dyadic& a, const Dyadic& b) { return a < b ? b : a; }
inline Dyadic square(const Dyadic& x) { return x * x; }

/// |error| / bound, above 1 exactly when the error exceeds the bound.
inline double error_over_bound(const Dyadic& error, const Dyadic& bound) {
  const Dyadic magnitude = abs(error);
  if (bound.sign() <= 0) return magnitude.sign() == 0 ? 0 : std::numeric_limits<double>::infinity();
  const double rounded = quotient(magnitude, bound);
  return magnitude > bound ? std::max(rounded, std::nextafter(1.0, 2.0)) : std::min(rounded, 1.0);
}

}  // namespace truth
