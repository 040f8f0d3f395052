// SPDX-License-Identifier: Apache-2.0
// Change of grid, in integers and so the same everywhere; and columns of doubles.
#pragma once

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {
namespace {  // compiled for several instruction sets

/// 2^e for -1022 <= e <= 1023.
inline double power_of_two(int e) noexcept {
  return __builtin_bit_cast(double, static_cast<std::uint64_t>(e + 1023) << 52);
}

/// How the columns of one grid become those of another, along one axis. A column q + k of the first is the interval
/// [q + k, q + k + 1) 2^p. With r = p - p': for r < 0 its column in the other is floor((q + k) 2^r), exactly, as
/// floor(floor(x) / 2^m) = floor(x / 2^m). For r >= 0 it spans (q + k) 2^r to (q + k + 1) 2^r - 1: low ends take the
/// first, high ends the last. So what shared a column, or was in order, still is.
struct Change {
  std::int64_t k, other_k;
  int shift;  // p - p'

  Change(const Frame& from, const Frame& to, int axis) noexcept
      : k(from.k[axis]), other_k(to.k[axis]), shift(from.p[axis] - to.p[axis]) {}

  /// |k| and |other_k| are at most 2^50, columns below 2^16. What grows beyond 2^60 is limited to that, which is beyond
  /// every column of the other grid still.
  std::int64_t column(std::int64_t q, int high) const noexcept {
    std::int64_t t = q + k;
    if (shift < 0) {
      t >>= shift < -62 ? 62 : -shift;
    } else {
      t += high;
      constexpr std::int64_t limit = std::int64_t{1} << 60;
      const int s = shift > 62 ? 62 : shift;
      const std::int64_t most = limit >> s;
      t = t > most ? limit : t < -most ? -limit : t * (std::int64_t{1} << s);
      t -= high;
    }
    return t - other_k;
  }
  std::uint16_t low(std::int64_t q) const noexcept {
    const std::int64_t t = column(q, 0);
    return static_cast<std::uint16_t>(t < column_low ? column_low : t > above_all ? above_all : t);
  }
  std::uint16_t high(std::int64_t q) const noexcept {
    const std::int64_t t = column(q, 1);
    return static_cast<std::uint16_t>(t < below_all ? below_all : t > column_high ? column_high : t);
  }
};

/// floor(v 2^-p) for any double but NaN, limited to +-2^51: to nearest by a sum whose last place is 1, then down. A
/// product that underflows to 0 from below is in column -1.
inline double grid_floor(double v, double scale) noexcept {
  constexpr double limit = 0x1p51, rounder = 0x1.8p52;
  // Plain selections, each of one comparison: so loops over this become vectors.
  double t = v * scale;
  t = t > limit ? limit : t;
  t = t < -limit ? -limit : t;
  const double nearest = (t + rounder) - rounder;
  const double above = nearest > t ? 1 : 0, below_zero = v < 0 ? -1 : 0;
  const double floor = nearest - above;
  return t == 0 ? below_zero : floor;
}

/// A box of doubles in a grid's columns. Low ends are at least 1 and high ends at most 65534, so that neither lanes
/// without an item nor anything outside ever match.
inline GridBox to_columns(const Frame& frame, const double (&box)[4]) noexcept {
  std::uint16_t side[4];
  for (int s = 0; s < 4; ++s) {
    const int axis = s & 1;
    const double q = grid_floor(box[s], power_of_two(-frame.p[axis])) - static_cast<double>(frame.k[axis]);
    const double low = s < 2 ? column_low : below_all, high = s < 2 ? above_all : column_high;
    side[s] = static_cast<std::uint16_t>(q < low ? low : q > high ? high : q);
  }
  return {side[0], side[1], side[2], side[3]};
}

}  // namespace
}  // namespace vesica::index
