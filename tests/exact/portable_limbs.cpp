// SPDX-License-Identifier: Apache-2.0
#include "exact/portable_limbs.hpp"

// Everything number.hpp includes, before its compiler seems to have no 128-bit integers.
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#undef __SIZEOF_INT128__
// Under another name, or the linker would keep one of the two definitions for the whole program.
#define exact exact_portable
#include <vesica/exact/number.hpp>
#undef exact

namespace portable {

LimbPair multiply_add(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
  const auto sum = vesica::exact_portable::detail::multiply_add(a, b, c, d);
  return {sum.low, sum.high};
}

void multiply(const std::uint64_t* a, int na, const std::uint64_t* b, int nb, std::uint64_t* out) {
  vesica::exact_portable::detail::multiply(a, na, b, nb, out);
}

void multiply_by_itself(const std::uint64_t* a, int n, std::uint64_t* out) {
  vesica::exact_portable::detail::multiply_by_itself(a, n, out);
}

}  // namespace portable
