// SPDX-License-Identifier: Apache-2.0
// The stated bound on the outline's error, measured: how far the polygons and the circle segments are from the ellipse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vesica/methods/circle_ellipse_circle_approximation.hpp>

namespace {

using namespace vesica::methods::detail;
using Point = Vector<double>;

// The margin for rounding counts on 2 roundoffs.
TEST(EllipseOutlineError, HalfSecants) {
  EXPECT_NEAR(half_secants<double>.of[0], 0.70710678118654752, 0x1p-53);
  EXPECT_EQ(half_secants<double>.of[30], 0.5);
  for (int i = 0; i <= vesica::methods::most_sandwich_iterations; ++i) {
    const long double secant = 0.5L / std::cos(std::ldexp(3.14159265358979323846264338327950288L, -(i + 2)));
    const auto error = [secant](auto k) {
      return static_cast<double>(std::fabs(static_cast<long double>(k) / secant - 1));
    };
    EXPECT_LE(error(half_secants<double>.of[i]), 0x2p-53) << i;
    EXPECT_LE(error(half_secants<float>.of[i]), 0x1p-24) << i;
  }
}

/// Distance of a point in the first quadrant to the outline of the ellipse of half lengths 1 and h, from inside or out:
/// its nearest point is (x / (1 + t), y h^2 / (t + h^2)), t the root of a falling function.
double distance_to_outline(double half_height, const Point& p) {
  if (p.y == 0) return std::abs(1 - p.x);  // of points on the longer axis only its vertex is asked for
  const auto h = static_cast<long double>(half_height), px = static_cast<long double>(p.x);
  const auto py = static_cast<long double>(p.y);
  long double low = h * (py - h), high = px + py + 1;
  for (int i = 0; i < 120; ++i) {
    const long double t = (low + high) / 2, x = px / (1 + t), y = py * h / (t + h * h);
    (x * x + y * y > 1 ? low : high) = t;
  }
  return static_cast<double>(std::hypot(px * low / (1 + low), py * low / (low + h * h)));
}

/// `visit(arc)` for every arc of the first quadrant after `depth` halvings.
template <class Visit>
void each_arc(const Arc<double>& arc, int depth, int most, const Visit& visit) {
  if (depth == most) return visit(arc);
  const ArcEnd<double> half = middle(arc, depth);
  each_arc({arc.from, half}, depth + 1, most, visit);
  each_arc({half, arc.to}, depth + 1, most, visit);
}

struct Errors {
  double inner = 0, outer = 0;
};

constexpr int samples = 16;

Errors polygons(double h, int n) {
  Errors worst;
  each_arc(quarter(Point{1, 0}, Point{0, h}), 0, n, [&](const Arc<double>& arc) {
    for (int i = 0; i <= samples; ++i) {
      const double s = static_cast<double>(i) / samples;
      const Point on_chord = plus(times(1 - s, arc.from.at), times(s, arc.to.at));
      worst.inner = std::max(worst.inner, distance_to_outline(h, on_chord));
    }
    worst.outer = std::max(worst.outer, distance_to_outline(h, tip(arc, n)));
  });
  return worst;
}

double bound(int n) { return std::exp2(0.303 - 2 * n); }

TEST(EllipseOutlineError, PolygonsAreWithinTheBound) {
  std::printf("half lengths 1 and h; distance of polygon and outline over 2^(0.303 - 2 n), inner / outer\n");
  for (const double h : {1., 0.5, 0.1, 1e-3, 1e-6}) {
    std::printf("h = %-8g", h);
    for (const int n : {0, 1, 2, 3, 5, 8}) {
      const Errors errors = polygons(h, n);
      std::printf(" n = %d: %.4f / %.4f", n, errors.inner / bound(n), errors.outer / bound(n));
      EXPECT_LT(errors.inner, bound(n));
      EXPECT_LT(errors.outer, bound(n));
      if (h == 1) {
        EXPECT_GT(errors.inner, 0.23 * bound(n));
      }
    }
    std::printf("\n");
  }
}

/// A point of the circle tangent to `end` of the arc and through its other end, at share s of the way between them.
Point on_circle(const Arc<double>& arc, const ArcEnd<double>& end, double m, double wh, double s) {
  const double lambda = m / wh;
  const Point centre = minus(end.at, times(lambda, normal(end)));
  const Point a = minus(arc.from.at, centre), b = minus(arc.to.at, centre);
  const double from = std::atan2(a.y, a.x), to = std::atan2(b.y, b.x), angle = from + s * (to - from);
  const double radius = lambda * std::hypot(end.tangent.x, end.tangent.y);
  return plus(centre, {radius * std::cos(angle), radius * std::sin(angle)});
}

/// Signed by the side of the outline: what is not on the side it belongs to counts as below 0.
struct CircleErrors {
  double inner = 0, outer = 0, wrong_side = 0;
};

CircleErrors circles(double h, int n) {
  CircleErrors worst;
  each_arc(quarter(Point{1, 0}, Point{0, h}), 0, n, [&](const Arc<double>& arc) {
    const ArcEnd<double> half = middle(arc, n);
    const double m = dot(half.tangent, half.tangent);
    for (int i = 1; i < samples; ++i) {
      const double s = static_cast<double>(i) / samples;
      const Point inner = on_circle(arc, arc.to, m, h, s), outer = on_circle(arc, arc.from, m, h, s);
      const auto level = [h](const Point& p) { return std::hypot(p.x, p.y / h) - 1; };
      const double in = distance_to_outline(h, inner), out = distance_to_outline(h, outer);
      worst.inner = std::max(worst.inner, in);
      worst.outer = std::max(worst.outer, out);
      if (level(inner) > 1e-13) worst.wrong_side = std::max(worst.wrong_side, in);
      if (level(outer) < -1e-13) worst.wrong_side = std::max(worst.wrong_side, out);
    }
  });
  return worst;
}

TEST(EllipseOutlineError, CircleSegmentsAreWithinTheBound) {
  std::printf("half lengths 1 and h; distance of circle segments and outline over 2^(0.303 - 2 n), inner / outer\n");
  for (const double h : {0.9, 0.5, 0.1, 0.01}) {
    std::printf("h = %-8g", h);
    for (const int n : {0, 1, 2, 3, 5, 8}) {
      const CircleErrors errors = circles(h, n);
      std::printf(" n = %d: %.5f / %.5f", n, errors.inner / bound(n), errors.outer / bound(n));
      EXPECT_LT(errors.inner, bound(n));
      EXPECT_LT(errors.outer, bound(n));
      EXPECT_LT(errors.wrong_side, 1e-13);
    }
    std::printf("\n");
  }
}

// Third order: a factor of 8 for each halving.
TEST(EllipseOutlineError, CircleSegmentsConvergeInThirdOrder) {
  for (const int n : {3, 4, 5, 6}) {
    EXPECT_NEAR(circles(0.5, n).outer / circles(0.5, n + 1).outer, 8, 1) << n;
    EXPECT_NEAR(polygons(0.5, n).outer / polygons(0.5, n + 1).outer, 4, 0.1) << n;
  }
}

}  // namespace
