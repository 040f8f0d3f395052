// SPDX-License-Identifier: Apache-2.0
// Depths that are right to the last place: of discs everywhere, of boxes where numbers are subnormal.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "boundary_distance/reference.hpp"
#include "properties/generators.hpp"
#include "vesica.h"

namespace {

using outline_reference::Real;
using properties::Numbers;

constexpr double quantum = 0x1p-1074;

vesica_penetration_f64 depth(int kind_a, const Numbers& a, int kind_b, const Numbers& b) {
  vesica_penetration_f64 out{-1, -1, -1};
  EXPECT_EQ(vesica_depth_f64(kind_a, a.data(), kind_b, b.data(), &out), 0);
  return out;
}

/// Sizes of 2^-1074 and of 1 need some 2200 bits for a square, and differences cancel.
Real real(double x) { return Real(x, 5000); }

Real disc_depth(const Numbers& a, const Numbers& b) {
  const Real x = real(b[0]) - real(a[0]), y = real(b[1]) - real(a[1]);
  return real(a[2]) + real(b[2]) - sqrt(Real(x * x + y * y));
}

/// The distance from a number to the next one away from 0.
double last_place(double x) { return std::nextafter(x, INFINITY) - x; }

/// Returns whether the discs overlap.
bool expect_last_place(const Numbers& a, const Numbers& b, int kind_a = VESICA_CIRCLE) {
  const Real exact = disc_depth(a, b);
  if (exact <= 0) return false;
  const double found = depth(kind_a, a, VESICA_CIRCLE, b).depth;
  EXPECT_LE(abs(Real(real(found) - exact)), real(last_place(found)))
      << std::hexfloat << a[0] << ' ' << a[1] << ' ' << a[2] << ' ' << b[0] << ' ' << b[1] << ' ' << b[2];
  return true;
}

// The first was off by 5.4 roundoffs of the scale: a search found the depth, divided two rounded numbers and was so
// 1.75 roundoffs of a depth of twice the scale.
TEST(DepthLastPlace, NearlyConcentricDiscs) {
  EXPECT_TRUE(expect_last_place({0x1.a1f9d44837038p-2, -0x1.a7d589f508cb4p-1, 0x1.00d79fd740eeap-1},
                                {0x1.a1f9f82973f6ep-2, -0x1.a7d59215829a7p-1, 0x1.00d79fd74063cp-1}));
  EXPECT_TRUE(expect_last_place({0, 0, 1}, {0x1.4fc04050efp-26, 0x1.9b533f4p-26, 1.125}));
}

TEST(DepthLastPlace, DiscsNearTouching) {
  EXPECT_TRUE(expect_last_place({0, 0, std::nextafter(5, 6)}, {6, 8, 5}));
  EXPECT_TRUE(expect_last_place({0, 0, 0x1p+0}, {0x1.8p0, 0, 0x1.0000000000001p-1}));
  EXPECT_TRUE(expect_last_place({3, 4}, {0, 0, std::nextafter(5, 6)}, VESICA_POINT));
}

/// The offset of centres as a share of the sum of radii: near 0, near 1 and between.
TEST(DepthLastPlace, Discs) {
  std::mt19937_64 random(properties::seed());
  std::uniform_real_distribution<double> unit(0, 1);
  int overlapping = 0;
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const double scale = std::ldexp(1, i % 4 == 0 ? -1060 + static_cast<int>(random() % 60) : 0);
    const double ra = scale * (0.5 + unit(random)), rb = ra * (i % 3 == 0 ? 1 + 0x1p-40 * unit(random) : unit(random));
    const double near = std::exp2(-50 * unit(random)), angle = 6.28 * unit(random);
    const double share = i % 3 == 0 ? near : i % 3 == 1 ? 1 - near : unit(random);
    const double cx = scale * (unit(random) - 0.5), cy = scale * (unit(random) - 0.5), d = share * (ra + rb);
    overlapping += expect_last_place({cx, cy, ra}, {cx + d * std::cos(angle), cy + d * std::sin(angle), rb});
  }
  EXPECT_GT(overlapping, 2000 * properties::repeat());
}

TEST(DepthLastPlace, ConcentricDiscsKeepADirection) {
  for (const double zero : {0.0, -0.0}) {
    const auto found = depth(VESICA_CIRCLE, {zero, 0, 1}, VESICA_CIRCLE, {0, zero, 2});
    const auto back = depth(VESICA_CIRCLE, {0, zero, 2}, VESICA_CIRCLE, {zero, 0, 1});
    EXPECT_EQ(found.depth, 3);
    EXPECT_TRUE(found.x == 1 && found.y == 0 && back.x == -1 && back.y == 0);
  }
}

/// Off from the truth, in quanta: the least over all directions, to 90 digits.
double off_by_quanta(int kind_a, const Numbers& a, int kind_b, const Numbers& b) {
  const auto exact =
      outline_reference::least(outline_reference::shape(kind_a, a), outline_reference::shape(kind_b, b), 1);
  const Real off = abs(Real(Real(depth(kind_a, a, kind_b, b).depth) - exact.value));
  return Real(off / Real(quantum)).get_d();
}

// Off by 2 quanta and by 1.125: the closed form took products that had underflown for settled.
TEST(DepthLastPlace, SubnormalBoxes) {
  EXPECT_LE(off_by_quanta(VESICA_RECT, {0, 0, -1, 1, 0x0.0000006d85825p-1022, 0x0.000001p-1022}, VESICA_AABB,
                          {0x0.00000138b80e3p-1022, 0, 0x0.000002p-1022, 0x0.000001p-1022}),
            0.5001);
  EXPECT_LE(off_by_quanta(VESICA_AABB, {0, 0, 0, 0x0.01p-1022}, VESICA_RECT,
                          {0, 0x0.008p-1022, 0x1.bcp-1, 0x1.8p-2, 0x0.006410ac41acp-1022, 0x0.007096deae117p-1022}),
            0.5001);
}

// Had a depth of 2 quanta.
TEST(DepthLastPlace, SubnormalBoxesThatTouchHaveNone) {
  const double q = quantum;
  for (const double size : {1.0, 3.0, 1000.0}) {
    const auto found = depth(VESICA_AABB, {0, 0, size * q, 2 * q}, VESICA_AABB, {size * q, 0, 2 * size * q, q});
    EXPECT_EQ(found.depth, 0);
    EXPECT_EQ(depth(VESICA_RECT, {0, 0, 1, 0, size * q, q}, VESICA_AABB, {size * q, 0, 9 * size * q, q}).depth, 0);
  }
}

// Was up to 3.5 quanta off. A depth below one quantum is one.
TEST(DepthLastPlace, AllSubnormalBoxes) {
  std::mt19937_64 random(properties::seed());
  std::uniform_real_distribution<double> unit(-1, 1);
  int overlapping = 0;
  for (int i = 0; i < 150 * properties::repeat(); ++i) {
    const double size = std::ldexp(1, -1070 + static_cast<int>(random() % 50));
    const auto box = [&] {
      return Numbers{size * unit(random), size * unit(random),       unit(random),
                     unit(random),        size * (1 + unit(random)), size * (1 + unit(random))};
    };
    const Numbers a = box(), b = box();
    if (vesica_overlap_f64(VESICA_RECT, a.data(), VESICA_RECT, b.data()) != 1) continue;
    const double found = depth(VESICA_RECT, a, VESICA_RECT, b).depth,
                 off = off_by_quanta(VESICA_RECT, a, VESICA_RECT, b);
    EXPECT_TRUE(off <= 0.5001 * last_place(found) / quantum || found == quantum) << off;
    ++overlapping;
  }
  EXPECT_GT(overlapping, 30 * properties::repeat());
}

// Were a last place off: an AABB's width was rounded before it was used.
TEST(DepthLastPlace, AabbsAtAnyMagnitude) {
  const Numbers a{-0x1.3046eec8b8bc9p-1022, -0x1.264380b791ca5p-1021, 0x0.d3c841dc893dep-1022, 0x0.9ff4fa39e44b4p-1022};
  const Numbers b{-0x1.5859047ac507ap-1021, -0x1.5932d0949d045p-1021, 0x0.259ec2ce1db88p-1022, 0x0.d7cf3691d717fp-1022};
  for (const int exponent : {0, 1, 600, 1020}) {
    Numbers p = a, q = b;
    for (std::size_t i = 0; i < 4; ++i) p[i] = std::ldexp(a[i], exponent), q[i] = std::ldexp(b[i], exponent);
    const auto found = depth(VESICA_AABB, p, VESICA_AABB, q);
    EXPECT_EQ(found.depth, q[2] - p[0]);
    EXPECT_TRUE(found.x == -1 && found.y == 0);
  }
  EXPECT_EQ(depth(VESICA_AABB, {-0x1p+52, 0, 3, 9}, VESICA_POINT, {2.5, 4}).depth, 0.5);
}

// A component that was rounded to 0 kept its sign: -0.
TEST(DepthLastPlace, NoDirectionHasANegativeZero) {
  const float a[] = {0, 0, 1e20f}, b[] = {1e20f, -1e-30f, 1e20f};
  for (const bool swapped : {false, true}) {
    vesica_penetration_f32 one;
    const float *first = swapped ? b : a, *second = swapped ? a : b;
    ASSERT_EQ(vesica_depth_f32(VESICA_CIRCLE, first, VESICA_CIRCLE, second, &one), 0);
    EXPECT_TRUE(one.y == 0 && !std::signbit(one.y));
  }
}

}  // namespace
