// SPDX-License-Identifier: Apache-2.0
// Results of the queries of numbers, from a block of doubles into the caller's type.
#pragma once

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "query.hpp"

namespace vesica::batch {
namespace {  // compiled in place by queries.cpp

using Results = double[max_results][query_block];

/// Results as the caller's type has them. Codes hold 0 for errors.
template <class Out>
using Stored = Out[max_results][query_block];

/// True if any of n floats is infinite. By their bits, since compilers do not vectorise comparisons of floats here.
bool any_infinite(const float* numbers, std::int32_t n) noexcept {
  std::uint32_t any = 0;
  for (std::int32_t i = 0; i < n; ++i) any |= (std::bit_cast<std::uint32_t>(numbers[i]) & 0x7fffffffu) == 0x7f800000u;
  return any != 0;
}

/// True if rounding made any of n lengths 0. By their bits too.
bool any_lost(const double* lengths, const float* rounded, std::int32_t n) noexcept {
  std::uint64_t any = 0;
  for (std::int32_t i = 0; i < n; ++i) {
    any |= std::uint64_t{(std::bit_cast<std::uint32_t>(rounded[i]) & 0x7fffffffu) == 0} &
           std::uint64_t{std::bit_cast<std::uint64_t>(lengths[i]) << 1 != 0};
  }
  return any != 0;
}

/// Repairs lengths that rounding to float made 0 (they become the smallest float) or infinite (an error).
std::int32_t mend(const Query& query, std::int32_t n, const Results& results, Stored<float>& out) noexcept {
  std::int32_t error = 0;
  for (std::int32_t i = 0; i < n; ++i) {
    bool in_range = true;
    for (int k = 0; k < query.columns(); ++k) in_range = in_range && !std::isinf(out[k][i]);
    // Below 0 it is a depth.
    const bool lost = query.is_length && out[0][i] == 0 && std::fabs(results[0][i]) > 0;
    if (lost) out[0][i] = std::copysign(std::numeric_limits<float>::denorm_min(), static_cast<float>(results[0][i]));
    if (in_range) continue;
    error = error_range;
    for (int k = 0; k < query.columns(); ++k) out[k][i] = std::numeric_limits<float>::quiet_NaN();
  }
  return error;
}

/// Rounds n results once, as the scalar functions do. A float beyond the range is an error.
std::int32_t store(const Query& query, std::int32_t n, const Results& results, Stored<float>& out) noexcept {
  bool in_range = true;
  for (int k = 0; k < query.columns(); ++k) {
    for (std::int32_t i = 0; i < n; ++i) out[k][i] = static_cast<float>(results[k][i]);
    in_range = in_range && !any_infinite(out[k], n);
  }
  if (query.reversal == Reversal::direction) {
    for (int k = 1; k < query.columns(); ++k) {
      for (std::int32_t i = 0; i < n; ++i) out[k][i] += 0.0f;  // no -0
    }
  }
  const bool lost = query.is_length && any_lost(results[0], out[0], n);
  return in_range && !lost ? 0 : mend(query, n, results, out);
}
std::int32_t store(const Query& query, std::int32_t n, const Results& results, Stored<double>& out) noexcept {
  for (int k = 0; k < query.columns(); ++k)
    std::memcpy(out[k], results[k], static_cast<std::size_t>(n) * sizeof(double));
  return 0;
}
std::int32_t store(const Query&, std::int32_t n, const Results& results, Stored<std::uint8_t>& out) noexcept {
  for (std::int32_t i = 0; i < n; ++i) {
    out[0][i] = std::isnan(results[0][i]) ? std::uint8_t{0} : static_cast<std::uint8_t>(results[0][i]);
  }
  return 0;
}

}  // namespace
}  // namespace vesica::batch
