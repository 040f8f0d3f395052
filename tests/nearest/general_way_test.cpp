// SPDX-License-Identifier: Apache-2.0
// What is asked where the usual search is not settled, ties among them, asked everywhere: every vertex and face, and
// halving alone. Both find the same distance.
#include <gtest/gtest.h>

#include <cmath>
#include <vesica/nearest.hpp>

#include "properties/random.hpp"

namespace {

using namespace vesica;
using namespace vesica::detail::nearest;
using properties::Random;

/// Distances err by 4u of the scale each; `size` is more than that.
constexpr double allowed = 8 * 0x1p-53;

/// Small integers: half of the pairs are parallel, and some shapes have no width.
Rect<double> rect(Random& random) {
  const double straight = random.below(2);
  return {0, 0, straight + random.below(2), 1 - straight, double(random.below(3)), double(random.below(3))};
}
Ellipse<double> ellipse(Random& random) {
  const double x = random.integer(-6, 6), y = random.integer(-6, 6), straight = random.below(2);
  const double ux = straight + random.below(2), a = random.integer(1, 3);
  return {x, y, ux, 1 - straight, a, double(random.integer(1, 3))};
}

template <class A, class B>
ScaledPair scaled(const A& a, const B& b) {
  return scaled_pair(form_times(a, 1.0), form_times(b, 1.0));
}

TEST(GeneralWay, FeaturesOfBoxAndEllipse) {
  Random random(properties::seed());
  int asked = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const Rect<double> a = rect(random);
    const Ellipse<double> b = ellipse(random);
    if (overlap(a, b)) continue;
    const ScaledPair p = scaled(a, b);
    int steps = 0;
    const BoxEllipse<double> found = box_ellipse_by_features(p.a.box, p.b.axes(), p.d, p.size, steps);
    const double distance = std::ldexp(rounded(found.distance), p.exponent);
    ++asked;
    ASSERT_NEAR(distance, nearest(a, b).distance, allowed * std::ldexp(p.size, p.exponent))
        << a.ux << ' ' << a.uy << ' ' << a.hx << ' ' << a.hy << " | " << b.cx << ' ' << b.cy << ' ' << b.ux << ' '
        << b.uy << ' ' << b.a << ' ' << b.b;
  }
  EXPECT_GT(asked, 1000);
}

TEST(GeneralWay, HalvingOfEllipses) {
  Random random(properties::seed());
  int asked = 0;
  for (int i = 0; i < 10000 * properties::repeat(); ++i) {
    Ellipse<double> a = ellipse(random);
    const Ellipse<double> b = ellipse(random);
    a.cx = a.cy = 0;
    if (overlap(a, b)) continue;
    const ScaledPair p = scaled(a, b);
    const auto found = ellipse_ellipse_by_halving(p.a.axes(), p.b.axes(), p.d, p.size);
    ++asked;
    ASSERT_NEAR(std::ldexp(rounded(found.distance), p.exponent), nearest(a, b).distance,
                allowed * std::ldexp(p.size, p.exponent));
  }
  EXPECT_GT(asked, 500);
}

TEST(GeneralWay, VerticesOfBoxes) {
  Random random(properties::seed());
  int asked = 0;
  for (int i = 0; i < 10000 * properties::repeat(); ++i) {
    const Rect<double> a = rect(random);
    Rect<double> b = rect(random);
    b.cx = random.integer(-6, 6), b.cy = random.integer(-6, 6);
    if (overlap(a, b)) continue;
    const ScaledPair p = scaled(a, b);
    const auto found = box_box_by_vertices(p.a.box, p.b.box, p.d);
    ++asked;
    ASSERT_NEAR(std::ldexp(rounded(found.distance), p.exponent), nearest(a, b).distance,
                allowed * std::ldexp(p.size, p.exponent));
  }
  EXPECT_GT(asked, 500);
}

}  // namespace
