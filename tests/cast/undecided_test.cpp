// SPDX-License-Identifier: Apache-2.0
// How many casts the filter, the early outs and the fast hits leave open. One that leaves more is still right, only
// slower: a bound
// too wide, or a guard too narrow, shows here and in no answer. One that leaves fewer has a bound narrower than its
// proof, or a better proof, which is a reason to write other numbers here. The motions are the same everywhere, and
// nothing is fused.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vesica/cast.hpp>
#include <vesica/each_shape.hpp>

#include "filter/inputs.hpp"
#include "properties/generators.hpp"
#include "properties/pair.hpp"
#include "properties/random.hpp"
#include "properties/shape_maker.hpp"

namespace {

using namespace vesica;
using detail::cast::Motion;
using properties::Pair;
using properties::Random;
using properties::Vector;

constexpr int count = 2048;
/// Fixed: the numbers below are of these motions.
constexpr std::uint64_t seed = 1;

struct Moving {
  Pair pair;
  Motion motion;
};

double tiny(Random& random) {
  const double sign = random.sign(), size = 1 + random.unit();
  return sign * std::ldexp(size, -random.below(54));
}

/// The shapes touch at time 1, to which the second moves from -v: along the tangent, or towards the first to an end
/// near that. What is left of exactness is 1 to 2^-53, every power of two as likely.
Moving meeting(int kind_a, int kind_b, bool grazes, Random& random) {
  auto [pair, x, y] = properties::touching(kind_a, kind_b, random);
  const double length = std::sqrt(x * x + y * y), ahead = grazes ? 0 : -random.integer(1, 9);
  const double sign = random.sign(), beside = sign * random.integer(1, 9);
  const Vector n{x / length, y / length}, v{ahead * n.x - beside * n.y, ahead * n.y + beside * n.x};
  pair.a = properties::moved(kind_a, pair.a, {v.x, v.y});
  if (!grazes) return {pair, {v.x, v.y, 1 + tiny(random)}};
  double& coordinate = pair.a[static_cast<std::size_t>(random.below(2))];
  coordinate += tiny(random);
  return {pair, {v.x, v.y, random.integer(1, 3) / 2.0}};
}

/// All lengths times one power of two, all axes times another, the motion times a third.
Moving of_any_magnitude(Moving m, Random& random) {
  const int narrower = random.below(4), of_lengths = random.integer(-480, 480) >> narrower;
  const int of_axes = random.integer(-240, 240) >> narrower, of_motion = random.integer(-480, 480) >> narrower;
  const auto scale = [&](int kind, properties::Numbers& numbers) {
    for (int i = 0; i < properties::field_count(kind); ++i) {
      double& x = numbers[static_cast<std::size_t>(i)];
      x = std::ldexp(x, properties::role(kind, i) == properties::Role::axis ? of_axes : of_lengths);
    }
  };
  scale(m.pair.kind_a, m.pair.a);
  scale(m.pair.kind_b, m.pair.b);
  const double k = std::ldexp(1, of_motion);
  return {m.pair, {m.motion.vx * k, m.motion.vy * k, std::ldexp(m.motion.end, of_lengths - of_motion)}};
}

/// How many are undecided, and how many not certain to be apart at the start, by the filter of all kinds; how many the
/// filter of these kinds leaves open, and how many the fast hit after it (0 for kinds without them). For grazing
/// motions, for motions towards a contact, and for each at any magnitude.
using Left = std::array<int, 16>;

template <class A, class B>
void ask(const A& a, const B& b, const Motion& motion, int* left) {
  namespace cast = detail::cast;
  const cast::Body first = cast::body(a), second = cast::body(b);
  const cast::Filtered known = cast::filter(cast::sketch(first), cast::sketch(second), motion);
  left[0] += known.verdict == cast::Verdict::undecided;
  left[1] += !known.apart;
  if constexpr (cast::HasEarlyOut<A, B>) {
    Impact<double> found;
    const cast::EarlyOut quick = cast::early_out(a, b, motion);
    left[2] += quick == cast::EarlyOut::open;
    left[3] += quick == cast::EarlyOut::hit &&
               cast::fast_hit<cast::SplitProducts>(a, b, motion, found) == cast::EarlyOut::open;
  }
}

template <template <class> class A, template <class> class B>
Left left() {
  constexpr int kind_a = static_cast<int>(ShapeTraits<A<double>>::kind),
                kind_b = static_cast<int>(ShapeTraits<B<double>>::kind);
  Random random(seed);
  Left left{};
  const auto ask_at = [&](const Moving& m, int workload) {
    ask(inputs::shape_at<A<double>>(m.pair.a.data()), inputs::shape_at<B<double>>(m.pair.b.data()), m.motion,
        &left[static_cast<std::size_t>(4 * workload)]);
  };
  for (int i = 0; i < count; ++i) {
    for (const int towards : {0, 1}) {
      const Moving m = meeting(kind_a, kind_b, towards == 0, random);
      ask_at(m, towards);
      ask_at(of_any_magnitude(m, random), 2 + towards);
    }
  }
  return left;
}

struct Expected {
  const char* name;
  Left (*left)();
  Left expected;
};

class CastUndecided : public testing::TestWithParam<Expected> {};

TEST_P(CastUndecided, AreAsManyAsTheBoundsSay) { EXPECT_EQ(GetParam().left(), GetParam().expected); }

constexpr Expected all_expected[] = {
    {"point_point", left<Point, Point>, {235, 0, 0, 0, 1095, 0, 0, 0, 664, 477, 0, 0, 1374, 508, 0, 0}},
    {"segment_point",
     left<Segment, Point>,
     {1011, 367, 1291, 13, 1337, 56, 2048, 0, 1330, 825, 1819, 41, 1566, 636, 2048, 0}},
    {"segment_segment", left<Segment, Segment>, {1108, 736, 0, 0, 1083, 147, 0, 0, 1388, 1096, 0, 0, 1382, 650, 0, 0}},
    {"circle_point",
     left<Circle, Point>,
     {520, 840, 704, 369, 229, 473, 435, 719, 912, 1169, 1640, 126, 738, 855, 1530, 271}},
    {"circle_segment", left<Circle, Segment>, {517, 933, 0, 0, 244, 617, 0, 0, 969, 1229, 0, 0, 823, 1014, 0, 0}},
    {"circle_circle",
     left<Circle, Circle>,
     {565, 1062, 569, 443, 43, 850, 104, 962, 925, 1289, 1609, 122, 592, 1162, 1480, 321}},
    {"aabb_point",
     left<Aabb, Point>,
     {1181, 589, 1361, 71, 1118, 57, 1405, 363, 1416, 966, 1832, 52, 1367, 560, 1827, 128}},
    {"aabb_segment", left<Aabb, Segment>, {1213, 926, 0, 0, 865, 126, 0, 0, 1472, 1259, 0, 0, 1227, 665, 0, 0}},
    {"aabb_circle", left<Aabb, Circle>, {1341, 1359, 0, 0, 217, 586, 0, 0, 1524, 1540, 0, 0, 715, 954, 0, 0}},
    {"aabb_aabb", left<Aabb, Aabb>, {1250, 963, 0, 0, 950, 137, 0, 0, 1461, 1211, 0, 0, 1265, 608, 0, 0}},
    {"rect_point",
     left<Rect, Point>,
     {483, 633, 545, 83, 1169, 277, 1450, 339, 840, 1276, 1682, 31, 905, 1227, 1688, 52}},
    {"rect_segment", left<Rect, Segment>, {505, 817, 0, 0, 915, 360, 0, 0, 789, 1255, 0, 0, 829, 1286, 0, 0}},
    {"rect_circle", left<Rect, Circle>, {527, 1049, 0, 0, 227, 738, 0, 0, 764, 1240, 0, 0, 815, 1319, 0, 0}},
    {"rect_aabb", left<Rect, Aabb>, {485, 831, 0, 0, 797, 333, 0, 0, 742, 1233, 0, 0, 800, 1253, 0, 0}},
    {"rect_rect", left<Rect, Rect>, {532, 1028, 0, 0, 805, 552, 0, 0, 867, 1303, 0, 0, 844, 1294, 0, 0}},
    {"ellipse_point",
     left<Ellipse, Point>,
     {724, 1285, 931, 333, 144, 1748, 231, 1132, 923, 1314, 1790, 12, 802, 1296, 1764, 30}},
    {"ellipse_segment", left<Ellipse, Segment>, {796, 1363, 0, 0, 118, 1750, 0, 0, 872, 1319, 0, 0, 779, 1290, 0, 0}},
    {"ellipse_circle", left<Ellipse, Circle>, {778, 1354, 0, 0, 27, 1781, 0, 0, 870, 1305, 0, 0, 772, 1309, 0, 0}},
    {"ellipse_aabb", left<Ellipse, Aabb>, {783, 1338, 0, 0, 97, 1748, 0, 0, 801, 1283, 0, 0, 772, 1274, 0, 0}},
    {"ellipse_rect", left<Ellipse, Rect>, {763, 1321, 0, 0, 101, 1773, 0, 0, 913, 1299, 0, 0, 793, 1306, 0, 0}},
    {"ellipse_ellipse",
     left<Ellipse, Ellipse>,
     {824, 1424, 1426, 0, 11, 1976, 2041, 0, 912, 1299, 1299, 0, 755, 1320, 1331, 0}},
};

INSTANTIATE_TEST_SUITE_P(Pairs, CastUndecided, testing::ValuesIn(all_expected),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
