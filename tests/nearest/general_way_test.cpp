// SPDX-License-Identifier: Apache-2.0
// The fallback of an unsettled search, such as a tie, used everywhere: every vertex and face, and
// signs of slopes alone. Both find the same distance.
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
    const BoxEllipse<double> found = box_ellipse_by_features(p.a.box, p.b.axes(), p.d, p.size);
    const double distance = std::ldexp(rounded(found.distance), p.exponent);
    ++asked;
    ASSERT_NEAR(distance, nearest(a, b).distance, allowed * std::ldexp(p.size, p.exponent))
        << a.ux << ' ' << a.uy << ' ' << a.hx << ' ' << a.hy << " | " << b.cx << ' ' << b.cy << ' ' << b.ux << ' '
        << b.uy << ' ' << b.a << ' ' << b.b;
  }
  EXPECT_GT(asked, 1000);
}

/// Halfway from 2^-20 to 2^-60, and from an axis to another; slopes below 2^-200 are no farther. To both sides of an
/// axis it is that.
TEST(GeneralWay, BracketsAreHalvedByPowersOfTwo) {
  const auto slope = [](const Bracket<double>& b) {
    Direction<double> n{0, 0};
    const bool halved = halves_powers(b, n);
    EXPECT_TRUE(!halved || (b.holds(n) && std::fabs(std::fabs(n.x) + std::fabs(n.y) - 1) < 1e-15));
    return halved ? n.y / n.x : 7;
  };
  EXPECT_DOUBLE_EQ(slope({{1, 0x1p-60}, {1, 0x1p-20}}), 0x1p-40);
  EXPECT_DOUBLE_EQ(slope({{1, -0x1p-20}, {1, -0x1p-60}}), -0x1p-40);
  EXPECT_DOUBLE_EQ(slope({{0x1p-20, 1}, {0x1p-60, 1}}), 0x1p40);
  EXPECT_DOUBLE_EQ(slope({{-0x1p-60, 1}, {-0x1p-20, 1}}), -0x1p40);
  EXPECT_DOUBLE_EQ(slope({{-1, -0x1p-60}, {-1, -0x1p-20}}), 0x1p-40);
  EXPECT_DOUBLE_EQ(slope({{1, 0}, {0, 1}}), 1);
  EXPECT_DOUBLE_EQ(slope({{0, -1}, {1, 0}}), -1);
  EXPECT_DOUBLE_EQ(slope({{1, 0x1p-900}, {1, 0x1p-20}}), 0x1p-110);
  EXPECT_EQ(slope({{1, -0x1p-60}, {1, 0x1p-20}}), 0);
  EXPECT_EQ(slope({{1, -0x1p-20}, {1, 0x1p-20}}), 0);
  EXPECT_EQ(slope({{-1, 0x1p-60}, {-1, -0x1p-20}}), 0);
  EXPECT_EQ(slope({{0x1p-20, 1}, {-0x1p-60, 1}}), INFINITY);
  EXPECT_EQ(slope({{-0x1p-60, -1}, {0x1p-20, -1}}), -INFINITY);
  constexpr double none = 7;
  EXPECT_EQ(slope({{1, 0x1p-900}, {1, 0x1p-300}}), none) << "no difference that matters";
  EXPECT_EQ(slope({{1, 0x1p-5}, {1, 0.5}}), none) << "not far";
}

/// Every vertex and every face, in no order of preference.
BoxEllipse<double> closest_of_all(const ScaledPair& p) {
  BoxEllipse<double> best{{0x1p1000, 0}, {0, 0}, 0, 0, 0, 0, false};
  const bool is_point = p.a.box.hx.high == 0 && p.a.box.hy.high == 0;
  for (int k = 0; k < (is_point ? 4 : 12); ++k) {
    const bool again = (p.a.box.hx.high == 0 && k % 2 == 1) || (p.a.box.hy.high == 0 && k / 2 % 2 == 1);
    if (k < 4 && again) continue;
    int steps = 0;
    const auto search = [](const OneEllipse<double>& e, const Vector<double>& d, double size) {
      return bracketed_normal(e, d, size, Frame(e.a));
    };
    const auto found = searched_feature(p.a.box, p.b.axes(), p.d, p.size, feature(k), search, steps);
    const bool counts = k < 4 || (rounded(found.distance) > -0x1p-80 * p.size &&
                                  stands_above(p.a.box, p.b.axes(), p.d, feature(k), found.distance.high));
    if (counts && less(found.distance, best.distance)) best = found;
  }
  return best;
}

/// Ellipses down to a billionth of the box, beside faces and vertices: those that need no search change nothing.
TEST(GeneralWay, VerticesThatNeedNoSearch) {
  Random random(properties::seed());
  int asked = 0;
  for (int i = 0; i < 10000 * properties::repeat(); ++i) {
    const Rect<double> a = rect(random);
    Ellipse<double> b = ellipse(random);
    const double scale = std::ldexp(1.0, -random.integer(0, 40)), about = std::ldexp(1.0, -random.integer(0, 40));
    b.a *= scale, b.b *= scale;
    if (random.chance(0.5)) b.cx = std::trunc(b.cx / 2) + about * random.integer(-2, 2);
    if (random.chance(0.5)) b.cy = std::trunc(b.cy / 2) + about * random.integer(-2, 2);
    if (overlap(a, b)) continue;
    const ScaledPair p = scaled(a, b);
    if (p.a.curved || !p.b.curved) continue;
    const auto found = box_ellipse_by_features(p.a.box, p.b.axes(), p.d, p.size), all = closest_of_all(p);
    ++asked;
    ASSERT_EQ(found.distance.high, all.distance.high);
    ASSERT_EQ(found.distance.low, all.distance.low);
    ASSERT_TRUE(found.bx == all.bx && found.by == all.by && found.spot.s == all.spot.s && found.spot.t == all.spot.t);
  }
  EXPECT_GT(asked, 1000);
}

TEST(GeneralWay, BracketsOfEllipses) {
  Random random(properties::seed());
  int asked = 0;
  for (int i = 0; i < 10000 * properties::repeat(); ++i) {
    Ellipse<double> a = ellipse(random);
    const Ellipse<double> b = ellipse(random);
    a.cx = a.cy = 0;
    if (overlap(a, b)) continue;
    const ScaledPair p = scaled(a, b);
    const auto ellipses = two_ellipses(p.a.axes(), p.b.axes());
    const Frame frame = frame_of_flatter(ellipses, farthest_normal(ellipses, p.d, p.size));
    const auto found = offsets_along(ellipses, p.d, bracketed_normal(ellipses, p.d, p.size, frame), p.size);
    ++asked;
    ASSERT_NEAR(std::ldexp(rounded(found.distance), p.exponent), nearest(a, b).distance,
                allowed * std::ldexp(p.size, p.exponent));
  }
  EXPECT_GT(asked, 500);
}

/// Needles and tiny ellipses at any distance take about four steps. Few take many: where two needles' normals are known
/// to all digits in different frames.
TEST(GeneralWay, BracketsCloseInFewSteps) {
  Random random(properties::seed());
  const auto length = [&random] { return std::ldexp(0.5 + 0.5 * random.unit(), -random.integer(0, 60)); };
  const auto number = [&] { return random.sign() * length(); };
  int asked = 0, of_points = 0, of_pairs = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const Ellipse<double> a{0, 0, number(), number(), length(), length()};
    const Ellipse<double> b{number(), number(), number(), number(), length(), length()};
    if (overlap(a, b) || overlap(Point<double>{0, 0}, b)) continue;
    ++asked;
    const ScaledPair p = scaled(a, b);
    const auto pair = two_ellipses(p.a.axes(), p.b.axes());
    const Frame frame = frame_of_flatter(pair, farthest_normal(pair, p.d, p.size));
    of_pairs += bracketed_normal(pair, p.d, p.size, frame).steps;
    const Axes<double> e = p.b.axes();
    of_points += bracketed_normal(one_ellipse(e), p.d, p.size, Frame(e)).steps;
  }
  EXPECT_GT(asked, 1000);
  EXPECT_LT(of_pairs, 8 * asked);
  EXPECT_LT(of_points, 5 * asked);
}

/// For two ellipses that are mirror images the frame comes from the same one in either order.
TEST(GeneralWay, FrameOfMirrorImages) {
  const Axes<double> left{0.6, 0.8, 2, 0.5}, right{0.6, -0.8, 2, 0.5};
  const Vector<double> to_right{{8, 0}, {0, 0}}, to_left{{-8, 0}, {0, 0}};
  const auto seen_by = [&](const TwoEllipses<double>& shapes, const Vector<double>& d) {
    return frame_of_flatter(shapes, farthest_normal(shapes, d, 10)).of(to_right);
  };
  const Direction<double> seen = seen_by(two_ellipses(left, right), to_right);
  const Direction<double> back = seen_by(two_ellipses(right, left), to_left);
  EXPECT_EQ(seen.x, back.x);
  EXPECT_EQ(seen.y, back.y);
  EXPECT_NE(seen.y, 0);
}

/// A result that the search has not proved is not settled, even if it is right.
TEST(GeneralWay, DirectionThatWasNotFound) {
  const OneEllipse<double> e = one_ellipse(Axes<double>{1, 0, 1, 1});
  const Vector<double> d{{4, 0}, {0, 0}};
  FoundNormal along = farthest_normal(e, d, 5);
  EXPECT_TRUE(offsets_along(e, d, along, 5).settled);
  along.found = false;
  EXPECT_FALSE(offsets_along(e, d, along, 5).settled);
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
