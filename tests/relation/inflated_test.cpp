// SPDX-License-Identifier: Apache-2.0
// Relations of capsules and rounded rectangles: known ones, and on a lattice against distances between corners and
// edges in whole numbers.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "properties/random.hpp"

namespace relation_inflated_test {
namespace {

using properties::Random;

/// A fraction of whole numbers, den > 0; or infinite.
struct Square {
  std::int64_t num, den;
};
int compare(const Square& a, const Square& b) {
  const std::int64_t x = a.num * b.den, y = b.num * a.den;
  return x < y ? -1 : x > y ? 1 : 0;
}

struct Place {
  std::int64_t x, y;
};

/// One to four corners, counter-clockwise if they enclose an area; a radius. Lengths are in halves.
struct Shape {
  std::int32_t kind;
  std::array<double, 7> number;
  std::vector<Place> corners;
  std::int64_t radius;
};

Square squared_distance(Place p, Place a, Place b) {
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const std::int64_t length = dx * dx + dy * dy, along = px * dx + py * dy, across = dx * py - dy * px;
  if (length == 0 || along <= 0) return {px * px + py * py, 1};
  if (along >= length) return {(p.x - b.x) * (p.x - b.x) + (p.y - b.y) * (p.y - b.y), 1};
  return {across * across, length};
}

std::vector<std::array<Place, 2>> edges(const Shape& s) {
  std::vector<std::array<Place, 2>> result;
  for (std::size_t i = 0; i < s.corners.size(); ++i)
    result.push_back({s.corners[i], s.corners[(i + 1) % s.corners.size()]});
  return result;
}

Square to_outline(Place p, const Shape& s) {
  Square least{1, 0};
  for (const auto& [a, b] : edges(s)) {
    const Square d = squared_distance(p, a, b);
    if (compare(d, least) < 0) least = d;
  }
  return least;
}

bool has_area(const Shape& s) {
  const Place &a = s.corners[0], &b = s.corners[1], &d = s.corners[3];
  return (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x) != 0;
}

bool holds(const Shape& s, Place p) {
  if (s.corners.size() < 4 || !has_area(s)) return to_outline(p, s).num == 0;
  for (const auto& [a, b] : edges(s)) {
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
  }
  return true;
}

/// 1 if a is inside b, 0 if it reaches b's outline from inside, -1 if it reaches out.
int clearance(const Shape& a, const Shape& b) {
  const std::int64_t length = b.radius - a.radius;
  const Square squared{length * length, 1};
  int least = 1;
  for (const Place& p : a.corners) {
    const bool in = holds(b, p);
    const int distance = compare(to_outline(p, b), squared);
    const int room = in ? (length > 0 ? 1 : distance) : length < 0 ? -1 : -distance;
    least = room < least ? room : least;
  }
  return least;
}

bool cross(const std::array<Place, 2>& e, const std::array<Place, 2>& f) {
  const auto side = [](const std::array<Place, 2>& l, Place p) {
    const std::int64_t s = (l[1].x - l[0].x) * (p.y - l[0].y) - (l[1].y - l[0].y) * (p.x - l[0].x);
    return s < 0 ? -1 : s > 0 ? 1 : 0;
  };
  return side(e, f[0]) * side(e, f[1]) < 0 && side(f, e[0]) * side(f, e[1]) < 0;
}

/// The distance of the cores against the sum of the radii: -1 closer, 0 equal, 1 farther.
int contact(const Shape& a, const Shape& b) {
  const std::int64_t sum = a.radius + b.radius;
  Square least{1, 0};
  const auto take = [&](const Square& d) {
    if (compare(d, least) < 0) least = d;
  };
  for (const Place& p : a.corners) take(holds(b, p) ? Square{0, 1} : to_outline(p, b));
  for (const Place& p : b.corners) take(holds(a, p) ? Square{0, 1} : to_outline(p, a));
  for (const auto& e : edges(a)) {
    for (const auto& f : edges(b)) {
      if (cross(e, f)) take({0, 1});
    }
  }
  return compare(least, {sum * sum, 1});
}

/// By the definition of vesica.h, for shapes of which at least one has a radius.
int relation(const Shape& a, const Shape& b) {
  const int apart = contact(a, b), in_b = clearance(a, b), in_a = clearance(b, a);
  if (apart > 0) return VESICA_DISJOINT;
  if (in_a >= 0 && in_b >= 0) return VESICA_EQUAL;
  if (in_b >= 0) return in_b > 0 ? VESICA_INSIDE : VESICA_INSIDE_TOUCH;
  if (in_a >= 0) return in_a > 0 ? VESICA_CONTAINS : VESICA_CONTAINS_TOUCH;
  return apart < 0 ? VESICA_CROSS : VESICA_TOUCH;
}

constexpr std::array<std::array<int, 2>, 5> axes{{{1, 0}, {0, -2}, {3, 4}, {1, 1}, {-2, 1}}};

Shape shape(std::int32_t kind, Random& random) {
  const auto integer = [&](int low, int high) { return static_cast<std::int64_t>(random.integer(low, high)); };
  const auto number = [](std::int64_t halves) { return static_cast<double>(halves) / 2; };
  const Place p{integer(-8, 8), integer(-8, 8)};
  const std::int64_t r = integer(kind == VESICA_CIRCLE ? 0 : 1, 12);
  switch (kind) {
    case VESICA_POINT:
      return {kind, {number(p.x), number(p.y)}, {p}, 0};
    case VESICA_CIRCLE:
      return {kind, {number(p.x), number(p.y), number(r)}, {p}, r};
    case VESICA_SEGMENT:
    case VESICA_CAPSULE: {
      const Place q{integer(-8, 8), integer(-8, 8)};
      const std::int64_t radius = kind == VESICA_CAPSULE ? r : 0;
      return {kind, {number(p.x), number(p.y), number(q.x), number(q.y), number(radius)}, {p, q}, radius};
    }
    case VESICA_AABB: {
      const Place q{p.x + integer(0, 8), p.y + integer(0, 8)};
      return {kind, {number(p.x), number(p.y), number(q.x), number(q.y)}, {p, {q.x, p.y}, q, {p.x, q.y}}, 0};
    }
    default: {
      const auto& [ux, uy] = axes[static_cast<std::size_t>(random.below(axes.size()))];
      const std::int64_t hx = integer(0, 4), hy = integer(0, 4), radius = kind == VESICA_ROUND_RECT ? r : 0;
      const Place u{ux * hx, uy * hx}, v{-uy * hy, ux * hy};
      return {kind,
              {number(p.x), number(p.y), static_cast<double>(ux), static_cast<double>(uy), number(hx), number(hy),
               number(radius)},
              {{p.x - u.x - v.x, p.y - u.y - v.y},
               {p.x + u.x - v.x, p.y + u.y - v.y},
               {p.x + u.x + v.x, p.y + u.y + v.y},
               {p.x - u.x + v.x, p.y - u.y + v.y}},
              radius};
    }
  }
}

int asked(const Shape& a, const Shape& b) {
  return vesica_relation_f64(a.kind, a.number.data(), b.kind, b.number.data());
}

TEST(RelationInflated, AgreesWithWholeNumbersOnALattice) {
  Random random(properties::seed());
  std::array<int, 8> seen{};
  const int cases = 300000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    const std::int32_t kinds[] = {VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE,    VESICA_AABB,
                                  VESICA_RECT,  VESICA_CAPSULE, VESICA_ROUND_RECT};
    const Shape a = shape(kinds[random.below(7)], random);
    Shape b = shape(random.chance(0.5) ? VESICA_CAPSULE : VESICA_ROUND_RECT, random);
    if (a.kind == VESICA_CAPSULE && random.chance(0.1)) {  // the same set, from its other end
      b = a;
      std::swap(b.number[0], b.number[2]);
      std::swap(b.number[1], b.number[3]);
    }
    const int truth = relation(a, b), found = asked(a, b), converse = asked(b, a);
    ASSERT_EQ(found, truth) << "case " << i << ", kinds " << a.kind << " and " << b.kind;
    ASSERT_EQ(converse, relation(b, a)) << "case " << i << ", exchanged";
    ASSERT_EQ(vesica_contains_f64(a.kind, a.number.data(), b.kind, b.number.data()), found >= VESICA_CONTAINS);
    ASSERT_EQ(vesica_contains_f64(b.kind, b.number.data(), a.kind, a.number.data()), converse >= VESICA_CONTAINS);
    ASSERT_EQ(vesica_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data()), found != VESICA_DISJOINT);
    const auto insides = vesica_interiors_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data());
    ASSERT_EQ(insides, contact(a, b) < 0) << "case " << i << ", insides";
    ++seen[static_cast<std::size_t>(found)];
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST(RelationInflated, OneSetInOtherNumbers) {
  const vesica_capsule_f64 capsule{0, 0, 6, 8, 5}, turned{6, 8, 0, 0, 5}, disc{1, 2, 1, 2, 5}, bare{0, 0, 6, 8, 0};
  const vesica_round_rect_f64 as_rect{3, 4, 3, 4, 1, 0, 5}, across{3, 4, -4, 3, 0, 1, 5}, sharp{3, 4, 3, 4, 1, 1, 0};
  const vesica_circle_f64 circle{1, 2, 5};
  const vesica_segment_f64 segment{6, 8, 0, 0};
  const vesica_rect_f64 rect{3, 4, -4, 3, 1, 1};
  EXPECT_EQ(vesica_relation_f64(VESICA_CAPSULE, &capsule, VESICA_CAPSULE, &turned), VESICA_EQUAL);
  EXPECT_EQ(vesica_relation_f64(VESICA_CAPSULE, &capsule, VESICA_ROUND_RECT, &as_rect), VESICA_EQUAL);
  EXPECT_EQ(vesica_relation_f64(VESICA_ROUND_RECT, &across, VESICA_CAPSULE, &capsule), VESICA_EQUAL);
  EXPECT_EQ(vesica_relation_f64(VESICA_CAPSULE, &disc, VESICA_CIRCLE, &circle), VESICA_EQUAL);
  EXPECT_EQ(vesica_relation_f64(VESICA_SEGMENT, &segment, VESICA_CAPSULE, &bare), VESICA_EQUAL);
  EXPECT_EQ(vesica_relation_f64(VESICA_RECT, &rect, VESICA_ROUND_RECT, &sharp), VESICA_EQUAL);
}

/// Without a radius the outline of a segment is its ends.
TEST(RelationInflated, WithoutRadii) {
  const vesica_capsule_f64 bare{0, 0, 6, 8, 0};
  const vesica_point_f64 end{6, 8}, middle{3, 4};
  EXPECT_EQ(vesica_relation_f64(VESICA_POINT, &end, VESICA_CAPSULE, &bare), VESICA_INSIDE_TOUCH);
  EXPECT_EQ(vesica_relation_f64(VESICA_POINT, &middle, VESICA_CAPSULE, &bare), VESICA_INSIDE);
  const vesica_round_rect_f64 dot{6, 8, 1, 0, 0, 0, 0};
  EXPECT_EQ(vesica_relation_f64(VESICA_ROUND_RECT, &dot, VESICA_CAPSULE, &bare), VESICA_INSIDE_TOUCH);
}

}  // namespace
}  // namespace relation_inflated_test
