// SPDX-License-Identifier: Apache-2.0
// Sorts places by keys of 64 bits, such as scores, in memory of the caller.
#pragma once

#include <bit>
#include <cstdint>
#include <utility>

namespace vesica::index {

/// A place to sort by its key.
struct Ranked {
  std::uint64_t key;
  std::uint32_t place;
};

/// Ascending where the scores descend; 0 and -0 are equal.
inline std::uint64_t key_of(double score) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(score + 0.0);
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return ~((bits & sign) != 0 ? ~bits : bits | sign);
}

/// Sorts by keys, a byte at a time from the lowest, equal ones in the order they have. Returns which buffer has them.
inline Ranked* sort_ranked(Ranked* from, Ranked* to, std::int64_t n) noexcept {
  constexpr int digits = 8, values = 256;
  std::uint32_t count[digits][values] = {};
  for (std::int64_t i = 0; i < n; ++i) {
    for (int d = 0; d < digits; ++d) ++count[d][from[i].key >> (8 * d) & 0xff];
  }
  for (int d = 0; d < digits; ++d) {
    if (n > 0 && count[d][from[0].key >> (8 * d) & 0xff] == n) continue;
    std::uint32_t begin = 0;
    for (std::uint32_t& c : count[d]) begin += std::exchange(c, begin);
    for (std::int64_t i = 0; i < n; ++i) to[count[d][from[i].key >> (8 * d) & 0xff]++] = from[i];
    std::swap(from, to);
  }
  return from;
}

}  // namespace vesica::index
