// SPDX-License-Identifier: Apache-2.0
// Which pairs of kinds have kernels of first contacts: boxes, a ray at anything, and round shapes.
#pragma once

#include "kernels/cast_boxes.hpp"
#include "kernels/cast_rounds.hpp"

namespace vesica {
namespace {

consteval CastTable make_cast_table() noexcept {
  CastTable table{filter_casts, {}};
  // Two lanes find a contact no faster than the scalar functions do.
  if constexpr (Doubles::width > 2) {
    constexpr Kind boxes[] = {Kind::segment, Kind::aabb, Kind::rect}, rounds[] = {Kind::circle, Kind::ellipse};
    const auto enter = [&table](Kind a, Kind b, CastKernel kernel) {
      table.contact[static_cast<int>(a)][static_cast<int>(b)] = kernel;
    };
    for (const Kind a : boxes) {
      enter(a, Kind::point, cast_boxes<true>);
      enter(Kind::point, a, cast_boxes<false>);
      for (const Kind b : boxes) enter(a, b, cast_boxes<false>);
    }
    for (const Kind a : rounds) {
      enter(a, Kind::point, cast_rounds<true>);
      for (const Kind b : rounds) enter(a, b, cast_rounds<false>);
    }
  }
  return table;
}

}  // namespace
}  // namespace vesica
