// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using AabbEllipse = Pair<vesica_overlap_aabb_ellipse_f64, vesica_overlap_aabb_ellipse_f32>;

// (3/5)^2 + (4/5)^2 = 1, and the normal there points into the box's quadrant.
TEST(OverlapAabbEllipse, CornerOnRationalOutlinePoint) {
  AabbEllipse::touch({3, 8, 9, 9}, {0, 0, 1, 0, 5, 10},
                     {up(first, aabb::min_x), up(first, aabb::min_y), down(second, ellipse::a),
                      down(second, ellipse::b), down(second, ellipse::cx), down(second, ellipse::cy)});
  // 3v + 8 perp(v) = (-2, 19) for v = (2, 1); the normal is (4, 7).
  AabbEllipse::touch(
      {-2, 19, 5, 30}, {0, 0, 2, 1, 5, 10},
      {up(first, aabb::min_x), up(first, aabb::min_y), down(second, ellipse::a), down(second, ellipse::b)});
  AabbEllipse::touch(
      {-20, -30, -3, -8}, {0, 0, -1, 0, 5, 10},
      {down(first, aabb::max_x), down(first, aabb::max_y), down(second, ellipse::a), down(second, ellipse::b)});
}

// v = (4, 3), half lengths 2 and 5: to the right it reaches sqrt((2 4)^2 + (5 3)^2) = 17, at y = -252 / 17.
TEST(OverlapAabbEllipse, EdgeOnRotatedExtreme) {
  AabbEllipse::touch(
      {17, -20, 30, 0}, {0, 0, 4, 3, 2, 5},
      {up(first, aabb::min_x), down(second, ellipse::a), down(second, ellipse::b), down(second, ellipse::cx)});
  AabbEllipse::touch(
      {0, 17, 20, 18}, {0, 0, -3, 4, 2, 5},
      {up(first, aabb::min_y), down(second, ellipse::a), down(second, ellipse::b), down(second, ellipse::cy)});
  // The extreme point lies outside this edge.
  AabbEllipse::miss({17, -12, 30, 0}, {0, 0, 4, 3, 2, 5}, {down(first, aabb::min_x), up(second, ellipse::a)});
}

TEST(OverlapAabbEllipse, EdgeOnVertex) {
  AabbEllipse::touch({5, -1, 8, 1}, {0, 0, 1, 0, 5, 10}, {up(first, aabb::min_x), down(second, ellipse::a)});
  // At the very corner of the box: up by 2^-1074 the vertex is past it.
  AabbEllipse::touch({5, 0, 8, 1}, {0, 0, 1, 0, 5, 10},
                     {up(first, aabb::min_x), up(first, aabb::min_y), down(second, ellipse::a)});
}

TEST(OverlapAabbEllipse, InternalTangency) {
  AabbEllipse::meet({-5, -10, 5, 10}, {0, 0, 1, 0, 5, 10}, {up(second, ellipse::a), down(first, aabb::max_x)});
  AabbEllipse::meet({-3, -8, 3, 8}, {0, 0, 1, 0, 5, 10}, {down(second, ellipse::a), up(first, aabb::max_x)});
  AabbEllipse::meet({-3, -4, 3, 4}, {0, 0, 3, 4, 1, 1}, {down(second, ellipse::b), up(first, aabb::max_y)});
}

TEST(OverlapAabbEllipse, OneInsideTheOther) {
  AabbEllipse::meet({-1, -1, 1, 1}, {0, 0, 2, 1, 5, 10}, {up(first, aabb::min_x), down(second, ellipse::a)});
  AabbEllipse::meet({-99, -99, 99, 99}, {0, 0, 2, 1, 5, 10}, {up(first, aabb::min_x), up(second, ellipse::uy)});
  // In the box round the ellipse, not in it.
  AabbEllipse::miss({4, 8, 5, 10}, {0, 0, 1, 0, 5, 10}, {down(first, aabb::min_x), up(second, ellipse::b)});
}

TEST(OverlapAabbEllipse, BoxWithoutSize) {
  AabbEllipse::touch({3, 8, 3, 8}, {0, 0, 1, 0, 5, 10}, {down(second, ellipse::a), down(second, ellipse::cx)});
  AabbEllipse::pinned({5, 0, 5, 0}, {0, 0, 1, 0, 5, 10}, {up(second, ellipse::cy)});
  AabbEllipse::touch({17, -20, 17, 0}, {0, 0, 4, 3, 2, 5}, {down(second, ellipse::a), down(second, ellipse::b)});
  AabbEllipse::meet({-99, 1, 99, 1}, {0, 0, 4, 3, 2, 5}, {down(second, ellipse::a), up(first, aabb::min_x)});
}

TEST(OverlapAabbEllipse, EllipseWithoutSize) {
  // The segment (-6, -8) - (6, 8): its end on an edge, its inside on a corner; and a single point.
  AabbEllipse::touch({0, 8, 9, 9}, {0, 0, 3, 4, 2, 0}, {up(first, aabb::min_y), down(second, ellipse::a)});
  AabbEllipse::touch({3, 0, 9, 4}, {0, 0, 4, -3, 0, 2},
                     {up(first, aabb::min_x), down(first, aabb::max_y), down(second, ellipse::cx)});
  AabbEllipse::touch({3, 0, 9, 4}, {3, 4, 3, 4, 0, 0}, {up(first, aabb::min_x), down(first, aabb::max_y)});
  AabbEllipse::pinned({3, 4, 3, 4}, {0, 0, 3, 4, 2, 0}, {up(second, ellipse::cx), up(second, ellipse::cy)});
  AabbEllipse::pinned({3, 4, 3, 4}, {3, 4, 3, 4, 0, 0}, {up(second, ellipse::cx), up(second, ellipse::cy)});
}

TEST(OverlapAabbEllipse, Needle) {
  AabbEllipse::touch({0x1p40, -1, 0x1p41, 1}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                     {up(first, aabb::min_x), down(second, ellipse::a)});
  AabbEllipse::touch({-1, 0x1p-40, 1, 1}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                     {up(first, aabb::min_y), down(second, ellipse::b)});
  AabbEllipse::touch(
      {0x3p40, 0x1p-38, 0x9p40, 1}, {0, 0, 1, 0, 0x5p40, 0x5p-40},
      {up(first, aabb::min_x), up(first, aabb::min_y), down(second, ellipse::a), down(second, ellipse::b)});
}

}  // namespace
