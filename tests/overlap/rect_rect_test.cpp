// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using RectRect = Pair<vesica_overlap_rect_rect_f64, vesica_overlap_rect_rect_f32>;

// Axis (3, 4), half extents 2 and 1: corners (10, 5), (2, 11) and their opposites; the face 3x + 4y = 50.

// Axis (1, 2), half extents 1: along (3, 4) it reaches |11| + |2| = 13, at its corner (-3, -1) from the centre.
TEST(OverlapRectRect, CornerOnFace) {
  RectRect::touch({0, 0, 3, 4, 2, 1}, {9, 9, 1, 2, 1, 1},
                  {down(first, rect::hx), down(second, rect::hx), down(second, rect::hy), up(second, rect::cx),
                   up(second, rect::cy), down(first, rect::cx)});
  RectRect::touch({0, 0, 3, 4, 2, 1}, {7, 10.5, 1, 2, 1, 1},
                  {down(first, rect::hx), down(second, rect::hx), down(second, rect::hy)});
  // Corner (2, 11) on a level face.
  RectRect::touch({0, 0, 3, 4, 2, 1}, {0, 14, 1, 0, 9, 3},
                  {down(first, rect::hx), down(first, rect::hy), down(second, rect::hy), up(second, rect::cy)});
}

TEST(OverlapRectRect, CornerOnCorner) {
  RectRect::touch({0, 0, 3, 4, 2, 1}, {5, 12, 1, 2, 1, 1},
                  {down(first, rect::hx), down(second, rect::hx), down(second, rect::hy)});
  // Parallel axes: the second's corner -3w - 2 perp(w) on (2, 11).
  RectRect::touch({0, 0, 3, 4, 2, 1}, {3, 29, 3, 4, 3, 2},
                  {down(first, rect::hx), down(first, rect::hy), down(second, rect::hx), down(second, rect::hy),
                   up(second, rect::cy)});
}

// The second lies along the face, by a whole edge, by part of one, and from the corner on; also with its axis turned.
TEST(OverlapRectRect, EdgeOnEdge) {
  RectRect::touch({0, 0, 3, 4, 2, 1}, {9, 12, 3, 4, 1, 1},
                  {down(first, rect::hx), down(second, rect::hx), up(second, rect::cx)});
  RectRect::touch({0, 0, 3, 4, 2, 1}, {5, 15, 3, 4, 1, 1},
                  {down(first, rect::hx), down(second, rect::hx), up(second, rect::cy)});
  RectRect::touch({0, 0, 3, 4, 2, 1}, {9, 12, -8, 6, 1, 0.5}, {down(first, rect::hx), down(second, rect::hy)});
  RectRect::touch({2, 1, 1, 0, 5, 3}, {12, 4, 1, 0, 5, 2},
                  {down(first, rect::hx), down(second, rect::hx), up(second, rect::cx)});
  RectRect::touch({0.5, 0.5, 1, 0, 0.5, 0.5}, {1.5, 0.5, 0, -1, 0.5, 0.5},
                  {down(first, rect::hx), down(second, rect::hy), up(second, rect::cx)});
}

TEST(OverlapRectRect, GridCornerOnCorner) {
  RectRect::touch({2, 1, 1, 0, 5, 3}, {12, 6, 1, 0, 5, 2},
                  {down(first, rect::hx), down(first, rect::hy), down(second, rect::hx), down(second, rect::hy),
                   up(second, rect::cx), up(second, rect::cy)});
  // Squares on their corners, (2, 0) to (2, 0).
  RectRect::touch({0, 0, 1, 1, 1, 1}, {5, 0, 3, -3, 0.5, 0.5},
                  {down(first, rect::hx), down(first, rect::hy), down(second, rect::hx), down(second, rect::hy),
                   up(second, rect::cx)});
}

TEST(OverlapRectRect, EqualUnderOtherAxes) {
  RectRect::meet({1, 2, 3, 4, 5, 6}, {1, 2, 0x3p40, 0x4p40, 0x5p-40, 0x6p-40},
                 {up(first, rect::hx), up(second, rect::cx)});
  RectRect::meet({1, 2, 3, 4, 5, 6}, {1, 2, -0x4p-40, 0x3p-40, 0x6p40, 0x5p40},
                 {up(first, rect::hx), up(second, rect::cx)});
}

TEST(OverlapRectRect, Solid) {
  RectRect::meet({0, 0, 3, 4, 9, 9}, {1, 1, 1, 2, 1, 1}, {up(first, rect::hx), up(second, rect::ux)});
  // A cross: no corner of either lies in the other.
  RectRect::meet({0, 0, 3, 4, 9, 1}, {1, 1, -4, 3, 9, 1}, {up(first, rect::hx), up(second, rect::ux)});
}

// No axis of the first separates them, one of the second does; and the other way round.
TEST(OverlapRectRect, SeparatedByOneAxisOnly) {
  RectRect::miss({3, 3, 1, 0, 1, 1}, {0, 0, 1, 1, 1.5, 3}, {up(first, rect::hx), up(second, rect::hx)});
  RectRect::miss({0, 0, 1, 1, 1.5, 3}, {3, 3, 1, 0, 1, 1}, {up(first, rect::hx), up(second, rect::hx)});
  RectRect::miss({0, 0, 3, 4, 2, 1}, {9, 9.5, 1, 2, 1, 1}, {up(first, rect::hx), up(second, rect::hx)});
}

TEST(OverlapRectRect, OneWithoutHeight) {
  // The segment (-6, -8) - (6, 8): its end on a face, its inside on a corner, in line with another one.
  RectRect::touch({0, 0, 3, 4, 2, 0}, {6, 11, 1, 0, 9, 3},
                  {down(first, rect::hx), down(second, rect::hy), up(second, rect::cy)});
  RectRect::touch({0, 0, 3, 4, 2, 0}, {6, 3, 1, 0, 3, 1},
                  {down(second, rect::hx), down(second, rect::hy), up(second, rect::cx)});
  RectRect::touch({0, 0, 3, 4, 2, 0}, {15, 20, 3, 4, 3, 0}, {down(first, rect::hx), down(second, rect::hx)});
  RectRect::meet({0, 0, 3, 4, 2, 0}, {0, 0, 4, -3, 2, 0}, {up(first, rect::hx), up(second, rect::cx)});
  RectRect::miss({0, 0, 3, 4, 2, 0}, {18, 24, 3, 4, 3, 0}, {up(first, rect::hx), up(second, rect::hx)});
  RectRect::miss({0, 0, 3, 4, 2, 0}, {-4, 3, 3, 4, 2, 0}, {up(first, rect::hx), up(second, rect::hx)});
}

TEST(OverlapRectRect, WithoutSize) {
  RectRect::touch({3, 4, 1, 2, 0, 0}, {0, 0, 3, 4, 1, 1}, {down(second, rect::hx), up(first, rect::cx)});
  RectRect::pinned({3, 4, 1, 2, 0, 0}, {0, 0, 3, 4, 2, 0}, {up(first, rect::cx), up(second, rect::cy)});
  RectRect::pinned({3, 4, 1, 2, 0, 0}, {3, 4, -2, 5, 0, 0}, {up(first, rect::cx), up(second, rect::cy)});
  RectRect::miss({3, 4, 1, 2, 0, 0}, {4, 3, 1, 2, 0, 0}, {up(first, rect::cx)});
}

TEST(OverlapRectRect, Needles) {
  RectRect::touch({0, 0, 1, 0, 0x1p40, 0x1p-40}, {0x1p41, 0, 1, 0, 0x1p40, 0x1p-40},
                  {down(first, rect::hx), down(second, rect::hx), up(second, rect::cx)});
  RectRect::touch({0, 0, 1, 0, 0x1p40, 0x1p-40}, {0, 0x1p-39, 1, 0, 0x1p40, 0x1p-40},
                  {down(first, rect::hy), down(second, rect::hy), up(second, rect::cy)});
  // The tip of an upright one on the side of a level one.
  RectRect::touch({0, 0, 1, 0, 0x1p20, 0x1p-20}, {0, 0x1p20 + 0x1p-20, 0, 1, 0x1p20, 0x1p-20},
                  {down(first, rect::hy), down(second, rect::hx), up(second, rect::cy)});
}

}  // namespace
