// SPDX-License-Identifier: Apache-2.0
/// The law of methods that may answer "uncertain": any other answer is true, near contact too.
#pragma once

#include <string>

#include "methods/typed_method.hpp"

namespace method_pairs {

/// Every workload, in both scalars: with 11 workloads and three gaps, 14 runs each.
inline void expect_never_wrong(const std::string& name, const Method& method, int kind_a, int kind_b, Scalar scalar,
                               int cases) {
  for (const properties::Workload workload : properties::all_workloads) {
    const Counts counts = count(method, workload, kind_a, kind_b, scalar, cases);
    print(name, scalar, properties::name(workload), counts);
    EXPECT_EQ(counts.wrong, 0) << properties::name(workload) << ", VESICA_SEED=" << properties::seed();
    EXPECT_EQ(counts.refused, 0) << properties::name(workload);
    if (properties::draws_all()) {
      EXPECT_LT(counts.uncertain, counts.cases) << properties::name(workload);
    }
  }
  for (const double gap : gaps) {
    const Counts counts = count_near_tangent(method, gap, kind_a, kind_b, scalar, cases);
    print(name, scalar, "near tangent " + std::to_string(static_cast<int>(std::log10(gap) - 0.5)), counts);
    EXPECT_EQ(counts.wrong, 0) << gap << ", VESICA_SEED=" << properties::seed();
  }
}

}  // namespace method_pairs
