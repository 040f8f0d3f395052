// SPDX-License-Identifier: Apache-2.0
/// Laws that need no known contact: powers of two to the bit; exchange and a finer tolerance as far as answers
/// are proved; and where nothing turns, what vesica_cast proves.
#include <gtest/gtest.h>

#include <cmath>

#include "cast/motions.hpp"
#include "impact_time/face.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace laws_test {
namespace {

using namespace impact_time_test;

bool proves_a_miss(const Answer& r) { return r.code == VESICA_CAST_MISS; }
bool proves_contact(const Answer& r) { return r.code == VESICA_CAST_HIT || r.code == VESICA_CAST_START; }

class Laws : public testing::TestWithParam<properties::Kinds> {
 protected:
  static void expect_no_contradiction(const Answer& r, const Answer& s) {
    if (r.code == VESICA_E_RANGE || s.code == VESICA_E_RANGE) return;
    EXPECT_FALSE(proves_a_miss(r) && proves_contact(s));
    EXPECT_FALSE(proves_contact(r) && proves_a_miss(s));
    EXPECT_EQ(r.code == VESICA_CAST_START, s.code == VESICA_CAST_START);
  }

  static void check_exchange(const Turning& s, const Answer& r) {
    const Pair& p = s.pair;
    const Answer q = impact_time(Scalar::f64, {{p.kind_b, p.kind_a, p.b, p.a}, s.b, s.a, s.tolerance});
    expect_no_contradiction(r, q);
  }

  static void check_scale(const Turning& s, const Answer& r, int exponent) {
    const auto a = properties::scaled_exactly({s.pair.kind_a, s.pair.a}, Scalar::f64, exponent, false);
    const auto b = properties::scaled_exactly({s.pair.kind_b, s.pair.b}, Scalar::f64, exponent, false);
    if (!a || !b) return;
    const auto times = [exponent](double x) { return std::ldexp(x, exponent); };
    const Answer q = impact_time(Scalar::f64, {{s.pair.kind_a, s.pair.kind_b, a->numbers, b->numbers},
                                               {times(s.a.vx), times(s.a.vy), s.a.angle},
                                               {times(s.b.vx), times(s.b.vy), s.b.angle},
                                               times(s.tolerance)});
    EXPECT_EQ(q.code, r.code);
    // At the start the direction is vesica_depth's.
    if (r.code == VESICA_CAST_MISS || r.code == VESICA_CAST_START) return;
    EXPECT_EQ(q.t, r.t);
    EXPECT_EQ(q.nx, r.nx);
    EXPECT_EQ(q.ny, r.ny);
    EXPECT_EQ(q.gap, times(r.gap));
  }

  /// A finer tolerance stays proved, comes later and nearer.
  static void check_finer(const Turning& s, const Answer& r) {
    Turning finer = s;
    finer.tolerance = s.tolerance / 16;
    const Answer q = impact_time(Scalar::f64, finer);
    expect_no_contradiction(r, q);
    if (r.code == VESICA_CAST_MISS) {
      EXPECT_EQ(q.code, VESICA_CAST_MISS);
    }
  }

  static void check_against_cast(Turning s) {
    s.a.vx = s.a.vy = s.a.angle = s.b.angle = 0;
    const Answer r = impact_time(Scalar::f64, s);
    vesica_impact_f64 out{};
    const std::int32_t code =
        vesica_cast_f64(s.pair.kind_a, s.pair.a.data(), s.pair.kind_b, s.pair.b.data(), s.b.vx, s.b.vy, 1, &out);
    if (r.code < 0 || code < 0) return;
    EXPECT_EQ(r.code == VESICA_CAST_START, code == VESICA_CAST_START);
    if (r.code == VESICA_CAST_MISS || r.code == VESICA_CAST_HIT) {
      EXPECT_EQ(r.code, code);
    }
    if (code == VESICA_CAST_HIT) {
      EXPECT_LE(r.t, out.t);
    }
  }
};

TEST_P(Laws, HoldForRandomMotions) {
  const properties::Kinds k = GetParam();
  properties::Random random(properties::seed() + 32);
  for (const Style style : {Style::plain, Style::needles, Style::close}) {
    for (const double spin : {1.0, 6.3, 40.0, 100.0}) {
      for (int i = 0; i < 8 * properties::repeat(); ++i) {
        const Turning s = draw(k.a, k.b, style, spin, random);
        SCOPED_TRACE(describe(s));
        const Answer r = impact_time(Scalar::f64, s);
        ASSERT_GE(r.code, 0);
        check_exchange(s, r);
        check_scale(s, r, random.integer(-900, 900));
        check_finer(s, r);
        check_against_cast(s);
        if (HasFailure()) FAIL();
      }
    }
  }
}

/// Shapes of any size at any place: what is proved stays free of contradiction.
TEST_P(Laws, HoldForEveryWorkload) {
  const properties::Kinds k = GetParam();
  properties::Random random(properties::seed() + 33);
  for (const properties::Workload workload : properties::all_workloads) {
    properties::Stream stream(workload, k.a, k.b, k.scalar, properties::seed() + 34);
    for (int i = 0; i < 12 * properties::repeat(); ++i) {
      const Pair p = stream.next();
      const cast_test::Motion m = cast_test::draw_motion(p, k.scalar, random);
      const double size = std::fmax(std::fmax(std::fabs(m.vx), std::fabs(m.vy)), 0x1p-1000);
      const Turn still{0, 0, 0}, turn{m.vx, m.vy, random.between(-10, 10)};
      const Turning s{p, random.chance(0.5) ? still : Turn{m.vy, m.vx, random.between(-3, 3)}, turn, 1e-6 * size};
      SCOPED_TRACE(describe(s));
      const Answer r = impact_time(Scalar::f64, s);
      if (r.code == VESICA_E_RANGE) continue;
      ASSERT_GE(r.code, 0);
      if (r.code == VESICA_CAST_HIT || r.code == VESICA_CAST_NEAR) {
        EXPECT_TRUE(r.t >= 0 && r.t <= 1 && r.gap >= 0) << r.t;
      }
      check_exchange(s, r);
      check_finer(s, r);
      check_against_cast(s);
      if (HasFailure()) FAIL() << properties::name(workload);
    }
  }
}

std::vector<properties::Kinds> pairs_in_double() {
  std::vector<properties::Kinds> result;
  for (const properties::Kinds& k : properties::all_pairs_of_kinds()) {
    if (k.scalar == Scalar::f64) result.push_back(k);
  }
  return result;
}
INSTANTIATE_TEST_SUITE_P(ImpactTime, Laws, testing::ValuesIn(pairs_in_double()), properties::test_name);

}  // namespace
}  // namespace laws_test
