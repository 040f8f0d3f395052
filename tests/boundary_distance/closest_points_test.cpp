// SPDX-License-Identifier: Apache-2.0
// The points that go with a distance of outlines: a common point is on both, others are as far apart as they should be.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>

#include "nearest/reference.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "vesica.h"

namespace {

using nearest_reference::Real;
using properties::Numbers;
using properties::Pair;

constexpr double u = 0x1p-53;

vesica_closest_points_f64 ask(const Pair& p) {
  vesica_closest_points_f64 out{-1, -1, -1, -1, -1};
  EXPECT_EQ(vesica_boundary_distance_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out), 0);
  return out;
}

/// A computed point's distance from where it should be, less its coordinates' rounding.
double in_scales(const Real& off, const Pair& p, double rounding) {
  const Real scale =
      nearest_reference::scale(nearest_reference::shape(p.kind_a, p.a), nearest_reference::shape(p.kind_b, p.b));
  return Real((off - Real(u * rounding)) / (Real(u) * scale)).get_d();
}

/// In u of the scale.
double common_point_off(const Pair& p) {
  const auto found = ask(p);
  EXPECT_EQ(found.distance, 0) << properties::describe(p);
  EXPECT_TRUE(found.ax == found.bx && found.ay == found.by);
  nearest_reference::set_precision(p);
  double worst = 0;
  for (const auto& [kind, numbers] : {std::pair(p.kind_a, p.a), std::pair(p.kind_b, p.b)}) {
    const auto shape = nearest_reference::shape(kind, numbers);
    const Real off = abs(nearest_reference::beyond_outline(shape, found.ax, found.ay, Real(u * 0x1p-10)));
    worst = std::fmax(worst, in_scales(off, p, std::fabs(found.ax) + std::fabs(found.ay)));
  }
  return worst;
}

/// How far the two points' distance is from the one that is given, in u of the scale.
double gap_off(const Pair& p) {
  const auto f = ask(p);
  EXPECT_GT(f.distance, 0);
  nearest_reference::set_precision(p);
  const Real dx = Real(f.bx) - Real(f.ax), dy = Real(f.by) - Real(f.ay);
  const Real off = abs(Real(sqrt(Real(dx * dx + dy * dy)) - Real(f.distance)));
  return in_scales(off, p, std::fabs(f.ax) + std::fabs(f.ay) + std::fabs(f.bx) + std::fabs(f.by));
}

/// Both shapes, changed without rounding: turned, mirrored, scaled.
Pair changed(const Pair& p, int how) {
  properties::Shape a{p.kind_a, p.a}, b{p.kind_b, p.b};
  if (how % 2 != 0) a = properties::mirrored(a), b = properties::mirrored(b);
  for (int quarter = 0; quarter < how / 2 % 4; ++quarter) a = properties::turned(a), b = properties::turned(b);
  const int exponent = 211 * (how / 8 % 3 - 1);
  const auto x = properties::scaled_exactly(a, properties::Scalar::f64, exponent, false);
  const auto y = properties::scaled_exactly(b, properties::Scalar::f64, exponent, false);
  return x && y ? Pair{x->kind, y->kind, x->numbers, y->numbers} : Pair{a.kind, b.kind, a.numbers, b.numbers};
}

// Were off an outline by up to twice the needle's size: in the frame in which the needle is round, the other outline
// has no digits left.
TEST(OutlinePoints, CommonPointsOfNeedles) {
  const Pair needles[] = {{VESICA_ELLIPSE,
                           VESICA_CIRCLE,
                           {0x1.dafc7978bb618p-3, -0x1.0f40913ef15p-8, 0x1.4b14cc8410729p-1, -0x1.868cc4ef8f132p-1,
                            0x1.c839c951941ebp-28, 0x1.4dd65c648d778p-1},
                           {0x1.d2ad671a807e4p-1, -0x1.ba85a7782b92p-4, 0x1.00d98a90f234p+0}},
                          {VESICA_CIRCLE, VESICA_ELLIPSE, {0, 0, 1}, {0, 1, 1, 0x1.8p-1, 0x1p-41, 1}},
                          {VESICA_CIRCLE, VESICA_ELLIPSE, {0, 0, 1}, {0, 1, 0x1.bp+1, 2, 0x1.ff8p-30, 0x1p-2}},
                          {VESICA_ELLIPSE, VESICA_ELLIPSE, {0, 0, 0x1p-1, 1, 0x1p-28, 1}, {1, 0, 1, 0, 1, 0x1.1p+0}}};
  for (const Pair& needle : needles) {
    for (int how = 0; how < 24; ++how) {
      const Pair p = changed(needle, how);
      EXPECT_LE(common_point_off(p), 4) << properties::describe(p);
      EXPECT_LE(common_point_off(swapped(p)), 4);
      EXPECT_EQ(ask(p).ax, ask(swapped(p)).ax);
    }
  }
}

Numbers drawn(int kind, double thinness, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double angle = 6.28 * unit(random), size = 1 + 3 * unit(random), x = 4 * unit(random), y = 4 * unit(random);
  if (kind == VESICA_SEGMENT) return {x, y, 4 * unit(random), 4 * unit(random)};
  if (kind == VESICA_CIRCLE) return {x, y, size};
  if (kind == VESICA_CAPSULE) return {x, y, 4 * unit(random), 4 * unit(random), thinness * size};
  const bool upright = unit(random) < 0.5;
  const double radius = kind == VESICA_ROUND_RECT ? size * std::exp2(-60 * unit(random)) : 0;
  return {
      x,     y, std::cos(angle), std::sin(angle), upright ? thinness * size : size, upright ? size : thinness * size,
      radius};
}

/// most: in u of the scale.
void expect_common_points(const std::array<int, 4>& kinds, double most) {
  std::mt19937_64 random(properties::seed());
  std::uniform_real_distribution<double> unit(0, 1);
  int crossing = 0;
  double worst = 0;
  for (int i = 0; i < 6000 * properties::repeat(); ++i) {
    const int kind = kinds[static_cast<std::size_t>(i % 4)];
    const double thinness = std::exp2(-60 * unit(random));
    Pair p{kind, VESICA_ELLIPSE, drawn(kind, i % 3 == 0 ? thinness : 1 - unit(random) / 2, random),
           drawn(VESICA_ELLIPSE, thinness, random)};
    if (i % 5 == 0) p.a[0] = p.b[0] + thinness * unit(random), p.a[1] = p.b[1];
    if (vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) != VESICA_CROSS) continue;
    worst = std::fmax(worst, common_point_off(p));
    EXPECT_LE(common_point_off(p), most) << properties::describe(p);
    ++crossing;
  }
  EXPECT_GT(crossing, 2000 * properties::repeat());
  testing::Test::RecordProperty("worst_in_u_scale", std::to_string(worst));
}

TEST(OutlinePoints, CommonPointsAtEveryAspect) {
  expect_common_points({VESICA_SEGMENT, VESICA_CIRCLE, VESICA_RECT, VESICA_ELLIPSE}, 4);
}

TEST(OutlinePoints, CommonPointsOfCoresWithARadius) {
  expect_common_points({VESICA_CAPSULE, VESICA_ROUND_RECT, VESICA_CAPSULE, VESICA_ROUND_RECT}, 12);
}

// Were 2e-8 of the size off: the search stopped where the distance would gain less than its rounding, which leaves half
// of the direction's digits open.
TEST(OutlinePoints, OfNestedShapesNearTangencyAreAsFarApartAsTheDistance) {
  const Pair nested[] = {
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0x1.980fde03b8cc4p+0, 0x1.e8a7f3acaa73cp-2, -0x1.e3d0f1dff5181p-1, -0x1.4f0ec3df326ep-2, 0x1.07e3cfa823a9dp+1,
        0x1.be29a31920e2bp+0},
       {0x1.980fdddc8f354p+0, 0x1.e8a7faf436d84p-2, -0x1.e3d0f2934dd23p-1, -0x1.4f0ebcd539d1dp-2, 0x1.07e3cfaf05235p+1,
        0x1.063d74dd147a9p-2}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0x1.48a4e49fca3bap-2, 0x1.d5f4bbcf8042fp-1, -0x1.09d5707f373efp-2, -0x1.ee723e22a1de3p-1, 0x1.78672ef7b6616p-28,
        0x1.8a443442ac1eap+0},
       {0x1.48a4e49fc67b3p-2, 0x1.d5f4bbcf80f96p-1, -0x1.09d5707f373efp-2, -0x1.ee723e22a1dd7p-1, 0x1.78642e2e1d268p-28,
        0x1.8a42b56ed0696p+0}},
      // A needle whose side is bent as the outline it lies at.
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0, 0, 0x1.259c6ec93p+1, 0x1.7af0396p-5, 0x1.a8d6c0bdp+0, 0x1.1a9ce1f3p+0},
       {0x1.bb222c3ap+1, 0x1.17b94307p+0, 0x1.2398a393p-1, -0x1.a4d9e034p-1, 0x1.8d6dp-10, 0x1.14b4p-20}}};
  for (const Pair& pair : nested) {
    for (int how = 0; how < 24; ++how) {
      EXPECT_LE(gap_off(changed(pair, how)), 16);
      EXPECT_LE(gap_off(swapped(changed(pair, how))), 16);
    }
  }
}

/// An ellipse inside another from which it differs little, or that it nearly touches at one end.
TEST(OutlinePoints, OfNestedEllipsesAreAsFarApartAsTheDistance) {
  std::mt19937_64 random(properties::seed());
  std::uniform_real_distribution<double> unit(0, 1);
  int nested = 0;
  double worst = 0;
  for (int i = 0; i < 8000 * properties::repeat(); ++i) {
    const Numbers outer = drawn(VESICA_ELLIPSE, std::exp2(-20 * unit(random)), random);
    const double near = std::exp2(-50 * unit(random)), nearer = std::exp2(-50 * unit(random));
    Numbers inner = outer;
    inner[4] *= 1 - near, inner[5] *= 1 - nearer;
    if (i % 2 == 0) inner[5] *= unit(random);
    inner[0] += near * inner[4] * outer[2] * unit(random), inner[1] += near * inner[4] * outer[3] * unit(random);
    const Pair p{VESICA_ELLIPSE, VESICA_ELLIPSE, outer, inner};
    if (vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) != VESICA_CONTAINS) continue;
    worst = std::fmax(worst, gap_off(p));
    EXPECT_LE(gap_off(p), 16) << properties::describe(p);
    ++nested;
  }
  EXPECT_GT(nested, 500 * properties::repeat());
  RecordProperty("worst_in_u_scale", std::to_string(worst));
}

/// An ellipse of half lengths 1 and `outer_b`, and one inside it at a gap: at the contact its radius of curvature is
/// 1 - less of the other's.
Pair osculating(double outer_b, double at, double inner_aspect, double inner_at, double less, double gap) {
  const auto radius = [](double a, double b, double t) {
    return std::pow(std::hypot(a * std::sin(t), b * std::cos(t)), 3) / (a * b);
  };
  const double a = radius(1, outer_b, at) * (1 - less) / radius(1, inner_aspect, inner_at), b = a * inner_aspect;
  const auto normal = [](double p, double q, double t) { return std::atan2(p * std::sin(t), q * std::cos(t)); };
  const double towards = normal(1, outer_b, at), turn = towards - normal(a, b, inner_at);
  const double ux = std::cos(turn), uy = std::sin(turn), x = a * std::cos(inner_at), y = b * std::sin(inner_at);
  const double cx = std::cos(at) - gap * std::cos(towards) - (ux * x - uy * y);
  const double cy = outer_b * std::sin(at) - gap * std::sin(towards) - (uy * x + ux * y);
  return {VESICA_ELLIPSE, VESICA_ELLIPSE, {0, 0, 1, 0, 1, outer_b}, {cx, cy, ux, uy, a, b}};
}

/// Checks the nested pairs among those drawn: there must be more than `least_nested`.
template <class Draw>
void expect_points_apart(int pairs, int least_nested, Draw draw) {
  int nested = 0;
  double worst = 0;
  for (int i = 0; i < pairs * properties::repeat(); ++i) {
    const Pair p = draw(i);
    if (vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) != VESICA_CONTAINS) continue;
    const double off = gap_off(p);
    worst = std::fmax(worst, off);
    EXPECT_LE(off, 16) << properties::describe(p);
    ++nested;
  }
  std::printf("%d nested, at most %g u scale off\n", nested, worst);
  EXPECT_GT(nested, least_nested * properties::repeat());
}

// Were up to 1e5 u of the scale off: the distance is as flat as its rounding over a hill beside the minimum.
TEST(OutlinePoints, OfOsculatingEllipsesAreAsFarApartAsTheDistance) {
  std::mt19937_64 random(properties::seed() + 3);
  std::uniform_real_distribution<double> unit(0, 1);
  expect_points_apart(20000, 1000, [&](int i) {
    const double turn = 6.3 * unit(random);
    return osculating(std::exp2(-4 * unit(random)), 6.3 * unit(random), std::exp2(-19 * unit(random)),
                      i % 2 == 0 ? turn : 1.57 + turn * 1e-3, std::exp2(-40 * unit(random)),
                      std::exp2(-10 - 40 * unit(random)));
  });
}

/// An ellipse of half lengths 1 and `b`, and about it a disc at a gap, or nearly one: at the contact its radius is
/// 1 + more of the ellipse's.
Pair in_disc(double b, double at, double turn, double more, double gap, double stretch) {
  const double c = std::cos(at), s = std::sin(at), ux = std::cos(turn), uy = std::sin(turn);
  const double length = std::hypot(c, s / b), nx = c / length, ny = s / b / length;
  const double radius = std::pow(std::hypot(s, b * c), 3) / b * (1 + more), off = radius * (1 - gap);
  const double cx = c - nx * off, cy = b * s - ny * off;
  return {VESICA_ELLIPSE,
          VESICA_ELLIPSE,
          {ux * cx - uy * cy, uy * cx + ux * cy, 1, 0, radius, radius * (1 + stretch)},
          {0, 0, ux, uy, 1, b}};
}

// Three in a thousand were up to 1e7 u of the scale off: where the curvature of an ellipse that is nearly a disc's is
// extreme too, the steps from a hill to the minimum beside it were too few.
TEST(OutlinePoints, OfEllipsesInDiscsThatBendAsTheyDoAreAsFarApartAsTheDistance) {
  std::mt19937_64 random(properties::seed() + 5);
  std::uniform_real_distribution<double> unit(0, 1);
  expect_points_apart(100000, 20000, [&](int i) {
    const double off_end = std::exp2(-45 * unit(random)) * (i % 2 == 0 ? 1 : -1);
    return in_disc(std::exp2((i % 3 == 0 ? -20 : -6) * unit(random)), 1.5707963267948966 + off_end, 6.3 * unit(random),
                   std::exp2(-5 - 50 * unit(random)) * (i % 4 == 0 ? -1 : 1), std::exp2(-10 - 42 * unit(random)),
                   i % 5 < 2 ? 0 : std::exp2(-8 - 40 * unit(random)));
  });
}

/// A short side along the tangent of an ellipse's outline, inside at a gap: its two ends are about as near.
Pair along_tangent(int kind, double outer_b, double at, double half, double gap) {
  const double towards = std::atan2(std::sin(at), outer_b * std::cos(at));
  const double nx = std::cos(towards), ny = std::sin(towards);
  const double cx = std::cos(at) - gap * nx, cy = outer_b * std::sin(at) - gap * ny;
  const Numbers outer{0, 0, 1, 0, 1, outer_b};
  if (kind == VESICA_RECT) return {VESICA_ELLIPSE, kind, outer, {cx, cy, nx, ny, 0, half}};
  return {VESICA_ELLIPSE, kind, outer, {cx - half * ny, cy + half * nx, cx + half * ny, cy - half * nx}};
}

// Were of different ends: the search ended along the normal of the side, which is the same for both corners.
TEST(OutlinePoints, OfTiedCornersBelongToOneOfThem) {
  const Pair ties[] = {{VESICA_CIRCLE, VESICA_SEGMENT, {0, 1, 0x1.01p+0}, {0x1p-27, 0, 0, 0x1p-111}},
                       {VESICA_ELLIPSE,
                        VESICA_RECT,
                        {0, 0, 0x1.884d078p-1, -0x1.49012b9p-1, 0x1.5508435p+1, 0x1.f616bbp-3},
                        {-0x1.cb1bf9p+0, 0x1.541bc77p+0, -0x1.137ddf5p+0, -0x1.f09e617p-1, 0, 0x1p-28}}};
  for (const Pair& pair : ties) {
    for (int how = 0; how < 24; ++how) EXPECT_LE(gap_off(changed(pair, how)), 16);
  }
  std::mt19937_64 random(properties::seed() + 4);
  std::uniform_real_distribution<double> unit(0, 1);
  int nested = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const int kind = i % 2 == 0 ? VESICA_RECT : VESICA_SEGMENT;
    const Pair p = along_tangent(kind, i % 4 < 2 ? 1 : std::exp2(-4 * unit(random)), 6.3 * unit(random),
                                 std::exp2(-20 - 25 * unit(random)), std::exp2(-4 - 44 * unit(random)));
    if (vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) != VESICA_CONTAINS) continue;
    EXPECT_LE(gap_off(p), 16) << properties::describe(p);
    ++nested;
  }
  EXPECT_GT(nested, 5000 * properties::repeat());
}

}  // namespace
