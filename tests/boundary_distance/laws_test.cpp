// SPDX-License-Identifier: Apache-2.0
// Laws that hold for every pair of shapes, on every workload.
#include <gtest/gtest.h>

#include <cmath>

#include "boundary_distance/nested_pairs.hpp"
#include "boundary_distance/reference.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"
#include "vesica.h"

namespace laws_test {
namespace {

using properties::has_area;
using properties::Numbers;
using properties::Pair;
using properties::Scalar;
using properties::Workload;

using Points = vesica_closest_points_f64;

int32_t ask(int ka, const Numbers& a, int kb, const Numbers& b, Points& out) {
  return vesica_boundary_distance_f64(ka, a.data(), kb, b.data(), &out);
}

bool same(double x, double y) { return x == y && std::signbit(x) == std::signbit(y); }

/// 0 exactly where outlines meet, as the exact relation says.
bool outlines_meet(const Pair& p) {
  const int32_t relation = vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  if (relation == VESICA_DISJOINT) return false;
  if (relation == VESICA_INSIDE) return !has_area(p.kind_b, p.b);
  if (relation == VESICA_CONTAINS) return !has_area(p.kind_a, p.a);
  return true;
}

void expect_points_on_outlines(const Pair& p, const Points& c) {
  const auto a = outline_reference::shape(p.kind_a, p.a), b = outline_reference::shape(p.kind_b, p.b);
  const double rounding = 0x1p-53 * (std::abs(c.ax) + std::abs(c.ay) + std::abs(c.bx) + std::abs(c.by));
  const double unit = 0x1p-53 * outline_reference::scale(a, b), denormal = 0x1p-1072;
  const double on_a = outline_reference::distance_from_outline(a, c.ax, c.ay);
  const double on_b = outline_reference::distance_from_outline(b, c.bx, c.by);
  // A common point is worked out on one of the two outlines: the greater aspect ratio counts for both.
  const double aspect = std::max(outline_reference::aspect(a), outline_reference::aspect(b));
  if (!(aspect <= 1e6)) return;
  const double most = properties::is_inflated(p.kind_a) || properties::is_inflated(p.kind_b) ? 12 : 4;
  EXPECT_LE(on_a, most * unit * aspect + rounding + denormal) << properties::describe(p);
  EXPECT_LE(on_b, most * unit * aspect + rounding + denormal) << properties::describe(p);
}

void expect_laws(const Pair& p) {
  Points c, reversed, nearest;
  const int32_t error = ask(p.kind_a, p.a, p.kind_b, p.b, c);
  ASSERT_EQ(ask(p.kind_b, p.b, p.kind_a, p.a, reversed), error);
  if (error != 0) {  // points that no double holds
    ASSERT_EQ(error, VESICA_E_RANGE) << properties::describe(p);
    return;
  }
  ASSERT_TRUE(std::isfinite(c.distance) && std::isfinite(c.ax) && std::isfinite(c.ay) && std::isfinite(c.bx) &&
              std::isfinite(c.by))
      << properties::describe(p);
  ASSERT_TRUE(same(c.distance, reversed.distance) && same(c.ax, reversed.bx) && same(c.ay, reversed.by) &&
              same(c.bx, reversed.ax) && same(c.by, reversed.ay))
      << properties::describe(p);
  const bool meet = outlines_meet(p);
  ASSERT_EQ(c.distance == 0, meet) << properties::describe(p);
  ASSERT_GE(c.distance, 0);
  if (meet) {
    ASSERT_TRUE(c.ax == c.bx && c.ay == c.by);
  }
  // A common point of the solid shapes may be beyond the range where one of the outlines is not.
  if (vesica_nearest_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &nearest) == 0) {
    ASSERT_GE(c.distance, nearest.distance);
    const bool disjoint = vesica_overlap_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) == 0;
    ASSERT_TRUE(!disjoint || (c.distance == nearest.distance && c.ax == nearest.ax && c.ay == nearest.ay &&
                              c.bx == nearest.bx && c.by == nearest.by))
        << properties::describe(p);
  }
  expect_points_on_outlines(p, c);
}

class Laws : public testing::TestWithParam<Workload> {};

TEST_P(Laws, EveryPairOfKinds) {
  const int pairs = (GetParam() == Workload::near_contact ? 20 : 200) * properties::repeat();
  for (int ka = 0; ka < properties::kinds; ++ka) {
    for (int kb = ka; kb < properties::kinds; ++kb) {
      properties::Stream stream(GetParam(), ka, kb, Scalar::f64, properties::seed());
      for (int i = 0; i < pairs && !HasFatalFailure(); ++i) expect_laws(stream.next());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BoundaryDistance, Laws, testing::ValuesIn(properties::all_workloads),
                         [](const auto& test) { return std::string(properties::name(test.param)); });

TEST(BoundaryDistance, NestedPairsKeepTheLaws) {
  properties::Random random(properties::seed());
  for (int outer = VESICA_CIRCLE; outer < properties::kinds; ++outer) {
    for (int inner = 0; inner < properties::kinds; ++inner) {
      for (const nested_pairs::Style style : nested_pairs::all_styles) {
        for (int i = 0; i < 20 * properties::repeat(); ++i) {
          const auto pair = nested_pairs::draw(style, outer, inner, random);
          if (pair) expect_laws(*pair);
        }
      }
    }
  }
}

/// Positions as multiples of 2^-20, so that whole numbers are added exactly.
Numbers on_grid(int kind, Numbers n, double dx, double dy) {
  for (int i = 0; i < properties::field_count(kind); ++i) {
    const properties::Role role = properties::role(kind, i);
    const auto k = static_cast<std::size_t>(i);
    if (role == properties::Role::x) n[k] = std::rint(n[k] * 0x1p20) * 0x1p-20 + dx;
    if (role == properties::Role::y) n[k] = std::rint(n[k] * 0x1p20) * 0x1p-20 + dy;
  }
  return n;
}

TEST(BoundaryDistance, ExactTranslationsChangeNoBit) {
  properties::Random random(properties::seed());
  int nested = 0;
  for (int ka = 0; ka < properties::kinds; ++ka) {
    for (int kb = 0; kb < properties::kinds; ++kb) {
      properties::Stream stream(Workload::random, std::min(ka, kb), std::max(ka, kb), Scalar::f64, properties::seed());
      for (int i = 0; i < 60 * properties::repeat(); ++i) {
        Pair p = stream.next();
        if (ka >= VESICA_CIRCLE && i % 2 == 0) {
          p = nested_pairs::draw(nested_pairs::Style::any, ka, kb, random).value_or(p);
        }
        const double dx = std::ldexp(random.integer(-1000, 1000), 8), dy = std::ldexp(random.integer(-1000, 1000), 8);
        const Numbers a = on_grid(p.kind_a, p.a, 0, 0), b = on_grid(p.kind_b, p.b, 0, 0);
        Points c, moved;
        ASSERT_EQ(ask(p.kind_a, a, p.kind_b, b, c), 0);
        ASSERT_EQ(ask(p.kind_a, on_grid(p.kind_a, p.a, dx, dy), p.kind_b, on_grid(p.kind_b, p.b, dx, dy), moved), 0);
        ASSERT_TRUE(same(c.distance, moved.distance)) << properties::describe(p);
        nested += vesica_relation_f64(p.kind_a, a.data(), p.kind_b, b.data()) == VESICA_CONTAINS;
      }
    }
  }
  EXPECT_GT(nested, 300 * properties::repeat());
}

}  // namespace
}  // namespace laws_test
