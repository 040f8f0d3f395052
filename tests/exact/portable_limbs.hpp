// SPDX-License-Identifier: Apache-2.0
/// The products of exact/limbs.hpp as compilers without 128-bit integers build them.
#pragma once

#include <cstdint>

namespace portable {

struct LimbPair {
  std::uint64_t low, high;
};

LimbPair multiply_add(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d);
void multiply(const std::uint64_t* a, int na, const std::uint64_t* b, int nb, std::uint64_t* out);
void multiply_by_itself(const std::uint64_t* a, int n, std::uint64_t* out);

}  // namespace portable
