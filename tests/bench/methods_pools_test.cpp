// SPDX-License-Identifier: Apache-2.0
/// The named methods' trials are what their names say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "methods/pools.hpp"

namespace {

using namespace vesica::bench;
using methods::Axes;
using methods::Kinds;
using methods::Trial;

constexpr Kinds all_kinds[] = {
    {VESICA_RECT, VESICA_RECT, Axes::any},           {VESICA_RECT, VESICA_ELLIPSE, Axes::any},
    {VESICA_CIRCLE, VESICA_ELLIPSE, Axes::any},      {VESICA_SEGMENT, VESICA_CIRCLE, Axes::any},
    {VESICA_ELLIPSE, VESICA_ELLIPSE, Axes::any},     {VESICA_AABB, VESICA_AABB, Axes::any},
    {VESICA_ELLIPSE, VESICA_ELLIPSE, Axes::parallel}};

double hit_rate(const Kinds& kinds, const Pool& pool) {
  int hits = 0;
  for (std::size_t i = 0; i < pool.a.size(); ++i) {
    const std::int32_t answer = vesica_overlap_f64(kinds.a, pool.a[i].data(), kinds.b, pool.b[i].data());
    EXPECT_GE(answer, 0) << "invalid shape at " << i;
    hits += answer;
  }
  return hits / static_cast<double>(pool.a.size());
}

Pool small_pool(const Kinds& kinds, Trial trial) { return methods::make_pool(kinds, trial, seed_of_run(), 1024); }

/// The second shapes are moved towards the first by a part of the distance of centres; for kinds with centres.
double hit_rate_nearer(const Kinds& kinds, Pool pool, double part) {
  for (std::size_t i = 0; i < pool.a.size(); ++i) {
    for (const std::size_t field : {0U, 1U}) pool.b[i][field] -= part * (pool.b[i][field] - pool.a[i][field]);
  }
  return hit_rate(kinds, pool);
}

TEST(MethodsPools, HalfOfThePairsOverlap) {
  for (const Kinds& kinds : all_kinds) {
    for (const Trial trial : methods::trials) {
      SCOPED_TRACE(testing::Message() << vesica_kind_name(kinds.a) << " " << vesica_kind_name(kinds.b) << " "
                                      << methods::name_of(trial) << ", VESICA_SEED=" << seed_of_run());
      // Thinned boxes along the axes keep one corner, so that contact lies anywhere.
      EXPECT_NEAR(hit_rate(kinds, small_pool(kinds, trial)), 0.5, 0.07);
    }
  }
}

TEST(MethodsPools, NearPairsAreAsNearAsTheyAreCalled) {
  const Kinds kinds{VESICA_RECT, VESICA_ELLIPSE, Axes::any};
  const std::pair<Trial, double> gaps[] = {{Trial::near_6, 1e-6}, {Trial::near_12, 1e-12}, {Trial::contact, 1e-15}};
  for (const auto& [trial, gap] : gaps) {
    const Pool pool = small_pool(kinds, trial);
    EXPECT_EQ(hit_rate_nearer(kinds, pool, 2.1 * gap), 1) << gap;
    EXPECT_EQ(hit_rate_nearer(kinds, pool, -2.1 * gap), 0) << gap;
  }
}

TEST(MethodsPools, ThinTinyHugeFarAndParallel) {
  const Kinds kinds{VESICA_RECT, VESICA_ELLIPSE, Axes::any};
  for (const Numbers& rect : small_pool(kinds, Trial::thin).a) {
    EXPECT_TRUE(rect[4] >= 99 * rect[5] && rect[4] <= 1.01e6 * rect[5]);
  }
  for (const Numbers& ellipse : small_pool(kinds, Trial::tiny).b) {
    EXPECT_TRUE(ellipse[4] > 0 && ellipse[4] <= 0x1p-1060);
    EXPECT_NEAR(std::hypot(ellipse[2], ellipse[3]), 1, 1e-15);
  }
  for (const Numbers& ellipse : small_pool(kinds, Trial::huge).b) {
    EXPECT_TRUE(ellipse[4] >= 0x1p997 && ellipse[4] <= 0x1p1000);
  }
  for (const Numbers& ellipse : small_pool(kinds, Trial::far).b) {
    EXPECT_TRUE(ellipse[0] > 0.9e12 && ellipse[4] <= 1);
  }
  for (const Trial trial : methods::trials) {
    const Pool pool = small_pool({VESICA_ELLIPSE, VESICA_ELLIPSE, Axes::parallel}, trial);
    for (const auto* shapes : {&pool.a, &pool.b}) {
      EXPECT_TRUE(std::ranges::all_of(*shapes, [](const Numbers& e) { return e[2] == 0.8 && e[3] == 0.6; }));
    }
  }
}

}  // namespace
