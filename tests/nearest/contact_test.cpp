// SPDX-License-Identifier: Apache-2.0
// Distances just short of contact, where an ellipse bends sharply: right to 2u of themselves.
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
