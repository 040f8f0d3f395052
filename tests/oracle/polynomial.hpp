// SPDX-License-Identifier: Apache-2.0
/// Integer polynomials and the number of their real roots, by Sturm's theorem.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <vector>

namespace oracle {

/// Divides by the largest power of two that divides all: a positive factor, which no sign below depends on.
template <class Numbers>
void strip_power_of_two(Numbers& numbers) {
  mp_bitcnt_t shift = ~mp_bitcnt_t{0};
  for (const mpz_class& x : numbers) {
    if (x != 0) shift = std::min(shift, mpz_scan1(x.get_mpz_t(), 0));
  }
  if (shift == ~mp_bitcnt_t{0}) return;
  for (mpz_class& x : numbers) x >>= shift;
}

/// Coefficients, constant first; the last is not 0.
using Polynomial = std::vector<mpz_class>;

Polynomial derivative(const Polynomial& f);
Polynomial operator+(const Polynomial& f, const Polynomial& g);
Polynomial operator*(const Polynomial& f, const Polynomial& g);

/// Distinct roots > 0 of f, f(0) != 0; a multiple root counts once.
int distinct_positive_roots(const Polynomial& f);

/// Distinct real roots of f, which is not 0.
int distinct_real_roots(const Polynomial& f);

/// Distinct roots of f between 0 and 1, neither of which is one.
int distinct_roots_below_1(const Polynomial& f);

/// The greatest common divisor of f and its derivative, up to a factor: each root of f once less.
Polynomial repeated_part(const Polynomial& f);

}  // namespace oracle
