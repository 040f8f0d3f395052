// SPDX-License-Identifier: Apache-2.0
/// The pairs that the named methods are measured on: ordinary pairs, and those that arithmetic finds hard.
#pragma once

#include <array>

#include "workloads.hpp"

namespace vesica::bench::methods {

enum class Trial {
  random,   ///< sizes 1/4 to 1, about half of the pairs overlap
  near_6,   ///< moved along the line of centres until they touch, then apart or together by 1e-6 of the distance
  near_12,  ///< the same by 1e-12
  contact,  ///< the last double of that distance at which they touch, or the next one
  thin,     ///< aspects of 1e2 to 1e6, at 1/2 to 3/2 of the distance at which they touch
  far,      ///< random, 1e12 from the origin
  tiny,     ///< random, lengths times 2^-1060: subnormal, with few bits left
  huge,     ///< random, lengths times 2^1000
};

inline constexpr std::array trials{Trial::random, Trial::near_6, Trial::near_12, Trial::contact,
                                   Trial::thin,   Trial::far,    Trial::tiny,    Trial::huge};

const char* name_of(Trial trial);

/// True if rectangles and ellipses have any axes, or all the same.
enum class Axes { any, parallel };

/// The kinds that a pool is of, and what its shapes share.
struct Kinds {
  std::int32_t a, b;
  Axes axes;

  bool operator==(const Kinds&) const = default;
};

/// A function of its arguments alone, of at most `size` shapes a side; that must be a power of two.
Pool make_pool(const Kinds& kinds, Trial trial, std::uint64_t seed, std::size_t size = 1 << 16);

}  // namespace vesica::bench::methods
