// SPDX-License-Identifier: Apache-2.0
// First contacts of a circle or an ellipse with a moving point, and of two such (include/vesica/cast/quick_round_hit.hpp).
// A circle is an ellipse with the axis (1, 0).
#pragma once

#include "kernels/cast_scene.hpp"

namespace vesica {
namespace {

using EllipseLanes = detail::cast::QuickEllipse<Doubles>;

VESICA_INLINE EllipseLanes ellipse_lanes(const SideColumns& side, std::int32_t i) noexcept {
  return {load(side.ux.to, i), load(side.uy.to, i), load(side.hx.to, i), load(side.hy.to, i)};
}

/// ray: b is a point.
template <bool ray>
void cast_rounds(const CastColumns& columns, std::int32_t n, double* const* results) noexcept {
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const WayLanes way = way_lanes(columns, i);
    const EllipseLanes a = ellipse_lanes(columns.a, i);
    CastMask settled = both(way.plain, a.is_usual());
    FloorLanes floor;
    detail::cast::QuickPlace<Doubles> place;
    if constexpr (ray) {
      const auto asked = a.ask<LaneProducts>(way.d, way.v);
      floor = detail::cast::floor_of(asked.time.value, asked.time.error);
      place = detail::cast::round_place<LaneProducts>(a, asked, way.d, way.v, floor.t);
    } else {
      const EllipseLanes b = ellipse_lanes(columns.b, i);
      settled = both(settled, b.is_usual());
      const auto met = detail::cast::ellipses_meeting<LaneProducts>(a, b, way.d, way.v, negated<Doubles>(settled));
      floor = met.floor;
      place = met.place;
    }
    settled = both(settled, both(floor.certain, place.certain));
    store_impacts(columns, i, floor.t, place.at, place.normal.x.high, place.normal.y.high, settled, results);
  }
}

}  // namespace
}  // namespace vesica
