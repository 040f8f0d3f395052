// SPDX-License-Identifier: Apache-2.0
/// Hit or miss, and the time, against the oracle: over every workload, and at the very numbers at which a hit becomes a
/// miss.
#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstddef>
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

/// The oracle is slow for two such shapes with an area.
bool has_round_outline(int kind, const Numbers& n) { return properties::is_curved(kind, n); }

/// By how many powers of two the numbers of a moving pair differ, zeros left out.
int spread(const Pair& p, const Motion& m, double t) {
  int least = INT_MAX, most = INT_MIN;
  const auto look = [&](double x) {
    if (x == 0) return;
    least = std::min(least, std::ilogb(x));
    most = std::max(most, std::ilogb(x));
  };
  for (int i = 0; i < vesica_field_count(p.kind_a); ++i) look(p.a[static_cast<std::size_t>(i)]);
  for (int i = 0; i < vesica_field_count(p.kind_b); ++i) look(p.b[static_cast<std::size_t>(i)]);
  for (const double x : {m.vx, m.vy, t}) look(x);
  return most - least;
}

/// Contact before t by more than 2^-less of it.
bool meets_before(const Pair& p, const Motion& m, double t, int less) { return t > 0 && meets(p, m, t, less); }

/// A time of contact that is so near to a number mostly is that number.
int precision(const Pair& p) {
  return has_round_outline(p.kind_a, p.a) && has_round_outline(p.kind_b, p.b) ? 300 : 6500;
}

/// Contact before the number that comes after t, or at t. Lengths whose ratio is 2^-k change a time by 2^-k or, where
/// they cancel to first order, by 2^-2k of it: that near a time may come before a number.
bool meets_by(const Pair& p, const Motion& m, double t, double next) {
  return meets_before(p, m, next, precision(p)) || meets(p, m, t) ||
         meets_before(p, m, next, precision(p) + 2 * spread(p, m, t));
}

class Decision : public testing::TestWithParam<properties::Kinds> {
 protected:
  Scalar scalar() const { return GetParam().scalar; }

  double next(double t) const { return properties::at_ordinal(scalar(), properties::ordinal(scalar(), t) + 1); }

  void check(const Pair& p, const Motion& m, bool with_time) {
    SCOPED_TRACE(describe(p, m));
    const Answer r = cast(scalar(), p, m);
    ++cases_;
    // Rays have a quicker way where it is the point that moves. Places in the other order may have too many digits.
    const Answer exchanged = cast(scalar(), properties::swapped(p), {-m.vx, -m.vy, m.end});
    EXPECT_TRUE(exchanged.code == VESICA_E_RANGE || r.code < 0 || (exchanged.code == r.code && exchanged.t == r.t))
        << exchanged.code << ' ' << exchanged.t << " / " << r.code << ' ' << r.t;
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
    EXPECT_FALSE(meets_before(p, m, r.t, precision(p))) << std::hexfloat << r.t;
    EXPECT_TRUE(meets_by(p, m, r.t, next(r.t))) << std::hexfloat << r.t;
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
    const auto has_arcs = [](int kind) { return properties::is_round(kind) || properties::is_inflated(kind); };
    const bool slow = has_arcs(k.a) && has_arcs(k.b);
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
