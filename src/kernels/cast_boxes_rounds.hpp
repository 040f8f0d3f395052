// SPDX-License-Identifier: Apache-2.0
// First contacts of a box with a circle or an ellipse, either of which moves (box_round_meeting() of
// include/vesica/cast/quick_box_round_hit.hpp).
#pragma once

#include <vesica/cast/quick_box_round_hit.hpp>

#include "kernels/cast_boxes.hpp"
#include "kernels/cast_rounds.hpp"

namespace vesica {
namespace {

VESICA_KERNEL void cast_boxes_rounds(const CastColumns& columns, std::int32_t n, double* const* results) noexcept {
  const bool box_first = columns.b.round;
  const SideColumns &boxes = box_first ? columns.a : columns.b, &rounds = box_first ? columns.b : columns.a;
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const WayLanes way = way_lanes(columns, i);
    const BoxLanes box = box_lanes(boxes, i);
    const EllipseLanes round = ellipse_lanes(rounds, i);
    const auto met = detail::cast::box_round_meeting<LaneProducts>(box, round, way.d, way.v);
    const Doubles nx = met.normal.x.high, ny = met.normal.y.high, zero(0.0);
    const FloorLanes floor = detail::cast::floor_of(met.time, met.error);
    CastMask settled =
        both(both(way.plain, both(met.certain, floor.certain)), both(is_plain_box(box), round.is_usual()));
    OffsetLanes at = round.out_of_frame(detail::cast::foremost_of(round.a, round.b, met.in_frame.x, met.in_frame.y));
    if (box_first) {
      const ForemostLanes of_box = foremost_lanes(box, nx, ny, met.face, negated<Doubles>(met.lengthwise));
      const OffsetLanes on_face = point_on_edge(of_box, {{-at.x, -at.y}, {zero, zero}, met.face},
                                                way.d.x.high + floor.t * way.v.x, way.d.y.high + floor.t * way.v.y);
      at = {select(met.face, on_face.x, of_box.middle.x), select(met.face, on_face.y, of_box.middle.y)};
      settled = both(settled, of_box.known);
    }
    store_impacts(columns, i, floor.t, at, nx, ny, settled, results);
  }
}

}  // namespace
}  // namespace vesica
