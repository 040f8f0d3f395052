// SPDX-License-Identifier: Apache-2.0
// vesica_interiors_overlap: known answers, and what follows from the relation, the nine-intersection matrix and
// overlap. The inside of a segment is all but its ends, and that of a point is the point.
#include <gtest/gtest.h>
#include <vesica.h>
#include <vesica_topology.h>

#include <array>
#include <cmath>
#include <string>
#include <vesica/overlap.hpp>

#include "interiors/lattice.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using properties::Kinds;
using properties::Numbers;
using properties::Pair;
using properties::Scalar;

/// The answers of vesica_interiors_overlap_f64 in both orders, which must agree.
template <class A, class B>
std::int32_t asked(std::int32_t kind_a, const A& a, std::int32_t kind_b, const B& b) {
  const std::int32_t answer = vesica_interiors_overlap_f64(kind_a, &a, kind_b, &b);
  EXPECT_EQ(vesica_interiors_overlap_f64(kind_b, &b, kind_a, &a), answer) << "exchanged";
  return answer;
}

TEST(Interiors, Boxes) {
  const vesica_aabb_f64 unit{0, 0, 1, 1}, beside{1, 0, 2, 1}, at_corner{1, 1, 2, 2}, in{0x1.fffffffffffffp-1, 0, 2, 1};
  EXPECT_EQ(asked(VESICA_AABB, unit, VESICA_AABB, beside), 0);
  EXPECT_EQ(asked(VESICA_AABB, unit, VESICA_AABB, at_corner), 0);
  EXPECT_EQ(asked(VESICA_AABB, unit, VESICA_AABB, in), 1);
  EXPECT_EQ(asked(VESICA_AABB, unit, VESICA_AABB, unit), 1);
  const vesica_rect_f64 diamond{2, 0.5, 1, 1, 0.5, 0.5};  // its left corner is (1, 0.5)
  EXPECT_EQ(asked(VESICA_AABB, unit, VESICA_RECT, diamond), 0);
  const vesica_aabb_f64 edge{0, 0, 1, 0}, across{0, 0.5, 1, 0.5}, flat_beyond{1, 0, 2, 0}, corner{1, 1, 1, 1};
  EXPECT_EQ(asked(VESICA_AABB, unit, VESICA_AABB, edge), 0);
  EXPECT_EQ(asked(VESICA_AABB, unit, VESICA_AABB, across), 1);
  EXPECT_EQ(asked(VESICA_AABB, edge, VESICA_AABB, flat_beyond), 0);
  EXPECT_EQ(asked(VESICA_AABB, edge, VESICA_AABB, edge), 1);
  EXPECT_EQ(asked(VESICA_AABB, unit, VESICA_AABB, corner), 0);
  EXPECT_EQ(asked(VESICA_AABB, corner, VESICA_AABB, corner), 1);
}

TEST(Interiors, PointsAndSegments) {
  const vesica_point_f64 origin{0, 0}, end{2, 0}, middle{1, 0}, off{1, 0x1p-1074};
  const vesica_segment_f64 along{0, 0, 2, 0}, beyond{2, 0, 3, 0}, part{1, 0, 3, 0}, cross{1, -1, 1, 1}, on{1, 0, 1, 1};
  EXPECT_EQ(asked(VESICA_POINT, origin, VESICA_POINT, origin), 1);
  EXPECT_EQ(asked(VESICA_POINT, origin, VESICA_POINT, end), 0);
  EXPECT_EQ(asked(VESICA_POINT, middle, VESICA_SEGMENT, along), 1);
  EXPECT_EQ(asked(VESICA_POINT, end, VESICA_SEGMENT, along), 0);
  EXPECT_EQ(asked(VESICA_POINT, off, VESICA_SEGMENT, along), 0);
  EXPECT_EQ(asked(VESICA_SEGMENT, along, VESICA_SEGMENT, beyond), 0);
  EXPECT_EQ(asked(VESICA_SEGMENT, along, VESICA_SEGMENT, part), 1);
  EXPECT_EQ(asked(VESICA_SEGMENT, along, VESICA_SEGMENT, cross), 1);
  EXPECT_EQ(asked(VESICA_SEGMENT, along, VESICA_SEGMENT, on), 0);
  const vesica_segment_f64 as_point{1, 0, 1, 0};
  EXPECT_EQ(asked(VESICA_SEGMENT, as_point, VESICA_SEGMENT, along), 1);
  EXPECT_EQ(asked(VESICA_SEGMENT, as_point, VESICA_SEGMENT, on), 0);
  const vesica_rect_f64 rect{1, 1, 1, 0, 1, 1};
  EXPECT_EQ(asked(VESICA_SEGMENT, along, VESICA_RECT, rect), 0);
  EXPECT_EQ(asked(VESICA_SEGMENT, cross, VESICA_RECT, rect), 1);
  EXPECT_EQ(asked(VESICA_POINT, middle, VESICA_RECT, rect), 0);
}

TEST(Interiors, Discs) {
  const vesica_circle_f64 disc{0, 0, 5}, beside{8, 6, 5}, closer{8, 6, 0x1.4000000000001p+2}, point{3, 4, 0};
  EXPECT_EQ(asked(VESICA_CIRCLE, disc, VESICA_CIRCLE, beside), 0);
  EXPECT_EQ(asked(VESICA_CIRCLE, disc, VESICA_CIRCLE, closer), 1);
  EXPECT_EQ(asked(VESICA_CIRCLE, disc, VESICA_CIRCLE, point), 0);
  EXPECT_EQ(asked(VESICA_CIRCLE, point, VESICA_CIRCLE, point), 1);
  const vesica_point_f64 on_rim{3, 4}, in{3, 3};
  EXPECT_EQ(asked(VESICA_POINT, on_rim, VESICA_CIRCLE, disc), 0);
  EXPECT_EQ(asked(VESICA_POINT, in, VESICA_CIRCLE, disc), 1);
  EXPECT_EQ(asked(VESICA_POINT, on_rim, VESICA_CIRCLE, point), 1);
  const vesica_segment_f64 tangent{5, -1, 5, 1}, chord{3, 4, -3, 4};
  EXPECT_EQ(asked(VESICA_SEGMENT, tangent, VESICA_CIRCLE, disc), 0);
  EXPECT_EQ(asked(VESICA_SEGMENT, chord, VESICA_CIRCLE, disc), 1);
  const vesica_ellipse_f64 as_ellipse{8, 6, 3, 4, 1, 1}, thin{0, 0, 1, 0, 5, 0}, round{0, 3, 1, 0, 4, 3};
  EXPECT_EQ(asked(VESICA_CIRCLE, disc, VESICA_ELLIPSE, as_ellipse), 0);
  EXPECT_EQ(asked(VESICA_ELLIPSE, thin, VESICA_ELLIPSE, round), 0);
  EXPECT_EQ(asked(VESICA_ELLIPSE, thin, VESICA_ELLIPSE, thin), 1);
  EXPECT_EQ(asked(VESICA_ELLIPSE, round, VESICA_ELLIPSE, round), 1);
}

TEST(Interiors, Inflated) {
  const vesica_capsule_f64 capsule{0, 0, 4, 0, 1}, above{0, 3, 4, 3, 2}, bare{0, 0, 4, 0, 0}, disc{4, 0, 4, 0, 0};
  EXPECT_EQ(asked(VESICA_CAPSULE, capsule, VESICA_CAPSULE, above), 0);
  EXPECT_EQ(asked(VESICA_CAPSULE, bare, VESICA_CAPSULE, bare), 1);
  EXPECT_EQ(asked(VESICA_CAPSULE, bare, VESICA_CAPSULE, disc), 0);
  EXPECT_EQ(asked(VESICA_CAPSULE, capsule, VESICA_CAPSULE, disc), 1);
  const vesica_ellipse_f64 ellipse{2, 3, 1, 0, 3, 2}, lower{2, 3, 1, 0, 3, 0x1.0000000000001p+1},
      thin{2, 1, 1, 0, 1, 0};
  EXPECT_EQ(asked(VESICA_ELLIPSE, ellipse, VESICA_CAPSULE, capsule), 0);
  EXPECT_EQ(asked(VESICA_ELLIPSE, lower, VESICA_CAPSULE, capsule), 1);
  EXPECT_EQ(asked(VESICA_ELLIPSE, thin, VESICA_CAPSULE, capsule), 0);
  const vesica_ellipse_f64 at_end{8, 0, 1, 0, 3, 2};
  EXPECT_EQ(asked(VESICA_ELLIPSE, at_end, VESICA_CAPSULE, capsule), 0);
  const vesica_round_rect_f64 card{2, -3, 1, 0, 1, 1, 1}, low{2, -3, 1, 0, 1, 1, 0};
  EXPECT_EQ(asked(VESICA_CAPSULE, capsule, VESICA_ROUND_RECT, card), 0);
  EXPECT_EQ(asked(VESICA_ROUND_RECT, low, VESICA_ROUND_RECT, low), 1);
  EXPECT_EQ(asked(VESICA_ROUND_RECT, card, VESICA_ROUND_RECT, low), 1);
}

TEST(Interiors, InvalidShapes) {
  const vesica_aabb_f64 good{0, 0, 1, 1}, inverted{1, 0, 0, 1};
  const vesica_circle_f64 negative{0, 0, -1};
  const vesica_point_f64 nan{0, std::nan("")};
  EXPECT_EQ(asked(VESICA_AABB, good, VESICA_AABB, inverted), VESICA_E_SHAPE);
  EXPECT_EQ(asked(VESICA_AABB, good, VESICA_CIRCLE, negative), VESICA_E_SHAPE);
  EXPECT_EQ(asked(VESICA_AABB, good, VESICA_POINT, nan), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_interiors_overlap_f64(VESICA_AABB, nullptr, VESICA_AABB, &good), VESICA_E_NULL);
  EXPECT_EQ(vesica_interiors_overlap_f64(VESICA_AABB, &good, VESICA_POLYLINE + 1, &good), VESICA_E_KIND);
}

int dimension(int kind, const Numbers& n) {
  if (properties::radius(kind, n) > 0) return 2;
  switch (kind) {
    case VESICA_POINT:
    case VESICA_CIRCLE:
      return 0;
    case VESICA_SEGMENT:
    case VESICA_CAPSULE:
      return n[0] != n[2] || n[1] != n[3] ? 1 : 0;
    case VESICA_AABB:
      return (n[0] < n[2] ? 1 : 0) + (n[1] < n[3] ? 1 : 0);
    default:
      return (n[4] > 0 ? 1 : 0) + (n[5] > 0 ? 1 : 0);
  }
}

class InteriorsOfPairs : public testing::TestWithParam<Kinds> {
 protected:
  std::int32_t relation(const Pair& p) const {
    if (GetParam().scalar == Scalar::f64) return vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
    return vesica_relation_f32(p.kind_a, properties::narrow(p.a).data(), p.kind_b, properties::narrow(p.b).data());
  }
  std::int32_t asked(const Pair& p) const {
    if (GetParam().scalar == Scalar::f64) {
      return vesica_interiors_overlap_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
    }
    return vesica_interiors_overlap_f32(p.kind_a, properties::narrow(p.a).data(), p.kind_b,
                                        properties::narrow(p.b).data());
  }
  char insides_in_matrix(const Pair& p) const {
    char matrix[10];
    EXPECT_EQ(vesica_de9im_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), matrix), 0);
    return matrix[0];
  }
  /// A relation says whether insides meet, unless a shape without area may lie in the other's outline.
  std::int32_t truth(const Pair& p) const {
    const std::int32_t r = relation(p);
    if (r != VESICA_INSIDE_TOUCH && r != VESICA_CONTAINS_TOUCH) return r >= VESICA_CROSS ? 1 : 0;
    const int inner = r == VESICA_INSIDE_TOUCH ? dimension(p.kind_a, p.a) : dimension(p.kind_b, p.b);
    return inner == 2 ? 1 : inner == 0 ? 0 : insides_in_matrix(p) != 'F';
  }
  void check(const Pair& p) {
    const std::int32_t answer = asked(p);
    counted_[static_cast<std::size_t>(answer == 1)] += 1;
    ASSERT_EQ(answer, truth(p)) << properties::describe(p);
    ASSERT_EQ(asked(properties::swapped(p)), answer) << properties::describe(p);
    const Pair mirrored = properties::pair_of(properties::mirrored(first(p)), properties::mirrored(second(p)));
    ASSERT_EQ(asked(mirrored), answer) << properties::describe(p);
  }
  std::array<int, 2> counted_{};
};

TEST_P(InteriorsOfPairs, FollowFromTheRelation) {
  const Kinds& kinds = GetParam();
  for (const properties::Workload workload : properties::all_workloads) {
    properties::Stream stream(workload, kinds.a, kinds.b, kinds.scalar, properties::seed());
    for (int i = 0; i < 300 * properties::repeat(); ++i) check(stream.next());
  }
  properties::Random random(properties::seed());
  for (int i = 0; i < 300 * properties::repeat(); ++i) {
    check(properties::touching_from_one_side(kinds.a, kinds.b, random));
  }
  EXPECT_GT(counted_[0], 0);
  EXPECT_GT(counted_[1], 0);
}

INSTANTIATE_TEST_SUITE_P(Pairs, InteriorsOfPairs, testing::ValuesIn(properties::all_pairs_of_kinds()),
                         properties::test_name);

/// The least radius at which two shapes overlap is bisected. At the next larger one insides meet, at the next smaller
/// one they do not, and at it only if it is not the distance itself.
TEST(Interiors, RadiusAtContact) {
  properties::Random random(properties::seed());
  int touching = 0, near = 0;
  for (int i = 0; i < 30000 * properties::repeat(); ++i) {
    const std::int32_t with_radius[] = {VESICA_CIRCLE, VESICA_CAPSULE, VESICA_ROUND_RECT};
    interiors::Shape b = interiors::shape(with_radius[random.below(3)], 0, random);
    const interiors::Shape a = interiors::shape(static_cast<std::int32_t>(random.below(8)), 0, random);
    double& r = b.number[b.kind == VESICA_CIRCLE ? 2 : b.kind == VESICA_CAPSULE ? 4 : 6];
    double low = 0, high = 32;
    r = low;
    if (interiors::overlap(a, b) == 1) continue;
    while (std::nextafter(low, high) < high) {
      r = low + (high - low) / 2;
      (interiors::overlap(a, b) == 1 ? high : low) = r;
    }
    r = low;
    ASSERT_EQ(interiors::interiors_overlap(a, b), 0) << "case " << i;
    r = std::nextafter(high, 64);
    ASSERT_EQ(interiors::interiors_overlap(a, b), 1) << "case " << i;
    r = high;
    const std::int32_t at_contact = interiors::interiors_overlap(a, b);
    ASSERT_EQ(interiors::interiors_overlap(b, a), at_contact) << "case " << i;
    // On this lattice a distance is a multiple of 1/8, or no double.
    const bool exact = std::floor(8 * high) == 8 * high;
    ASSERT_EQ(at_contact, exact ? 0 : 1) << "case " << i << ", radius " << high;
    (at_contact == 0 ? touching : near) += 1;
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(near, 100);
}

/// The same set as a shape of another kind, which other code decides: a capsule or rounded rectangle as a circle, and a
/// circle as an ellipse. And the core's functions.
TEST(Interiors, OneSetInOtherNumbers) {
  properties::Random random(properties::seed());
  int meeting = 0;
  for (int i = 0; i < 100000 * properties::repeat(); ++i) {
    const int exponents[] = {-1060, -500, 0, 0, 0, 0, 300, 1000};
    const int exponent = exponents[random.below(8)];
    const interiors::Shape a = interiors::shape(static_cast<std::int32_t>(random.below(8)), exponent, random);
    const interiors::Shape circle = interiors::shape(VESICA_CIRCLE, exponent, random);
    const auto [x, y, r] = std::array{circle.number[0], circle.number[1], circle.number[2]};
    const std::int32_t answer = interiors::interiors_overlap(a, circle);
    meeting += answer;
    const interiors::Shape others[] = {{VESICA_CAPSULE, {x, y, x, y, r}},
                                       {VESICA_ROUND_RECT, {x, y, 3, 4, 0, 0, r}},
                                       {VESICA_ELLIPSE, {x, y, 0, 1, r, r}}};
    for (const interiors::Shape& other : others) {
      ASSERT_EQ(interiors::interiors_overlap(a, other), answer)
          << "case " << i << ", kind " << a.kind << " and " << other.kind << ", 2^" << exponent;
    }
    ASSERT_LE(answer, interiors::overlap(a, circle));
  }
  EXPECT_GT(meeting, 0);
}

constexpr vesica::Segment<double> diagonal{0, 0, 2, 2}, other_diagonal{0, 2, 2, 0};
static_assert(vesica::interiors_overlap(diagonal, other_diagonal));
static_assert(!vesica::interiors_overlap(vesica::Aabb<float>{0, 0, 1, 1}, vesica::Aabb<float>{1, 0, 2, 1}));
static_assert(!vesica::interiors_overlap(vesica::Capsule<double>{0, 0, 4, 0, 1},
                                         vesica::Ellipse<double>{2, 3, 1, 0, 3, 2}));

}  // namespace
