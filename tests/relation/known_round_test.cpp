// SPDX-License-Identifier: Apache-2.0
// Known relations of circles and ellipses. The ellipse with half lengths 80 and 45 about the origin has the rational
// point (64, 27) with normal (3, 4); that with 10 and 5 has the points (+-6, +-4).
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cmath>

#include "relation/known.hpp"

namespace known_round_test {
namespace {

using known::expect_cases;

constexpr int disjoint = VESICA_DISJOINT, touch = VESICA_TOUCH, cross = VESICA_CROSS, inside = VESICA_INSIDE,
              inside_touch = VESICA_INSIDE_TOUCH, contains = VESICA_CONTAINS, contains_touch = VESICA_CONTAINS_TOUCH,
              equal = VESICA_EQUAL;

TEST(KnownRelation, PointCircle) {
  expect_cases(VESICA_POINT, VESICA_CIRCLE,
               {{disjoint, {4, 4}, {0, 0, 5}},
                {inside, {1, 1}, {0, 0, 5}},
                {inside_touch,
                 {3, 4},
                 {0, 0, 5},
                 {{'a', 0, 1, disjoint}, {'a', 0, -1, inside}, {'b', 2, 1, inside}, {'b', 2, -1, disjoint}}},
                {equal, {3, 4}, {3, 4, 0}, {{'a', 0, 1, disjoint}, {'b', 2, 1, inside}}}});
}

TEST(KnownRelation, PointEllipse) {
  expect_cases(VESICA_POINT, VESICA_ELLIPSE,
               {{disjoint, {7, 4}, {0, 0, 1, 0, 10, 5}},
                {inside, {1, 1}, {0, 0, 1, 0, 10, 5}},
                {inside_touch,
                 {6, 4},
                 {0, 0, 1, 0, 10, 5},
                 {{'a', 1, 1, disjoint}, {'a', 1, -1, inside}, {'b', 4, 1, inside}, {'b', 4, -1, disjoint}}},
                {inside_touch,
                 {6, 8},
                 {0, 0, 3, 4, 2, 1},
                 {{'a', 0, 1, disjoint}, {'b', 4, 1, inside}, {'b', 4, -1, disjoint}, {'b', 5, 1, inside_touch}}},
                {inside, {3, 4}, {0, 0, 3, 4, 2, 0}, {{'a', 0, 1, disjoint}}},
                {inside_touch, {6, 8}, {0, 0, 3, 4, 2, 0}, {{'b', 4, 1, inside}, {'b', 4, -1, disjoint}}},
                {equal, {1, 2}, {1, 2, 3, 4, 0, 0}, {{'a', 0, 1, disjoint}, {'b', 5, 1, inside}}}});
}

TEST(KnownRelation, SegmentCircle) {
  expect_cases(
      VESICA_SEGMENT, VESICA_CIRCLE,
      {{disjoint, {6, 0, 9, 0}, {0, 0, 5}},
       {touch,
        {-4, 5, 4, 5},
        {0, 0, 5},
        {{'b', 2, 1, cross}, {'b', 2, -1, disjoint}, {'a', 1, 1, disjoint}, {'a', 1, -1, cross}}},
       {touch, {5, 0, 9, 0}, {0, 0, 5}, {{'a', 0, 1, disjoint}, {'a', 0, -1, cross}}},
       {touch, {7, 1, -1, 7}, {0, 0, 5}, {{'b', 2, 1, cross}, {'b', 2, -1, disjoint}}},
       {cross, {-9, 0, 9, 0}, {0, 0, 5}},
       {cross, {0, 0, 9, 0}, {0, 0, 5}},
       {inside, {-1, 0, 1, 2}, {0, 0, 5}},
       {inside_touch,
        {-3, 4, 3, 4},
        {0, 0, 5},
        {{'b', 2, 1, inside}, {'b', 2, -1, cross}, {'a', 0, -1, cross}, {'a', 0, 1, inside_touch}}},
       {inside_touch,
        {0, 0, 3, 4},
        {0, 0, 5},
        {{'b', 2, 1, inside}, {'b', 2, -1, cross}, {'a', 2, 1, cross}, {'a', 2, -1, inside}}},
       {contains, {-4, 0, 4, 0}, {1, 0, 0}, {{'b', 2, 1, cross}, {'b', 1, 1, disjoint}}},
       {contains_touch, {-4, 0, 4, 0}, {4, 0, 0}, {{'b', 2, 1, cross}, {'b', 0, 1, disjoint}, {'b', 0, -1, contains}}},
       {equal, {4, 1, 4, 1}, {4, 1, 0}, {{'b', 2, 1, inside}}}});
}

TEST(KnownRelation, SegmentEllipse) {
  expect_cases(VESICA_SEGMENT, VESICA_ELLIPSE,
               {{disjoint, {20, 0, 30, 0}, {0, 0, 1, 0, 10, 5}},
                {touch, {-4, 5, 4, 5}, {0, 0, 1, 0, 10, 5}, {{'b', 5, 1, cross}, {'b', 5, -1, disjoint}}},
                {touch, {-2, 7, 14, 1}, {0, 0, 1, 0, 10, 5}, {{'b', 4, 1, cross}, {'b', 4, -1, disjoint}}},
                {touch, {6, 4, 12, 8}, {0, 0, 1, 0, 10, 5}, {{'a', 1, 1, disjoint}, {'a', 1, -1, cross}}},
                {touch, {6, 8, 12, 16}, {0, 0, 3, 4, 2, 1}, {{'b', 4, 1, cross}, {'b', 4, -1, disjoint}}},
                {cross, {-20, 0, 20, 0}, {0, 0, 1, 0, 10, 5}},
                {inside, {-1, 0, 1, 2}, {0, 0, 1, 0, 10, 5}},
                {inside_touch, {-6, -4, 6, 4}, {0, 0, 1, 0, 10, 5}, {{'b', 4, 1, inside}, {'b', 4, -1, cross}}},
                {contains, {-12, -16, 12, 16}, {0, 0, 3, 4, 2, 0}, {{'b', 5, 1, cross}}},
                {contains_touch, {-6, -8, 12, 16}, {0, 0, 3, 4, 2, 0}, {{'b', 4, 1, cross}, {'b', 4, -1, contains}}},
                {equal,
                 {-6, -8, 6, 8},
                 {0, 0, -4, 3, 0, 2},
                 {{'b', 5, 1, inside}, {'b', 5, -1, contains}, {'b', 4, 1, inside_touch}}}});
}

TEST(KnownRelation, CircleCircle) {
  expect_cases(
      VESICA_CIRCLE, VESICA_CIRCLE,
      {{disjoint, {0, 0, 2}, {9, 0, 2}},
       {touch,
        {0, 0, 2},
        {6, 8, 8},
        {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}, {'b', 0, 1, disjoint}, {'b', 0, -1, cross}}},
       {cross, {0, 0, 5}, {4, 0, 5}},
       {inside, {1, 1, 1}, {0, 0, 5}},
       {inside, {0, 0, 1}, {0, 0, 2}},
       {inside_touch,
        {3, 4, 5},
        {0, 0, 10},
        {{'a', 2, 1, cross}, {'a', 2, -1, inside}, {'a', 0, 1, cross}, {'a', 0, -1, inside}}},
       {contains, {0, 0, 5}, {1, 1, 1}},
       {contains_touch, {0, 0, 10}, {6, -8, 0}, {{'b', 2, 1, cross}, {'b', 0, 1, disjoint}, {'b', 0, -1, contains}}},
       {equal,
        {1, 2, 3},
        {1, 2, 3},
        {{'a', 2, 1, contains}, {'a', 2, -1, inside}, {'a', 0, 1, cross}, {'b', 1, -1, cross}}},
       {equal, {1, 2, 0}, {1, 2, 0}, {{'a', 2, 1, contains}, {'a', 0, 1, disjoint}}}});
}

TEST(KnownRelation, CircleAabb) {
  expect_cases(
      VESICA_CIRCLE, VESICA_AABB,
      {{disjoint, {0, 0, 5}, {6, 0, 9, 9}},
       {touch, {0, 0, 5}, {5, -1, 9, 1}, {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}}},
       {touch,
        {0, 0, 5},
        {3, 4, 9, 9},
        {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}, {'b', 0, 1, disjoint}, {'b', 0, -1, cross}}},
       {cross, {0, 0, 5}, {0, 0, 9, 9}},
       {inside, {0, 0, 1}, {-4, -4, 4, 4}},
       {inside_touch, {3, 0, 1}, {-4, -4, 4, 4}, {{'a', 2, 1, cross}, {'a', 2, -1, inside}}},
       {inside_touch, {0, 0, 4}, {-4, -4, 4, 4}, {{'a', 2, 1, cross}, {'a', 2, -1, inside}, {'b', 2, 1, inside_touch}}},
       {contains, {0, 0, 9}, {-2, -2, 2, 2}},
       {contains_touch, {0, 0, 5}, {-3, -4, 3, 4}, {{'a', 2, 1, contains}, {'a', 2, -1, cross}}},
       {contains_touch, {0, 0, 5}, {-1, -1, 3, 4}, {{'b', 2, 1, cross}, {'b', 2, -1, contains}}},
       {equal, {3, 4, 0}, {3, 4, 3, 4}, {{'a', 2, 1, contains}, {'b', 2, 1, inside_touch}}}});
}

TEST(KnownRelation, CircleRect) {
  expect_cases(
      VESICA_CIRCLE, VESICA_RECT,
      {{disjoint, {30, 40, 10}, {0, 0, 3, 4, 2, 1}},
       {touch, {12, 16, 10}, {0, 0, 3, 4, 2, 1}, {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}, {'b', 4, 1, cross}}},
       {touch, {0, 30, 5}, {0, 0, 3, 4, 4, 3}, {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}}},
       {cross, {12, 16, 15}, {0, 0, 3, 4, 2, 1}},
       {inside, {0, 0, 4}, {0, 0, 3, 4, 2, 1}},
       {inside_touch, {0, 0, 5}, {0, 0, 3, 4, 2, 1}, {{'a', 2, 1, cross}, {'a', 2, -1, inside}}},
       {contains, {0, 0, 30}, {0, 0, 3, 4, 4, 3}},
       {contains_touch,
        {0, 0, 25},
        {0, 0, 3, 4, 4, 3},
        {{'a', 2, 1, contains}, {'a', 2, -1, cross}, {'b', 5, 1, cross}}},
       {contains_touch,
        {0, 0, 25},
        {0, 0, 3, 4, 5, 0},
        {{'a', 2, 1, contains}, {'a', 2, -1, cross}, {'b', 5, 1, cross}}},
       {equal, {3, 4, 0}, {3, 4, 1, 7, 0, 0}, {{'a', 2, 1, contains}, {'b', 4, 1, inside}}}});
}

TEST(KnownRelation, CircleEllipse) {
  expect_cases(
      VESICA_CIRCLE, VESICA_ELLIPSE,
      {{disjoint, {20, 0, 5}, {0, 0, 1, 0, 10, 5}},
       {touch, {15, 0, 5}, {0, 0, 1, 0, 10, 5}, {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}}},
       {touch, {67, 31, 5}, {0, 0, 1, 0, 80, 45}, {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}, {'b', 5, 1, cross}}},
       {cross, {0, 0, 7}, {0, 0, 1, 0, 10, 5}},
       {cross, {10, 0, 3}, {0, 0, 1, 0, 10, 5}},
       // Tangent at the vertex from inside, but flatter than it is there.
       {cross, {14, 0, 6}, {0, 0, 1, 0, 20, 10}, {{'a', 2, 1, cross}, {'a', 2, -1, cross}}},
       {inside, {1, 1, 1}, {0, 0, 1, 0, 10, 5}},
       {inside_touch,
        {61, 23, 5},
        {0, 0, 1, 0, 80, 45},
        {{'a', 2, 1, cross}, {'a', 2, -1, inside}, {'b', 4, 1, inside}}},
       {inside_touch,
        {0, 0, 5},
        {0, 0, 1, 0, 10, 5},
        {{'a', 2, 1, cross}, {'a', 2, -1, inside}, {'b', 4, 1, inside_touch}}},
       {contains, {0, 0, 20}, {0, 0, 1, 0, 10, 5}},
       {contains_touch,
        {0, 0, 10},
        {0, 0, 1, 0, 10, 5},
        {{'a', 2, 1, contains}, {'a', 2, -1, cross}, {'b', 5, 1, contains_touch}}},
       {contains_touch,
        {0, 0, 10},
        {5, 0, 1, 0, 5, 2},
        {{'a', 2, 1, contains}, {'a', 2, -1, cross}, {'b', 0, 1, cross}}},
       // Four-fold contact at a vertex: the circle of curvature.
       {inside_touch,
        {3, 0, 1},
        {0, 0, 1, 0, 4, 2},
        {{'a', 2, 1, cross}, {'a', 2, -1, inside}, {'a', 0, 1, cross}, {'a', 0, -1, inside}}},
       {contains_touch, {0, -6, 8}, {0, 0, 1, 0, 4, 2}, {{'a', 2, 1, contains}, {'a', 2, -1, cross}}},
       {equal,
        {0, 0, 5},
        {0, 0, 3, 4, 1, 1},
        {{'a', 2, 1, contains},
         {'a', 2, -1, inside},
         {'b', 4, 1, inside_touch},
         {'b', 4, -1, contains_touch},
         {'b', 0, 1, cross}}},
       {contains_touch, {0, 0, 5}, {0, 0, 3, 4, 1, 0}, {{'a', 2, 1, contains}, {'a', 2, -1, cross}}}});
}

TEST(KnownRelation, AabbEllipse) {
  expect_cases(
      VESICA_AABB, VESICA_ELLIPSE,
      {{disjoint, {70, 40, 99, 99}, {0, 0, 1, 0, 80, 45}},
       {touch,
        {64, 27, 99, 99},
        {0, 0, 1, 0, 80, 45},
        {{'a', 0, 1, disjoint}, {'a', 0, -1, cross}, {'b', 4, 1, cross}}},
       {touch, {80, -9, 99, 9}, {0, 0, 1, 0, 80, 45}, {{'a', 0, 1, disjoint}, {'a', 0, -1, cross}}},
       {cross, {0, 0, 99, 99}, {0, 0, 1, 0, 80, 45}},
       {inside, {-9, -9, 9, 9}, {0, 0, 1, 0, 80, 45}},
       {inside_touch, {0, 0, 64, 27}, {0, 0, 1, 0, 80, 45}, {{'a', 2, 1, cross}, {'a', 2, -1, inside}}},
       {inside_touch,
        {-6, -4, 6, 4},
        {0, 0, 1, 0, 10, 5},
        {{'a', 0, -1, cross}, {'a', 0, 1, inside_touch}, {'b', 5, 1, inside}}},
       {contains, {-99, -99, 99, 99}, {0, 0, 1, 0, 80, 45}},
       {contains_touch, {-80, -99, 99, 99}, {0, 0, 1, 0, 80, 45}, {{'a', 0, 1, cross}, {'a', 0, -1, contains}}},
       {equal, {-6, 1, 6, 1}, {0, 1, 2, 0, 3, 0}, {{'b', 4, 1, inside}, {'b', 5, 1, inside_touch}}}});
}

TEST(KnownRelation, RectEllipse) {
  expect_cases(
      VESICA_RECT, VESICA_ELLIPSE,
      {{disjoint, {60, 80, 3, 4, 1, 1}, {0, 0, 3, 4, 10, 5}},
       {touch, {36, 48, 3, 4, 2, 1}, {0, 0, 3, 4, 10, 5}, {{'a', 4, 1, cross}, {'a', 4, -1, disjoint}}},
       {touch, {4, 47, 3, 4, 2, 1}, {0, 0, 3, 4, 10, 5}, {{'a', 5, 1, cross}, {'a', 5, -1, disjoint}}},
       {cross, {36, 48, 3, 4, 5, 1}, {0, 0, 3, 4, 10, 5}},
       {inside, {0, 0, 3, 4, 1, 1}, {0, 0, 3, 4, 10, 5}},
       {inside_touch,
        {0, 0, 3, 4, 6, 4},
        {0, 0, 3, 4, 10, 5},
        {{'a', 4, 1, cross}, {'a', 4, -1, inside}, {'b', 5, 1, inside}}},
       {contains, {0, 0, 3, 4, 20, 20}, {0, 0, 3, 4, 10, 5}},
       {contains_touch, {0, 0, 3, 4, 10, 9}, {0, 0, 3, 4, 10, 5}, {{'a', 4, 1, contains}, {'a', 4, -1, cross}}},
       {contains_touch, {0, 0, 3, 4, 10, 5}, {0, 0, -4, 3, 5, 10}, {{'a', 4, 1, contains_touch}, {'a', 4, -1, cross}}},
       {equal, {1, 2, 3, 4, 0, 2}, {1, 2, -3, -4, 0, 2}, {{'a', 5, 1, contains}, {'b', 4, 1, inside_touch}}}});
}

TEST(KnownRelation, EllipseEllipse) {
  expect_cases(
      VESICA_ELLIPSE, VESICA_ELLIPSE,
      {{disjoint, {0, 0, 1, 0, 80, 45}, {200, 54, 1, 0, 80, 45}},
       {touch,
        {0, 0, 1, 0, 80, 45},
        {128, 54, 1, 0, 80, 45},
        {{'a', 4, 1, cross}, {'a', 4, -1, disjoint}, {'b', 0, 1, disjoint}, {'b', 0, -1, cross}}},
       {cross, {0, 0, 1, 0, 4, 2}, {0, 0, 0, 1, 4, 2}},
       {cross, {0, 0, 1, 0, 4, 2}, {3, 1, 0, 1, 4, 2}},
       // The same shape moved: equal areas.
       {cross, {0, 0, 3, 4, 10, 5}, {1, 0, 3, 4, 10, 5}},
       {inside, {0, 0, 1, 0, 4, 2}, {0, 0, 1, 0, 6, 3}, {{'a', 4, 1, inside}, {'a', 4, -1, inside}}},
       {inside, {1, 1, 3, 4, 1, 1}, {0, 0, 1, 0, 40, 20}},
       // Touching at both ends of an axis.
       {inside_touch,
        {0, 0, 1, 0, 4, 2},
        {0, 0, 1, 0, 4, 3},
        {{'a', 4, 1, cross}, {'a', 4, -1, inside}, {'b', 5, 1, inside_touch}, {'a', 0, 1, cross}}},
       {inside_touch,
        {64, 27, 1, 0, 80, 45},
        {0, 0, 1, 0, 160, 90},
        {{'a', 4, 1, cross}, {'a', 4, -1, inside}, {'a', 0, 1, cross}, {'a', 0, -1, inside}}},
       // Four-fold contact: the circle of curvature at the vertex (20, 0).
       {inside_touch,
        {15, 0, 3, 4, 1, 1},
        {0, 0, 1, 0, 20, 10},
        {{'a', 4, 1, cross}, {'a', 4, -1, inside}, {'a', 0, 1, cross}, {'a', 0, -1, inside}}},
       {contains, {0, 0, 1, 0, 40, 20}, {1, 1, 3, 4, 1, 1}},
       // An image of two circles about one centre, so that the cubic has a double root and yet nothing touches: in the
       // units of a, 5 c^2 + 12 c + 8 is the squared distance of (3 c, 2 s) from b's centre (-2, 0), c^2 + s^2 = 1,
       // which is b's 4/5 at c = -6/5 alone. The exact stage said that they touch.
       {contains, {-8, -6, 1, 2, 3, 2}, {-10, -10, 0, -2, 1, 1}},
       {contains_touch, {0, 0, 3, 4, 10, 5}, {0, 0, 3, 4, 10, 2}, {{'b', 4, 1, cross}, {'b', 4, -1, contains}}},
       {equal,
        {0, 0, 3, 4, 2, 1},
        {0, 0, -4, 3, 1, 2},
        {{'a', 4, 1, contains_touch}, {'a', 4, -1, inside_touch}, {'a', 0, 1, cross}}},
       {equal, {0, 0, 3, 4, 8, 1}, {0, 0, 3, 4, 8, 1}, {{'a', 2, 1, cross}, {'a', 3, -1, cross}}},
       {equal, {1, 2, 3, 4, 2, 0}, {1, 2, 6, 8, 1, 0}, {{'a', 4, 1, contains}, {'a', 5, 1, contains_touch}}},
       {equal, {1, 2, 3, 4, 0, 0}, {1, 2, 5, 1, 0, 0}, {{'a', 4, 1, contains}}}});
}

/// Their centres and axes differ by so little that only the sizes count, and the discriminant of their cubic is nearly
/// 0.
TEST(KnownRelation, EllipsesNearlySimilarAboutNearlyOneCentre) {
  using Ellipse = std::array<double, 6>;
  const double above_5 = std::nextafter(5, 6), below_5 = std::nextafter(5, 4), above_3 = std::nextafter(3, 4),
               below_3 = std::nextafter(3, 2);
  const auto expect = [](int expected, int converse, const Ellipse& a, const Ellipse& b) {
    EXPECT_EQ(vesica_relation_f64(VESICA_ELLIPSE, a.data(), VESICA_ELLIPSE, b.data()), expected) << a[4] << ' ' << b[4];
    EXPECT_EQ(vesica_relation_f64(VESICA_ELLIPSE, b.data(), VESICA_ELLIPSE, a.data()), converse) << a[4] << ' ' << b[4];
  };
  for (const double offset : {0x1p-700, -0x1p-1040}) {
    for (const double tilt : {0x1p-900, -0x1p-1070}) {
      const Ellipse e{0, 0, 1, 0, 5, 3};
      const auto other = [&](double a, double b) { return Ellipse{offset, 0, 1, tilt, a, b}; };
      expect(inside, contains, e, other(above_5, above_3));
      expect(contains, inside, e, other(below_5, below_3));
      expect(inside, contains, e, other(0x1p300 * 5, 0x1p300 * 3));
      expect(contains, inside, e, other(0x1p-300 * 5, 0x1p-300 * 3));
      expect(cross, cross, e, other(5, 3));
      expect(cross, cross, e, other(above_5, below_3));
      expect(cross, cross, e, other(below_5, above_3));
      // Discs whose radii differ by less than their offset, by 2^-4148 of themselves.
      expect(cross, cross, {0, 0, 0x1p1000, 0, 5, 5}, {offset, 0, 0x1p1000, 0x1p-1074, 5, 5});
      // As long, and a little wider: beyond each other at one end, or by the tilt.
      expect(cross, cross, e, other(5, above_3));
    }
  }
}

}  // namespace
}  // namespace known_round_test
