// SPDX-License-Identifier: Apache-2.0
// Areas of pairs with a capsule or a rounded rectangle: known ones, accuracy against a reference of 60 digits and more,
// and laws without any tolerance.
#include <gtest/gtest.h>
#include <vesica.h>
#include <vesica_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include "area/inflated_pairs.hpp"
#include "area/reference.hpp"
#include "properties/generators.hpp"

namespace inflated_areas {
namespace {

using hard::InflatedPair;
using inflated::Shape;
using properties::Random;
using properties::repeat;
using properties::seed;

constexpr double pi = 3.141592653589793;
constexpr std::array areal_kinds{VESICA_CIRCLE,  VESICA_AABB,    VESICA_RECT,
                                 VESICA_ELLIPSE, VESICA_CAPSULE, VESICA_ROUND_RECT};

struct Answer {
  std::int32_t code;
  double value;
  bool operator==(const Answer&) const = default;
};
Answer area(const Shape& a, const Shape& b) {
  double out = -1;
  const std::int32_t code = vesica_area_f64(a.kind, a.number.data(), b.kind, b.number.data(), &out);
  return {code, out};
}
Answer iou(const Shape& a, const Shape& b) {
  double out = -1;
  const std::int32_t code = vesica_iou_f64(a.kind, a.number.data(), b.kind, b.number.data(), &out);
  return {code, out};
}
double ratio(int which, const Shape& a, const Shape& b) {
  double out = -7;
  EXPECT_EQ(vesica_ratio_f64(which, a.kind, a.number.data(), b.kind, b.number.data(), &out), 0);
  return out;
}
double own_area(const Shape& s) {
  double out = -1;
  EXPECT_EQ(vesica_shape_area_f64(s.kind, s.number.data(), &out), 0);
  return out;
}
/// With an ellipse whether their insides meet is known, no more: VESICA_CROSS stands for it.
std::int32_t relation(const Shape& a, const Shape& b) {
  if (a.kind == VESICA_ELLIPSE || b.kind == VESICA_ELLIPSE)
    return vesica_interiors_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data()) == 1 ? VESICA_CROSS
                                                                                               : VESICA_DISJOINT;
  return vesica_relation_f64(a.kind, a.number.data(), b.kind, b.number.data());
}

std::string describe(const InflatedPair& p) {
  std::string text;
  for (const Shape& s : {p.a, p.b}) {
    text += vesica_kind_name(s.kind);
    for (const double x : s.number) {
      char number[40];
      std::snprintf(number, sizeof number, " %a", x);
      text += number;
    }
    text += "\n  ";
  }
  return text;
}

/// Every pair of kinds with a capsule or a rounded rectangle.
template <class Check>
void for_inflated_pairs(const Check& check) {
  for (const int a : areal_kinds) {
    for (const int b : inflated::kinds) {
      if (a <= b) check(a, b);
    }
  }
}

TEST(InflatedAreas, Known) {
  const Shape capsule{VESICA_CAPSULE, {-2, 0, 2, 0, 1}}, half_plane{VESICA_AABB, {0, -9, 9, 9}};
  EXPECT_DOUBLE_EQ(area(capsule, half_plane).value, 4 + pi / 2);
  EXPECT_DOUBLE_EQ(area(capsule, {VESICA_AABB, {-9, 0, 9, 9}}).value, 4 + pi / 2);
  // Two capsules that cross at a right angle share a square of 2 x 2.
  EXPECT_EQ(area(capsule, {VESICA_CAPSULE, {0, -2, 0, 2, 1}}).value, 4);
  // The circle's right half is the capsule's end; its left half is in the capsule's middle.
  EXPECT_DOUBLE_EQ(area(capsule, {VESICA_CIRCLE, {2, 0, 1}}).value, pi);
  // A lens of two unit discs at a distance of 1: 2 pi / 3 - sqrt(3) / 2.
  EXPECT_DOUBLE_EQ(area(capsule, {VESICA_CAPSULE, {3, 0, 8, 0, 1}}).value, 2 * pi / 3 - std::sqrt(3.0) / 2);
  EXPECT_DOUBLE_EQ(area(capsule, {VESICA_CIRCLE, {3, 0, 1}}).value, 2 * pi / 3 - std::sqrt(3.0) / 2);
  // A quarter of a rounded square, and all but the corners of a square.
  const Shape rounded{VESICA_ROUND_RECT, {0, 0, 0, 1, 1, 1, 1}};
  EXPECT_DOUBLE_EQ(area(rounded, {VESICA_AABB, {0, 0, 9, 9}}).value, 3 + pi / 4);
  EXPECT_DOUBLE_EQ(area(rounded, {VESICA_AABB, {-2, -2, 2, 9}}).value, 12 + pi);
  EXPECT_DOUBLE_EQ(area(rounded, {VESICA_RECT, {9, 9, 1, 1, 9, 7.5}}).value, 6 + pi / 2);
  EXPECT_DOUBLE_EQ(iou(rounded, {VESICA_ROUND_RECT, {2, 0, 1, 0, 1, 1, 1}}).value, (6 + pi - 2) / (18 + pi + 2));
}

TEST(InflatedAreas, OfAnEllipse) {
  const Shape ellipse{VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}};
  EXPECT_EQ(area(ellipse, {VESICA_CAPSULE, {-1, 2, 1, 2, 1}}), (Answer{0, 0}));              // they touch at (0, 1)
  EXPECT_EQ(area(ellipse, {VESICA_ROUND_RECT, {3.5, 0, 0, 1, 1, 1, 0.5}}), (Answer{0, 0}));  // at (2, 0)
  EXPECT_EQ(area(ellipse, {VESICA_CAPSULE, {-0.5, 0, 0.5, 0, 0.25}}).value,
            own_area({VESICA_CAPSULE, {0, 0, 1, 0, 0.25}}));
  EXPECT_EQ(area(ellipse, {VESICA_ROUND_RECT, {0, 0, 0, 1, 1, 1, 1}}).value, own_area(ellipse));
  EXPECT_DOUBLE_EQ(area(ellipse, {VESICA_ROUND_RECT, {5, 0, 0, 1, 9, 4, 1}}).value, pi);
}

TEST(InflatedAreas, OfPointsAndSegments) {
  const Shape s{VESICA_ROUND_RECT, {0, 0, 0, 1, 1, 1, 1}}, capsule{VESICA_CAPSULE, {0, 0, 1, 0, 1}};
  for (const Shape& other : {Shape{VESICA_POINT, {0, 0}}, Shape{VESICA_SEGMENT, {0, 0, 1, 1}}}) {
    EXPECT_EQ(area(s, other), (Answer{0, 0}));
    EXPECT_EQ(area(other, capsule), (Answer{0, 0}));
    EXPECT_EQ(iou(other, capsule), (Answer{0, 0}));
  }
  const Shape flat{VESICA_CAPSULE, {0, 0, 1, 0, 0}};
  EXPECT_EQ(area(flat, s), (Answer{0, 0}));
  EXPECT_EQ(iou(flat, s), (Answer{0, 0}));
  EXPECT_EQ(iou(flat, flat), (Answer{VESICA_E_ARGUMENT, -1}));
  EXPECT_EQ(area({VESICA_CAPSULE, {0, 0, 1, 0, -1}}, s), (Answer{VESICA_E_SHAPE, -1}));
  EXPECT_EQ(area({VESICA_CAPSULE, {0, 0, 1, NAN, 1}}, s), (Answer{VESICA_E_SHAPE, -1}));
  EXPECT_EQ(area({VESICA_ROUND_RECT, {0.5, 0, 0, 0, 1, 1, 1}}, s), (Answer{VESICA_E_SHAPE, -1}));
  EXPECT_EQ(area({VESICA_ROUND_RECT, {0.5, 0, 1, 0, -0.5, 1, 1}}, s), (Answer{VESICA_E_SHAPE, -1}));
}

TEST(InflatedAreas, AccuracyOnHardPairs) {
  for (const double most_ratio : {1.0, 8.0}) {
    for_inflated_pairs([&](int kind_a, int kind_b) {
      for (const hard::Case c : hard::all_cases) {
        Random random(seed() + static_cast<std::uint64_t>(100 * kind_a + 10 * kind_b + static_cast<int>(c)));
        double worst = 0;
        InflatedPair of{};
        int crossing = 0;
        for (int i = 0; i < 60 * repeat(); ++i) {
          const InflatedPair p = hard::draw_inflated(c, kind_a, kind_b, most_ratio, random);
          if (relation(p.a, p.b) != VESICA_CROSS) continue;
          const Answer found = area(p.a, p.b);
          ASSERT_EQ(found.code, 0) << describe(p);
          const auto deviation =
              reference::deviation(p.a.kind, p.a.number.data(), p.b.kind, p.b.number.data(), found.value);
          if (deviation.aspect > 1.001e4) continue;
          ++crossing;
          if (deviation.in_roundoffs > worst) worst = deviation.in_roundoffs, of = p;
        }
        std::printf("%-10s %-10s %-17s %5d crossing, worst %.3g u x aspect x area\n", vesica_kind_name(kind_a),
                    vesica_kind_name(kind_b), hard::name(c), crossing, worst);
        EXPECT_LE(worst, 64) << describe(of) << ", seed " << seed();
      }
    });
  }
}

/// The same shape times 2^exponent, its axis times 2^axis.
Shape scaled(const Shape& s, int exponent, int axis) {
  Shape t = s;
  const bool has_axis = s.kind == VESICA_RECT || s.kind == VESICA_ELLIPSE || s.kind == VESICA_ROUND_RECT;
  for (std::size_t i = 0; i < 7; ++i) {
    const bool is_axis = has_axis && (i == 2 || i == 3), is_ratio = has_axis && (i == 4 || i == 5);
    t.number[i] = std::ldexp(s.number[i], is_axis ? axis : is_ratio ? exponent - axis : exponent);
  }
  return t;
}

class InflatedLaws : public testing::Test {
 protected:
  void demand(bool holds, const char* law, const InflatedPair& p) {
    ++asked_;
    if (!holds && ++broken_ <= 3) ADD_FAILURE() << law << ", seed " << seed() << "\n  " << describe(p);
  }

  void all(const InflatedPair& p, Random& random) {
    const Answer shared = area(p.a, p.b), part = iou(p.a, p.b);
    const double a = own_area(p.a), b = own_area(p.b);
    const std::int32_t related = relation(p.a, p.b);
    const bool inside = related == VESICA_INSIDE || related == VESICA_INSIDE_TOUCH || related == VESICA_EQUAL;
    const bool contains = related == VESICA_CONTAINS || related == VESICA_CONTAINS_TOUCH;
    if (related <= VESICA_TOUCH) demand(shared == Answer{0, 0} && part == Answer{0, 0}, "apart", p);
    if (inside) demand(shared == Answer{0, a}, "inside", p);
    if (contains) demand(shared == Answer{0, b}, "contains", p);
    if (related == VESICA_EQUAL) demand(part == Answer{0, 1}, "equal", p);
    if (related == VESICA_CROSS) demand(shared.value > 0, "above 0", p);
    demand(shared.value >= 0 && shared.value <= a && shared.value <= b, "at most either", p);
    demand(part.value >= 0 && part.value <= 1, "a ratio", p);
    demand(area(p.b, p.a) == shared && iou(p.b, p.a) == part, "symmetry", p);
    const int exponent = random.chance(0.5) ? random.integer(-8, 8) : random.integer(-300, 300);
    const int axis = random.integer(-40, 40);
    const InflatedPair q{scaled(p.a, exponent, axis), scaled(p.b, exponent, 0)};
    demand(iou(q.a, q.b) == part, "scale of iou", p);
    demand(area(q.a, q.b).value == std::ldexp(shared.value, 2 * exponent), "scale of area", p);
    const double over_a = ratio(VESICA_RATIO_OVER_FIRST, p.a, p.b), over_b = ratio(VESICA_RATIO_OVER_SECOND, p.a, p.b);
    demand(ratio(VESICA_RATIO_OVER_UNION, p.a, p.b) == part.value, "over union", p);
    demand(over_a >= 0 && over_a <= 1 && over_a == ratio(VESICA_RATIO_OVER_SECOND, p.b, p.a), "over first", p);
    demand(ratio(VESICA_RATIO_OVER_SMALLER, p.a, p.b) == std::max(over_a, over_b), "over smaller", p);
    for (const int which : {VESICA_RATIO_GENERALIZED, VESICA_RATIO_DISTANCE, VESICA_RATIO_COMPLETE}) {
      const double r = ratio(which, p.a, p.b);
      demand(r <= part.value && r >= (which == VESICA_RATIO_COMPLETE ? -2 : -1), "a lesser ratio", p);
      demand(r == ratio(which, p.b, p.a), "symmetry of ratios", p);
    }
  }

  int asked_ = 0, broken_ = 0;
};

TEST_F(InflatedLaws, OnHardPairs) {
  Random random(seed());
  for_inflated_pairs([&](int kind_a, int kind_b) {
    for (const hard::Case c : hard::all_cases) {
      for (int i = 0; i < 100 * repeat(); ++i)
        all(hard::draw_inflated(c, kind_a, kind_b, random.chance(0.5) ? 1 : 8, random), random);
    }
  });
  EXPECT_GT(asked_, 50000 * repeat());
}

/// Without a radius they are their core, to the bit, and without a size a circle.
TEST_F(InflatedLaws, OfPlainShapes) {
  Random random(seed());
  for (int i = 0; i < 2000 * repeat(); ++i) {
    const Shape other = inflated::shape(areal_kinds[static_cast<std::size_t>(random.below(6))], random);
    const auto same = [&](const Shape& s, const Shape& t) {
      demand(area(s, other) == area(t, other) && area(other, s) == area(t, other), "the same area", {s, other});
      demand(iou(s, other) == iou(t, other), "the same ratio", {s, other});
      for (int which = 0; which < 7; ++which)
        demand(ratio(which, s, other) == ratio(which, t, other), "the same ratios", {s, other});
    };
    Shape s = inflated::shape(VESICA_ROUND_RECT, random);
    s.number[6] = 0;
    same(s, inflated::core(s));
    const auto [x, y, r] = std::array{s.number[0], s.number[1], random.unit()};
    same({VESICA_ROUND_RECT, {x, y, s.number[2], s.number[3], 0, 0, r}}, {VESICA_CIRCLE, {x, y, r}});
    same({VESICA_CAPSULE, {x, y, x, y, r}}, {VESICA_CIRCLE, {x, y, r}});
  }
  EXPECT_GT(asked_, 10000 * repeat());
}

/// Floats: the same shapes in double, and the result rounded.
TEST_F(InflatedLaws, OfFloats) {
  Random random(seed());
  for_inflated_pairs([&](int kind_a, int kind_b) {
    for (int i = 0; i < 200 * repeat(); ++i) {
      InflatedPair p{inflated::shape(kind_a, random), inflated::shape(kind_b, random)};
      std::array<float, 7> f{}, g{};
      for (std::size_t k = 0; k < 7; ++k) {
        p.a.number[k] = f[k] = static_cast<float>(p.a.number[k]);
        p.b.number[k] = g[k] = static_cast<float>(p.b.number[k]);
      }
      float shared = -1, part = -1;
      EXPECT_EQ(vesica_area_f32(kind_a, f.data(), kind_b, g.data(), &shared), 0);
      EXPECT_EQ(vesica_iou_f32(kind_a, f.data(), kind_b, g.data(), &part), 0);
      demand(shared == static_cast<float>(area(p.a, p.b).value), "float area", p);
      demand(part == static_cast<float>(iou(p.a, p.b).value), "float iou", p);
    }
  });
}

}  // namespace
}  // namespace inflated_areas
