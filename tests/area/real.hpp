// SPDX-License-Identifier: Apache-2.0
/// A number of 384 bits, about 115 digits, over MPFR.
#pragma once

#include <mpfr.h>

#include <compare>

namespace reference {

class Real {
 public:
  Real(double value = 0) : Real(Unset{}) { mpfr_set_d(number_, value, MPFR_RNDN); }
  explicit Real(const char* digits) : Real(Unset{}) { mpfr_set_str(number_, digits, 10, MPFR_RNDN); }
  Real(const Real& other) : Real(Unset{}) { mpfr_set(number_, other.number_, MPFR_RNDN); }
  Real& operator=(const Real& other) {
    mpfr_set(number_, other.number_, MPFR_RNDN);
    return *this;
  }
  ~Real() { mpfr_clear(number_); }

  explicit operator double() const { return mpfr_get_d(number_, MPFR_RNDN); }
  Real operator-() const { return of(mpfr_neg, *this); }
  Real& operator+=(const Real& other) { return *this = *this + other; }
  Real& operator-=(const Real& other) { return *this = *this - other; }

  friend Real operator+(const Real& p, const Real& q) { return of(mpfr_add, p, q); }
  friend Real operator-(const Real& p, const Real& q) { return of(mpfr_sub, p, q); }
  friend Real operator*(const Real& p, const Real& q) { return of(mpfr_mul, p, q); }
  friend Real operator/(const Real& p, const Real& q) { return of(mpfr_div, p, q); }
  friend Real sqrt(const Real& p) { return of(mpfr_sqrt, p); }
  friend Real exp(const Real& p) { return of(mpfr_exp, p); }
  friend Real log(const Real& p) { return of(mpfr_log, p); }
  friend Real abs(const Real& p) { return of(mpfr_abs, p); }
  friend Real cos(const Real& p) { return of(mpfr_cos, p); }
  friend Real sin(const Real& p) { return of(mpfr_sin, p); }
  friend Real acos(const Real& p) { return of(mpfr_acos, p); }
  friend Real atan(const Real& p) { return of(mpfr_atan, p); }
  friend Real atan2(const Real& y, const Real& x) { return of(mpfr_atan2, y, x); }
  friend Real ldexp(const Real& p, long exponent) {
    Real result{Unset{}};
    mpfr_mul_2si(result.number_, p.number_, exponent, MPFR_RNDN);
    return result;
  }

  friend bool operator==(const Real& p, const Real& q) { return mpfr_equal_p(p.number_, q.number_) != 0; }
  friend std::partial_ordering operator<=>(const Real& p, const Real& q) {
    if (mpfr_unordered_p(p.number_, q.number_) != 0) return std::partial_ordering::unordered;
    return mpfr_cmp(p.number_, q.number_) <=> 0;
  }

 private:
  struct Unset {};
  explicit Real(Unset) { mpfr_init2(number_, 384); }

  using OfOne = int(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  static Real of(OfOne function, const Real& p) {
    Real result{Unset{}};
    function(result.number_, p.number_, MPFR_RNDN);
    return result;
  }
  using OfTwo = int(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
  static Real of(OfTwo function, const Real& p, const Real& q) {
    Real result{Unset{}};
    function(result.number_, p.number_, q.number_, MPFR_RNDN);
    return result;
  }

  mpfr_t number_;
};

}  // namespace reference
