// SPDX-License-Identifier: Apache-2.0
// The filter of casts (include/vesica/cast/filter.hpp, where its bounds are proved) for a vector of pairs of any kinds.
#pragma once

#include <vesica/filter/estimate.hpp>
#include <vesica/nearest/support.hpp>

#include "kernels/cast_columns.hpp"

namespace vesica {
namespace {

using CastMask = detail::nearest::MaskOf<Doubles>;

VESICA_INLINE Doubles load(const Column& column, std::int32_t i) noexcept {
  return Doubles::load(column.at + i * column.step);
}
VESICA_INLINE Doubles load(const ColumnDifference& d, std::int32_t i) noexcept {
  return load(d.to, i) - load(d.from, i);
}

/// One operand's part of detail::cast::Sketch and Reach, and a mask: is it usable?
struct SketchLanes {
  Doubles h, h_error, forward, size;
  CastMask usable;
};

VESICA_INLINE SketchLanes form_lanes(const SideColumns& side, std::int32_t i, Doubles vx, Doubles vy,
                                     Doubles speed) noexcept {
  const Doubles zero(0.0), ux = load(side.ux, i), uy = load(side.uy, i), hx = load(side.hx, i), hy = load(side.hy, i);
  const Doubles length = abs(ux) + abs(uy), shorter = min(hx, hy), sizes = hx + hy;
  CastMask usable =
      both(side.round ? shorter > zero : shorter >= zero, filter::in_range(sizes, zero, Doubles(0x1p200)));
  CastMask axis = filter::in_range(length, Doubles(0x1p-200), Doubles(0x1p200));
  if (side.may_vanish) axis = either(axis, length == zero);
  usable = both(usable, axis);
  const Doubles c = ux * vx + uy * vy, k = ux * vy - uy * vx, size = sizes * (length * speed);
  const Doubles p = hx * k, q = hy * c, p_along = hx * c, q_along = hy * k;
  if (!side.round) {
    return {abs(p) + abs(q), Doubles(0x1p-49) * size, abs(p_along) + abs(q_along), size, usable};
  }
  const Doubles h = sqrt(p * p + q * q);
  const Doubles forward = side.disc ? h : sqrt(p_along * p_along + q_along * q_along);  // of a disc the same
  return {h, Doubles(0x1.8p-50) * size, forward, size, both(usable, size >= Doubles(0x1p-400))};
}
/// The same with a radius, which reaches as far across v as along it.
VESICA_INLINE SketchLanes sketch_lanes(const SideColumns& side, std::int32_t i, Doubles vx, Doubles vy,
                                       Doubles speed) noexcept {
  SketchLanes out = form_lanes(side, i, vx, vy, speed);
  if (!side.has_radius) return out;
  const Doubles radius = load(side.radius, i), around = radius * sqrt(vx * vx + vy * vy);
  out.h = out.h + around;
  out.h_error = out.h_error + Doubles(0x1p-50) * around;
  out.forward = out.forward + around;
  out.usable = both(out.usable, filter::in_range(radius, Doubles(0.0), Doubles(0x1p200)));
  return out;
}

VESICA_INLINE Doubles offset_lanes(Doubles to0, Doubles to1, Doubles from0, Doubles from1) noexcept {
  return Doubles(0.5) * ((to0 - from0) + (to1 - from1));
}

/// See CastFilter. A line that crosses the sum enters it; a kernel that finds when, after the start, has found that the
/// shapes are apart before.
struct CastVerdict {
  CastMask missed, meets;
};

VESICA_INLINE CastVerdict cast_verdict(const CastColumns& columns, std::int32_t i) noexcept {
  const SideColumns &ca = columns.a, &cb = columns.b;
  const Doubles u(0x1p-53), zero(0.0), vx = Doubles::load(columns.vx + i), vy = Doubles::load(columns.vy + i);
  const Doubles speed = abs(vx) + abs(vy);
  const Doubles dx = offset_lanes(load(cb.x0, i), load(cb.x1, i), load(ca.x0, i), load(ca.x1, i));
  const Doubles dy = offset_lanes(load(cb.y0, i), load(cb.y1, i), load(ca.y0, i), load(ca.y1, i));
  const SketchLanes a = sketch_lanes(ca, i, vx, vy, speed);
  SketchLanes b{zero, zero, zero, zero, zero <= zero};
  if (!cb.is_point) b = sketch_lanes(cb, i, vx, vy, speed);
  const Doubles size = a.size + b.size, distance = abs(dx) + abs(dy), d_size = distance * speed;
  CastMask usable = both(both(a.usable, b.usable), filter::in_range(speed, Doubles(0x1p-200), Doubles(0x1p200)));
  usable = both(usable, both(distance <= Doubles(0x1p200), size + d_size >= Doubles(0x1p-400)));

  const Doubles w = vx * dy - vy * dx, q = vx * dx + vy * dy,
                d_error = u * (Doubles(6.0) * d_size + Doubles(2.0) * size);
  const Doubles h = a.h + b.h, h_error = a.h_error + b.h_error + Doubles(4.0) * u * h, gap = abs(w) - h;
  const Doubles forward = a.forward + b.forward;
  const Doubles forward_error = d_error + h_error + Doubles(4.0) * u * forward, before = -q - forward;
  CastMask missed = either(gap > d_error + h_error, q - forward > forward_error);
  if (columns.end <= 0x1p200) {
    const Doubles whole = Doubles(columns.end) * (vx * vx + vy * vy);
    missed = either(missed, before - whole > forward_error + Doubles(8.0) * u * whole);
  }
  missed = both(usable, missed);
  return {missed, and_not(both(usable, gap < -(d_error + h_error)), missed)};
}

VESICA_KERNEL void filter_casts(const CastColumns& columns, std::int32_t n, const CastBytes& out) noexcept {
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const CastVerdict verdict = cast_verdict(columns, i);
    store_bytes(verdict.missed, out.missed + i);
    store_bytes(verdict.meets, out.meets + i);
  }
}

}  // namespace
}  // namespace vesica
