// SPDX-License-Identifier: Apache-2.0
/// Random numbers that are the same on every platform, and the two environment variables random tests obey.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdlib>
#include <random>

namespace properties {

/// VESICA_SEED, any integer; unset, a fixed seed, so that the default run is the same everywhere.
inline std::uint64_t seed() {
  const char* text = std::getenv("VESICA_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 20240229;
}

/// A factor on the number of cases of a random test. What is few already does not become fewer.
struct Factor {
  double value;

  template <std::integral Count>
  friend Count operator*(Count cases, Factor factor) {
    const auto scaled = static_cast<Count>(static_cast<double>(cases) * factor.value);
    return std::max(scaled, std::min(cases, Count{8}));
  }
};

/// VESICA_REPEAT, such as 10 or 0.25: the factor for every random test; unset or not above 0, 1.
inline Factor repeat() {
  static const double value = [] {
    const char* text = std::getenv("VESICA_REPEAT");
    const double given = text != nullptr ? std::strtod(text, nullptr) : 1;
    return given > 0 ? given : 1;
  }();
  return {value};
}

/// True if random tests draw all of their cases, so that the rare ones must be among them.
inline bool draws_all() { return repeat().value >= 1; }

/// Draws from one seed. The engine's sequence is fixed by the C++ standard; its distributions are not, hence these.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// In [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// In 0 ... count - 1.
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
  int integer(int low, int high) { return low + below(high - low + 1); }
  bool chance(double probability) { return unit() < probability; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace properties
