// SPDX-License-Identifier: Apache-2.0
/// The benchmark's pools are what their names say.
#include "workloads.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace vesica::bench;

double hit_rate(std::int32_t kind_a, std::int32_t kind_b, const Pool& pool) {
  int hits = 0;
  for (std::size_t i = 0; i < pool.a.size(); ++i) {
    const std::int32_t answer = vesica_overlap_f64(kind_a, pool.a[i].data(), kind_b, pool.b[i].data());
    EXPECT_GE(answer, 0) << "invalid shape at " << i;
    hits += answer;
  }
  return hits / static_cast<double>(pool.a.size());
}

/// A rectangle or ellipse inside the given one's interior, one representable number smaller each way.
Numbers shrunk(Numbers numbers) {
  numbers[4] = std::nextafter(numbers[4], 0.0);
  numbers[5] = std::nextafter(numbers[5], 0.0);
  return numbers;
}

TEST(Workloads, EveryPairHasItsHitRates) {
  for (std::int32_t a = VESICA_POINT; a <= VESICA_ELLIPSE; ++a) {
    for (std::int32_t b = a; b <= VESICA_ELLIPSE; ++b) {
      SCOPED_TRACE(testing::Message() << vesica_kind_name(a) << " " << vesica_kind_name(b)
                                      << ", VESICA_SEED=" << seed_of_run());
      EXPECT_NEAR(hit_rate(a, b, make_pool(a, b, Workload::mixed, seed_of_run())), 0.5, 0.05);
      EXPECT_NEAR(hit_rate(a, b, make_pool(a, b, Workload::sparse, seed_of_run())), 0.05, 0.02);
      if (!has_workload(a, b, Workload::near)) continue;
      EXPECT_NEAR(hit_rate(a, b, make_pool(a, b, Workload::near, seed_of_run())), 0.5, 0.05);
    }
  }
}

TEST(Workloads, IncidentPairsMeet) {
  for (const auto& [a, b] : {std::pair(VESICA_POINT, VESICA_SEGMENT), std::pair(VESICA_SEGMENT, VESICA_SEGMENT),
                             std::pair(VESICA_SEGMENT, VESICA_AABB)}) {
    EXPECT_EQ(hit_rate(a, b, make_pool(a, b, Workload::incident, seed_of_run())), 1.0);
  }
}

// They touch, and one that shrinks by the least there is no longer does: so they touch exactly and from outside.
TEST(Workloads, TangentPairsTouchExactly) {
  for (const auto& [a, b] : {std::pair(VESICA_RECT, VESICA_RECT), std::pair(VESICA_RECT, VESICA_ELLIPSE),
                             std::pair(VESICA_ELLIPSE, VESICA_ELLIPSE)}) {
    SCOPED_TRACE(testing::Message() << vesica_kind_name(a) << " " << vesica_kind_name(b)
                                    << ", VESICA_SEED=" << seed_of_run());
    Pool pool = make_pool(a, b, Workload::tangent, seed_of_run());
    EXPECT_EQ(hit_rate(a, b, pool), 1.0);
    for (Numbers& numbers : pool.b) numbers = shrunk(numbers);
    EXPECT_EQ(hit_rate(a, b, pool), 0.0);
  }
}

}  // namespace
