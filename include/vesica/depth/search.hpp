// SPDX-License-Identifier: Apache-2.0
/// How deep two shapes of any form overlap, by a search over all directions (support_minimum/arc_search.hpp).
#pragma once

#include <vesica/depth/disc_disc.hpp>
#include <vesica/support_minimum/frame.hpp>
#include <vesica/support_minimum/order.hpp>

namespace vesica::detail::depth {

using namespace support_minimum;

/// The least over all n of h1(n) + h2(n) - n.D: how far the second shape must move along n until n separates the two.
/// Rounding may make it slightly negative. For disjoint shapes it is negative.
inline Depth searched_depth(const Form& a, const Form& b) noexcept {
  const PlacedPair given = place(a, b);
  const bool exchange = out_of_order(a, b, given);
  const PlacedPair pair = exchange ? exchanged(given) : given;
  const Frame frame(pair);
  const PlaneVector n = minimise(frame.objective(1)).at.n;
  const PlaneVector direction = unit(frame.world(n));
  return {frame.value(n, 1), exchange ? -direction : direction, pair.exponent};
}

}  // namespace vesica::detail::depth
