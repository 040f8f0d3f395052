// SPDX-License-Identifier: Apache-2.0
/// Moving pairs of small numbers: most at random, the others built so that a rational point of one outline meets one of
/// the other's at a time that is known.
#pragma once

#include "cast/face.hpp"
#include "properties/random.hpp"

namespace swept {

enum class Class {
  random,         ///< on a grid
  at_a_time,      ///< first or last contact at a known time, often the end
  beside_a_time,  ///< the same, one number changed by 2^-3 to 2^-60
  grazing,        ///< the velocity is along both outlines where they meet
  beside,         ///< the same, one number changed so
};

struct Case {
  cast_test::Pair pair;
  cast_test::Motion motion;
  Class kind;
  /// Of those built, before a number is changed: there is contact at this time, and b lies on the positive side along
  /// the normal, but for what they share.
  double meeting = 0, nx = 0, ny = 0;
};

/// The shapes valid, all numbers of the scalar type, and without overflow or underflow.
Case draw(int kind_a, int kind_b, cast_test::Scalar scalar, properties::Random& random);

}  // namespace swept
