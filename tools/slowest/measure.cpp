// SPDX-License-Identifier: Apache-2.0
#include "slowest/measure.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <vesica/exact/number.hpp>

#include "stress/call.hpp"
#include "vesica.h"

namespace slowest {
namespace {

template <class Call>
double least_microseconds(int calls, Call call) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < calls; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    const std::chrono::duration<double, std::micro> passed = std::chrono::steady_clock::now() - start;
    least = std::min(least, passed.count());
  }
  return least;
}

/// Keeps the compiler from leaving work out.
volatile std::uint64_t sink;

void yardstick() {
  constexpr int n = 32;
  static const std::array<std::uint64_t, n> factor = [] {
    std::array<std::uint64_t, n> limbs{};
    for (std::uint64_t i = 0; i < n; ++i) limbs[i] = (i + 1) * 0x9E3779B97F4A7C15U;
    return limbs;
  }();
  std::array<std::uint64_t, 2 * n> product{};
  for (std::size_t i = 0; i < n; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const auto sum = vesica::exact::detail::multiply_add(factor[i], factor[j], product[i + j], carry);
      product[i + j] = sum.low;
      carry = sum.high;
    }
    product[i + n] = carry;
  }
  sink = product[n];
}

/// The slowest of the ratios, each a call of its own; stress::ask() makes all these calls.
double slowest_ratio(const properties::Pair& p, int calls) {
  double most = 0, out = 0;
  for (std::int32_t which = 0; which < static_cast<std::int32_t>(stress::ratio_count); ++which) {
    const auto call = [&] {
      sink = static_cast<std::uint64_t>(vesica_ratio_f64(which, p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out));
    };
    most = std::max(most, least_microseconds(calls, call));
  }
  return most;
}

}  // namespace

double microseconds(const stress::Case& c, int calls) {
  if (c.query == stress::Query::ratio && c.scalar == properties::Scalar::f64) return slowest_ratio(c.pair, calls);
  return least_microseconds(calls, [&] { sink = static_cast<std::uint64_t>(ask(c).code); });
}

double yardstick_microseconds() { return least_microseconds(1000, yardstick); }

}  // namespace slowest
