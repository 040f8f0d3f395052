// SPDX-License-Identifier: Apache-2.0
// Places of outlines that almost coincide, almost touch or almost osculate, that begin at a place, and of sizes far
// from 1: as many as exact integers count, each where they find a true one, in order.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "area/reference.hpp"
#include "capi/face.hpp"
#include "crossings/crossing_count.hpp"
#include "properties/generators.hpp"

namespace hard_test {
namespace {

using properties::Random, properties::repeat, properties::seed;

constexpr double u = 0x1p-53, turn = 2 * std::numbers::pi;

struct Shape {
  int kind;
  std::vector<double> numbers;
};

Shape circle(double x, double y, double r) { return {VESICA_CIRCLE, {x, y, r}}; }
Shape ellipse(double x, double y, double ux, double uy, double a, double b) {
  return {VESICA_ELLIPSE, {x, y, ux, uy, a, b}};
}

std::string text(const Shape& s) {
  std::string out = s.kind == VESICA_CIRCLE ? "circle" : s.kind == VESICA_ELLIPSE ? "ellipse" : std::to_string(s.kind);
  char number[40];
  for (const double x : s.numbers) {
    std::snprintf(number, sizeof number, " %a", x);
    out += number;
  }
  return out;
}

struct Oval {
  double cx, cy, ux, uy, a, b;
  explicit Oval(const Shape& s) {
    const auto& n = s.numbers;
    const bool round = s.kind == VESICA_CIRCLE;
    const double length = round ? 1 : std::hypot(n[2], n[3]);
    cx = n[0], cy = n[1], ux = round ? 1 : n[2] / length, uy = round ? 0 : n[3] / length;
    a = n[round ? 2 : 4] * length, b = n[round ? 2 : 5] * length;
  }
  double extent() const { return std::fmax(std::fmax(std::fabs(cx), std::fabs(cy)), std::fmax(a, b)); }
  double angle(double x, double y) const {
    const double dx = x - cx, dy = y - cy, at = std::atan2((ux * dy - uy * dx) / b, (ux * dx + uy * dy) / a);
    return at < 0 ? at + turn : at;
  }
  /// 1 on the outline.
  double size_at(double x, double y) const {
    const double dx = x - cx, dy = y - cy;
    return std::hypot((ux * dy - uy * dx) / b, (ux * dx + uy * dy) / a);
  }
  /// How much angle() may change within a distance.
  double slack(double distance) const { return 4 * distance / std::fmin(a, b) + 64 * u; }
};

/// The contract: what vesica_crossings_f64 promises of places, in u of the greatest coordinate and size.
constexpr double promised = 4;

struct Tally {
  int asked = 0, meeting = 0, equal = 0, failures = 0;
  double furthest = 0;

  void fail(const Shape& a, const Shape& b, const char* what) {
    if (++failures <= 3) ADD_FAILURE() << what << ", seed " << seed() << "\n  " << text(a) << " | " << text(b);
  }
  void ask(const Shape& a, const Shape& b) {
    capi_tests::Crossings<double> out, back;
    const int count = capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out);
    ASSERT_GE(count, 0) << text(a) << " | " << text(b);
    ++asked;
    meeting += count > 0;
    const reference::Meeting truth = reference::meeting(a.kind, a.numbers.data(), b.kind, b.numbers.data());
    if (count != truth.count || (out.shared != 0) != truth.shared) return fail(a, b, "not as many");
    if (capi_tests::crossings<double>(b.kind, b.numbers.data(), a.kind, a.numbers.data(), &back) != count) {
      return fail(a, b, "not as many of exchanged shapes");
    }
    for (int i = 0; i < count; ++i) {
      bool found = false;
      for (int k = 0; k < count; ++k) found = found || (back.x[k] == out.x[i] && back.y[k] == out.y[i]);
      if (!found) return fail(a, b, "other places of exchanged shapes");
    }
    const Oval p(a), q(b);
    const double extent = std::fmax(p.extent(), q.extent()), near = promised * u * extent + 0x1p-1073;
    for (int i = 0; i < count; ++i) {
      for (const Shape* s : {&a, &b}) {
        double off = reference::distance_to_outline(s->kind, s->numbers.data(), out.x[i], out.y[i]);
        // That is a formula for points near the outline; well inside, the outline is within the lesser half length.
        const Oval o(*s);
        if (o.size_at(out.x[i], out.y[i]) < 0.5) off = std::fmin(off, std::fmin(o.a, o.b));
        if (extent > 0x1p-900) furthest = std::fmax(furthest, off / (u * extent));
        if (off > near) return fail(a, b, "off an outline");
      }
    }
    in_order(a, b, p, out, near);
    where_true_ones_are(a, b, q, out, near);
  }
  void in_order(const Shape& a, const Shape& b, const Oval& p, const capi_tests::Crossings<double>& out, double near) {
    if (std::fmin(p.a, p.b) < 1024 * near) return;
    for (int i = 0; i + 1 < out.count; ++i) {
      double from = p.angle(out.x[i], out.y[i]), to = p.angle(out.x[i + 1], out.y[i + 1]);
      const double slack = 2 * p.slack(near);
      if (i == 0 && from > turn - slack) from = 0;
      if (i + 2 == out.count && to < slack) to = turn;
      if (from > to + slack) return fail(a, b, "not in order");
    }
  }
  /// As many true places around each group of places as the group has, and as many different ones as are distinct.
  void where_true_ones_are(const Shape& a, const Shape& b, const Oval& q, const capi_tests::Crossings<double>& out,
                           double near) {
    if (out.count == 0 || std::fmin(q.a, q.b) < 1024 * near) return;
    for (int i = 0; i < out.count; ++i) {
      const double at = q.angle(out.x[i], out.y[i]), slack = q.slack(near);
      int same = 0;
      for (int k = 0; k < out.count; ++k) same += out.x[k] == out.x[i] && out.y[k] == out.y[i];
      equal += same > 1;
      if (reference::meetings_between(a.kind, a.numbers.data(), b.kind, b.numbers.data(), at - slack, at + slack) <
          same) {
        return fail(a, b, "fewer true places here");
      }
    }
  }
  void report(const char* name) const {
    std::printf("%-28s %6d asked, %6d meet, at most %.2g u x extent off, %d places not told apart\n", name, asked,
                meeting, furthest, equal);
    EXPECT_EQ(failures, 0) << name;
    EXPECT_GT(meeting, 0);
  }
};

/// Some places further on, by a tenth of a place to 64 of them: a number that is 0 moves by as much of the size.
double moved(double x, double size, Random& random) {
  const double by = std::exp2(random.between(-3.3, 6)) * random.sign() * std::ldexp(size, -53);
  return x == 0 ? (random.chance(0.5) ? by : 0) : x + by * (x / size);
}

Shape any_ellipse(Random& random, double most_aspect) {
  const double at = random.between(0, turn), a = random.between(0.5, 2);
  const double b = a * std::exp2(-random.between(0, std::log2(most_aspect)));
  return ellipse(random.integer(-2, 2), random.integer(-2, 2), std::cos(at), std::sin(at), a, b);
}

Shape scaled(Shape s, int by) {
  for (std::size_t i = 0; i < s.numbers.size(); ++i) {
    if (s.kind == VESICA_ELLIPSE && (i == 2 || i == 3)) continue;
    s.numbers[i] = std::ldexp(s.numbers[i], by);
  }
  return s;
}

TEST(CrossingsHard, NearlyCoincidentCircles) {
  Random random(seed());
  Tally tally;
  for (int i = 0; i < 400 * repeat(); ++i) {
    const Shape a = circle(random.integer(-1, 1), random.chance(0.5) ? 0 : random.unit(), random.between(0.5, 2));
    Shape b = a;
    for (double& x : b.numbers) x = random.chance(0.6) ? moved(x, std::fabs(a.numbers[2]), random) : x;
    tally.ask(a, b);
  }
  tally.report("nearly coincident circles");
}

TEST(CrossingsHard, NearlyCoincidentEllipses) {
  Random random(seed());
  Tally tally;
  for (int i = 0; i < 400 * repeat(); ++i) {
    const Shape a = any_ellipse(random, random.chance(0.8) ? 20 : 1e6);
    Shape b = a;
    for (double& x : b.numbers) x = random.chance(0.4) ? moved(x, 1, random) : x;
    tally.ask(a, b);
  }
  tally.report("nearly coincident ellipses");
}

/// x^2 + y^2 - 1 + lambda (x - 1)(p (x - 1) + q y) = 0 osculates the unit circle at (1, 0), and for q = 0 touches it to
/// the fourth order; with q = 0 its numbers can be stored: the ellipse about (c, 0) of half lengths 1 - c and b^2 = 1 -
/// c.
TEST(CrossingsHard, NearlyOsculatingEllipses) {
  Random random(seed());
  Tally tally;
  for (int i = 0; i < 500 * repeat(); ++i) {
    const double k = random.integer(2, 6), exponent = random.integer(20, 200),
                 by = random.sign() * std::exp2(-exponent);
    // The ellipse of half lengths k^2 and k and the circle of curvature at its end, at the origin or away from it.
    const double far = random.chance(0.5) ? 0 : random.integer(-8, 8);
    Shape a = ellipse(far - k * k, 25, 1, 0, k * k, k), b = ellipse(far - 1, 25, random.integer(1, 3), 0, 1, 1);
    b.numbers[4] = b.numbers[5] = 1 / b.numbers[2];
    if (b.numbers[2] == 3) b = circle(far - 1, 25, 1);
    // Contact of the second order only, turned a little, or moved.
    Shape& which = random.chance(0.5) ? a : b;
    const std::size_t at = static_cast<std::size_t>(random.below(static_cast<int>(which.numbers.size())));
    double& x = which.numbers[at];
    x = x == 0 ? by : x * (1 + by);
    tally.ask(a, b);
  }
  tally.ask(ellipse(-4, 25, -2, 0, .5, .5), ellipse(-4, 1, 0x1p-90, 1, 25, 5));
  tally.report("nearly osculating ellipses");
}

/// An ellipse and its circle of curvature at (0, q), which touch to the fourth order, moved along the tangent by 2^-20
/// to 2^-420: the true places are as near to each other as the cube root of that. Bisection then has many intervals
/// pending whose coefficients are all rounding.
TEST(CrossingsHard, OsculatingEllipsesMovedByFarLessThanRoundings) {
  Random random(seed());
  Tally tally;
  for (int i = 0; i < 200 * repeat(); ++i) {
    const double q = std::ldexp(1, random.integer(-2, 3)), p = random.integer(1, 10) * q, r = p * (p / q);
    const double by = random.sign() * random.integer(1, 8) * std::ldexp(1, -random.integer(20, 420));
    tally.ask(ellipse(by, 0, 1, 0, p, q), random.chance(0.5) ? circle(0, q - r, r) : ellipse(0, q - r, 1, 0, r, r));
  }
  tally.ask(ellipse(0x1p-224, 0, 1, 0, 10, 5), ellipse(0, -15, 3, 4, 4, 4));
  tally.report("osculating ellipses moved");
}

// The x of the places are 0 and the cube root of 3200 / 3 times the offset, up to its fourth power.
TEST(CrossingsHard, PlacesOfAnOsculatingCircle) {
  const Shape a = ellipse(0x1p-224, 0, 1, 0, 10, 5), b = ellipse(0, -15, 3, 4, 4, 4);
  capi_tests::Crossings<double> out;
  ASSERT_EQ(capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out), 2);
  const double far = std::cbrt(3200.0 / 3) * std::exp2(-224.0 / 3);
  EXPECT_NEAR(out.x[0], far, 0.01 * far);
  EXPECT_NEAR(out.x[1], 0, 0.01 * far);
  EXPECT_EQ(out.y[0], 5);
  EXPECT_EQ(out.y[1], 5);
}

/// A circle and an ellipse through (1, 0) with a common curvature there, crossing it: from the pencil with q != 0,
/// solved in doubles and so perturbed by their rounding.
TEST(CrossingsHard, OsculatingPencils) {
  Random random(seed());
  Tally tally;
  for (int i = 0; i < 300 * repeat(); ++i) {
    const double lambda = random.between(-0.8, 0.8), p = random.between(-1, 1), q = random.between(-1, 1);
    // (1 + lambda p) x^2 + lambda q x y + y^2 - 2 lambda p x - lambda q y + lambda p - 1 = 0
    const double m = 1 + lambda * p, n = lambda * q / 2, det = m - n * n;
    if (det < 0.05) continue;
    const double cx = (lambda * p - n * n) / det, cy = (m * n - n * lambda * p) / det;
    const double rest = 1 - lambda * p + lambda * p * cx + n * cy, mean = (m + 1) / 2,
                 half = std::hypot((m - 1) / 2, n);
    const double at = 0.5 * std::atan2(2 * n, m - 1);
    tally.ask(circle(0, 0, 1), ellipse(cx, cy, std::cos(at), std::sin(at), std::sqrt(rest / (mean + half)),
                                       std::sqrt(rest / (mean - half))));
  }
  tally.report("osculating pencils");
}

TEST(CrossingsHard, ThinFarTinyAndHuge) {
  Random random(seed());
  Tally thin, far, tiny, huge;
  for (int i = 0; i < 150 * repeat(); ++i) {
    const Shape a = any_ellipse(random, 20), b = any_ellipse(random, 20);
    thin.ask(any_ellipse(random, 1e12), any_ellipse(random, 1e12));
    Shape c = any_ellipse(random, 4), d = any_ellipse(random, 4);
    c.numbers[0] += 1e15, d.numbers[0] += 1e15;
    far.ask(c, d);
    tiny.ask(scaled(a, -1060), scaled(b, -1060));
    huge.ask(scaled(a, 1000), scaled(b, 1000));
  }
  thin.report("thin"), far.report("far"), tiny.report("tiny"), huge.report("huge");
}

/// The same bits, times a power of two.
TEST(CrossingsHard, AreScaledWithTheShapes) {
  Random random(seed());
  for (int i = 0; i < 300 * repeat(); ++i) {
    const Shape a = any_ellipse(random, 20), b = any_ellipse(random, 20);
    const int by = random.integer(-900, 900);
    const Shape c = scaled(a, by), d = scaled(b, by);
    capi_tests::Crossings<double> out, other;
    const int count = capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out);
    ASSERT_EQ(capi_tests::crossings<double>(c.kind, c.numbers.data(), d.kind, d.numbers.data(), &other), count);
    for (int k = 0; k < count; ++k) {
      EXPECT_EQ(std::ldexp(out.x[k], by), other.x[k]) << text(a) << " | " << text(b);
      EXPECT_EQ(std::ldexp(out.y[k], by), other.y[k]) << text(a) << " | " << text(b);
    }
  }
}

/// Integers far apart in size: cx = cy = 2^j m.
TEST(CrossingsHard, MixedExponents) {
  Random random(seed());
  Tally tally;
  const auto number = [&random] { return std::ldexp(random.between(0.5, 1), random.integer(-200, 200)); };
  for (int i = 0; i < 300 * repeat(); ++i) {
    Shape a = ellipse(number(), number(), number(), number(), number(), number());
    Shape b = ellipse(a.numbers[0], a.numbers[1], number(), number(), number(), number());
    if (random.chance(0.5)) b.numbers[0] = number();
    tally.ask(a, b);
  }
  tally.report("mixed exponents");
}

// Were errors of range: shares of an edge underflowed, and 0 was divided by 0.
TEST(CrossingsHard, EdgesFarLongerThanAnEllipse) {
  const auto count = [](const Shape& a, const Shape& b) {
    capi_tests::Crossings<double> out;
    return capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out);
  };
  EXPECT_EQ(count(ellipse(0, 0, 0, 0x1p-189, 1, 1), {VESICA_AABB, {-0x1p+976, -1, 0x1p-113, 0}}), 2);
  EXPECT_EQ(count(ellipse(0, 0, 0x1p-892, -1, 0x1p-14, 1), {VESICA_AABB, {0, 0, 1, 0x1p+229}}), 4);
}

// The start's place was given to its neighbour too, and the start came second.
TEST(CrossingsHard, ACornerAtTheStartAndANeighbour) {
  const double r = 0x1.1e68c65b0a91dp+493;
  const Shape a = circle(-r, 0, r), b{VESICA_AABB, {-1, -1, 0, 0}};
  capi_tests::Crossings<double> out;
  ASSERT_EQ(capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out), 2);
  EXPECT_TRUE(out.x[0] == 0 && out.y[0] == 0 && out.y[1] == -1);
}

/// The start of an outline is a place, and the other place is nearer to it than roundings: on either side, as near as
/// exponents allow.
TEST(CrossingsHard, AStartComesBeforePlacesNearerThanRoundings) {
  Random random(seed());
  int asked = 0;
  for (int i = 0; i < 300 * repeat(); ++i) {
    const double r = random.integer(1, 9), near = random.sign() * std::ldexp(1, -random.integer(20, 450));
    const double h = 256 * std::fabs(near);  // edges short enough to tell the places apart
    const Shape firsts[] = {circle(-r, 0, r), ellipse(-r, 0, 1, 0, r, r), ellipse(-2 * r, 0, 2, 0, r, 2 * r)};
    // The line x = -near y, and a small circle, through the origin.
    const Shape others[] = {{VESICA_SEGMENT, {near * h, -h, -near * h, h}},
                            {VESICA_SEGMENT, {-near * h, h, near * h, -h}},
                            {VESICA_RECT, {1, near, 1, near, 1, h}},
                            circle(0, near, std::fabs(near)),
                            ellipse(0, near, 0, -1, std::fabs(near), std::fabs(near))};
    for (const Shape& a : firsts) {
      for (const Shape& b : others) {
        capi_tests::Crossings<double> out;
        const int count = capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out);
        ASSERT_EQ(count, 2) << text(a) << " | " << text(b);
        ++asked;
        EXPECT_LE(std::fabs(out.y[0]), 64 * u * std::fabs(near)) << text(a) << " | " << text(b);
        EXPECT_LE(std::fabs(out.x[0]), 64 * u * std::fabs(near)) << text(a) << " | " << text(b);
        EXPECT_GT(out.y[1] * near, 0) << text(a) << " | " << text(b);
        EXPECT_LT(std::fabs(out.y[1]), 1000 * std::fabs(near)) << text(a) << " | " << text(b);
      }
    }
  }
  EXPECT_GT(asked, 1000);
}

// So near that their angles underflow: the place just before the start was taken for it, and the start's own place came
// next. It is the last.
TEST(CrossingsHard, APlaceJustBeforeTheStartIsTheLast) {
  const Shape a = ellipse(-0x1.8p-568, -0x1.4p-569, 0x1.8p+1, 0x1p-1073, 0x1p-571, 0x1p-569);
  const Shape b{VESICA_AABB, {-0x1.8p-568, -0x1.1p-567, -0x1.2p-568, -0x1.3ffffffffffffp-569}};
  capi_tests::Crossings<double> out;
  ASSERT_EQ(capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out), 6);
  EXPECT_EQ(out.x[0], -0x1.2p-568);
  EXPECT_EQ(out.y[0], -0x1.4p-569);
  EXPECT_EQ(out.x[5], -0x1.2p-568);
}

/// Two places on an edge, an ellipse's start and another: it is turned as little as exponents allow, and the edge
/// runs across the end of its axis.
TEST(CrossingsHard, AStartOnAnEdgeComesBeforeTheOtherPlaceThere) {
  Random random(seed());
  for (int i = 0; i < 300 * repeat(); ++i) {
    const double a = random.integer(1, 9), b = a * random.integer(1, 3);
    const double tilt = random.sign() * std::ldexp(1, -random.integer(20, 450)), h = 1024 * std::fabs(tilt);
    const Shape first = ellipse(-a, 0, 1, tilt, a, b);
    // To first order in the tilt.
    const double other = a * tilt * (1 - 2 * b * b / (a * a));
    const Shape others[] = {{VESICA_SEGMENT, {0, -h, 0, h}},
                            {VESICA_SEGMENT, {0, h, 0, -h}},
                            {VESICA_AABB, {0, -h, 1, h}},
                            {VESICA_RECT, {1, 0, 0, -1, h, 1}}};
    for (const Shape& second : others) {
      capi_tests::Crossings<double> out;
      ASSERT_EQ(
          capi_tests::crossings<double>(first.kind, first.numbers.data(), second.kind, second.numbers.data(), &out), 2)
          << text(first) << " | " << text(second);
      EXPECT_NEAR(out.y[0], a * tilt, 1e-9 * h) << text(first) << " | " << text(second);
      EXPECT_NEAR(out.y[1], other, 1e-9 * h) << text(first) << " | " << text(second);
    }
  }
}

/// One of the places is where the first outline begins, exactly; and it comes first.
TEST(CrossingsHard, AStartThatIsAPlaceComesFirst) {
  Random random(seed());
  constexpr int triples[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17},  {4, 3, 5},
                                {0, 1, 1}, {-3, 4, 5},  {-12, 5, 13}, {3, -4, 5}};
  int asked = 0;
  for (int i = 0; i < 400 * repeat(); ++i) {
    const auto& t = triples[random.below(8)];
    const double x = random.integer(-9, 9), y = random.integer(-9, 9), r = random.integer(1, 9),
                 w = random.integer(1, 3);
    const Shape firsts[] = {circle(x - r, y, r),
                            ellipse(x - r * w, y, w, 0, r, random.integer(1, 9)),
                            ellipse(x, y - r * w, 0, w, r, random.integer(1, 9)),
                            {VESICA_AABB, {x, y, x + r, y + w}},
                            {VESICA_RECT, {x + r, y + w, 1, 0, r, w}},
                            {VESICA_SEGMENT, {x, y, x + r, y - w}}};
    // Through (x, y), on the side that the circle's point has.
    const double tx = t[0], ty = t[1], tr = t[2];
    const Shape others[] = {circle(x + tx, y + ty, tr),
                            ellipse(x + tx, y + ty, 0, 1, tr, tr),
                            {VESICA_SEGMENT, {x - tx, y - ty, x + tx, y + ty}},
                            {VESICA_AABB, {x - 1, y - 20, x, y + 20}},
                            ellipse(x + 2 * tx, y + ty, 1, 0, 2 * tr, tr)};
    for (const Shape& a : firsts) {
      for (const Shape& b : others) {
        capi_tests::Crossings<double> out;
        const int count = capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out);
        if (out.shared != 0 && count == 0) continue;
        ASSERT_GT(count, 0) << text(a) << " | " << text(b);
        ++asked;
        EXPECT_NEAR(out.x[0], x, 64 * u) << text(a) << " | " << text(b) << ", seed " << seed();
        EXPECT_NEAR(out.y[0], y, 64 * u) << text(a) << " | " << text(b) << ", seed " << seed();
      }
    }
  }
  EXPECT_GT(asked, 1000);
}

}  // namespace
}  // namespace hard_test
