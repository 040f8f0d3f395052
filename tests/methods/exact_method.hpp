// SPDX-License-Identifier: Apache-2.0
/// The promises of every method called exact, and counts of the exceptions.
#pragma once

#include <string>

#include "methods/typed_method.hpp"

namespace method_pairs {

/// Shapes that rounding can misjudge near contact only: nothing wrong beyond the gap.
inline constexpr std::array conditioned{properties::Workload::random, properties::Workload::grid,
                                        properties::Workload::far,    properties::Workload::tiny,
                                        properties::Workload::huge,   properties::Workload::axis_length};
/// Contact on purpose, or needles whose width is below the rounding of their length: counted.
inline constexpr std::array counted{properties::Workload::near_contact, properties::Workload::touching,
                                    properties::Workload::degenerate, properties::Workload::thin,
                                    properties::Workload::mixed_scale};

/// Agreement with the exact default beyond the gap; counts, printed, within it.
inline void expect_exact_beyond_gap(const std::string& name, const Method& method, int kind_a, int kind_b,
                                    Scalar scalar) {
  constexpr int cases = 20000, random_cases = 100000;
  for (const properties::Workload workload : conditioned) {
    const int how_many = workload == properties::Workload::random ? random_cases : cases;
    const Counts counts = count(method, workload, kind_a, kind_b, scalar, how_many);
    print(name, scalar, properties::name(workload), counts);
    EXPECT_GT(counts.overlapping, counts.cases / 20);
    EXPECT_EQ(counts.uncertain, 0);
    EXPECT_EQ(counts.refused, 0);
    EXPECT_EQ(counts.wrong_beyond_gap, 0) << name << ", VESICA_SEED=" << properties::seed() << "\n"
                                          << counts.first_wrong;
  }
  for (const properties::Workload workload : counted) {
    const Counts counts = count(method, workload, kind_a, kind_b, scalar, cases);
    print(name, scalar, properties::name(workload), counts);
    EXPECT_EQ(counts.uncertain, 0);
  }
}

/// Counts at the gaps, printed; in double nothing is wrong at 1e-6 of the distance.
inline void expect_counts_near_tangent(const std::string& name, const Method& method, int kind_a, int kind_b,
                                       Scalar scalar) {
  for (const double gap : gaps) {
    const Counts counts = count_near_tangent(method, gap, kind_a, kind_b, scalar, 20000);
    print(name, scalar, "near tangent " + std::to_string(static_cast<int>(std::log10(gap) - 0.5)), counts);
    EXPECT_EQ(counts.uncertain, 0);
    EXPECT_EQ(counts.refused, 0);
    EXPECT_EQ(counts.wrong_beyond_gap, 0) << name << ", VESICA_SEED=" << properties::seed() << "\n"
                                          << counts.first_wrong;
    if (scalar == Scalar::f64 && gap >= 1e-6) {
      EXPECT_EQ(counts.wrong, 0);
    }
  }
}

}  // namespace method_pairs
