// SPDX-License-Identifier: Apache-2.0
/// The products of exact/limbs.hpp and exact/signed_digits.hpp as compilers without 128-bit integers build them.
#pragma once

#include <cstdint>

namespace portable {

struct LimbPair {
  std::uint64_t low, high;
};

LimbPair multiply_add(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d);
void multiply(const std::uint64_t* a, int na, const std::uint64_t* b, int nb, std::uint64_t* out);
void multiply_by_itself(const std::uint64_t* a, int n, std::uint64_t* out);
/// sum + a * b, as of RunningSum.
LimbPair add_product(const LimbPair& sum, std::int64_t a, std::int64_t b);

}  // namespace portable
