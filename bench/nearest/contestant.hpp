// SPDX-License-Identifier: Apache-2.0
/// Ways to ask how far two disjoint shapes are apart, for the table of vesica_nearest. Each has its own copies of the
/// pairs, made beforehand; only the question is timed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "nearest/outline_pairs.hpp"

namespace vesica::bench {

/// Pairs of two kinds in a contestant's own form.
class DistancePairs {
 public:
  virtual ~DistancePairs() = default;
  virtual double distance(std::size_t pair) = 0;
  /// The sum of the distances of `count` pairs: the loop that is timed.
  virtual double sum(std::size_t first, std::size_t count) {
    double result = 0;
    for (std::size_t i = first; i < first + count; ++i) result += distance(i);
    return result;
  }
};

struct Contestant {
  std::string name;
  bool (*answers)(std::int32_t kind_a, std::int32_t kind_b);
  std::unique_ptr<DistancePairs> (*make)(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs);
  std::size_t passes;  ///< of 256 pairs; slow ones have fewer
};

/// In the order of the table, the library first; those that were built in.
std::vector<Contestant>& contestants();
bool add_contestant(Contestant contestant);

inline bool any_kinds(std::int32_t, std::int32_t) { return true; }

struct PlanePoint {
  double x, y;
};

/// A rectangle's corners, 64 points of a circle or an ellipse; counter-clockwise, the first one not repeated.
std::vector<PlanePoint> outline_of(std::int32_t kind, const Numbers& shape);

}  // namespace vesica::bench
