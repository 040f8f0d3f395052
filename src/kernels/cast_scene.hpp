// SPDX-License-Identifier: Apache-2.0
// Shared by the kernels of first contacts: how they read a pair and write what was found. Points and normals are made
// of the operations of the scalar functions in their order, so that bits are the same. The time is the one double that
// is right, whichever way it is found.
#pragma once

#include <limits>
#include <type_traits>
#include <vesica/cast/fast_round_hit.hpp>

#include "kernels/cast_filter.hpp"

namespace vesica {
namespace {

using detail::arithmetic::exact_difference;
using detail::arithmetic::exact_sum;
using detail::cast::is_plain;
using detail::cast::is_plain_size;
using detail::nearest::negated;
using TwofoldLanes = detail::arithmetic::Twofold<Doubles>;
using VectorLanes = detail::arithmetic::Vector<Doubles>;
using OffsetLanes = detail::cast::OffsetOf<Doubles>;
using FloorLanes = detail::cast::Floor<Doubles>;
using LaneProducts =
    std::conditional_t<detail::arithmetic::HasFused<Doubles>, detail::cast::FusedProducts, detail::cast::SplitProducts>;

/// As form::twice_offset() has it.
VESICA_INLINE TwofoldLanes exact_offset(Doubles to0, Doubles to1, Doubles from0, Doubles from1) noexcept {
  const TwofoldLanes first = exact_difference(to0, from0), second = exact_difference(to1, from1);
  const TwofoldLanes sum = exact_sum(first.high, second.high);
  const TwofoldLanes twice = exact_sum(sum.high, sum.low + (first.low + second.low));
  return {Doubles(0.5) * twice.high, Doubles(0.5) * twice.low};
}

/// The offset of the centres and the velocity, and whether both are plain (cast/fast_numbers.hpp).
struct WayLanes {
  VectorLanes d;
  OffsetLanes v;
  CastMask plain;
};
VESICA_INLINE WayLanes way_lanes(const CastColumns& columns, std::int32_t i) noexcept {
  const SideColumns &a = columns.a, &b = columns.b;
  WayLanes way{{exact_offset(load(b.x0, i), load(b.x1, i), load(a.x0, i), load(a.x1, i)),
                exact_offset(load(b.y0, i), load(b.y1, i), load(a.y0, i), load(a.y1, i))},
               {Doubles::load(columns.vx + i), Doubles::load(columns.vy + i)},
               {}};
  way.plain = both(is_plain(way.d, way.v), is_plain_size(abs(way.v.x) + abs(way.v.y)));
  return way;
}

/// support_minimum::located_coordinate(), where nothing is large.
VESICA_INLINE Doubles located_lanes(Doubles from, Doubles to, Doubles offset) noexcept {
  const TwofoldLanes twice = exact_sum(from, to), all = exact_sum(twice.high, Doubles(2.0) * offset);
  return Doubles(0.5) * (all.high + (all.low + twice.low)) + Doubles(0.0);
}

/// Writes what was found, from the time to the normal: NaN for a time that is not settled, infinity for a miss.
VESICA_INLINE void store_impacts(const CastColumns& columns, std::int32_t i, Doubles time, const OffsetLanes& at,
                                 Doubles nx, Doubles ny, CastMask settled, double* const* results) noexcept {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), never = std::numeric_limits<double>::infinity();
  const Doubles end(columns.end), none(nan), infinity(never), zero(0.0), large(0x1p1000);
  const SideColumns& a = columns.a;
  const Doubles x0 = load(a.x0, i), x1 = load(a.x1, i), y0 = load(a.y0, i), y1 = load(a.y1, i);
  settled = both(settled, both(abs(x0) + abs(x1) < large, abs(y0) + abs(y1) < large));
  // Exactly at the end, the exact stage decides.
  const Doubles t = select(time < end, time, select(time > end, infinity, none)), length = sqrt(nx * nx + ny * ny);
  select(settled, t, none).store(results[0] + i);
  located_lanes(x0, x1, at.x).store(results[1] + i);
  located_lanes(y0, y1, at.y).store(results[2] + i);
  (nx / length + zero).store(results[3] + i);
  (ny / length + zero).store(results[4] + i);
}

}  // namespace
}  // namespace vesica
