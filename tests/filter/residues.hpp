// SPDX-License-Identifier: Apache-2.0
/// What contacts in integers decide, in near and in far units, or by leading and by all limbs, and how often they are
/// wrong.
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vesica/overlap.hpp>

#include "oracle/oracle.hpp"
#include "properties/random.hpp"

namespace vesica::filter_test {

using properties::Random;

inline constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

struct Counts {
  int asked = 0, near = 0, far = 0, wrong = 0, overlap = 0;
};

/// The second is no answer where the pair is known in one way alone.
template <class A, class B>
std::pair<filter::Verdict<bool>, filter::Verdict<bool>> both_verdicts(const A& a, const B& b) {
  if constexpr (filter::HasAxes<A, B>) {
    return {filter::by_axes<filter::Limbs::leading>(a, b), filter::by_axes<filter::Limbs::all>(a, b)};
  } else if constexpr (filter::HasSquares<A, B>) {
    return {filter::by_squares(a, b), {false, false}};
  } else if constexpr (filter::HasResidues<A, B, filter::FarUnit>) {
    return {filter::by_residues<filter::NearUnit>(a, b), filter::by_residues<filter::FarUnit>(a, b)};
  } else {
    return {filter::by_residues<filter::NearUnit>(a, b), {false, false}};
  }
}

template <class A, class B>
void ask(const A& a, const B& b, Counts& counts) {
  constexpr int kind_a = static_cast<int>(ShapeTraits<A>::kind), kind_b = static_cast<int>(ShapeTraits<B>::kind);
  if (check(a) != 0 || check(b) != 0) return;
  const auto [near, far] = both_verdicts(a, b);
  const bool truth =
      oracle::overlap(kind_a, reinterpret_cast<const double*>(&a), kind_b, reinterpret_cast<const double*>(&b));
  ++counts.asked;
  counts.overlap += truth;
  counts.near += near.overlap || near.disjoint;
  counts.far += far.overlap || far.disjoint;
  for (const auto& verdict : {near, far}) counts.wrong += truth ? verdict.disjoint : verdict.overlap;
}

template <class A, class B>
bool decided(const A& a, const B& b) {
  const auto [near, far] = both_verdicts(a, b);
  return near.overlap || near.disjoint || far.overlap || far.disjoint;
}

/// A number up to two places away.
inline double neighbour(double x, Random& random) {
  for (int places = random.integer(0, 2); places > 0; --places) x = std::nextafter(x, random.chance(0.5) ? inf : -inf);
  return x;
}

}  // namespace vesica::filter_test
