// SPDX-License-Identifier: Apache-2.0
/// Random numbers that are the same on every platform and cheap enough to draw a batch with.
#pragma once

#include <cmath>
#include <cstdint>

namespace vesica::bench {

/// SplitMix64 (Steele, Lea and Flood, 2014): one addition and a mix a number. The standard's engines are portable,
/// its distributions are not.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) noexcept : state_(seed) {}

  constexpr std::uint64_t bits() noexcept {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// A number of [0, 1).
  constexpr double unit() noexcept { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// A number of [low, high).
  constexpr double between(double low, double high) noexcept { return low + (high - low) * unit(); }

  /// An integer of [low, high], as a double; the range must be far below 2^53.
  double integer(double low, double high) noexcept { return low + std::floor((high - low + 1) * unit()); }

  /// An index below `count`, which must be a power of two.
  constexpr std::size_t index(std::size_t count) noexcept { return static_cast<std::size_t>(bits()) & (count - 1); }

  constexpr bool chance(double probability) noexcept { return unit() < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace vesica::bench
