// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using PointRect = Pair<vesica_overlap_point_rect_f64, vesica_overlap_point_rect_f32>;

// Axis (3, 4), half extents 2 and 1: the face is 3x + 4y = 50, from (10, 5) to (2, 11). (4, 9.5) lies a quarter along.
TEST(OverlapPointRect, RotatedFace) {
  PointRect::touch({4, 9.5}, {0, 0, 3, 4, 2, 1}, {up(first, point::x), up(first, point::y), down(second, rect::hx)});
  PointRect::touch({6, 8}, {0, 0, 3, 4, 2, 1}, {up(first, point::x), up(first, point::y), down(second, rect::hx)});
  // The far face, perp(u) . X = -25, and another centre.
  PointRect::touch({14, -23}, {10, -20, 3, 4, 2, 1},
                   {up(first, point::x), down(first, point::y), down(second, rect::hy)});
}

// 2u + perp(u) = (2, 11): to the right it leaves by one face, to the left by the other.
TEST(OverlapPointRect, RotatedCorner) {
  PointRect::touch({2, 11}, {0, 0, 3, 4, 2, 1},
                   {up(first, point::y), down(second, rect::hx), down(second, rect::hy), down(second, rect::cy)});
  PointRect::pinned({2, 11}, {0, 0, 3, 4, 2, 1}, {up(first, point::x), up(second, rect::cx)});
}

// |u| is irrational: 3u + 1.5 perp(u) = (0, 7.5) for u = (1, 2).
TEST(OverlapPointRect, AxisWithoutRationalLength) {
  PointRect::touch({0, 7.5}, {0, 0, 1, 2, 3, 1.5},
                   {up(first, point::y), down(second, rect::hx), down(second, rect::hy)});
  PointRect::touch({1, 7}, {0, 0, 1, 2, 3, 1.5}, {up(first, point::x), up(first, point::y), down(second, rect::hx)});
}

TEST(OverlapPointRect, AlignedFace) {
  PointRect::touch({7, 1}, {2, 1, 1, 0, 5, 3}, {up(first, point::x), down(second, rect::hx), down(second, rect::cx)});
  PointRect::touch({7, 4}, {2, 1, 1, 0, 5, 3}, {up(first, point::y), down(second, rect::hx), down(second, rect::hy)});
}

// Half height 0 is a segment: only its own points meet it.
TEST(OverlapPointRect, RectWithoutHeight) {
  PointRect::pinned({3, 6}, {0, 0, 1, 2, 3, 0}, {up(first, point::x), up(first, point::y), up(second, rect::cx)});
  PointRect::touch({3, 6}, {0, 0, 1, 2, 3, 0}, {down(second, rect::hx)});
  PointRect::pinned({1, 2}, {0, 0, 1, 2, 3, 0}, {up(first, point::x), up(first, point::y), up(second, rect::cy)});
  PointRect::pinned({-2, 1}, {0, 0, 1, 2, 0, 3}, {up(first, point::x), up(first, point::y)});
}

TEST(OverlapPointRect, RectWithoutSize) {
  PointRect::pinned({3, -2}, {3, -2, 1, 2, 0, 0}, {up(first, point::x), up(first, point::y), up(second, rect::cx)});
  PointRect::miss({3, -2}, {-2, 3, 1, 2, 0, 0}, {up(first, point::x)});
}

TEST(OverlapPointRect, Needle) {
  PointRect::touch({0x3p40, 0x4p40}, {0, 0, 3, 4, 0x1p40, 0}, {down(second, rect::hx)});
  PointRect::touch({0x1p40, 0x1p-40}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                   {up(first, point::x), up(first, point::y), down(second, rect::hx), down(second, rect::hy)});
}

TEST(OverlapPointRect, Solid) {
  PointRect::meet({1, 2}, {0, 0, 3, 4, 2, 1}, {up(first, point::x), down(second, rect::hx), up(second, rect::ux)});
  // In the bounding box of the rectangle, not in it.
  PointRect::miss({9, 9}, {0, 0, 3, 4, 2, 1}, {down(first, point::x), up(second, rect::hx)});
}

}  // namespace
