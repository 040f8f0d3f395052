// SPDX-License-Identifier: Apache-2.0
/// A search that climbs from random pairs towards the one that a query takes longest for.
#pragma once

#include <cstdint>
#include <vector>

#include "stress/query.hpp"

namespace slowest {

struct Slowest {
  stress::Case input;
  double microseconds;
  std::uint64_t calls;  ///< inputs tried
};

/// Searches for the given number of seconds, in double, for one query and two kinds. Starts from the known inputs of
/// this query and these kinds, if there are any.
Slowest climb(stress::Query query, int kind_a, int kind_b, double seconds, std::uint64_t seed,
              const std::vector<stress::Case>& known);

}  // namespace slowest
