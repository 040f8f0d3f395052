// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using SegmentRect = Pair<vesica_overlap_segment_rect_f64, vesica_overlap_segment_rect_f32>;

// Axis (3, 4), half extents 2 and 1: corners (10, 5), (2, 11) and their opposites; the face 3x + 4y = 50.

TEST(OverlapSegmentRect, CollinearWithRotatedFace) {
  SegmentRect::touch({10, 5, 2, 11}, {0, 0, 3, 4, 2, 1}, {down(second, rect::hx), down(second, rect::cy)});
  SegmentRect::touch({18, -1, -6, 17}, {0, 0, 3, 4, 2, 1}, {down(second, rect::hx), down(second, rect::cx)});
  // From the corner outward on the face's line.
  SegmentRect::touch({2, 11, -6, 17}, {0, 0, 3, 4, 2, 1}, {down(second, rect::hx), down(second, rect::hy)});
  SegmentRect::miss({-2, 14, -6, 17}, {0, 0, 3, 4, 2, 1}, {up(first, segment::x0), up(second, rect::hy)});
}

TEST(OverlapSegmentRect, EndOnRotatedFace) {
  SegmentRect::touch({6, 8, 9, 12}, {0, 0, 3, 4, 2, 1},
                     {up(first, segment::x0), up(first, segment::y0), down(second, rect::hx)});
  SegmentRect::touch({4, 9.5, 4, 20}, {0, 0, 3, 4, 2, 1},
                     {up(first, segment::x0), up(first, segment::y0), down(second, rect::hx)});
}

// u + perp(u) = (-1, 7) is normal to (7, 1): (2, 11) -+ (7, 1) touches the corner and nothing else.
TEST(OverlapSegmentRect, ThroughRotatedCorner) {
  SegmentRect::touch({-5, 10, 9, 12}, {0, 0, 3, 4, 2, 1},
                     {up(first, segment::y0), up(first, segment::y1), down(first, segment::x0), down(second, rect::hx),
                      down(second, rect::hy), down(second, rect::cy)});
}

// The corner 3u + 1.5 perp(u) = (0, 7.5) of a rectangle whose axis (1, 2) has no rational length.
TEST(OverlapSegmentRect, AxisWithoutRationalLength) {
  SegmentRect::touch({-4, 7.5, 4, 7.5}, {0, 0, 1, 2, 3, 1.5},
                     {down(second, rect::hx), down(second, rect::hy), up(first, segment::y0), up(first, segment::y1)});
  SegmentRect::touch({0, 7.5, 6, 4.5}, {0, 0, 1, 2, 3, 1.5}, {down(second, rect::hx)});
}

TEST(OverlapSegmentRect, RectWithoutHeight) {
  // A cross-bar at the end (6, 8), and one in the middle that ends on it.
  SegmentRect::touch({10, 5, 2, 11}, {0, 0, 3, 4, 2, 0}, {down(second, rect::hx)});
  SegmentRect::touch({3, 4, -5, 10}, {0, 0, 3, 4, 2, 0}, {down(first, segment::x0), up(first, segment::y0)});
  // Collinear, end on end.
  SegmentRect::touch({6, 8, 9, 12}, {0, 0, 3, 4, 2, 0}, {down(second, rect::hx)});
  SegmentRect::miss({9, 12, 12, 16}, {0, 0, 3, 4, 2, 0}, {down(first, segment::x0), up(second, rect::hx)});
}

TEST(OverlapSegmentRect, RectWithoutSize) {
  SegmentRect::pinned({0, 0, 4, 2}, {2, 1, 3, 4, 0, 0},
                      {up(first, segment::y0), up(first, segment::x1), up(second, rect::cx), up(second, rect::cy)});
  SegmentRect::miss({0, 0, 4, 2}, {6, 3, 3, 4, 0, 0}, {up(second, rect::cx)});
}

TEST(OverlapSegmentRect, SegmentWithoutLength) {
  SegmentRect::touch({2, 11, 2, 11}, {0, 0, 3, 4, 2, 1}, {down(second, rect::hx), down(second, rect::hy)});
  SegmentRect::pinned({1, 2, 1, 2}, {0, 0, 1, 2, 3, 0}, {up(second, rect::cx), up(second, rect::cy)});
  SegmentRect::pinned({3, -2, 3, -2}, {3, -2, 1, 2, 0, 0}, {up(second, rect::cx)});
}

TEST(OverlapSegmentRect, Needle) {
  SegmentRect::touch({-5, 0x1p-40, 5, 0x1p-40}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                     {down(second, rect::hy), down(second, rect::cy)});
  SegmentRect::touch({0x1p40, -1, 0x1p40, 1}, {0, 0, 1, 0, 0x1p40, 0x1p-40}, {down(second, rect::hx)});
}

TEST(OverlapSegmentRect, ThroughAndInside) {
  SegmentRect::meet({-20, 0, 20, 1}, {0, 0, 3, 4, 2, 1}, {up(first, segment::x0), down(second, rect::hx)});
  SegmentRect::meet({0, 1, 1, 1}, {0, 0, 3, 4, 2, 1}, {up(first, segment::x0), down(second, rect::hx)});
}

}  // namespace
