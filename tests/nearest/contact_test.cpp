// SPDX-License-Identifier: Apache-2.0
// At contact and just short of it: distances that are right to 2u of themselves, and common points in both shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "nearest/face.hpp"
#include "nearest/reference.hpp"
#include "properties/generators.hpp"

namespace {

using nearest_reference::Real;
using nearest_test::Answer;
using properties::Numbers;
using properties::Pair;

/// The error in u of the distance, where the header promises 2; 0 elsewhere.
double error_of_itself(const Pair& pair) {
  nearest_reference::set_precision(pair);
  const auto a = nearest_reference::shape(pair.kind_a, pair.a), b = nearest_reference::shape(pair.kind_b, pair.b);
  const Answer r = nearest_test::nearest(properties::Scalar::f64, pair);
  EXPECT_EQ(r.code, 0);
  if (r.distance == 0) return 0;
  const auto exact = nearest_reference::distance(a, b, r.bx - r.ax, r.by - r.ay);
  const Real scale = nearest_reference::scale(a, b);
  const Real aspect = std::max(nearest_reference::aspect(a), nearest_reference::aspect(b));
  const bool promised = exact.upper > Real(1e-10) * scale || (exact.upper > Real(1e-14) * scale && aspect <= 1000);
  if (!exact.proved() || !promised) return 0;
  return Real(abs(Real(Real(r.distance) - exact.upper)) / exact.upper * Real(0x1p53)).get_d();
}

// Was off by 6 last places: the last Newton step was longer than its own rounding allows.
TEST(NearestContact, APointAtTheEndOfAThinEllipse) {
  const Pair pair{VESICA_POINT,
                  VESICA_ELLIPSE,
                  {0x1.3f63dcefae31cp+1, 0x1.20b2b42337212p+1},
                  {0x1.3f60e9adfba11p+1, 0x1.0a3b5dd5c74bfp+1, 1, 0, 0x1.00be89b210a6fp-8, 0x1.678db464acdc5p-3}};
  EXPECT_EQ(nearest_test::nearest(properties::Scalar::f64, pair).distance, 0x1.c3100416c7c4bp-49);
  EXPECT_LE(error_of_itself(pair), 2);
}

/// A point, circle or ellipse beside an ellipse of an aspect up to 1000, most often near its ends.
TEST(NearestContact, Ellipses) {
  std::mt19937_64 random(properties::seed());
  std::uniform_real_distribution<double> unit(0, 1);
  double worst = 0;
  for (int i = 0; i < 1500 * properties::repeat(); ++i) {
    const double b = std::exp2(-9.9 * unit(random)), turn = 6.28 * unit(random);
    const double ux = std::cos(turn), uy = std::sin(turn), cx = 8 * unit(random) - 4, cy = 8 * unit(random) - 4;
    const double t = 3 * std::pow(unit(random), 6), gap = std::exp2(-45 * unit(random));
    double nx = b * std::cos(t), ny = std::sin(t);
    const double length = std::hypot(nx, ny);
    nx /= length, ny /= length;
    const double r = i % 3 == 0 ? 0 : std::exp2(-12 * unit(random));
    const double x = std::cos(t) + (gap + r) * nx, y = b * std::sin(t) + (gap + r) * ny;
    const double px = cx + x * ux - y * uy, py = cy + x * uy + y * ux;
    const int kind = i % 3 == 0 ? VESICA_POINT : i % 3 == 1 ? VESICA_CIRCLE : VESICA_ELLIPSE;
    Numbers other{px, py, r};
    if (kind == VESICA_ELLIPSE) other = {px, py, 0.6, 0.8, r, r * (0.5 + unit(random))};
    const Pair pair{kind, VESICA_ELLIPSE, other, {cx, cy, ux, uy, 1, b}};
    const double error = error_of_itself(pair);
    EXPECT_LE(error, 2) << properties::describe(pair);
    worst = std::max(worst, error);
  }
  RecordProperty("worst_in_u", std::to_string(worst));
}

// Was 0.042: the face that the ellipse all but touches was taken for its vertex.
TEST(NearestContact, AFaceThatAnEllipseAllButTouches) {
  const Pair pair{VESICA_RECT,
                  VESICA_ELLIPSE,
                  {-0x1.f04c41a506cp-52, 0, 0x1.8d4e1a8e01875p-1, 0x1.42f1995cb90cbp-1, 1, 0x1.7cee8e42f12c8p-6},
                  {0x1.1ce2908419da2p+0, 0x1.0330c8f78e62p+0, 0x1.8552bfbf8b70ep-1, 0x1.4c85d69270895p-1,
                   0x1.3afdead6ec723p+1, 0x1.0e2a577fc4393p-7}};
  const Answer r = nearest_test::nearest(properties::Scalar::f64, pair);
  EXPECT_GT(r.distance, 0);
  EXPECT_LE(r.distance, 0x1p-52);
}

/// How far a common point is outside of a shape, at least, in u of the scale, less its coordinates' rounding.
double common_point_outside(const Pair& pair) {
  const Answer r = nearest_test::nearest(properties::Scalar::f64, pair);
  EXPECT_TRUE(r.code == 0 && r.distance == 0);
  nearest_reference::set_precision(pair);
  const auto a = nearest_reference::shape(pair.kind_a, pair.a), b = nearest_reference::shape(pair.kind_b, pair.b);
  const Real scale = nearest_reference::scale(a, b), rounding = Real(0x1p-53) * (std::fabs(r.ax) + std::fabs(r.ay));
  Real worst = 0;
  for (const auto* shape : {&a, &b}) {
    const Real off = nearest_reference::beyond_outline(*shape, r.ax, r.ay, Real(0x1p-60) * scale) - rounding;
    if (off > worst) worst = off;
  }
  return Real(worst / scale * Real(0x1p53)).get_d();
}

// Were up to 256,450 u of the scale outside.
TEST(NearestContact, CommonPointsOfNeedles) {
  const Pair pairs[] = {{VESICA_ELLIPSE, VESICA_AABB, {0, 0, -0x1p-1, 1, 0x1.8p-28, 4}, {-32, -0x1p+30, 0x1p+41, -1}},
                        {VESICA_ELLIPSE, VESICA_AABB, {0, 0, 0x1.fp-1, -1, 0x1p-28, 1}, {-0x1.4p+36, 0x1p-2, 2, 1}},
                        {VESICA_ELLIPSE,
                         VESICA_RECT,
                         {0, 0, 1, 0x1.273cfd3c5p-1, 0x1.1a3a01435p+2, 0x1p-36},
                         {0x1.deb0e7fe1p+0, 0x1.fe93aba3cp+0, -0x1.f4778b02p-1, -0x1.b03cbef08p-3, 4, 0x1p-36}}};
  for (const Pair& pair : pairs) {
    EXPECT_LE(common_point_outside(pair), 8) << properties::describe(pair);
    EXPECT_EQ(nearest_test::nearest(properties::Scalar::f64, properties::swapped(pair)),
              nearest_test::exchanged(nearest_test::nearest(properties::Scalar::f64, pair)));
  }
}

// A needle's tip in the flank of another that is all but parallel to it. Were up to 1e7 u of the scale outside: the
// point was beyond the tip, and only the other ellipse was asked whether it holds the point.
TEST(NearestContact, CommonPointsOfTipsInFlanks) {
  properties::Random random(properties::seed());
  const auto power = [&random](int least, int most) {
    return std::ldexp(1 + random.unit(), random.integer(least, most));
  };
  int overlapping = 0;
  for (int i = 0; i < 8000 * properties::repeat(); ++i) {
    const double angle = 6.3 * random.unit(), ux = std::cos(angle), uy = std::sin(angle), turn = power(-41, -31);
    const double length = power(-16, -13), width = length * power(-18, -14), over = power(-29, -25);
    const double along = 1 + length * std::sqrt(over) * random.unit(), across = width * (1 - over);
    const Pair pair{
        VESICA_ELLIPSE,
        VESICA_ELLIPSE,
        {0, 0, ux, uy, 1, power(-46, -34)},
        {ux * along - uy * across, uy * along + ux * across, ux - uy * turn, uy + ux * turn, length, width}};
    if (nearest_test::nearest(properties::Scalar::f64, pair).distance > 0) continue;
    ++overlapping;
    EXPECT_LE(common_point_outside(pair), 8) << properties::describe(pair);
  }
  EXPECT_GT(overlapping, 4000 * properties::repeat());
}

// The common point of needles that meet in plain arithmetic is not in both; one of their crossings is. And the search
// for the normal of two needles far less than the other that ends by its limit of steps. In the last pair a needle that
// is taken for a segment holds a smaller one beside that segment.
TEST(NearestContact, CommonPointsThatAreNotFoundAtOnce) {
  const Pair pairs[] = {
      {VESICA_CIRCLE,
       VESICA_ELLIPSE,
       {0x1.28dd3bef6cda2p+1, -0x1.f9c872accdc11p+0, 0x1.57b656ea63b18p-11},
       {0x1.7dae3938acf3cp+1, -0x1.3a0d51c4c29b8p+0, -0x1.538446a73324ep-1, -0x1.7f3d46ce5877p-1, 1,
        0x1.6bc3a7247c62p-46}},
      {VESICA_CIRCLE,
       VESICA_ELLIPSE,
       {0x1.ffffe9ebfce36p-1, 0x1.8d9dc4aed45adp-2, 0x1.8d9dc4aed45adp-2},
       {0, 0, 1, 0, 1, 0x1.7c36441f0ebfcp-47}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0x1.9deefa078c656p-1, 0x1.2c994e1a02b91p-1, 0x1.7fb2d950cc70cp-1, -0x1.f447085c5ffc2p-1, 0x1.53cb7f47515c5p-29,
        0x1.16dde2ab993f1p-64},
       {0, 0, 0x1.9e48d95996753p-1, 0x1.2cda453210698p-1, 1, 0x1.79214ae30f96ap-15}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {-0x1.f4eb689081defp-1, -0x1.a368453eee201p-3, -0x1.3ebab6460101cp-2, 0x1.f24f3b5e00c3ep-1,
        0x1.b4d509100b26bp-32, 0x1.800c0798d1487p-38},
       {0, 0, -0x1.f523a06cca17fp-1, -0x1.a39748e81ecdbp-3, 1, 0x1.d63423d81e6b7p-19}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0, 0, -0x1.92adcb793151bp+6, -0x1.b26145e241d5fp+3, 0x1.3a834b22bbb63p-6, 0x1.0c165f631b58fp-61},
       {0x1.038ab0cf9573ap+0, 0x1.17f96c4d29661p-3, -0x1.92adcb7934118p+6, -0x1.b26145e241d5fp+3, 0x1.50719f19455d8p-25,
        0x1.39d0c7bc2476fp-70}}};
  for (const Pair& pair : pairs) {
    EXPECT_LE(common_point_outside(pair), 8) << properties::describe(pair);
    EXPECT_EQ(nearest_test::nearest(properties::Scalar::f64, properties::swapped(pair)),
              nearest_test::exchanged(nearest_test::nearest(properties::Scalar::f64, pair)));
  }
}

// A point all but on the side of a needle: the outline bends less than the distance along the direction found is off,
// so that a further step has no length, or three of them do not end the way.
TEST(NearestContact, APointAllButOnANeedle) {
  const Pair pairs[] = {
      {VESICA_POINT,
       VESICA_ELLIPSE,
       {0x1.df95632e0a32p-1, 0x1.0739dfae93a6cp+0},
       {0, 0x1.5b2a6beebadap-1, 0x1.df95632e0a321p-1, 0x1.6692a6dcd8e72p-2, 1, 0x1.15b0c58f5c188p-46}},
      {VESICA_POINT,
       VESICA_ELLIPSE,
       {0x1.9ea56cbe0da07p+2, 0x1.a9211c21fa06ap-1},
       {0x1.c24fc05f2c466p+2, 0, -0x1.1d529d08f505ep-1, 0x1.a9211c21fa226p-1, 1, 0x1.47fcce4df5d1p-40}}};
  for (const Pair& pair : pairs) {
    nearest_reference::set_precision(pair);
    const auto a = nearest_reference::shape(pair.kind_a, pair.a), b = nearest_reference::shape(pair.kind_b, pair.b);
    const Answer r = nearest_test::nearest(properties::Scalar::f64, pair);
    const auto exact = nearest_reference::distance(a, b, r.bx - r.ax, r.by - r.ay);
    EXPECT_GT(r.distance, 0);
    EXPECT_LE(abs(Real(Real(r.distance) - exact.upper)), Real(0x1p-52) * nearest_reference::scale(a, b))
        << properties::describe(pair);
    EXPECT_EQ(nearest_test::nearest(properties::Scalar::f64, properties::swapped(pair)), nearest_test::exchanged(r));
  }
}

// A shape all but on the tip of a needle, along its axis up to far less. The direction found was that of a needle's
// side: it was reached by a step too long to foresee what is left, or further steps only went some times as far as the
// one before, or led astray. Or a face counted that the tip was not above. Up to 3000u of the scale were off.
TEST(NearestContact, AllButOnTheTipOfANeedle) {
  const auto point = [](const Numbers& at, const Numbers& needle) {
    return Pair{VESICA_POINT, VESICA_ELLIPSE, at, needle};
  };
  const auto needles = [](const Numbers& one, const Numbers& other) {
    return Pair{VESICA_ELLIPSE, VESICA_ELLIPSE, one, other};
  };
  const Pair pairs[] = {
      point({0x1.a7aed57b525d4p+0, 0x1.e876673b55e32p-72},
            {0, 0, 0x1.781be8b88a92cp-5, 0, 0x1.2061a16152182p+5, 0x1.fc41c68e7229cp-47}),
      point({0x1.b171f85b63ce7p+0, 0x1.22204a7f2be1fp-97},
            {0, 0, 0x1.4db77e528350ap-5, 0, 0x1.4c80e099ee9d3p+5, 0x1.82a786170ce8dp-36}),
      point({0x1.f866d4a9b742cp+0, 0x1.4c084016a6338p-70},
            {0, 0, 0x1.7e9c46d99789dp-5, 0, 0x1.517d30e716e6fp+5, 0x1.c3713bb331624p-41}),
      point({0x1.b50878a73d52dp+0, -0x1.9a40f54dc8408p-89},
            {0, 0, 0x1.992810014fc17p-5, 0, 0x1.11711716a28efp+5, 0x1.16bca82f0baaep-38}),
      point({0x1.e655e1ffc5177p+0, 0x1.e4a71498216b8p-105}, {0, 0, 0x1.c9ba3e1de6acap-5, 0, 0x1.1p+5, 0x1.8p-47}),
      needles({0, 0, 0x1.f191279dac404p-5, 0, 0x1.db5bdf68edf71p+4, 0x1.5ef88ef70d662p-45},
              {0x1.dc442e911ea8dp+0, 0x1.a80a4b7bbfbcp-97, 1, 0, 0x1.c9d77ce36ac13p-5, 0x1.402cc4230ff63p-56}),
      needles({0, 0, 1, 0, 0x1.f0d21ada29c5ep+0, 0x1.f5ce415a3065cp-42},
              {0x1.f0d40d5ad53fp+0, 0, 1, 0, 0x1.f280ab791d5fcp-16, 0x1.0d7913b9a3792p-50}),
      needles({0, 0, 1, 0, 0x1.26748fd31866bp+0, 0x1.f76f236ab6c57p-42},
              {0x1.267884148f90bp+0, -0x1.e85915d9b4a9ep-135, -0x1.279908e8d66b5p-3, 0, 0x1.b653eb527d5acp-12,
               0x1.4c3a0edaed295p-59}),
      point({0x1.c678939cfd55bp+0, 0x1.3bc78562ac1a8p-10}, {0, 0, 16, 0, 0x1.c678939cfd55ap-4, 0x1.b9bb83fb6f13fp-53}),
      point({0x1.593f453537bcep+0, 0x1.c7e4c4d7ae003p-50}, {0, 0, 1, 0, 0x1.593f453537bcdp+0, 0x1.a38febb2688a5p-50}),
      {VESICA_SEGMENT,
       VESICA_ELLIPSE,
       {0x1.e25ca40d716f1p+0, -0x1.8d485db8ae363p-11, 0x1.e25ca60d716f1p+0, -0x1.8d485db8c1b6dp-11},
       {0, 0, 1, 0, 0x1.e25ca40d716f1p+0, 0x1.e25ca40d716f1p-46}},
      {VESICA_RECT,
       VESICA_ELLIPSE,
       {-0x1.fe23177aa3342p+0, 0x1.5e19c95ed523ap-137, 1, -0x1p-27, 0x1.9cf3a5eb4a922p-14, 0x1.9cf3a5eb4a922p-66},
       {0, 0, 1, 0, 0x1.fe1ca3ac0b87p+0, 0x1.b987f020de1e7p-44}},
      {VESICA_ELLIPSE, VESICA_RECT, {0, 0, 3, 0x1p-1058, 9, 3}, {-28, -1, 1, 1, 1, 0}}};
  for (const Pair& pair : pairs) {
    nearest_reference::set_precision(pair);
    const auto a = nearest_reference::shape(pair.kind_a, pair.a), b = nearest_reference::shape(pair.kind_b, pair.b);
    const Answer r = nearest_test::nearest(properties::Scalar::f64, pair);
    const auto exact = nearest_reference::distance(a, b, pair.b[0] - pair.a[0], 0);
    EXPECT_EQ(r.code, 0);
    EXPECT_LE(abs(Real(Real(r.distance) - exact.upper)), Real(0x1p-51) * nearest_reference::scale(a, b))
        << properties::describe(pair);
  }
}

// Needles above the sides of needles: rounded coordinates of a vector do not separate the best direction from others
// whose points are far along the needle, or off it once they were moved along a tangent.
TEST(NearestContact, AboveTheSideOfANeedle) {
  const Pair pairs[] = {
      {VESICA_CIRCLE,
       VESICA_ELLIPSE,
       {0x1.7c33104fc19b8p+0, 0x1.52354cf52ae7fp+0, 0x1.469032bac3316p-8},
       {0, 0, 0x1.7f9968cbb50e8p+0, 0x1.531c2ad16c51fp+0, 0x1.fcdb036eec3b4p-1, 0x1.fcdb036eec3b4p-53}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {-0x1.580e529d69dcdp-2, -0x1.1e3284aaef91dp+0, -0x1.26c5bbcabe4eep-2, -0x1.ea53e7d51adp-1, 0x1.554a44f03c11ap-24,
        0x1.554a44f03c11ap-76},
       {0, 0, -0x1.26c5bbcabe4eep-1, -0x1.ea53e7d51adp+0, 0x1.2ad7e2e3991bap-1, 0x1.2ad7e2e3991bap-52}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0x1.b65cf536f2fbep+0, 0x1.f4f0466e71aacp-30, 1, 0, 0x1.2b904d6b764cfp-27, 0x1.2b904d6b764cfp-59},
       {0, 0, 1, 0, 0x1.b65cf536f1fecp+0, 0x1.fb7952b2ca88dp-52}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0x1.4f7a2397a8c09p+0, 0x1.3f3749b3e43ccp-24, 1, 0, 0x1.5e1a93a0d7e3dp-5, 0x1.5e1a93a0d7e3dp-42},
       {0, 0, 1, 0, 0x1.4c45eddcc59ddp+0, 0x1.4c45eddcc59ddp-52}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0x1.dc314ccf0e8f8p+0, 0x1.98c78e884e6d8p-15, 1, 0, 0x1.a74dcd9034ea1p-29, 0x1.a74dcd9034ea1p-81},
       {0, 0, 0x1p+2, 0, 0x1.dce0a1000f2eap-2, 0x1.dce0a1000f2eap-53}},
      {VESICA_ELLIPSE,
       VESICA_SEGMENT,
       {0, 0, 0x1.8p+1, 0x1p+2, 0x1.a63362fad62cdp-2, 0x1p-45},
       {0x1.3ca68a3c20a15p+0, 0x1.a63362fad62d1p+0, 0x1.3ca6ap+0, 0x1.a6338p+0}}};
  for (const Pair& pair : pairs) {
    nearest_reference::set_precision(pair);
    const auto a = nearest_reference::shape(pair.kind_a, pair.a), b = nearest_reference::shape(pair.kind_b, pair.b);
    const Answer r = nearest_test::nearest(properties::Scalar::f64, pair);
    const auto exact = nearest_reference::distance(a, b, r.bx - r.ax, r.by - r.ay);
    const Real u_of_scale = Real(0x1p-53) * nearest_reference::scale(a, b);
    EXPECT_LE(abs(Real(Real(r.distance) - exact.upper)), 2 * u_of_scale) << properties::describe(pair);
    for (const auto& [s, x, y] : {std::tuple{&a, r.ax, r.ay}, {&b, r.bx, r.by}}) {
      EXPECT_LE(abs(nearest_reference::beyond_outline(*s, x, y, u_of_scale)), 8 * u_of_scale)
          << properties::describe(pair);
    }
    EXPECT_EQ(nearest_test::nearest(properties::Scalar::f64, properties::swapped(pair)), nearest_test::exchanged(r));
  }
}

// A slope whose terms cancel to nothing says little of the direction where the outline hardly bends; and whether a
// point of support is above a face is unknown from rounded numbers if the distance is as small as their errors.
TEST(NearestContact, AllButTouching) {
  const Pair pairs[] = {
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {-0x1.e95800c1da36ap+4, -0x1.4fc468b1f173bp+9, 0x1.3333333333333p-1, 0x1.999999999999ap-1, 0x1.0f60f8a837d8p-1,
        0x1.6011c5f910b3fp-7},
       {-0x1.f3853d48291b8p+4, -0x1.5030f5e234bd4p+9, 0x1.8p+1, 0x1p+2, 0x1.b234c10d26266p-4, 0x1.b234c10d26266p-10}},
      {VESICA_SEGMENT,
       VESICA_ELLIPSE,
       {-0x1.4d8981048a626p-1, 0x1.8cdd719326633p-1, -0x1.e6cbc0d08cf9ep+0, -0x1.1a1ca2e79bd9ep-2},
       {0, 0, -0x1.4969bf3925bf8p+14, 0x1.87f53b8c00787p+14, 0x1.03347883943d8p-15, 0x1.03347883943d8p-23}}};
  for (const Pair& pair : pairs) EXPECT_LE(error_of_itself(pair), 2) << properties::describe(pair);
}

// The way from one shape to the other is 0 in the pair's unit; the distance must not be.
TEST(NearestContact, ACircleOfTheLeastNumbers) {
  for (const double gap : {0x1p-1072, 0x1p-1071, 0x1p-1060}) {
    for (const Numbers& other : {Numbers{-1, -1, 0, 1}, Numbers{-1, 0, 0, 0}, Numbers{-1, 0, 1, 0, 1, 1}}) {
      const int kind = other[4] == 1 ? VESICA_ELLIPSE : other[1] == -1 ? VESICA_AABB : VESICA_SEGMENT;
      const Answer r = nearest_test::nearest(properties::Scalar::f64, {VESICA_CIRCLE, kind, {gap, 0, gap / 2}, other});
      EXPECT_TRUE(r.code == 0 && r.distance > 0 && r.distance <= 0x1p-52) << kind;
      EXPECT_NEAR(r.ax, 0, 0x1p-52);
      EXPECT_NEAR(r.bx, 0, 0x1p-52);
    }
  }
}

// In batches' unit and in the pair's the search took another number of steps: the distance changed by a relative 1e-9.
TEST(NearestContact, ScaledByAPowerOfTwo) {
  const Pair pair{
      VESICA_ELLIPSE,
      VESICA_ELLIPSE,
      {0, 0, -0x1.51f5b6c73571p+1, 0x1.076c3620895p+0, 0x1.2d16153727d8p-1, 0x1.26823d496cep-4},
      {0x1.5adbdd3f55e4p+0, -0x1.a245107b4a05p-2, 0x1.49d6994bfb65p+1, -0x1.76734902de1p+0, 0x1.05p-1, 0x1.934dp-38}};
  const double distance = nearest_test::nearest(properties::Scalar::f64, pair).distance;
  for (const int exponent : {-300, -3, 5, 300}) {
    Pair scaled = pair;
    for (const std::size_t i : {0U, 1U, 4U, 5U}) {
      scaled.a[i] = std::ldexp(pair.a[i], exponent);
      scaled.b[i] = std::ldexp(pair.b[i], exponent);
    }
    EXPECT_EQ(nearest_test::nearest(properties::Scalar::f64, scaled).distance, std::ldexp(distance, exponent));
  }
}

// The offset of centres underflowed in the pair's unit, and with it the sign that decides the order.
TEST(NearestContact, ExchangedWhereTheOffsetIsBelowTheRange) {
  const double length = 0x1.9bb15ffc51cfep+964;
  const Pair pair{VESICA_SEGMENT, VESICA_SEGMENT, {0, 0, 0, length}, {-0x1p-184, 0, -0x1p-115, length}};
  EXPECT_EQ(nearest_test::nearest(properties::Scalar::f64, properties::swapped(pair)),
            nearest_test::exchanged(nearest_test::nearest(properties::Scalar::f64, pair)));
}

// The common point's zero had the sign of the shape that came second.
TEST(NearestContact, TheSignOfAZeroDoesNotTellTheOrder) {
  const Numbers low{-0.0, -0.0, 1, 0, 2, 1}, high{-0.0, 0.0, 1, 0, 2, 1};
  for (const int kind : {VESICA_POINT, VESICA_RECT, VESICA_ELLIPSE}) {
    for (const bool swapped : {false, true}) {
      const Pair pair{kind, kind, swapped ? high : low, swapped ? low : high};
      const Answer r = nearest_test::nearest(properties::Scalar::f64, pair);
      EXPECT_FALSE(std::signbit(r.ax) || std::signbit(r.ay) || std::signbit(r.bx) || std::signbit(r.by)) << kind;
    }
  }
}

}  // namespace
