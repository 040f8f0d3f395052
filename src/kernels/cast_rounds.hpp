// SPDX-License-Identifier: Apache-2.0
// First contacts of a circle or an ellipse with a point or with another such shape; one of them moves
// (ellipses_meeting() of include/vesica/cast/fast_round_hit.hpp). A circle is an ellipse with the axis (1, 0).
#pragma once

#include "kernels/cast_scene.hpp"

namespace vesica {
namespace {

using EllipseLanes = detail::cast::FastEllipse<Doubles>;

VESICA_INLINE EllipseLanes ellipse_lanes(const SideColumns& side, std::int32_t i) noexcept {
  return {load(side.ux.to, i), load(side.uy.to, i), load(side.hx.to, i), load(side.hy.to, i)};
}

VESICA_KERNEL void cast_rounds(const CastColumns& columns, std::int32_t n, double* const* results) noexcept {
  const bool at_point = columns.a.is_point, of_point = at_point || columns.b.is_point;
  const SideColumns &first = at_point ? columns.b : columns.a, &second = at_point ? columns.a : columns.b;
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const WayLanes way = way_lanes(columns, i);
    const EllipseLanes a = ellipse_lanes(first, i), b = ellipse_lanes(second, i);
    CastMask usual = both(way.plain, a.is_usual());
    if (!of_point) usual = both(usual, b.is_usual());
    auto met = detail::cast::ellipses_meeting<LaneProducts>(a, b, way.d, way.v, negated<Doubles>(usual), of_point);
    const Doubles nx = met.normal.x.high, ny = met.normal.y.high, least(0x1p-24), zero(0.0);
    // As detail::cast::ends_at() has it.
    if (of_point) usual = both(usual, both(abs(nx) > least * abs(ny), abs(ny) > least * abs(nx)));
    if (at_point) met.at = {zero, zero};
    store_impacts(columns, i, met.floor.t, met.at, nx, ny, both(usual, met.floor.certain), results);
  }
}

}  // namespace
}  // namespace vesica
