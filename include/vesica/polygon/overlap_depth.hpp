// SPDX-License-Identifier: Apache-2.0
/// The depth of overlapping shapes with a polygon or a polyline.
#pragma once

#include <vesica/polygon/other.hpp>

namespace vesica::detail::polygon {

/// The depth of two overlapping valid shapes, of which at least one is a path, or an error. No pair is known as yet.
template <class T, class Other>
std::int32_t overlap_depth(const Edges<T>&, const Other&, double&) noexcept {
  return error_kind;
}

}  // namespace vesica::detail::polygon
