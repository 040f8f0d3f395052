// SPDX-License-Identifier: Apache-2.0
/// Workloads: endless seeded streams of pairs of shapes of two given kinds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "oracle/oracle.hpp"
#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace properties {

enum class Workload {
  random,        ///< sizes and distances about 1, about half overlap
  near_contact,  ///< one number of another workload's pair bisected to contact, and the numbers up to 4 places about
  touching,      ///< contact at a rational point by construction, most with one number moved one place; all scales
  degenerate,    ///< zero sizes, equal shapes, shared centres, corners and end points
  grid,          ///< small integers, where boxes touch often
  thin,          ///< aspect ratios up to 1e12 (float: 1e6), needles to 2^990 by 2^-990 (float: 2^120), in parallel too
  far,           ///< sizes about 1, up to 1e15 (float: 1e7) from the origin
  tiny,          ///< lengths down to 2^-1060 (float: 2^-140), whose numbers are subnormal
  huge,          ///< lengths up to 2^1000 (float: 2^120)
  mixed_scale,   ///< every number of its own magnitude, over the whole finite range
  axis_length,   ///< axes of any stored length, 2^-400 to 2^400 (float: 2^-50 to 2^50)
};

inline constexpr std::array all_workloads{Workload::random,      Workload::near_contact, Workload::touching,
                                          Workload::degenerate,  Workload::grid,         Workload::thin,
                                          Workload::far,         Workload::tiny,         Workload::huge,
                                          Workload::mixed_scale, Workload::axis_length};

const char* name(Workload workload);

/// The predicate that near_contact bisects: the oracle by default, or a quicker one.
using Decide = bool (*)(int kind_a, const double* a, int kind_b, const double* b);

/// Every pair is valid and its numbers are of the scalar type. Same arguments, same pairs in one build (cosines are the
/// mathematics library's, and a compiler may draw the operands of a product in either order).
class Stream {
 public:
  Stream(Workload workload, int kind_a, int kind_b, Scalar scalar, std::uint64_t seed, Decide decide = oracle::overlap);
  Pair next();

 private:
  Workload workload_;
  int kind_a_, kind_b_;
  Scalar scalar_;
  Random random_;
  Decide decide_;
  std::vector<Pair> pending_;
  std::size_t next_pending_ = 0;
};

/// One pair of any workload but near_contact.
Pair draw(Workload workload, int kind_a, int kind_b, Scalar scalar, Random& random);

/// Two shapes that share exactly the points of a line across (normal_x, normal_y), a on its one side and b on its
/// other: b moved along the normal is disjoint. All numbers are integers below 2^20.
struct Contact {
  Pair pair;
  double normal_x, normal_y;
};
Contact touching(int kind_a, int kind_b, Random& random);

/// Two shapes that share a point and a line through it that neither crosses, both on one side of it: one may hold the
/// other and touch its outline from inside. All numbers are integers below 2^20.
Pair touching_from_one_side(int kind_a, int kind_b, Random& random);

/// Pairs about one contact: one number of `base` bisected until neighbours differ in the answer, then up to 4 places to
/// either side; then other numbers one place off. Nothing when no such number is found.
std::vector<Pair> about_contact(const Pair& base, Scalar scalar, Random& random, Decide decide);

/// The same from some pair of another workload.
std::vector<Pair> near_contact(int kind_a, int kind_b, Scalar scalar, Random& random, Decide decide);

}  // namespace properties
