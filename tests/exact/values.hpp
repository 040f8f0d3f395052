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

/// A number as the ellipses' polynomials have them: a sum of products of lengths of any exponents.
inline Number<8> any_number(properties::Random& random) {
  const auto length = [&] {
    return vesica::exact::from_double(std::ldexp(1 + random.unit(), random.integer(-1000, 1000)));
  };
  const auto degree_2 = [&] { return length() * length() - length() * length(); };
  const auto degree_4 = [&] { return degree_2() * degree_2() + square(degree_2()); };
  return degree_4() * degree_4() - square(degree_4());
}

/// The same number, or one that differs by as little or as much as any double.
inline Number<8> about(const Number<8>& x, properties::Random& random) {
  if (random.chance(0.3)) return x;
  const auto tiny = vesica::exact::from_double(std::ldexp(1 + random.unit(), random.integer(-1000, 1000)));
  return random.chance(0.5) ? x + tiny : x - tiny;
}

}  // namespace exact_values
