// SPDX-License-Identifier: Apache-2.0
/// Hit or miss, and the time, against the oracle: over every workload, and at the very numbers at which a hit becomes a
/// miss.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "cast/motions.hpp"
#include "oracle/motion.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using namespace cast_test;

bool meets(const Pair& p, const Motion& m, double time, int less = 0) {
  return oracle::meets(p.kind_a, p.a.data(), p.kind_b, p.b.data(), {m.vx, m.vy, time, less});
}

/// Of two such the oracle is slow.
bool is_round(int kind) { return kind == VESICA_CIRCLE || kind == VESICA_ELLIPSE; }
bool is_slow(const Pair& p) { return is_round(p.kind_a) && is_round(p.kind_b); }

/// Contact before t. A time of contact that is so near to t is t: of boxes whatever the exponents.
bool meets_before(const Pair& p, const Motion& m, double t) { return t > 0 && meets(p, m, t, is_slow(p) ? 300 : 6500); }

class Decision : public testing::TestWithParam<properties::Kinds> {
 protected:
  Scalar scalar() const { return GetParam().scalar; }

  double next(double t) const { return properties::at_ordinal(scalar(), properties::ordinal(scalar(), t) + 1); }

  void check(const Pair& p, const Motion& m, bool with_time) {
    SCOPED_TRACE(describe(p, m));
    const Answer r = cast(scalar(), p, m);
    ++cases_;
    if (r.code < 0) {
      EXPECT_EQ(r.code, VESICA_E_RANGE);
      ++out_of_range_;
      return;
    }
    const bool start = meets(p, m, 0);
    EXPECT_EQ(r.code == VESICA_CAST_START, start);
    EXPECT_EQ(r.code > 0, start || meets(p, m, m.end));
    if (r.code != VESICA_CAST_HIT || !with_time) return;
    ++hits_;
    EXPECT_LE(r.t, m.end);
    EXPECT_FALSE(meets_before(p, m, r.t)) << std::hexfloat << r.t;
    EXPECT_TRUE(meets_before(p, m, next(r.t)) || meets(p, m, r.t)) << std::hexfloat << r.t;
    EXPECT_NEAR(std::hypot(r.nx, r.ny), 1, scalar() == Scalar::f64 ? 4 * 0x1p-53 : 2 * 0x1p-24);
  }

  int cases_ = 0, hits_ = 0, out_of_range_ = 0;
};

TEST_P(Decision, EveryWorkload) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  const properties::Kinds k = GetParam();
  for (const properties::Workload workload : properties::all_workloads) {
    const bool wild = workload == properties::Workload::mixed_scale || workload == properties::Workload::axis_length ||
                      workload == properties::Workload::thin;
    properties::Stream stream(workload, k.a, k.b, k.scalar, properties::seed() + 11);
    properties::Random random(properties::seed() + 12);
    const bool slow = is_round(k.a) && is_round(k.b);
    const int count = (wild ? 5 : 25) / (slow ? 5 : 1);
    for (int i = 0; i < count * properties::repeat(); ++i) {
      const Pair p = stream.next();
      const Motion m = draw_motion(p, k.scalar, random);
      const int before = out_of_range_;
      check(p, m, !(slow && wild));
      // Only exponents that are far from each other lead out of range.
      const double speed = std::fmax(std::fabs(m.vx), std::fabs(m.vy));
      const bool moderate = workload == properties::Workload::random || workload == properties::Workload::grid ||
                            workload == properties::Workload::degenerate;
      if (moderate && speed > 1e-9) {
        EXPECT_EQ(out_of_range_, before);
      }
      if (!wild && cast(k.scalar, p, m).code == VESICA_CAST_HIT && random.chance(0.2)) {
        for (const Moving& near : about_grazing({p, m}, k.scalar, random, 1)) check(near.pair, near.motion, true);
      }
      if (HasFailure()) FAIL() << properties::name(workload);
    }
  }
  if (properties::draws_all()) {
    EXPECT_GT(hits_, cases_ / 20);
  }
  std::printf("%d cases, %d hits\n", cases_, hits_);
}

INSTANTIATE_TEST_SUITE_P(Cast, Decision, testing::ValuesIn(properties::all_pairs_of_kinds()), properties::test_name);

}  // namespace
