// SPDX-License-Identifier: Apache-2.0
/// Exact numbers as GMP's, and numbers to try.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vesica/exact/number.hpp>

#include "properties/random.hpp"

namespace exact_values {

using vesica::exact::Limb;
using vesica::exact::Number;

/// x * 2^exponent.
inline mpq_class scaled(mpq_class x, std::int64_t exponent) {
  if (exponent < 0) {
    mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  } else {
    mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  }
  return x;
}
inline mpq_class power_of_two(std::int64_t exponent) { return scaled(1, exponent); }

inline mpz_class integer(const Limb* limbs, int n) {
  mpz_class x;
  mpz_import(x.get_mpz_t(), static_cast<std::size_t>(n), -1, sizeof(Limb), 0, 0, limbs);
  return x;
}

template <int Degree>
mpq_class value(const Number<Degree>& x) {
  return scaled(mpq_class(x.sign * integer(x.limb, x.size)), std::int64_t{64} * x.low);
}

}  // namespace exact_values
