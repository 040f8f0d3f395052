// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using AabbRect = Pair<vesica_overlap_aabb_rect_f64, vesica_overlap_aabb_rect_f32>;

// Axis (3, 4), half extents 2 and 1: corners (10, 5), (2, 11) and their opposites; the face 3x + 4y = 50.

TEST(OverlapAabbRect, CornerOnRotatedFace) {
  AabbRect::touch({6, 8, 9, 9}, {0, 0, 3, 4, 2, 1},
                  {up(first, aabb::min_x), up(first, aabb::min_y), down(second, rect::hx), down(second, rect::cx)});
  AabbRect::touch({4, 9.5, 9, 12}, {0, 0, 3, 4, 2, 1},
                  {up(first, aabb::min_x), up(first, aabb::min_y), down(second, rect::hx)});
}

TEST(OverlapAabbRect, RotatedCornerOnEdge) {
  AabbRect::touch({10, 0, 20, 7}, {0, 0, 3, 4, 2, 1},
                  {up(first, aabb::min_x), down(second, rect::hx), down(second, rect::hy), down(second, rect::cx)});
  AabbRect::touch({-4, 11, 9, 12}, {0, 0, 3, 4, 2, 1},
                  {up(first, aabb::min_y), down(second, rect::hx), down(second, rect::hy), down(second, rect::cy)});
  // The corner 3u + 1.5 perp(u) = (0, 7.5) for u = (1, 2).
  AabbRect::touch({-1, 7.5, 1, 9}, {0, 0, 1, 2, 3, 1.5},
                  {up(first, aabb::min_y), down(second, rect::hx), down(second, rect::hy)});
}

TEST(OverlapAabbRect, CornerOnRotatedCorner) {
  AabbRect::touch({10, 5, 12, 7}, {0, 0, 3, 4, 2, 1},
                  {up(first, aabb::min_x), up(first, aabb::min_y), down(second, rect::hx)});
  AabbRect::touch({10, 1, 12, 5}, {0, 0, 3, 4, 2, 1}, {up(first, aabb::min_x), down(second, rect::hy)});
}

// A square on its corner: (2, 0) is a corner, (1, 1) the middle of a face.
TEST(OverlapAabbRect, Diamond) {
  AabbRect::touch({2, -1, 3, 1}, {0, 0, 1, 1, 1, 1},
                  {up(first, aabb::min_x), down(second, rect::hx), down(second, rect::hy)});
  AabbRect::touch({1, 1, 3, 3}, {0, 0, 1, 1, 1, 1},
                  {up(first, aabb::min_x), up(first, aabb::min_y), down(second, rect::hx)});
  AabbRect::miss({1.5, 1.5, 2, 2}, {0, 0, 1, 1, 1, 1}, {down(first, aabb::min_x), up(second, rect::hx)});
}

// Axes along the coordinates, of other lengths and signs than (1, 0).
TEST(OverlapAabbRect, AlignedEdgesAndCorners) {
  AabbRect::touch({0, 0, 4, 2}, {7, 1, 1, 0, 3, 1},
                  {down(first, aabb::max_x), down(second, rect::hx), up(second, rect::cx)});
  AabbRect::touch({0, 0, 4, 2}, {7, 1, 0, -3, 2, 1},
                  {down(first, aabb::max_x), down(second, rect::hy), up(second, rect::cx)});
  AabbRect::touch({0, 0, 4, 2}, {7, 4, -1, 0, 3, 2},
                  {down(first, aabb::max_x), down(first, aabb::max_y), down(second, rect::hx), down(second, rect::hy),
                   up(second, rect::cx), up(second, rect::cy)});
}

TEST(OverlapAabbRect, BoxWithoutSize) {
  AabbRect::touch({6, 8, 6, 8}, {0, 0, 3, 4, 2, 1}, {down(second, rect::hx), down(second, rect::cx)});
  AabbRect::touch({-5, 11, 3, 11}, {0, 0, 3, 4, 2, 1}, {down(second, rect::hx), down(second, rect::hy)});
  AabbRect::meet({-5, 9, 3, 9}, {0, 0, 3, 4, 2, 1}, {up(first, aabb::min_x), down(second, rect::hx)});
}

TEST(OverlapAabbRect, RectWithoutSize) {
  // The segment (-6, -8) - (6, 8): its end on an edge, its middle on a corner's side, and a single point.
  AabbRect::touch({0, 8, 9, 9}, {0, 0, 3, 4, 2, 0}, {up(first, aabb::min_y), down(second, rect::hx)});
  AabbRect::touch({3, 0, 9, 4}, {0, 0, 3, 4, 2, 0},
                  {up(first, aabb::min_x), down(first, aabb::max_y), down(second, rect::cx)});
  AabbRect::touch({3, 0, 9, 4}, {3, 4, 3, 4, 0, 0}, {up(first, aabb::min_x), down(first, aabb::max_y)});
  AabbRect::pinned({3, 4, 3, 4}, {0, 0, 3, 4, 2, 0}, {up(second, rect::cx), up(second, rect::cy)});
  AabbRect::pinned({3, 4, 3, 4}, {3, 4, 3, 4, 0, 0}, {up(second, rect::cx), up(second, rect::cy)});
}

TEST(OverlapAabbRect, Needle) {
  AabbRect::touch({0x1p40, -1, 0x1p41, 1}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                  {up(first, aabb::min_x), down(second, rect::hx)});
  AabbRect::touch({-1, 0x1p-40, 1, 1}, {0, 0, 1, 0, 0x1p40, 0x1p-40}, {up(first, aabb::min_y), down(second, rect::hy)});
}

TEST(OverlapAabbRect, OneInsideTheOther) {
  AabbRect::meet({-1, -1, 1, 1}, {0, 0, 3, 4, 2, 1}, {up(first, aabb::min_x), down(second, rect::hx)});
  AabbRect::meet({-99, -99, 99, 99}, {0, 0, 3, 4, 2, 1}, {up(first, aabb::min_x), down(second, rect::hx)});
  // In the box round the rectangle, not in it.
  AabbRect::miss({8, 9, 9, 10}, {0, 0, 3, 4, 2, 1}, {down(first, aabb::min_x), up(second, rect::hx)});
}

}  // namespace
