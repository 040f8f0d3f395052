// SPDX-License-Identifier: Apache-2.0
/// Workloads for relations: pairs whose one shape often contains the other, nearly does, or equals it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace relations {

using properties::Pair;
using properties::Random;
using properties::Scalar;

enum class Nesting {
  nested,       ///< pairs of other workloads, one shape made smaller and moved into the other
  near_nested,  ///< one number of a nested pair bisected until containment changes, and the numbers about it
  one_sided,    ///< a common point and tangent line, both shapes on one side, rational; some numbers a place off
  equal,        ///< one shape written in two ways, in half of the pairs one number a place off
  osculating,   ///< circles and ellipses with a three- or four-fold contact, rational; half with a number a place off
};

inline constexpr std::array all_nestings{Nesting::nested, Nesting::near_nested, Nesting::one_sided, Nesting::equal,
                                         Nesting::osculating};

const char* name(Nesting nesting);

/// True if pairs of the two kinds can be nested like that. Only osculation needs certain kinds.
bool exists(Nesting nesting, int kind_a, int kind_b);

/// A stream as properties::Stream.
class NestingStream {
 public:
  NestingStream(Nesting nesting, int kind_a, int kind_b, Scalar scalar, std::uint64_t seed);
  Pair next();

 private:
  Nesting nesting_;
  int kind_a_, kind_b_;
  Scalar scalar_;
  Random random_;
  std::vector<Pair> pending_;
  std::size_t next_pending_ = 0;
};

/// An ellipse and its circle of curvature at a point: a vertex, where the contact is four-fold and one lies in the
/// other; or another, where it is three-fold, and the outlines cross there and once more. Of two circles, one circle
/// twice. All numbers are integers below 2^36.
struct Osculation {
  Pair pair;
  bool four_fold;
};
Osculation osculating_circle(int kind_a, int kind_b, Random& random);

}  // namespace relations
