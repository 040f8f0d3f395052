// SPDX-License-Identifier: Apache-2.0
// First contacts of a circle or an ellipse with a moving point or with another such shape (ellipses_meeting() of
// include/vesica/cast/quick_round_hit.hpp). A circle is an ellipse with the axis (1, 0).
#pragma once

#include "kernels/cast_scene.hpp"

namespace vesica {
namespace {

using EllipseLanes = detail::cast::QuickEllipse<Doubles>;

VESICA_INLINE EllipseLanes ellipse_lanes(const SideColumns& side, std::int32_t i) noexcept {
  return {load(side.ux.to, i), load(side.uy.to, i), load(side.hx.to, i), load(side.hy.to, i)};
}

VESICA_KERNEL void cast_rounds(const CastColumns& columns, std::int32_t n, double* const* results) noexcept {
  const bool ray = columns.b.is_point;
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const WayLanes way = way_lanes(columns, i);
    const EllipseLanes a = ellipse_lanes(columns.a, i), b = ellipse_lanes(columns.b, i);
    CastMask usual = both(way.plain, a.is_usual());
    if (!ray) usual = both(usual, b.is_usual());
    const auto met = detail::cast::ellipses_meeting<LaneProducts>(a, b, way.d, way.v, negated<Doubles>(usual), ray);
    const Doubles nx = met.normal.x.high, ny = met.normal.y.high, least(0x1p-24);
    // As detail::cast::ends_at() has it.
    if (ray) usual = both(usual, both(abs(nx) > least * abs(ny), abs(ny) > least * abs(nx)));
    store_impacts(columns, i, met.floor.t, met.at, nx, ny, both(usual, met.floor.certain), results);
  }
}

}  // namespace
}  // namespace vesica
