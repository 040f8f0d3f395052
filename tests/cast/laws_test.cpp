// SPDX-License-Identifier: Apache-2.0
/// Laws that hold without knowing any contact, over every workload, for answers and times to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "cast/motions.hpp"
#include "oracle/oracle.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using namespace cast_test;
using properties::Shape;

Pair as_pair(const Shape& a, const Shape& b) { return {a.kind, b.kind, a.numbers, b.numbers}; }

class Laws : public testing::TestWithParam<properties::Kinds> {
 protected:
  Scalar scalar() const { return GetParam().scalar; }
  Answer ask(const Pair& p, const Motion& m) const { return cast(scalar(), p, m); }

  /// Where exponents are wildly unlike, the one may be out of range and the other not.
  static void expect_same(const Answer& r, const Answer& s) {
    if (r.code == VESICA_E_RANGE || s.code == VESICA_E_RANGE) return;
    EXPECT_EQ(r.code, s.code);
    EXPECT_EQ(r.t, s.t);
  }
  /// Among exponents that are wildly unlike a corner may be as good as an edge, and either is right.
  void expect_normal(const Answer& r, double nx, double ny) const {
    if (r.code != VESICA_CAST_HIT || workload_ == properties::Workload::mixed_scale) return;
    // Parallel axes of other lengths give other roundings, and a thin ellipse's end turns fast.
    EXPECT_NEAR(r.nx, nx, 1e-10);
    EXPECT_NEAR(r.ny, ny, 1e-10);
  }

  void check_exchange(const Pair& p, const Motion& m, const Answer& r) {
    const Answer s = ask({p.kind_b, p.kind_a, p.b, p.a}, {-m.vx, -m.vy, m.end});
    expect_same(r, s);
    if (s.code == VESICA_CAST_HIT) expect_normal(r, 0 - s.nx, 0 - s.ny);
  }

  void check_mirror_and_turn(const Pair& p, const Motion& m, const Answer& r) {
    const Shape a{p.kind_a, p.a}, b{p.kind_b, p.b};
    expect_same(r, ask(as_pair(properties::mirrored(a), properties::mirrored(b)), {-m.vx, m.vy, m.end}));
    expect_same(r, ask(as_pair(properties::turned(a), properties::turned(b)), {-m.vy, m.vx, m.end}));
  }

  void check_scale(const Pair& p, const Motion& m, const Answer& r, properties::Random& random) {
    const int exponent = random.integer(-20, 20);
    const auto a = properties::scaled_exactly({p.kind_a, p.a}, scalar(), exponent, false);
    const auto b = properties::scaled_exactly({p.kind_b, p.b}, scalar(), exponent, false);
    const Motion scaled{std::ldexp(m.vx, exponent), std::ldexp(m.vy, exponent), m.end};
    const bool exact = properties::representable(scalar(), scaled.vx) &&
                       properties::representable(scalar(), scaled.vy) && std::ldexp(scaled.vx, -exponent) == m.vx &&
                       std::ldexp(scaled.vy, -exponent) == m.vy;
    if (!a || !b || !exact) return;
    const Answer s = ask(as_pair(*a, *b), scaled);
    ++scales_;
    expect_same(r, s);
    if (s.code == VESICA_CAST_HIT) expect_normal(r, s.nx, s.ny);
  }

  void check_time(const Pair& p, const Motion& m, const Answer& r) {
    const Motion half{0.5 * m.vx, 0.5 * m.vy, 2 * m.end};
    const bool exact = 2 * half.vx == m.vx && 2 * half.vy == m.vy && properties::representable(scalar(), half.vx) &&
                       properties::representable(scalar(), half.vy) &&
                       r.t < (scalar() == Scalar::f64 ? 0x1p1022 : 0x1p126);
    const bool normal = r.t > (scalar() == Scalar::f64 ? 0x1p-1020 : 0x1p-120);
    if (r.code == VESICA_CAST_HIT && exact && normal) {
      const Answer s = ask(p, half);
      if (s.code >= 0) {
        EXPECT_EQ(s.code, r.code);
        EXPECT_EQ(s.t, 2 * r.t);
      }
    }
    if (r.code < 0) return;
    EXPECT_EQ(r.code == VESICA_CAST_START, oracle::overlap(p.kind_a, p.a.data(), p.kind_b, p.b.data()));
    if (r.code != VESICA_CAST_HIT) return;
    // Later ends change nothing, earlier ones miss.
    const Answer later = ask(p, {m.vx, m.vy, infinity});
    expect_same(r, later);
    expect_normal(r, later.nx, later.ny);
    const double before = properties::at_ordinal(scalar(), properties::ordinal(scalar(), r.t) - 1);
    if (r.t > 0) {
      EXPECT_EQ(ask(p, {m.vx, m.vy, before}).code, VESICA_CAST_MISS);
    }
    const double after = properties::at_ordinal(scalar(), properties::ordinal(scalar(), r.t) + 1);
    expect_same(r, ask(p, {m.vx, m.vy, after}));
    // The normal is against the velocity, or across it.
    EXPECT_LE(r.nx * (m.vx / std::hypot(m.vx, m.vy)) + r.ny * (m.vy / std::hypot(m.vx, m.vy)),
              scalar() == Scalar::f64 ? 0x1p-51 : 0x1p-22);
  }

  properties::Workload workload_{};
  int scales_ = 0, hits_ = 0;
};

TEST_P(Laws, EveryWorkload) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  const properties::Kinds k = GetParam();
  for (const properties::Workload workload : properties::all_workloads) {
    workload_ = workload;
    properties::Stream stream(workload, k.a, k.b, k.scalar, properties::seed() + 21);
    properties::Random random(properties::seed() + 22);
    for (int i = 0; i < 20 * properties::repeat(); ++i) {
      const Pair p = stream.next();
      const Motion m = draw_motion(p, k.scalar, random);
      SCOPED_TRACE(describe(p, m));
      const Answer r = ask(p, m);
      hits_ += r.code == VESICA_CAST_HIT;
      check_exchange(p, m, r);
      check_mirror_and_turn(p, m, r);
      check_scale(p, m, r, random);
      check_time(p, m, r);
      if (HasFailure()) FAIL() << properties::name(workload);
    }
  }
  EXPECT_GT(hits_, properties::draws_all() ? 8 : 2);
  EXPECT_GT(scales_, 20 * properties::repeat());
}

INSTANTIATE_TEST_SUITE_P(Cast, Laws, testing::ValuesIn(properties::all_pairs_of_kinds()), properties::test_name);

}  // namespace
