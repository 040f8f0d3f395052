// SPDX-License-Identifier: Apache-2.0
/// Pairs of shapes for the named methods, and counts of what a method answers.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "properties/generators.hpp"

namespace method_pairs {

using properties::Pair;
using properties::Random;
using properties::Scalar;

/// A method as a function of the pair's flat numbers.
using Method = std::function<std::int32_t(const Pair&)>;

/// The answer of the exact default.
std::int32_t truth(Scalar scalar, const Pair& pair);

/// The pair with its second shape moved along the line from the first one's place until they touch, then apart or
/// together by `relative_gap` of the distance.
Pair moved_near_contact(const Pair& pair, Scalar scalar, double relative_gap, Random& random);

/// A random pair so moved.
Pair near_tangent(int kind_a, int kind_b, Scalar scalar, double relative_gap, Random& random);

/// True if the pair's answer changes between sizes (for a segment, its ends' distances from the middle) times 1 - gap
/// and 1 + gap: a method may err here, nowhere else.
bool within_gap(const Pair& pair, double gap);

/// The gap from which on a method's rounding must not matter: 1e-9, and for floats as many roundings.
double decided_gap(Scalar scalar);

struct Counts {
  std::int64_t cases = 0, overlapping = 0, wrong = 0, uncertain = 0, wrong_beyond_gap = 0;
  std::int64_t refused = 0;  ///< answered by an error: a result beyond the range of numbers
  std::string first_wrong;   ///< the first one beyond the gap, to be pasted into a test
};

/// Runs the method on every pair.
Counts count(const Method& method, Scalar scalar, std::int64_t cases, const std::function<Pair()>& next);

/// Cases of one workload, times VESICA_REPEAT.
Counts count(const Method& method, properties::Workload workload, int kind_a, int kind_b, Scalar scalar, int cases);

/// Near-tangent cases, times VESICA_REPEAT.
Counts count_near_tangent(const Method& method, double relative_gap, int kind_a, int kind_b, Scalar scalar, int cases);

/// One line on the test's output: method, workload, cases, wrong, uncertain, missed overlaps.
void print(const std::string& method, Scalar scalar, const std::string& workload, const Counts& counts);

/// The gaps that near-tangent counts are printed for.
inline constexpr std::array gaps{1e-6, 1e-9, 1e-12};

}  // namespace method_pairs
