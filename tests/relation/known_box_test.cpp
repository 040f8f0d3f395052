// SPDX-License-Identifier: Apache-2.0
// Known relations of points, segments, AABBs and rectangles. A rectangle with axis (3, 4) and half extent 1 is 10 long.
#include <gtest/gtest.h>
#include <vesica.h>

#include "relation/known.hpp"

namespace {

using known::expect_cases;

constexpr int disjoint = VESICA_DISJOINT, touch = VESICA_TOUCH, cross = VESICA_CROSS, inside = VESICA_INSIDE,
              inside_touch = VESICA_INSIDE_TOUCH, contains = VESICA_CONTAINS, contains_touch = VESICA_CONTAINS_TOUCH,
              equal = VESICA_EQUAL;

TEST(KnownRelation, PointPoint) {
  expect_cases(VESICA_POINT, VESICA_POINT,
               {{disjoint, {1, 2}, {1, 3}},
                {equal, {1, 2}, {1, 2}, {{'a', 0, 1, disjoint}, {'a', 1, -1, disjoint}, {'b', 1, 1, disjoint}}},
                {equal, {0, 0}, {0, 0}, {{'a', 0, 1, disjoint}, {'b', 1, -1, disjoint}}}});
}

TEST(KnownRelation, PointSegment) {
  expect_cases(VESICA_POINT, VESICA_SEGMENT,
               {{disjoint, {5, 0}, {-4, 0, 4, 0}},
                {inside, {2, 1}, {-4, -2, 4, 2}, {{'a', 0, 1, disjoint}, {'a', 1, 1, disjoint}}},
                {inside_touch, {4, 2}, {-4, -2, 4, 2}, {{'a', 0, 1, disjoint}, {'a', 0, -1, disjoint}}},
                {inside_touch,
                 {4, 0},
                 {-4, 0, 4, 0},
                 {{'a', 0, 1, disjoint}, {'a', 0, -1, inside}, {'b', 2, 1, inside}, {'b', 2, -1, disjoint}}},
                {inside, {0, 0}, {-4, 0, 4, 0}, {{'a', 1, 1, disjoint}, {'b', 1, 1, disjoint}}},
                {equal, {3, 1}, {3, 1, 3, 1}, {{'a', 0, 1, disjoint}, {'b', 0, 1, inside_touch}}}});
}

TEST(KnownRelation, PointAabb) {
  expect_cases(
      VESICA_POINT, VESICA_AABB,
      {{disjoint, {5, 0}, {-4, -4, 4, 4}},
       {inside, {1, 1}, {-4, -4, 4, 4}},
       {inside_touch, {4, 1}, {-4, -4, 4, 4}, {{'a', 0, 1, disjoint}, {'a', 0, -1, inside}, {'b', 2, 1, inside}}},
       {inside_touch, {4, 4}, {-4, -4, 4, 4}, {{'a', 0, 1, disjoint}, {'a', 0, -1, inside_touch}}},
       {inside, {0, 3}, {-4, 3, 4, 3}, {{'a', 1, 1, disjoint}, {'b', 3, 1, inside_touch}}},
       {inside_touch, {4, 3}, {-4, 3, 4, 3}, {{'a', 0, 1, disjoint}, {'a', 0, -1, inside}}},
       {equal, {4, 3}, {4, 3, 4, 3}, {{'a', 0, 1, disjoint}, {'b', 2, 1, inside_touch}}}});
}

TEST(KnownRelation, PointRect) {
  expect_cases(VESICA_POINT, VESICA_RECT,
               {{disjoint, {7, 9}, {0, 0, 3, 4, 1, 1}},
                {inside, {1, 1}, {0, 0, 3, 4, 1, 1}},
                {inside_touch,
                 {3, 4},
                 {0, 0, 3, 4, 1, 1},
                 {{'a', 0, 1, disjoint}, {'a', 0, -1, inside}, {'b', 4, 1, inside}, {'b', 4, -1, disjoint}}},
                {inside_touch,
                 {-1, 7},
                 {0, 0, 3, 4, 1, 1},
                 {{'a', 1, 1, disjoint}, {'b', 4, 1, inside_touch}, {'b', 4, -1, disjoint}}},
                {inside, {3, 4}, {0, 0, 3, 4, 2, 0}, {{'a', 0, 1, disjoint}, {'b', 5, 1, inside}}},
                {inside_touch, {6, 8}, {0, 0, 3, 4, 2, 0}, {{'b', 4, 1, inside}, {'b', 4, -1, disjoint}}},
                {equal, {1, 2}, {1, 2, 3, 4, 0, 0}, {{'a', 0, 1, disjoint}, {'b', 4, 1, inside}}}});
}

TEST(KnownRelation, SegmentSegment) {
  expect_cases(
      VESICA_SEGMENT, VESICA_SEGMENT,
      {{disjoint, {0, 1, 4, 1}, {0, 0, 4, 0}},
       {disjoint, {0, 0, 4, 0}, {5, 0, 8, 0}},
       {cross, {-4, 0, 4, 0}, {0, -4, 0, 4}},
       {cross, {-4, 0, 2, 0}, {-2, 0, 4, 0}, {{'a', 1, 1, touch}, {'a', 1, -1, touch}}},
       {touch, {0, 0, 0, 4}, {-4, 0, 4, 0}, {{'a', 1, 1, disjoint}, {'a', 1, -1, cross}}},
       {touch, {0, 0, 4, 4}, {0, 0, -4, 3}, {{'a', 0, 1, disjoint}}},
       {touch, {0, 0, 4, 0}, {4, 0, 8, 0}, {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}, {'b', 1, 1, disjoint}}},
       {inside, {-1, 0, 1, 0}, {-4, 0, 4, 0}, {{'a', 1, 1, touch}}},
       {inside_touch, {0, 0, 4, 0}, {-4, 0, 4, 0}, {{'a', 2, 1, cross}, {'a', 2, -1, inside}, {'b', 2, 1, inside}}},
       {contains, {-8, -4, 8, 4}, {-2, -1, 2, 1}, {{'b', 0, 1, touch}}},
       {contains_touch, {-8, -4, 8, 4}, {8, 4, -2, -1}},
       {equal, {-4, -2, 4, 2}, {4, 2, -4, -2}, {{'a', 0, 1, touch}}},
       {equal, {-4, 0, 4, 0}, {-4, 0, 4, 0}, {{'a', 0, 1, inside_touch}, {'a', 0, -1, contains_touch}}},
       {inside_touch, {4, 2, 4, 2}, {-4, -2, 4, 2}, {{'b', 2, 1, disjoint}}},
       {equal, {1, 2, 1, 2}, {1, 2, 1, 2}, {{'a', 0, 1, contains_touch}}}});
}

TEST(KnownRelation, SegmentAabb) {
  expect_cases(VESICA_SEGMENT, VESICA_AABB,
               {{disjoint, {5, 0, 9, 0}, {-4, -4, 4, 4}},
                {touch, {2, 4, 8, 4}, {-4, -4, 4, 4}, {{'b', 3, 1, cross}, {'b', 3, -1, disjoint}}},
                {touch, {4, 4, 8, 9}, {-4, -4, 4, 4}, {{'a', 0, 1, disjoint}}},
                {touch, {0, 8, 8, 0}, {-4, -4, 4, 4}, {{'b', 2, 1, cross}, {'b', 2, -1, disjoint}}},
                {cross, {-9, 0, 9, 1}, {-4, -4, 4, 4}},
                {cross, {0, 0, 9, 1}, {-4, -4, 4, 4}},
                {inside, {-1, -1, 2, 2}, {-4, -4, 4, 4}},
                {inside_touch, {-2, 4, 2, 4}, {-4, -4, 4, 4}, {{'a', 1, 1, touch}, {'a', 1, -1, inside_touch}}},
                {inside_touch, {0, 0, 4, 1}, {-4, -4, 4, 4}, {{'a', 2, 1, cross}, {'a', 2, -1, inside}}},
                {inside_touch, {-4, -4, 4, 4}, {-4, -4, 4, 4}, {{'b', 2, -1, cross}, {'a', 2, 1, cross}}},
                {contains, {-4, 0, 4, 0}, {-2, 0, 2, 0}, {{'b', 3, 1, touch}}},
                {contains_touch, {-4, 0, 4, 0}, {-2, 0, 4, 0}, {{'b', 2, 1, cross}, {'b', 2, -1, contains}}},
                {equal, {4, 0, -4, 0}, {-4, 0, 4, 0}, {{'b', 3, 1, inside_touch}, {'a', 1, 1, touch}}}});
}

TEST(KnownRelation, SegmentRect) {
  expect_cases(VESICA_SEGMENT, VESICA_RECT,
               {{disjoint, {12, 16, 15, 20}, {0, 0, 3, 4, 2, 1}},
                {touch, {6, 8, 12, 16}, {0, 0, 3, 4, 2, 1}, {{'b', 4, 1, cross}, {'b', 4, -1, disjoint}}},
                {touch, {-2, 14, 14, 2}, {0, 0, 3, 4, 2, 1}, {{'b', 4, 1, cross}, {'b', 4, -1, disjoint}}},
                {cross, {0, 0, 30, 40}, {0, 0, 3, 4, 2, 1}},
                {inside, {0, 0, 3, 4}, {0, 0, 3, 4, 2, 1}},
                {inside_touch,
                 {2, 11, 10, 5},
                 {0, 0, 3, 4, 2, 1},
                 {{'b', 4, -1, disjoint}, {'b', 5, -1, touch}, {'b', 5, 1, inside_touch}}},
                {inside_touch, {0, 0, 6, 8}, {0, 0, 3, 4, 2, 1}, {{'b', 4, 1, inside}, {'b', 4, -1, cross}}},
                {contains, {-6, -8, 6, 8}, {0, 0, 3, 4, 1, 0}, {{'b', 5, 1, cross}}},
                {contains_touch, {-6, -8, 3, 4}, {0, 0, 3, 4, 1, 0}, {{'b', 4, 1, cross}, {'b', 4, -1, contains}}},
                {equal,
                 {-6, -8, 6, 8},
                 {0, 0, -3, -4, 2, 0},
                 {{'b', 4, 1, inside}, {'b', 4, -1, contains}, {'b', 5, 1, inside_touch}}}});
}

TEST(KnownRelation, AabbAabb) {
  expect_cases(VESICA_AABB, VESICA_AABB,
               {{disjoint, {0, 0, 2, 2}, {3, 0, 5, 2}},
                {touch, {0, 0, 2, 2}, {2, 1, 5, 3}, {{'a', 2, 1, cross}, {'a', 2, -1, disjoint}}},
                {touch, {0, 0, 2, 2}, {2, 2, 5, 5}, {{'a', 2, 1, touch}, {'a', 2, -1, disjoint}}},
                {cross, {0, 0, 4, 4}, {1, 1, 5, 5}},
                {cross, {0, 1, 9, 2}, {3, 0, 4, 9}},
                {inside, {1, 1, 2, 2}, {0, 0, 3, 3}},
                {inside_touch, {1, 1, 3, 2}, {0, 0, 3, 3}, {{'a', 2, 1, cross}, {'a', 2, -1, inside}}},
                {inside_touch, {0, 0, 3, 2}, {0, 0, 3, 3}, {{'a', 2, 1, cross}, {'a', 3, 1, inside_touch}}},
                {contains, {0, 0, 3, 3}, {1, 1, 2, 2}},
                {contains_touch, {0, 0, 3, 3}, {1, 0, 2, 2}, {{'b', 1, 1, contains}, {'b', 1, -1, cross}}},
                {equal, {0, 0, 3, 3}, {0, 0, 3, 3}, {{'a', 2, 1, contains_touch}, {'a', 2, -1, inside_touch}}},
                // A box without width.
                {touch, {0, 0, 4, 0}, {1, 0, 3, 2}, {{'b', 1, 1, disjoint}, {'b', 1, -1, cross}}},
                {inside_touch, {1, 0, 3, 0}, {0, 0, 4, 2}, {{'a', 3, 1, inside_touch}, {'b', 1, -1, inside}}},
                {inside, {1, 1, 3, 1}, {0, 0, 4, 2}},
                {cross, {-1, 1, 3, 1}, {0, 0, 4, 2}},
                {cross, {0, 1, 4, 1}, {2, 0, 2, 4}},
                {touch, {0, 0, 4, 0}, {2, 0, 2, 4}, {{'b', 1, 1, disjoint}, {'b', 1, -1, cross}}},
                {cross, {0, 0, 3, 0}, {1, 0, 4, 0}},
                {inside, {1, 0, 2, 0}, {0, 0, 3, 0}, {{'a', 3, 1, touch}}},
                {equal, {0, 2, 3, 2}, {0, 2, 3, 2}, {{'a', 3, 1, contains_touch}}}});
}

TEST(KnownRelation, AabbRect) {
  expect_cases(
      VESICA_AABB, VESICA_RECT,
      {{disjoint, {20, 20, 30, 30}, {0, 0, 3, 4, 2, 1}},
       {touch, {6, 8, 20, 20}, {0, 0, 3, 4, 2, 1}, {{'a', 0, 1, disjoint}, {'a', 0, -1, cross}, {'b', 4, 1, cross}}},
       {touch, {10, 0, 20, 20}, {0, 0, 3, 4, 2, 1}, {{'a', 0, 1, disjoint}, {'a', 0, -1, cross}}},
       {cross, {-20, -1, 20, 1}, {0, 0, 3, 4, 2, 1}},
       {inside, {-1, -1, 1, 1}, {0, 0, 3, 4, 2, 1}},
       {inside_touch,
        {4, 6, 6, 8},
        {0, 0, 3, 4, 2, 1},
        {{'a', 2, 1, cross}, {'a', 2, -1, inside}, {'b', 4, 1, inside}}},
       {contains, {-20, -20, 20, 20}, {0, 0, 3, 4, 2, 1}},
       {contains_touch, {-20, -20, 10, 20}, {0, 0, 3, 4, 2, 1}, {{'a', 2, 1, contains}, {'a', 2, -1, cross}}},
       {contains_touch, {-10, -11, 10, 11}, {0, 0, 3, 4, 2, 1}, {{'a', 2, 1, contains_touch}, {'b', 4, 1, cross}}},
       {equal, {-4, -2, 4, 2}, {0, 0, 1, 0, 4, 2}, {{'b', 4, 1, inside_touch}, {'b', 4, -1, contains_touch}}},
       {equal, {-4, -2, 4, 2}, {0, 0, 0, -2, 1, 2}, {{'b', 4, 1, inside_touch}, {'b', 4, -1, contains_touch}}},
       {equal, {-4, 1, 4, 1}, {0, 1, 2, 0, 2, 0}, {{'b', 5, 1, inside_touch}}}});
}

TEST(KnownRelation, RectRect) {
  expect_cases(
      VESICA_RECT, VESICA_RECT,
      {{disjoint, {0, 0, 3, 4, 2, 1}, {15, 20, 3, 4, 2, 1}},
       {touch, {0, 0, 3, 4, 2, 1}, {12, 16, 3, 4, 2, 1}, {{'b', 4, 1, cross}, {'b', 4, -1, disjoint}}},
       {touch, {0, 0, 3, 4, 2, 1}, {4, 22, 3, 4, 2, 1}, {{'b', 4, 1, touch}, {'b', 4, -1, disjoint}}},
       {touch, {0, 0, 3, 4, 2, 1}, {12, 9, 1, 0, 6, 1}, {{'a', 4, 1, cross}, {'a', 4, -1, disjoint}}},
       {cross, {0, 0, 3, 4, 2, 1}, {0, 0, 4, -3, 2, 1}},
       {cross, {0, 0, 3, 4, 2, 1}, {3, 4, 1, 0, 9, 1}},
       {inside, {0, 0, 3, 4, 2, 1}, {0, 0, 1, 0, 20, 20}},
       {inside_touch,
        {3, 4, 3, 4, 1, 1},
        {0, 0, 3, 4, 2, 2},
        {{'a', 4, 1, cross}, {'a', 4, -1, inside}, {'b', 4, 1, inside}}},
       {contains, {0, 0, 3, 4, 2, 1}, {0, 0, 1, 0, 1, 1}},
       {contains_touch, {0, 0, 3, 4, 2, 1}, {5, 7, 1, 0, 1, 1}, {{'b', 4, 1, cross}, {'b', 4, -1, contains}}},
       {equal, {0, 0, 3, 4, 2, 1}, {0, 0, -4, 3, 1, 2}, {{'a', 4, 1, contains_touch}, {'a', 4, -1, inside_touch}}},
       {equal, {1, 2, 3, 4, 2, 0}, {1, 2, 6, 8, 1, 0}, {{'a', 4, 1, contains}, {'a', 5, 1, contains_touch}}},
       {cross, {0, 0, 3, 4, 2, 0}, {3, 4, 3, 4, 2, 0}, {{'b', 0, 1, disjoint}}},
       {touch, {0, 0, 3, 4, 2, 0}, {12, 16, 3, 4, 2, 0}, {{'b', 4, 1, cross}, {'b', 4, -1, disjoint}}}});
}

}  // namespace
