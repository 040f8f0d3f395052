// SPDX-License-Identifier: Apache-2.0
/// Numbers beyond what a guard expects, and shapes that are not valid.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "filter/inputs.hpp"

namespace inputs {

/// Any bit pattern, or one of the format's landmarks; not always finite.
template <class V>
V any_number(properties::Random& random) {
  using Limits = std::numeric_limits<V>;
  using Bits = std::conditional_t<sizeof(V) == 4, std::uint32_t, std::uint64_t>;
  const V landmarks[] = {
      0, 1, Limits::denorm_min(), Limits::min(), Limits::max(), Limits::infinity(), Limits::quiet_NaN()};
  const V x = random.chance(0.03) ? landmarks[random.below(7)] : std::bit_cast<V>(static_cast<Bits>(random.bits()));
  return random.chance(0.5) ? -x : x;
}

/// Signs and order of a shape's numbers as a valid shape has them, most of the time.
template <class V>
void mend(vesica::Kind kind, V* shape, properties::Random& random) {
  if (random.chance(0.02)) return;
  const std::string_view role = roles[static_cast<int>(kind)];
  for (std::size_t i = 0; i < role.size(); ++i) {
    if (role[i] == 's') shape[i] = std::abs(shape[i]);
  }
  if (kind != vesica::Kind::aabb) return;
  if (shape[0] > shape[2]) std::swap(shape[0], shape[2]);
  if (shape[1] > shape[3]) std::swap(shape[1], shape[3]);
}

/// Breaks one number of a valid pair, in most cases so that a shape is invalid.
template <class V>
void spoil(Numbers<V>& n, int first_count, int count, properties::Random& random) {
  using Limits = std::numeric_limits<V>;
  V& x = n[random.below(count)];
  const V bad[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), -x, -Limits::denorm_min(), 0};
  x = bad[random.below(6)];
  const bool has_axis = count - first_count == 6;
  if (has_axis && random.chance(0.1)) n[first_count + 2] = n[first_count + 3] = 0;
}

/// One number moved by up to 32 places, up or down.
template <class V>
void move_one(Numbers<V>& n, int count, properties::Random& random) {
  V& x = n[random.below(count)];
  const int places = random.integer(1, 1 << random.below(6));
  x = places_from(x, random.chance(0.5) ? places : -places);
}

}  // namespace inputs
