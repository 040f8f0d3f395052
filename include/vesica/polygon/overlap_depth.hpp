// SPDX-License-Identifier: Apache-2.0
/// The depth of overlapping shapes with a polygon or a polyline, for signed_distance() and within().
#pragma once

#include <vesica/polygon/depth.hpp>

namespace vesica::detail::polygon {

/// The depth of two overlapping valid shapes, of which at least one is a path; error_not_convex unless both are convex.
template <class T, class Other>
std::int32_t overlap_depth(const Edges<T>& a, const Other& b, double& depth) noexcept {
  Penetration<double> found{};
  const std::int32_t error = convex_depth(a, b, found);
  depth = found.depth;
  return error;
}

}  // namespace vesica::detail::polygon
