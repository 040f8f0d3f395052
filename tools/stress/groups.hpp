// SPDX-License-Identifier: Apache-2.0
/// Pairs to attack with: about contacts, where answers change.
#pragma once

#include <cstdint>
#include <vector>

#include "stress/query.hpp"

namespace stress {

/// Pairs of the same two kinds and one scalar type.
struct Group {
  Scalar scalar;
  std::vector<Pair> pairs;
};

/// The source of a group's first pair.
enum class Drawn { all, needles, ties };

/// The group of a seed and a number, the same in every run of one build. All shapes are valid.
///
/// A random pair is drawn, thinned, shrunk, moved, scaled or degraded; one in eight has an exponent of its own for
/// every number. With Drawn::needles the pair comes from draw_needle_pair(), in double; if it is not valid, the
/// group is empty. Then one number is bisected to where the library's answer (overlap, or the relation) changes, and
/// the pair is taken with neighbours of that number up to 64 places away, and some further, exchanged, mirrored or
/// turned. With Drawn::ties the group has eight pairs of draw_tie_pair(), less those that are not valid.
Group draw_group(std::uint64_t seed, std::uint64_t number, Drawn from = Drawn::all);

/// The pair with one number that makes a shape invalid.
Pair broken(const Pair& pair, std::uint64_t random_bits);

}  // namespace stress
