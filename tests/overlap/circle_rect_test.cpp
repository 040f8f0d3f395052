// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using CircleRect = Pair<vesica_overlap_circle_rect_f64, vesica_overlap_circle_rect_f32>;

// Axis (3, 4), half extents 1 and 1: a square of half side 5; the face 3x + 4y = 25 has its middle at (3, 4).

TEST(OverlapCircleRect, RotatedFace) {
  CircleRect::touch({6, 8, 5}, {0, 0, 3, 4, 1, 1},
                    {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, rect::hx)});
  // From the face's point (1, 5.5), three quarters along; another centre.
  CircleRect::touch({11, 7.5, 5}, {7, -2, 3, 4, 1, 1},
                    {up(first, circle::cy), down(first, circle::r), down(second, rect::hx), down(second, rect::cy)});
}

// From the corner u + perp(u) = (-1, 7) by 3u + 4 perp(u) = (-7, 24), which is 25 long.
TEST(OverlapCircleRect, RotatedCorner) {
  CircleRect::touch({-8, 31, 25}, {0, 0, 3, 4, 1, 1},
                    {down(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, rect::hx),
                     down(second, rect::hy), down(second, rect::cy)});
}

// The corner 3u + 1.5 perp(u) = (0, 7.5) for u = (1, 2), and (-3, 4) from there; |u| is irrational.
TEST(OverlapCircleRect, AxisWithoutRationalLength) {
  CircleRect::touch({-3, 11.5, 5}, {0, 0, 1, 2, 3, 1.5},
                    {down(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, rect::hx),
                     down(second, rect::hy)});
}

TEST(OverlapCircleRect, AlignedFaceAndCorner) {
  CircleRect::touch({10, 2, 3}, {2, 1, 1, 0, 5, 3},
                    {up(first, circle::cx), down(first, circle::r), down(second, rect::hx)});
  CircleRect::touch({10, 8, 5}, {2, 1, 1, 0, 5, 3},
                    {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, rect::hx),
                     down(second, rect::hy)});
}

// The circle crosses the lines of two faces, but passes the corner.
TEST(OverlapCircleRect, PastTheCorner) {
  CircleRect::miss({10, 8, 4.5}, {2, 1, 1, 0, 5, 3},
                   {down(first, circle::cx), up(first, circle::r), up(second, rect::hx)});
}

TEST(OverlapCircleRect, OneInsideTheOther) {
  CircleRect::meet({1, 1, 1}, {0, 0, 3, 4, 1, 1}, {up(first, circle::cx), down(first, circle::r)});
  CircleRect::meet({0, 0, 5}, {0, 0, 3, 4, 1, 1}, {up(first, circle::cx), up(first, circle::r)});
  CircleRect::meet({1, 1, 100}, {0, 0, 3, 4, 1, 1}, {up(first, circle::cx), up(second, rect::ux)});
}

TEST(OverlapCircleRect, CircleWithoutSize) {
  CircleRect::touch({3, 4, 0}, {0, 0, 3, 4, 1, 1},
                    {up(first, circle::cx), up(first, circle::cy), down(second, rect::hx)});
  CircleRect::touch({-1, 7, 0}, {0, 0, 3, 4, 1, 1}, {down(second, rect::hx), down(second, rect::hy)});
  CircleRect::pinned({1, 2, 0}, {0, 0, 1, 2, 3, 0}, {up(first, circle::cx), up(first, circle::cy)});
  CircleRect::pinned({3, -2, 0}, {3, -2, 1, 2, 0, 0}, {up(first, circle::cx), up(first, circle::cy)});
}

TEST(OverlapCircleRect, RectWithoutSize) {
  // Beside the segment (-3, -4) - (3, 4), beyond its end, and a single point.
  CircleRect::touch({-4, 3, 5}, {0, 0, 3, 4, 1, 0},
                    {down(first, circle::cx), up(first, circle::cy), down(first, circle::r)});
  CircleRect::touch({8, 16, 13}, {0, 0, 3, 4, 1, 0},
                    {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, rect::hx)});
  CircleRect::touch({8, 16, 13}, {3, 4, 3, 4, 0, 0},
                    {up(first, circle::cx), up(first, circle::cy), down(first, circle::r)});
}

TEST(OverlapCircleRect, Needle) {
  CircleRect::touch({0x1p40 + 2, 0, 2}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                    {up(first, circle::cx), down(first, circle::r), down(second, rect::hx)});
  CircleRect::touch({5, 0x1p-19, 0x1p-20}, {0, 0, 1, 0, 0x1p20, 0x1p-20},
                    {up(first, circle::cy), down(first, circle::r), down(second, rect::hy)});
}

}  // namespace
