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

/// Searches for so many seconds. Kinds are those of the first and the second shape; the numbers are doubles. From known
/// inputs, where some are of this query and these kinds.
Slowest climb(stress::Query query, int kind_a, int kind_b, double seconds, std::uint64_t seed,
              const std::vector<stress::Case>& known);

}  // namespace slowest
