// SPDX-License-Identifier: Apache-2.0
// Ratios of shared area: known answers, laws, and accuracy against 115 digits. The shared area and the IoU are the
// library's own, whose tests are in tests/area.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>

#include "area/real.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"

namespace {

using namespace properties;
using reference::Real;

constexpr int ratios = VESICA_RATIO_COMPLETE + 1;
constexpr int most_printed = 3;
constexpr double u = 0x1p-53;

struct Answer {
  std::int32_t code;
  double value;
  bool operator==(const Answer&) const = default;
};

Answer ratio(int which, const Pair& p) {
  double out = 7;
  const std::int32_t code = vesica_ratio_f64(which, p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out);
  return {code, out};
}
double number(std::int32_t (*measure)(std::int32_t, const void*, std::int32_t, const void*, double*), const Pair& p) {
  double out = 0;
  measure(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out);
  return out;
}
double shape_area(int kind, const Numbers& numbers) {
  double out = 0;
  return vesica_shape_area_f64(kind, numbers.data(), &out) == 0 ? out : HUGE_VAL;
}
int exchanged(int which) {
  return which == VESICA_RATIO_OVER_FIRST    ? VESICA_RATIO_OVER_SECOND
         : which == VESICA_RATIO_OVER_SECOND ? VESICA_RATIO_OVER_FIRST
                                             : which;
}

/// A shape from its definition in vesica.h: centre, axis and half sizes.
struct Form {
  Real cx, cy, ux, uy, along, across;
  bool round;
};
Form form(int kind, const Numbers& n) {
  const Real half(0.5);
  switch (kind) {
    case VESICA_POINT:
      return {n[0], n[1], 1, 0, 0, 0, false};
    case VESICA_SEGMENT:
      return {
          half * (Real(n[0]) + n[2]), half * (Real(n[1]) + n[3]), Real(n[2]) - n[0], Real(n[3]) - n[1], half, 0, false};
    case VESICA_CIRCLE:
      return {n[0], n[1], 1, 0, n[2], n[2], true};
    case VESICA_AABB:
      return {half * (Real(n[0]) + n[2]), half * (Real(n[1]) + n[3]), 1,    0,
              half * (Real(n[2]) - n[0]), half * (Real(n[3]) - n[1]), false};
    default:
      return {n[0], n[1], n[2], n[3], n[4], n[5], kind == VESICA_ELLIPSE};
  }
}
Real most(const Real& p, const Real& q) { return p < q ? q : p; }
Real least(const Real& p, const Real& q) { return q < p ? q : p; }

/// How far a shape reaches from its centre along a coordinate.
Real reach(const Form& s, const Real& p, const Real& q) {
  const Real along = abs(p * s.along), across = abs(q * s.across);
  return s.round ? sqrt(along * along + across * across) : along + across;
}
Real span(const Real& c, const Real& r, const Real& d, const Real& q) {
  return most(c + r, d + q) - least(c - r, d - q);
}
Real area(const Form& s) {
  static const Real pi = Real(4) * atan(Real(1));
  return (s.round ? pi : Real(4)) * s.along * s.across * (s.ux * s.ux + s.uy * s.uy);
}

/// The part of a ratio that is not the IoU, from the numbers of the shapes and the IoU.
Real taken_away(int which, const Pair& p, double iou) {
  const Form a = form(p.kind_a, p.a), b = form(p.kind_b, p.b);
  const Real width = span(a.cx, reach(a, a.ux, a.uy), b.cx, reach(b, b.ux, b.uy));
  const Real height = span(a.cy, reach(a, a.uy, a.ux), b.cy, reach(b, b.uy, b.ux));
  if (which == VESICA_RATIO_GENERALIZED) {
    const Real whole = (area(a) + area(b)) / (Real(1) + iou);
    return Real(1) - whole / (width * height);
  }
  const Real dx = b.cx - a.cx, dy = b.cy - a.cy;
  const Real distance = (dx * dx + dy * dy) / (width * width + height * height);
  if (which == VESICA_RATIO_DISTANCE) return distance;
  const auto no_size = [](const Form& s) {
    const Real zero;
    return (s.along == zero && s.across == zero) || (s.ux == zero && s.uy == zero);
  };
  if (no_size(a) || no_size(b)) return distance;
  const Real angle = atan2(a.along, a.across) - atan2(b.along, b.across), right = Real(2) * atan(Real(1));
  const Real v = (angle / right) * (angle / right);
  return v == Real(0.0) ? distance : distance + v * v / (Real(1) - iou + v);
}

bool moderate(const Pair& p) { return is_moderate(p, 0x1p95); }

class Ratios : public testing::Test {
 protected:
  void demand(bool holds, const char* law, int which, const Pair& p, double got) {
    ++asked_;
    if (holds || ++broken_ > most_printed) return;
    ADD_FAILURE() << law << ", ratio " << which << ": " << got << ", seed " << seed() << "\n  " << describe(p);
  }

  void laws(const Pair& p, Random& random) {
    const double iou = number(vesica_iou_f64, p), shared = number(vesica_area_f64, p);
    const std::int32_t relation = vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
    const bool flat_a = shape_area(p.kind_a, p.a) == 0, flat_b = shape_area(p.kind_b, p.b) == 0;
    const int exponent = random.integer(-40, 40);
    const auto scaled_a = scaled_exactly({p.kind_a, p.a}, Scalar::f64, exponent, random.chance(0.5));
    const auto scaled_b = scaled_exactly({p.kind_b, p.b}, Scalar::f64, exponent, random.chance(0.5));
    for (int which = 0; which < ratios; ++which) {
      const Answer r = ratio(which, p);
      demand(r == ratio(exchanged(which), swapped(p)), "exchange", which, p, r.value);
      if (scaled_a && scaled_b && moderate(p)) {
        const Pair q{p.kind_a, p.kind_b, scaled_a->numbers, scaled_b->numbers};
        demand(r == ratio(which, q), "scale", which, p, r.value);
      }
      if (r.code != 0) {
        demand(r.code == VESICA_E_ARGUMENT && r.value == 7 && (flat_a || flat_b), "error", which, p, r.code);
        continue;
      }
      const bool of_area = which >= VESICA_RATIO_OVER_FIRST && which <= VESICA_RATIO_OVER_SMALLER;
      demand(r.value <= (of_area ? 1 : iou), "upper bound", which, p, r.value);
      demand(r.value >= (which < VESICA_RATIO_GENERALIZED ? 0
                         : which == VESICA_RATIO_COMPLETE ? -2
                                                          : -1),
             "lower bound", which, p, r.value);
      if (of_area && relation <= VESICA_TOUCH) demand(r.value == 0, "apart", which, p, r.value);
      if (of_area && moderate(p)) demand((r.value > 0) == (shared > 0), "above 0", which, p, r.value);
      const bool a_inside = relation == VESICA_INSIDE || relation == VESICA_INSIDE_TOUCH || relation == VESICA_EQUAL;
      if (which == VESICA_RATIO_OVER_FIRST && a_inside) demand(r.value == 1, "inside", which, p, r.value);
      if (which == VESICA_RATIO_DISTANCE && relation == VESICA_EQUAL && moderate(p))
        demand(r.value >= 1 - 8 * u, "equal", which, p, r.value);
    }
  }

  /// Errors in units of u.
  void accuracy(const Pair& p) {
    const double shared = number(vesica_area_f64, p), iou = number(vesica_iou_f64, p);
    const double area_a = shape_area(p.kind_a, p.a), area_b = shape_area(p.kind_b, p.b);
    for (int which = VESICA_RATIO_OVER_FIRST; which < ratios; ++which) {
      const Answer r = ratio(which, p);
      if (r.code != 0) continue;
      const bool of_area = which <= VESICA_RATIO_OVER_SMALLER;
      const double divisor = which == VESICA_RATIO_OVER_FIRST    ? area_a
                             : which == VESICA_RATIO_OVER_SECOND ? area_b
                                                                 : std::min(area_a, area_b);
      const Real wanted = of_area ? Real(shared) / divisor : Real(iou) - taken_away(which, p, iou);
      const Real error = abs(Real(r.value) - wanted);
      const double in_u = static_cast<double>(error / u / (of_area ? most(wanted, 0x1p-1000) : Real(1)));
      worst_[which] = std::max(worst_[which], in_u);
      demand(in_u <= 8, "accuracy", which, p, in_u);
    }
  }

  void TearDown() override {
    for (int which = 0; which < ratios; ++which)
      RecordProperty("worst_" + std::to_string(which), std::to_string(worst_[which]));
  }

  int asked_ = 0, broken_ = 0;
  double worst_[ratios] = {};
};

Pair boxes(const Numbers& a, const Numbers& b) { return {VESICA_AABB, VESICA_AABB, a, b}; }

TEST_F(Ratios, Known) {
  const Pair corner = boxes({0, 0, 2, 2}, {1, 1, 3, 3});
  const double wanted[] = {1. / 7, 1. / 4, 1. / 4, 1. / 4, 1. / 7 - 2. / 9, 1. / 7 - 1. / 9, 1. / 7 - 1. / 9};
  for (int which = 0; which < ratios; ++which) EXPECT_NEAR(ratio(which, corner).value, wanted[which], 4 * u);
  const Pair apart = boxes({0, 0, 1, 1}, {3, 0, 4, 1});
  const double far[] = {0, 0, 0, 0, -0.5, -9. / 17, -9. / 17};
  for (int which = 0; which < ratios; ++which) EXPECT_NEAR(ratio(which, apart).value, far[which], 4 * u);
  // A box of 1 x 2 lengthwise on one of 1 x 1: v = (atan 2 - atan 1)^2 4 / pi^2.
  const Pair unlike = boxes({0, 0, 2, 1}, {0, 0, 1, 1});
  const double angle = (std::atan(2) - std::atan(1)) / std::atan2(1, 0), v = angle * angle;
  EXPECT_NEAR(ratio(VESICA_RATIO_COMPLETE, unlike).value, 0.5 - 0.25 / 5 - v * v / (0.5 + v), 4 * u);
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_SECOND, unlike).value, 1);
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_FIRST, unlike).value, 0.5);
}

TEST_F(Ratios, Errors) {
  const Pair fine = boxes({0, 0, 1, 1}, {0, 0, 1, 1}), flat = boxes({0, 0, 0, 1}, {0, 0, 1, 1});
  EXPECT_EQ(ratio(-1, fine).code, VESICA_E_ARGUMENT);
  EXPECT_EQ(ratio(ratios, fine).code, VESICA_E_ARGUMENT);
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_FIRST, flat).code, VESICA_E_ARGUMENT);
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_SMALLER, flat).code, VESICA_E_ARGUMENT);
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_SECOND, flat), (Answer{0, 0}));
  EXPECT_EQ(ratio(VESICA_RATIO_GENERALIZED, flat), (Answer{0, 0}));
  EXPECT_EQ(ratio(VESICA_RATIO_DISTANCE, boxes({0, 0, 0, 1}, {0, 0, 1, 0})).code, VESICA_E_ARGUMENT);
  for (int which = 0; which < ratios; ++which) {
    EXPECT_EQ(ratio(which, boxes({1, 0, 0, 1}, {0, 0, 1, 1})), (Answer{VESICA_E_SHAPE, 7}));
    EXPECT_EQ(ratio(which, boxes({0, 0, 1, 1}, {0, 0, 1, NAN})), (Answer{VESICA_E_SHAPE, 7}));
    EXPECT_EQ(ratio(which, {VESICA_POLYLINE + 1, VESICA_AABB, {}, {}}), (Answer{VESICA_E_KIND, 7}));
    double out = 0;
    EXPECT_EQ(vesica_ratio_f64(which, VESICA_AABB, nullptr, VESICA_AABB, fine.b.data(), &out), VESICA_E_NULL);
    EXPECT_EQ(vesica_ratio_f64(which, VESICA_AABB, fine.a.data(), VESICA_AABB, fine.b.data(), nullptr), VESICA_E_NULL);
  }
  EXPECT_EQ(vesica_ratio_many_f64(9, nullptr, nullptr, nullptr), VESICA_E_NULL);
}

TEST_F(Ratios, OnWorkloads) {
  Random random(seed());
  for (int a = VESICA_POINT; a <= VESICA_ELLIPSE; ++a) {
    for (int b = a; b <= VESICA_ELLIPSE; ++b) {
      for (const Workload workload : all_workloads) {
        Stream stream(workload, a, b, Scalar::f64, seed());
        for (int i = 0; i < 60 * repeat(); ++i) {
          const Pair p = stream.next();
          laws(p, random);
          if (moderate(p)) accuracy(p);
        }
      }
    }
  }
  EXPECT_GT(asked_, 100000 * repeat());
}

// Areas beyond the range of doubles have a ratio within it.
TEST_F(Ratios, OfAnyMagnitude) {
  for (const int exponent : {-1000, -600, -530, 500, 530, 1000}) {
    const double s = std::ldexp(1, exponent);
    const Pair p = boxes({0, 0, 2 * s, 2 * s}, {1 * s, 1 * s, 3 * s, 3 * s});
    const double wanted[] = {1. / 7, 1. / 4, 1. / 4, 1. / 4, 1. / 7 - 2. / 9, 1. / 7 - 1. / 9, 1. / 7 - 1. / 9};
    for (int which = 0; which < ratios; ++which) EXPECT_NEAR(ratio(which, p).value, wanted[which], 8 * u) << exponent;
  }
  const Pair whole = boxes({-0x1p1023, -0x1p1023, 0x1p1023, 0x1p1023}, {0, 0, 0x1p1023, 0x1p1023});
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_FIRST, whole), (Answer{0, 0.25}));
  EXPECT_EQ(ratio(VESICA_RATIO_GENERALIZED, whole), (Answer{0, 0.25}));
}

// Coordinates that are a few of the least numbers, whose halves are none: as the same multiples of 1.
TEST_F(Ratios, OfTheLeastNumbers) {
  constexpr double least = 0x1p-1074;
  Random random(seed() + 77);
  const auto shape = [&random](int kind) -> Numbers {
    const auto number = [&random] { return static_cast<double>(random.below(5)); };
    const double x = number() - 2, y = number() - 2;
    switch (kind) {
      case VESICA_POINT:
        return {x, y};
      case VESICA_SEGMENT:
        return {x, y, number(), number()};
      case VESICA_CIRCLE:
        return {x, y, number()};
      default:
        return {x, y, x + number(), y + number()};
    }
  };
  int answered = 0;
  for (int i = 0; i < 4000; ++i) {
    const int kinds[] = {random.below(4), random.below(4)};
    Pair p{kinds[0], kinds[1], shape(kinds[0]), shape(kinds[1])}, tiny = p;
    for (double& x : tiny.a) x *= least;
    for (double& x : tiny.b) x *= least;
    for (int which = 0; which < ratios; ++which) {
      const Answer expected = ratio(which, p);
      ASSERT_EQ(ratio(which, tiny), expected) << which << ' ' << i;
      answered += expected.code == 0;
    }
  }
  EXPECT_GT(answered, 3000);
}

// The IoU may underflow, and even the shared area; the share of the smaller shape does not.
TEST_F(Ratios, OfShapesFarSmallerThanTheOther) {
  const Numbers tiny{0, 0, 0x1p-900, 0x1p-900};
  const Pair inside = boxes(tiny, {-1, -1, 1, 1}), half = boxes(tiny, {0x1p-901, -1, 1, 1});
  const Pair disc = {VESICA_CIRCLE, VESICA_ELLIPSE, {0x1p-700, 0, 0x1p-701}, {0, 0, 0, 2, 0x1p500, 0x1p500}};
  for (const int which : {VESICA_RATIO_OVER_FIRST, VESICA_RATIO_OVER_SMALLER}) {
    EXPECT_EQ(ratio(which, inside), (Answer{0, 1}));
    EXPECT_EQ(ratio(which, half), (Answer{0, 0.5}));
    EXPECT_EQ(ratio(which, disc), (Answer{0, 1}));
  }
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_SECOND, swapped(half)), (Answer{0, 0.5}));
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_SECOND, half), (Answer{0, 0}));
}

// The IoU of such pairs underflows, or says less than the areas.
TEST_F(Ratios, OverOneAreaBesideAnotherFarAway) {
  const Pair in_ellipse{VESICA_AABB, VESICA_ELLIPSE, {0, 0, 1, 1}, {0, 0, 0x1p477, 0, 0x1p237, 1}};
  const Pair in_disc{VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, 1}, {0, 0, 0x1.7p+304}};
  const Pair both_huge{VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, 0x1.67p608}, {0x1p598, 0, 0x1.68p608}};
  const Pair tiny{VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, 0x1p-1000}, {0, 0, 1}};
  for (const Pair& p : {in_ellipse, in_disc, both_huge, tiny}) {
    EXPECT_EQ(ratio(VESICA_RATIO_OVER_FIRST, p), (Answer{0, 1}));
    EXPECT_EQ(ratio(VESICA_RATIO_OVER_SMALLER, p), (Answer{0, 1}));
  }
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_SECOND, tiny), (Answer{0, 0}));
}

// The shared area is far smaller than both boxes and underflows, or keeps few digits; its share of either does not.
TEST_F(Ratios, OfAnAreaThatUnderflows) {
  for (int exponent = -250; exponent <= 150; exponent += 25) {
    const double unit = std::ldexp(1, exponent);
    const Pair p = boxes({0, 0, unit, unit}, {-unit, -unit, unit * 0x3p-500, unit * 0x1p-200});
    for (const int which : {VESICA_RATIO_OVER_FIRST, VESICA_RATIO_OVER_SECOND, VESICA_RATIO_OVER_SMALLER}) {
      const Answer r = ratio(which, p);
      EXPECT_EQ(r.code, 0);
      EXPECT_DOUBLE_EQ(r.value, 0x3p-700) << which << " 2^" << exponent;
    }
    EXPECT_DOUBLE_EQ(ratio(VESICA_RATIO_OVER_UNION, p).value, 0x3p-701) << exponent;
    const Pair apart = boxes({0, 0, unit, unit}, {-unit, -unit, unit * 0x3p-500, 0});
    EXPECT_EQ(ratio(VESICA_RATIO_OVER_FIRST, apart), (Answer{0, 0})) << exponent;
  }
}

/// A shape with an area, about the origin: its lengths are from 2^exponent to 2^(exponent + 3).
Numbers about_origin(int kind, int exponent, Random& random) {
  const auto length = [&] { return std::ldexp(random.between(1, 2), exponent); };
  const double x = std::ldexp(random.between(-0.4, 0.4), exponent), y = std::ldexp(random.between(-0.4, 0.4), exponent);
  switch (kind) {
    case VESICA_CIRCLE:
      return {x, y, length()};
    case VESICA_AABB:
      return {-length(), -length(), length(), length()};
    default:
      return {x, y, random.sign() * random.between(1, 2), random.between(-2, 2), length(), length()};
  }
}

// Shares among the subnormal numbers were rounded twice by single calls, and once by those of arrays.
TEST_F(Ratios, SubnormalSharesHaveTheBitsOfArrays) {
  Random random(seed() + 78);
  constexpr int count = 40;
  const int kinds[] = {VESICA_CIRCLE, VESICA_AABB, VESICA_RECT, VESICA_ELLIPSE};
  int subnormal = 0, nearest_quotients = 0;
  for (int i = 0; i < 160 * repeat(); ++i) {
    const int kind_a = kinds[random.below(4)], kind_b = kinds[random.below(4)];
    const int small = random.integer(-350, -250), large = small + random.integer(511, 540);
    Numbers a[count], b[count];
    for (int k = 0; k < count; ++k) {
      a[k] = about_origin(kind_a, small, random);
      b[k] = about_origin(kind_b, large, random);
    }
    vesica_shapes_f64 as, bs;
    ASSERT_EQ(vesica_shapes_from_records_f64(kind_a, count, a, sizeof a[0], &as), 0);
    ASSERT_EQ(vesica_shapes_from_records_f64(kind_b, count, b, sizeof b[0], &bs), 0);
    for (const int which : {VESICA_RATIO_OVER_SECOND, VESICA_RATIO_OVER_FIRST}) {
      const bool second = which == VESICA_RATIO_OVER_SECOND;
      double many[count], matrix[count * count];
      ASSERT_GE(vesica_ratio_many_f64(which, second ? &as : &bs, second ? &bs : &as, many), 0);
      ASSERT_GE(vesica_ratio_matrix_f64(which, second ? &as : &bs, second ? &bs : &as, matrix, count), 0);
      for (int k = 0; k < count; ++k) {
        const Pair p{kind_a, kind_b, a[k], b[k]};
        const Answer one = ratio(which, second ? p : swapped(p));
        ASSERT_EQ(one, (Answer{0, many[k]})) << which << ", seed " << seed() << "\n  " << describe(p);
        ASSERT_EQ(one, (Answer{0, matrix[k * count + k]})) << which << ", seed " << seed() << "\n  " << describe(p);
        subnormal += one.value > 0 && one.value < 0x1p-1022;
        const double shared = number(vesica_area_f64, p), whole = shape_area(kind_b, b[k]);
        if (shared < 0x1p-1022 || whole > 0x1p1023) continue;
        EXPECT_EQ(one.value, shared / whole) << describe(p);  // the processor rounds a quotient once
        ++nearest_quotients;
      }
    }
  }
  EXPECT_GT(subnormal, 5000 * repeat());
  EXPECT_GT(nearest_quotients, 5000 * repeat());
}

// The offset of the centres overflows along one coordinate, and all lengths along the other are usual ones.
TEST_F(Ratios, FarApartAlongOneCoordinate) {
  for (const double x : {1.0, 0x1p-300}) {
    const Pair up{VESICA_CIRCLE, VESICA_POINT, {0, 0x1p1023, x}, {0, -0x1p1023}};
    const Pair aside{VESICA_CIRCLE, VESICA_AABB, {0x1p1023, 0, x}, {-0x1p1023, -x, -0x1p1023, x}};
    for (const int which : {VESICA_RATIO_GENERALIZED, VESICA_RATIO_DISTANCE, VESICA_RATIO_COMPLETE}) {
      EXPECT_EQ(ratio(which, up), (Answer{0, -1})) << which;
      const double v = which == VESICA_RATIO_COMPLETE ? 0.25 * 0.25 / 1.25 : 0;
      EXPECT_NEAR(ratio(which, aside).value, -1 - v, 8 * u) << which;
    }
  }
}

TEST_F(Ratios, OfFloats) {
  for (int which = 0; which < ratios; ++which) {
    const float a[] = {0.1f, 0.2f, 1.3f}, b[] = {0.4f, 0.5f, 1.6f, 2.5f};
    const double wide_a[] = {a[0], a[1], a[2]}, wide_b[] = {b[0], b[1], b[2], b[3]};
    float narrow = 0;
    double wide = 0;
    ASSERT_EQ(vesica_ratio_f32(which, VESICA_CIRCLE, a, VESICA_AABB, b, &narrow), 0);
    ASSERT_EQ(vesica_ratio_f64(which, VESICA_CIRCLE, wide_a, VESICA_AABB, wide_b, &wide), 0);
    EXPECT_EQ(narrow, static_cast<float>(wide));
  }
}

// Centres so near that the square of their distance underflows: the same bits at every scale. At one of them 13 digits
// of the square were kept.
TEST(Ratio, OfNearlyConcentricShapesAtEveryScale) {
  const double d = 0x1.84p-525;
  for (const int exponent : {-190, -60, -8, -1, 0, 1, 40, 190}) {
    const double k = std::ldexp(1, exponent);
    const Pair p{VESICA_CIRCLE, VESICA_RECT, {0, 0, k}, {k * d, 0, 0, 1, 0, 0}};
    const Answer found = ratio(VESICA_RATIO_DISTANCE, p);
    EXPECT_EQ(found.code, 0);
    EXPECT_EQ(found.value, -0x0.00000004982p-1022) << exponent;  // -(d / (2 sqrt 2))^2, rounded once
  }
}

// The same where both are small: the square of their distance is 2^-1072 or less, and a part of the hull's.
TEST(Ratio, OfSmallNearlyConcentricShapesAtEveryScale) {
  for (const int exponent : {-8, -7, -1, 0, 1, 6, 40}) {
    const double k = std::ldexp(1, exponent);
    const Pair p{VESICA_POINT, VESICA_RECT, {0, 0}, {k * 0x1p-536, 0, 0, 0x1p-21, k * 0x1p-126, k * 0x1p-167}};
    for (const int which : {VESICA_RATIO_DISTANCE, VESICA_RATIO_COMPLETE}) {
      const Answer found = ratio(which, p);
      EXPECT_EQ(found.code, 0);
      EXPECT_EQ(found.value, -0x1p-780) << exponent << ' ' << which;
    }
  }
}

}  // namespace
