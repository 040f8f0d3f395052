// SPDX-License-Identifier: Apache-2.0
// Which pairs of kinds have kernels of first contacts: all but two points, and an
// ellipse with a capsule or a rounded rectangle.
#pragma once

#include "kernels/cast_cores.hpp"

namespace vesica {
namespace {

consteval CastTable make_cast_table() noexcept {
  CastTable table{filter_casts, {}};
  constexpr Kind boxes[] = {Kind::segment, Kind::aabb, Kind::rect}, rounds[] = {Kind::circle, Kind::ellipse};
  const auto enter = [&table](Kind a, Kind b, CastKernel kernel) {
    table.contact[static_cast<int>(a)][static_cast<int>(b)] = kernel;
  };
  for (const Kind a : boxes) {
    enter(a, Kind::point, cast_boxes);
    enter(Kind::point, a, cast_boxes);
    for (const Kind b : boxes) enter(a, b, cast_boxes);
    for (const Kind b : rounds) {
      enter(a, b, cast_boxes_rounds);
      enter(b, a, cast_boxes_rounds);
    }
  }
  for (const Kind a : rounds) {
    enter(a, Kind::point, cast_rounds);
    enter(Kind::point, a, cast_rounds);
    for (const Kind b : rounds) enter(a, b, cast_rounds);
  }
  for (const Kind a : {Kind::capsule, Kind::round_rect}) {
    for (const Kind b :
         {Kind::point, Kind::circle, Kind::segment, Kind::aabb, Kind::rect, Kind::capsule, Kind::round_rect}) {
      enter(a, b, cast_cores);
      enter(b, a, cast_cores);
    }
  }
  return table;
}

}  // namespace
}  // namespace vesica
