// SPDX-License-Identifier: Apache-2.0
/// Casts with subnormal gaps and velocities. A point at (4, z), z = 2^-1074, moved by (-2, -z) over a box with its top
/// at y = 0. The cast returned 0.5, where the point is still above the box; right is 1. The product of the normal
/// (0, 1/2) with v underflowed to 0, so the normal was taken for one across v.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "cast/exact_truth.hpp"
#include "properties/random.hpp"

namespace {

using namespace cast_test;

constexpr double z = 0x1p-1074;

TEST(SubnormalCasts, KnownTimes) {
  const auto time = [](const Pair& p, const Motion& m) {
    const Answer r = cast(Scalar::f64, p, m);
    return r.code == VESICA_CAST_HIT ? r.t : r.code == VESICA_CAST_MISS ? infinity : -1;
  };
  const Pair point{VESICA_AABB, VESICA_POINT, {-2, -1, 3, 0}, {4, z}};
  EXPECT_EQ(time(point, {-2, -z, 0.75}), infinity);
  EXPECT_EQ(time(point, {-2, -z, 4}), 1);
  EXPECT_EQ(time({VESICA_AABB, VESICA_AABB, {-2, -1, 3, 0}, {4, z, 5, 1}}, {-2, -z, 0.75}), infinity);
  EXPECT_EQ(time({VESICA_CIRCLE, VESICA_SEGMENT, {-2 * z, 0.75, 0}, {0, 0x18p-1074, 0, 0.25}},
                 {-2 * z, 0.625, 0x1.999999999999ap-1}),
            infinity);
  EXPECT_EQ(time({VESICA_AABB,
                  VESICA_POINT,
                  {z, -0x1.0000000000001p+1, z, 0x1.ffffffffffffep-1},
                  {2 * z, -0x1.fffffffffffffp+1}},
                 {-z, 0x1.bfffffffffffep+1, 0x1.fffffffffffffp-1}),
            infinity);
}

/// A shape whose top is the x axis, or whose bottom is at `level`. Round shapes have no radius.
Numbers with_edge(int kind, double level, bool top, properties::Random& random) {
  const double x = random.integer(-3, 0), width = random.integer(0, 4), height = random.integer(0, 2);
  const double far = top ? -height : height == 0 ? level : height;
  switch (kind) {
    case VESICA_POINT:
      return {x, level};
    case VESICA_CIRCLE:
      return {x, level, 0};
    case VESICA_SEGMENT:
      return {x, level, x + width, far};
    case VESICA_AABB:
      return {x, std::min(level, far), x + width, std::max(level, far)};
    case VESICA_RECT:
      return {x, level, 1, 0, width, 0};
    default:
      return {x, level, static_cast<double>(random.integer(1, 3)), 0, width, 0};
  }
}

/// Mirrors in the diagonal.
void exchange_axes(int kind, Numbers& n) {
  std::swap(n[0], n[1]);
  if (kind != VESICA_CIRCLE) std::swap(n[2], n[3]);
}

/// Shapes of small integers that pass each other along an axis, with a subnormal gap across it that closes at k / m,
/// each number now and then moved by its last place.
TEST(SubnormalCasts, AgreeWithTheOracle) {
  properties::Random random(properties::seed() + 61);
  int hits = 0, misses = 0;
  for (int i = 0; i < 1500 * properties::repeat(); ++i) {
    Pair p{random.below(6), random.below(6), {}, {}};
    const double k = random.integer(1, 4), m = random.chance(0.5) ? 1 : random.integer(0, 4);
    p.a = with_edge(p.kind_a, 0, true, random);
    p.b = with_edge(p.kind_b, k * z, false, random);
    const double gap = random.integer(1, 9);
    p.b[0] += gap;
    if (p.kind_b == VESICA_SEGMENT || p.kind_b == VESICA_AABB) p.b[2] += gap;
    Motion motion{-random.integer(1, 4) * 1.0, -m * z, random.chance(0.3) ? infinity : random.integer(1, 12) / 4.0};
    if (random.chance(0.2)) motion.vx = std::nextafter(motion.vx, random.sign() * 9);
    if (random.chance(0.2)) p.b[0] = std::nextafter(p.b[0], random.sign() * 99);
    if (random.chance(0.5)) {
      exchange_axes(p.kind_a, p.a);
      exchange_axes(p.kind_b, p.b);
      std::swap(motion.vx, motion.vy);
    }
    if (!properties::valid(p.kind_a, p.a) || !properties::valid(p.kind_b, p.b)) continue;
    const std::int32_t code = expect_exact(p, motion);
    hits += code == VESICA_CAST_HIT;
    misses += code == VESICA_CAST_MISS;
    if (HasFailure()) return;
  }
  EXPECT_GT(hits, 100 * properties::repeat());
  EXPECT_GT(misses, 100 * properties::repeat());
}

}  // namespace
