// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using PointEllipse = Pair<vesica_overlap_point_ellipse_f64, vesica_overlap_point_ellipse_f32>;

// (3/5)^2 + (4/5)^2 = 1: 3v + 8 perp(v) = (-2, 19) for v = (2, 1) and half lengths 5 and 10. The normal is (4, 7).
TEST(OverlapPointEllipse, RationalOutlinePoint) {
  PointEllipse::touch({-2, 19}, {0, 0, 2, 1, 5, 10},
                      {up(first, point::x), up(first, point::y), down(second, ellipse::a), down(second, ellipse::b),
                       down(second, ellipse::cx), down(second, ellipse::cy)});
  PointEllipse::touch({3, 8}, {0, 0, 1, 0, 5, 10},
                      {up(first, point::x), up(first, point::y), down(second, ellipse::a), down(second, ellipse::b)});
  // 5, 12, 13 and another centre.
  PointEllipse::touch({-2, 25}, {-7, 1, 1, 0, 13, 26},
                      {up(first, point::x), up(first, point::y), down(second, ellipse::a), down(second, ellipse::b)});
}

// At a vertex any step along the tangent leaves the ellipse, be it 2^-1074.
TEST(OverlapPointEllipse, Vertex) {
  PointEllipse::touch({5, 0}, {0, 0, 1, 0, 5, 10}, {up(first, point::x), down(second, ellipse::a)});
  PointEllipse::pinned({5, 0}, {0, 0, 1, 0, 5, 10}, {up(first, point::y), up(second, ellipse::cy)});
  PointEllipse::touch({15, 20}, {0, 0, 3, 4, 5, 10},
                      {up(first, point::x), up(first, point::y), down(second, ellipse::a)});
}

TEST(OverlapPointEllipse, Needle) {
  PointEllipse::touch({0x1p40, 0}, {0, 0, 1, 0, 0x1p40, 0x1p-40}, {up(first, point::x), down(second, ellipse::a)});
  PointEllipse::pinned({0x1p40, 0}, {0, 0, 1, 0, 0x1p40, 0x1p-40}, {up(first, point::y)});
  PointEllipse::touch({0, 0x1p-40}, {0, 0, 1, 0, 0x1p40, 0x1p-40}, {up(first, point::y), down(second, ellipse::b)});
  PointEllipse::touch({0x3p400, 0x4p400}, {0, 0, 3, 4, 0x1p400, 0x1p-400}, {down(second, ellipse::a)});
  // 3/5 and 4/5 of the half lengths.
  PointEllipse::touch({0x3p40, 0x1p-38}, {0, 0, 1, 0, 0x5p40, 0x5p-40},
                      {up(first, point::x), up(first, point::y), down(second, ellipse::a), down(second, ellipse::b)});
}

// Half length 0 makes a segment of its own points only: a squared test alone would accept the whole line.
TEST(OverlapPointEllipse, EllipseWithoutWidth) {
  PointEllipse::pinned({-3, 6}, {0, 0, 2, 1, 0, 3},
                       {up(first, point::x), up(first, point::y), up(second, ellipse::cx)});
  PointEllipse::touch({-3, 6}, {0, 0, 2, 1, 0, 3}, {down(second, ellipse::b)});
  PointEllipse::pinned({-1, 2}, {0, 0, 2, 1, 0, 3}, {up(first, point::x), up(first, point::y)});
  PointEllipse::pinned({2, 1}, {0, 0, 2, 1, 3, 0}, {up(first, point::x), up(first, point::y)});
  PointEllipse::miss({-4, 8}, {0, 0, 2, 1, 0, 3}, {up(first, point::x), up(second, ellipse::b)});
  PointEllipse::miss({8, 4}, {0, 0, 2, 1, 3, 0}, {up(first, point::x), up(second, ellipse::a)});
}

TEST(OverlapPointEllipse, EllipseWithoutSize) {
  PointEllipse::pinned({2, -3}, {2, -3, 2, 1, 0, 0},
                       {up(first, point::x), up(first, point::y), up(second, ellipse::cy)});
  PointEllipse::miss({2, -3}, {0, -4, 2, 1, 0, 0}, {up(first, point::x)});
}

TEST(OverlapPointEllipse, Solid) {
  PointEllipse::meet({1, 2}, {1, 2, 2, 1, 5, 10},
                     {up(first, point::x), down(second, ellipse::a), up(second, ellipse::ux)});
  // A corner of the box round the ellipse.
  PointEllipse::miss({5, 10}, {0, 0, 1, 0, 5, 10}, {down(first, point::x), up(second, ellipse::a)});
}

}  // namespace
