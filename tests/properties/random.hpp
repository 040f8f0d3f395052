// SPDX-License-Identifier: Apache-2.0
/// Random numbers that are the same on every platform, and the two environment variables random tests obey.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

namespace properties {

/// VESICA_SEED, any integer; unset, a fixed seed, so that the default run is the same everywhere.
inline std::uint64_t seed() {
  const char* text = std::getenv("VESICA_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 20240229;
}

/// VESICA_REPEAT, a factor on the number of cases of every random test; unset or below 1, 1.
inline int repeat() {
  const char* text = std::getenv("VESICA_REPEAT");
  const long value = text != nullptr ? std::strtol(text, nullptr, 0) : 1;
  return value < 1 ? 1 : static_cast<int>(value);
}

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
