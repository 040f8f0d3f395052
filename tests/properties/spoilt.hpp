// SPDX-License-Identifier: Apache-2.0
/// Pairs with one invalid shape.
#pragma once

#include <cstddef>
#include <limits>

#include "properties/pair.hpp"

namespace properties {

/// By `how` from 0 to 3: a negative size, an axis of 0, or a number that is none. Another `how` leaves the pair as it
/// is.
inline void spoil(Pair& pair, int how) {
  const auto last = static_cast<std::size_t>(field_count(pair.kind_b)) - 1;
  if (how == 0) pair.b[last] = -1;
  if (how == 1) pair.b[2] = pair.b[3] = 0;
  if (how == 2) pair.a[0] = std::numeric_limits<double>::quiet_NaN();
  if (how == 3) pair.b[last] = std::numeric_limits<double>::infinity();
}

}  // namespace properties
