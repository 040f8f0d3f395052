// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using RectEllipse = Pair<vesica_overlap_rect_ellipse_f64, vesica_overlap_rect_ellipse_f32>;

// Along u = (2, 1), u.u = 5, the ellipse with v = (1, 2), half lengths 2 and 5, reaches to
// sqrt((2 u.v)^2 + (5 u x v)^2) = sqrt(8^2 + 15^2) = 17, and u.(9, 4) = 22 = 5 hx + 17; the foot is inside the face.
// Along perp(u) half lengths 5 and 2 do the same: sqrt((5 3)^2 + (2 4)^2) = 17.
TEST(OverlapRectEllipse, RotatedFaceTangent) {
  RectEllipse::touch({0, 0, 2, 1, 1, 3}, {9, 4, 1, 2, 2, 5},
                     {down(first, rect::hx), down(second, ellipse::a), down(second, ellipse::b),
                      up(second, ellipse::cx), up(second, ellipse::cy), down(first, rect::cx)});
  RectEllipse::touch({0, 0, 2, 1, 9, 1}, {-4, 9, 1, 2, 5, 2},
                     {down(first, rect::hy), down(second, ellipse::a), down(second, ellipse::b),
                      down(second, ellipse::cx), up(second, ellipse::cy)});
}

TEST(OverlapRectEllipse, AlignedFaceTangent) {
  // To the left v = (4, 3) with 2 and 5 reaches 17.
  RectEllipse::touch(
      {0, 0, 1, 0, 3, 99}, {20, 7, 4, 3, 2, 5},
      {down(first, rect::hx), down(second, ellipse::a), down(second, ellipse::b), up(second, ellipse::cx)});
  RectEllipse::touch({0, 0, 1, 0, 4, 2}, {9, 1, 1, 0, 5, 10},
                     {down(first, rect::hx), down(second, ellipse::a), up(second, ellipse::cx)});
  // The foot lies past the end of the face, and past the corner's reach.
  RectEllipse::miss({0, 0, 1, 0, 3, 5}, {20, 0, 4, 3, 2, 5}, {up(first, rect::hx), up(second, ellipse::a)});
}

// The corner is the ellipse's point at 3/5 and 4/5 of its half lengths.
TEST(OverlapRectEllipse, CornerOnRationalOutlinePoint) {
  RectEllipse::touch({0, 0, 2, 1, 1, 2}, {3, 13, 1, 0, 5, 10},
                     {down(first, rect::hx), down(first, rect::hy), down(second, ellipse::a), down(second, ellipse::b),
                      up(second, ellipse::cx), up(second, ellipse::cy)});
  // The corner (2, 11) of axis (3, 4), half extents 2 and 1, and the point -(3v + 8 perp(v)) = (2, -19) of v = (2, 1).
  RectEllipse::touch({0, 0, 3, 4, 2, 1}, {0, 30, 2, 1, 5, 10},
                     {down(first, rect::hx), down(first, rect::hy), down(second, ellipse::a), down(second, ellipse::b),
                      up(second, ellipse::cx), up(second, ellipse::cy)});
}

TEST(OverlapRectEllipse, VertexOnCorner) {
  RectEllipse::touch({0, 0, 1, 0, 4, 2}, {9, 2, 1, 0, 5, 10},
                     {down(first, rect::hx), down(first, rect::hy), down(second, ellipse::a), up(second, ellipse::cx),
                      up(second, ellipse::cy)});
  RectEllipse::touch({0, 0, 3, 4, 2, 1}, {14, 27, 3, 4, 4, 7},
                     {down(first, rect::hx), down(first, rect::hy), down(second, ellipse::a)});
}

// Growing the rectangle by the ellipse and rounding the corner in the centre's quadrant calls these overlapping: for
// a small rectangle and a long skewed ellipse another corner's arc applies.
TEST(OverlapRectEllipse, SkewedEllipsePastASmallRect) {
  RectEllipse::miss({0, 0, 1, 0, 4.25, 14.875}, {-21.25, -6.375, 8, 15, 3, 0.125},
                    {up(first, rect::hx), up(second, ellipse::a)});
  RectEllipse::miss({0, 0, 1, 0, 1, 1}, {2, 9, 1, 1, 14, 0.75}, {up(first, rect::hx), up(second, ellipse::a)});
}

TEST(OverlapRectEllipse, InternalTangency) {
  RectEllipse::meet({0, 0, 3, 4, 5, 10}, {0, 0, 3, 4, 5, 10}, {up(second, ellipse::a), down(first, rect::hx)});
  RectEllipse::meet({0, 0, 3, 4, 3, 8}, {0, 0, 3, 4, 5, 10}, {down(second, ellipse::a), up(first, rect::hx)});
}

TEST(OverlapRectEllipse, OneInsideTheOther) {
  RectEllipse::meet({1, 1, 3, 4, 1, 1}, {0, 0, 2, 1, 50, 90}, {up(first, rect::hx), up(second, ellipse::ux)});
  RectEllipse::meet({0, 0, 3, 4, 50, 90}, {1, 1, 2, 1, 5, 10}, {up(first, rect::ux), up(second, ellipse::a)});
  // A cross: no vertex of either in the other.
  RectEllipse::meet({0, 0, 3, 4, 50, 1}, {0, 0, 3, 4, 1, 50}, {up(first, rect::hx), up(second, ellipse::a)});
}

TEST(OverlapRectEllipse, RectWithoutSize) {
  RectEllipse::touch({-2, 19, -7, 4, 3, 0}, {0, 0, 2, 1, 5, 10},
                     {up(first, rect::cx), down(second, ellipse::a), down(second, ellipse::b)});
  RectEllipse::touch({4, 31, 3, 6, 2, 0}, {0, 0, 2, 1, 5, 10}, {down(first, rect::hx), down(second, ellipse::a)});
  RectEllipse::touch({-2, 19, 5, 7, 0, 0}, {0, 0, 2, 1, 5, 10},
                     {up(first, rect::cx), up(first, rect::cy), down(second, ellipse::a), down(second, ellipse::b)});
  RectEllipse::pinned({5, 0, 5, 7, 0, 0}, {0, 0, 1, 0, 5, 10}, {up(first, rect::cy)});
}

TEST(OverlapRectEllipse, EllipseWithoutSize) {
  // The segment (-6, -8) - (6, 8): its end on a face, its inside on a corner, and along a face.
  RectEllipse::touch({6, 11, 1, 0, 9, 3}, {0, 0, 3, 4, 2, 0},
                     {down(first, rect::hy), down(second, ellipse::a), up(first, rect::cy)});
  RectEllipse::touch({6, 3, 1, 0, 3, 1}, {0, 0, -4, 3, 0, 2},
                     {down(first, rect::hx), down(first, rect::hy), up(first, rect::cx)});
  RectEllipse::touch({4, -3, 3, 4, 1, 1}, {0, 0, 3, 4, 2, 0}, {down(first, rect::hy), down(second, ellipse::cx)});
  RectEllipse::touch({3, 4, 1, 2, 3, 1.5}, {3, 11.5, 1, 2, 0, 0},
                     {down(first, rect::hx), down(first, rect::hy), up(second, ellipse::cy)});
  RectEllipse::miss({18, 24, 3, 4, 3, 1}, {0, 0, 3, 4, 2, 0}, {up(first, rect::hx), up(second, ellipse::a)});
}

// Both are segments or points.
TEST(OverlapRectEllipse, BothWithoutSize) {
  RectEllipse::touch({15, 20, 3, 4, 3, 0}, {0, 0, 3, 4, 2, 0}, {down(first, rect::hx), down(second, ellipse::a)});
  RectEllipse::pinned({3, 4, 1, 2, 0, 0}, {0, 0, 3, 4, 2, 0}, {up(first, rect::cx), up(second, ellipse::cy)});
  RectEllipse::pinned({3, 4, 1, 2, 0, 0}, {3, 4, -2, 5, 0, 0}, {up(first, rect::cx), up(second, ellipse::cy)});
  RectEllipse::meet({0, 0, 3, 4, 2, 0}, {0, 0, 4, -3, 2, 0}, {up(first, rect::hx), up(second, ellipse::cx)});
}

TEST(OverlapRectEllipse, Needles) {
  RectEllipse::touch({0, 0, 1, 0, 0x1p40, 0x1p-40}, {0x1p41, 0, 1, 0, 0x1p40, 0x1p-40},
                     {down(first, rect::hx), down(second, ellipse::a), up(second, ellipse::cx)});
  RectEllipse::touch({0, 0, 1, 0, 0x1p40, 0x1p-40}, {0, 0x1p-39, 1, 0, 0x1p40, 0x1p-40},
                     {down(first, rect::hy), down(second, ellipse::b), up(second, ellipse::cy)});
  RectEllipse::touch({0, 0, 1, 0, 0x1p20, 0x1p-20}, {0, 0x1p20 + 0x1p-20, 0, 1, 0x1p20, 0x1p-20},
                     {down(first, rect::hy), down(second, ellipse::a), up(second, ellipse::cy)});
  // Corner (2^40, 2^-40) on the point at 3/5 and 4/5 of the half lengths.
  RectEllipse::touch({0, 0, 1, 0, 0x1p40, 0x1p-40}, {0x4p40, 0x5p-40, 1, 0, 0x5p40, 0x5p-40},
                     {down(first, rect::hx), down(first, rect::hy), down(second, ellipse::a), down(second, ellipse::b),
                      up(second, ellipse::cx), up(second, ellipse::cy)});
}

}  // namespace
