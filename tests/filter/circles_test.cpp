// SPDX-License-Identifier: Apache-2.0
// The look at circles and ellipses before the filter of round shapes: what it decides is what exact arithmetic decides,
// at the very distances where it begins to decide; it does decide there; and no invalid shape passes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vesica/overlap.hpp>

#include "properties/random.hpp"

namespace {

using namespace vesica;

std::mt19937_64 random_bits(20261122);

double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_bits); }
/// From 2^-exponent to 2^exponent, evenly on a logarithmic scale.
double magnitude(int exponent) { return std::exp2(between(-exponent, exponent)); }

Ellipse<double> random_ellipse(int exponent) {
  const double angle = between(0, 6.3), length = magnitude(exponent), size = magnitude(exponent);
  const double other = between(0, 1) < 0.3 ? size : size * magnitude(3);
  return {between(-1, 1), between(-1, 1), length * std::cos(angle), length * std::sin(angle), size, other};
}

struct Radii {
  double outer, inner;
};
Radii radii(const Ellipse<double>& e) {
  const double length = std::hypot(e.ux, e.uy);
  return {std::fmax(e.a, e.b) * length, std::fmin(e.a, e.b) * length};
}
Radii radii(const Circle<double>& c) { return {c.r, c.r}; }

/// Moves b to a distance where the look is about to say that the two are apart, or together, times 1 + by.
template <class A>
void place_at_edge(const A& a, Ellipse<double>& b, bool apart, double by) {
  const Radii p = radii(a), q = radii(b);
  const double least = std::fmin(p.inner, q.inner);
  const double edge = apart ? std::sqrt(2 * (p.outer * p.outer + q.outer * q.outer))
                            : std::sqrt(p.inner * p.inner + q.inner * q.inner + 2 * least * least);
  const double angle = between(0, 6.3);
  b.cx = a.cx + (1 + by) * edge * std::cos(angle);
  b.cy = a.cy + (1 + by) * edge * std::sin(angle);
}

/// The matrix of the squared reach.
struct Reach {
  double xx, yy, xy;
};
Reach reach(const Ellipse<double>& e) {
  const double a = e.a * e.a, b = e.b * e.b;
  return {a * e.ux * e.ux + b * e.uy * e.uy, a * e.uy * e.uy + b * e.ux * e.ux, (a - b) * e.ux * e.uy};
}
Reach reach(const Circle<double>& c) { return {c.r * c.r, c.r * c.r, 0}; }

/// The same at the edges of the ellipses about and within the sum of the two.
template <class A>
void place_at_edge_of_ellipse(const A& a, Ellipse<double>& b, bool apart, double by) {
  const Reach s = reach(a), t = reach(b);
  const double m = apart ? 0 : 2 * std::pow(std::fmin(radii(a).inner, radii(b).inner), 2);
  const double xx = s.xx + t.xx + m, yy = s.yy + t.yy + m, xy = s.xy + t.xy;
  const double angle = between(0, 6.3), x = std::cos(angle), y = std::sin(angle);
  const double edge = std::sqrt((apart ? 2 : 1) * (xx * yy - xy * xy) / (yy * x * x + xx * y * y - 2 * xy * x * y));
  b.cx = a.cx + (1 + by) * edge * x;
  b.cy = a.cy + (1 + by) * edge * y;
}

template <class A, class MakeA>
void attack(const MakeA& make_a) {
  int apart = 0, together = 0, apart_by_ellipse = 0, together_by_ellipse = 0;
  for (int i = 0; i < 120000 * properties::repeat(); ++i) {
    const int exponent = i % 3 == 0 ? 3 : 40;
    const A a = make_a(exponent);
    Ellipse<double> b = random_ellipse(exponent);
    const bool at_apart = i % 2 == 0, at_ellipse = i % 4 >= 2;
    const double by = std::ldexp(between(-1, 1), -static_cast<int>(between(5, 52)));
    at_ellipse ? place_at_edge_of_ellipse(a, b, at_apart, by) : place_at_edge(a, b, at_apart, by);
    if (check(a) != 0 || check(b) != 0) continue;
    const filter::Verdict<bool> verdict = detail::overlap::filter(a, b);
    const bool truth = detail::overlap::exact(a, b);
    ASSERT_FALSE(verdict.overlap && !truth) << "pair " << i;
    ASSERT_FALSE(verdict.disjoint && truth) << "pair " << i;
    if (at_apart && by > 0x1p-30) (at_ellipse ? apart_by_ellipse : apart) += verdict.disjoint;
    if (!at_apart && by < -0x1p-30) (at_ellipse ? together_by_ellipse : together) += verdict.overlap;
  }
  for (const int decided : {apart, together, apart_by_ellipse, together_by_ellipse}) {
    EXPECT_GT(decided, 5000 * properties::repeat());
  }
}

TEST(Circles, DecideAsExactArithmeticDoes) {
  attack<Ellipse<double>>(random_ellipse);
  attack<Circle<double>>([](int exponent) {
    return Circle<double>{between(-1, 1), between(-1, 1), magnitude(exponent)};
  });
}

template <class A>
void expect_undecided(A a, const Ellipse<double>& b) {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  double* fields = reinterpret_cast<double*>(&a);
  for (int field = 0; field < ShapeTraits<A>::fields; ++field) {
    for (const double bad : {nan, inf, -inf, -1.0}) {
      const double good = fields[field];
      fields[field] = bad;
      if (check(a) != 0) {
        const filter::Verdict<bool> verdict = detail::overlap::filter(a, b);
        EXPECT_FALSE(verdict.overlap || verdict.disjoint) << "field " << field << " is " << bad;
        EXPECT_EQ(overlap_or_error(a, b), error_shape);
      }
      fields[field] = good;
    }
  }
}

TEST(Circles, PassNoInvalidShape) {
  for (const double x : {0.0, 1.0, 100.0, 0x1p400}) {
    const Ellipse<double> near{0, 0, 1, 0, 1, 2}, far{x, 0, 0.6, 0.8, 2, 1};
    expect_undecided(near, far);
    expect_undecided(far, near);
    expect_undecided(Circle<double>{x, 0, 1}, near);
    EXPECT_EQ(overlap_or_error(near, Ellipse<double>{x, 0, 0, 0, 2, 1}), error_shape);
  }
}

/// The squared axis loses its x by underflow, which the half length would make a reach of 2^-40.
TEST(Circles, LeaveWhatUnderflowsTooMuch) {
  const Ellipse<double> flat{0, 0, 0x1p-540, 1, 0x1p500, 0x1p-48}, small{0, 0, 1, 0, 0x1p-48, 0x1p-48};
  EXPECT_FALSE(filter::Verdict<bool>(detail::overlap::filter(flat, small)).disjoint);
  EXPECT_FALSE(filter::Verdict<bool>(detail::overlap::filter(small, flat)).disjoint);
  EXPECT_EQ(overlap_or_error(flat, small), 1);
  for (int e = -1000; e <= 1000; e += 8) {
    const Ellipse<double> thin{0, 0, std::ldexp(1.0, e), 1, 0x1p300, 0x1p-48};
    const Circle<double> disc{0x1p-49, 0, 0x1p-48};
    EXPECT_FALSE(filter::Verdict<bool>(detail::overlap::filter(thin, small)).disjoint) << e;
    EXPECT_FALSE(filter::Verdict<bool>(detail::overlap::filter(disc, thin)).disjoint) << e;
  }
}

}  // namespace
