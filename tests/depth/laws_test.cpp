// SPDX-License-Identifier: Apache-2.0
// Laws that hold for every pair of shapes, on every workload.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "properties/generators.hpp"
#include "vesica.h"

namespace {

using properties::Numbers;
using properties::Pair;
using properties::Scalar;
using properties::Workload;

using Depth = vesica_penetration_f64;

int32_t ask(int ka, const Numbers& a, int kb, const Numbers& b, Depth& out) {
  return vesica_depth_f64(ka, a.data(), kb, b.data(), &out);
}

bool overlaps(const Pair& p) { return vesica_overlap_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) == 1; }

Numbers moved(int kind, Numbers n, double dx, double dy) {
  for (int i = 0; i < properties::field_count(kind); ++i) {
    const properties::Role role = properties::role(kind, i);
    const auto k = static_cast<std::size_t>(i);
    if (role == properties::Role::x) n[k] += dx;
    if (role == properties::Role::y) n[k] += dy;
  }
  return n;
}

void expect_laws(const Pair& p) {
  Depth d, back;
  const int32_t error = ask(p.kind_a, p.a, p.kind_b, p.b, d);
  ASSERT_EQ(ask(p.kind_b, p.b, p.kind_a, p.a, back), error);
  if (error != 0) {
    ASSERT_EQ(error, VESICA_E_RANGE);
    return;
  }
  ASSERT_TRUE(std::isfinite(d.depth) && d.depth >= 0 && std::isfinite(d.x) && std::isfinite(d.y))
      << properties::describe(p);
  const bool one_call = p.kind_a == p.kind_b && p.a == p.b;
  ASSERT_TRUE(d.depth == back.depth && (one_call || (d.x == -back.x && d.y == -back.y))) << properties::describe(p);
  ASSERT_EQ(d.x != 0 || d.y != 0, overlaps(p)) << properties::describe(p);
  if (!overlaps(p)) {
    ASSERT_EQ(d.depth, 0);
    return;
  }
  ASSERT_NEAR(std::hypot(d.x, d.y), 1, 1e-15);
  // Touching shapes are 0 deep unless one contains the other. (A point on an outline is, too, but inside by
  // relation.)
  const int32_t relation = vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  if (relation == VESICA_TOUCH) {
    ASSERT_EQ(d.depth, 0) << properties::describe(p);
  }
  if (relation == VESICA_CROSS && properties::has_area(p.kind_a, p.a) && properties::has_area(p.kind_b, p.b)) {
    ASSERT_GT(d.depth, 0) << properties::describe(p);
  }
}

class Laws : public testing::TestWithParam<Workload> {};

TEST_P(Laws, EveryPairOfKinds) {
  const int pairs = (GetParam() == Workload::near_contact ? 20 : 200) * properties::repeat();
  for (int ka = VESICA_POINT; ka <= VESICA_ELLIPSE; ++ka) {
    for (int kb = ka; kb <= VESICA_ELLIPSE; ++kb) {
      properties::Stream stream(GetParam(), ka, kb, Scalar::f64, properties::seed());
      for (int i = 0; i < pairs && !HasFatalFailure(); ++i) expect_laws(stream.next());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Depth, Laws, testing::ValuesIn(properties::all_workloads),
                         [](const auto& test) { return std::string(properties::name(test.param)); });

/// Shapes of the same numbers up to an offset that underflows in a unit in which their sizes do not overflow.
TEST(Depth, ExchangedShapesAtTheLeastOffsets) {
  properties::Random random(properties::seed());
  const auto tiny = [&] {
    return random.chance(0.4) ? 0 : random.sign() * std::ldexp(random.integer(1, 3), random.integer(-1074, -100));
  };
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const double size = std::ldexp(1.0, random.integer(940, 1000)), x = tiny(), y = tiny();
    const double ux = random.integer(-2, 2), uy = random.integer(1, 2), a = size * random.integer(1, 2), b = size;
    for (const int kind : {VESICA_RECT, VESICA_ELLIPSE})
      expect_laws({kind, kind, {0, 0, ux, uy, a, b}, {x, y, ux, uy, a, b}});
    expect_laws({VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, a}, {x, y, a}});
    expect_laws({VESICA_AABB, VESICA_AABB, {0, 0, a, b}, {x, y, a, b}});
    expect_laws({VESICA_SEGMENT, VESICA_SEGMENT, {0, 0, a, ux * b}, {x, y, a, ux * b}});
  }
}

/// b moved by the depth and a billionth of it: still overlapping before, disjoint beyond.
TEST(Depth, MovingByItEndsTheOverlap) {
  int pairs = 0;
  for (int ka = VESICA_POINT; ka <= VESICA_ELLIPSE; ++ka) {
    for (int kb = VESICA_POINT; kb <= VESICA_ELLIPSE; ++kb) {
      properties::Stream stream(Workload::random, std::min(ka, kb), std::max(ka, kb), Scalar::f64, properties::seed());
      for (int i = 0; i < 400 * properties::repeat(); ++i) {
        Pair p = stream.next();
        if (ka > kb) std::swap(p.kind_a, p.kind_b), std::swap(p.a, p.b);
        Depth d;
        ASSERT_EQ(ask(p.kind_a, p.a, p.kind_b, p.b, d), 0);
        // A billionth of it must be well above the rounding of coordinates, which are about 10.
        if (d.depth < 1e-4) continue;
        ++pairs;
        const double less = d.depth * (1 - 1e-9), more = d.depth * (1 + 1e-9);
        ASSERT_TRUE(overlaps({p.kind_a, p.kind_b, p.a, moved(p.kind_b, p.b, less * d.x, less * d.y)}))
            << properties::describe(p);
        ASSERT_FALSE(overlaps({p.kind_a, p.kind_b, p.a, moved(p.kind_b, p.b, more * d.x, more * d.y)}))
            << properties::describe(p);
      }
    }
  }
  EXPECT_GT(pairs, 2000 * properties::repeat());
}

/// No shorter move in any other direction ends it.
TEST(Depth, NoShorterMoveEndsTheOverlap) {
  properties::Random random(properties::seed());
  for (int ka = VESICA_CIRCLE; ka <= VESICA_ELLIPSE; ++ka) {
    for (int kb = VESICA_CIRCLE; kb <= VESICA_ELLIPSE; ++kb) {
      properties::Stream stream(Workload::random, std::min(ka, kb), std::max(ka, kb), Scalar::f64, properties::seed());
      for (int i = 0; i < 100 * properties::repeat(); ++i) {
        const Pair p = stream.next();
        Depth d;
        ASSERT_EQ(ask(p.kind_a, p.a, p.kind_b, p.b, d), 0);
        if (d.depth < 1e-4) continue;
        for (int k = 0; k < 30; ++k) {
          const double way = random.between(0, 6.283185307179586), less = d.depth * (1 - 1e-9);
          ASSERT_TRUE(
              overlaps({p.kind_a, p.kind_b, p.a, moved(p.kind_b, p.b, less * std::cos(way), less * std::sin(way))}))
              << properties::describe(p);
        }
      }
    }
  }
}

TEST(Depth, ExactTranslationsChangeNoBit) {
  properties::Random random(properties::seed());
  const auto on_grid = [](int kind, Numbers n) {
    for (int i = 0; i < properties::field_count(kind); ++i) {
      const properties::Role role = properties::role(kind, i);
      const auto k = static_cast<std::size_t>(i);
      if (role == properties::Role::x || role == properties::Role::y) n[k] = std::rint(n[k] * 0x1p20) * 0x1p-20;
    }
    return n;
  };
  for (int ka = VESICA_POINT; ka <= VESICA_ELLIPSE; ++ka) {
    for (int kb = ka; kb <= VESICA_ELLIPSE; ++kb) {
      properties::Stream stream(Workload::random, ka, kb, Scalar::f64, properties::seed());
      for (int i = 0; i < 60 * properties::repeat(); ++i) {
        const Pair p = stream.next();
        const double dx = std::ldexp(random.integer(-1000, 1000), 8), dy = std::ldexp(random.integer(-1000, 1000), 8);
        const Numbers a = on_grid(ka, p.a), b = on_grid(kb, p.b);
        Depth d, m;
        ASSERT_EQ(ask(ka, a, kb, b, d), 0);
        ASSERT_EQ(ask(ka, moved(ka, a, dx, dy), kb, moved(kb, b, dx, dy), m), 0);
        ASSERT_TRUE(d.depth == m.depth && d.x == m.x && d.y == m.y) << properties::describe(p);
      }
    }
  }
}

}  // namespace
