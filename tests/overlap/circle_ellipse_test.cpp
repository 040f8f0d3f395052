// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using CircleEllipse = Pair<vesica_overlap_circle_ellipse_f64, vesica_overlap_circle_ellipse_f32>;

// Half lengths 80 and 25: the outline point (64, 15) has the normal (25^2 64, 80^2 15) / 8000 = (5, 12), 13 long.
TEST(OverlapCircleEllipse, CommonRationalNormal) {
  CircleEllipse::touch({69, 27, 13}, {0, 0, 1, 0, 80, 25},
                       {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, ellipse::a),
                        down(second, ellipse::b), down(second, ellipse::cx), down(second, ellipse::cy)});
  // The same in the frame of v = (3, 4), 5 long: 69v + 27 perp(v) = (99, 357), normal (-33, 56).
  CircleEllipse::touch({99, 357, 65}, {0, 0, 3, 4, 80, 25},
                       {down(first, circle::cx), up(first, circle::cy), down(first, circle::r),
                        down(second, ellipse::a), down(second, ellipse::b)});
}

// v = (2, 1), half lengths 57 and 88: the outline point (-2, 175) has the normal (5, 12); |v| is irrational.
TEST(OverlapCircleEllipse, AxisWithoutRationalLength) {
  CircleEllipse::touch({3, 187, 13}, {0, 0, 2, 1, 57, 88},
                       {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, ellipse::a),
                        down(second, ellipse::b)});
}

TEST(OverlapCircleEllipse, Vertex) {
  CircleEllipse::touch({8, 0, 3}, {0, 0, 1, 0, 5, 10},
                       {up(first, circle::cx), down(first, circle::r), down(second, ellipse::a)});
  CircleEllipse::pinned({8, 0, 3}, {0, 0, 1, 0, 5, 10}, {up(first, circle::cy), up(second, ellipse::cy)});
  CircleEllipse::touch(
      {18, 24, 5}, {0, 0, 3, 4, 5, 10},
      {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, ellipse::a)});
}

TEST(OverlapCircleEllipse, RoundEllipseAtAPythagoreanOffset) {
  CircleEllipse::touch(
      {3, 4, 2}, {0, 0, 1, 0, 3, 3},
      {up(first, circle::cx), down(first, circle::r), down(second, ellipse::a), down(second, ellipse::b)});
  CircleEllipse::touch({-7, 24, 10}, {0, 0, 4, 3, 3, 3}, {down(first, circle::cx), down(first, circle::r)});
}

TEST(OverlapCircleEllipse, InternalTangency) {
  // At the vertex (5, 0), the circle inside; at (64, 15) the circle on the inner normal.
  CircleEllipse::meet({4, 0, 1}, {0, 0, 1, 0, 5, 10},
                      {up(first, circle::cx), up(first, circle::r), down(second, ellipse::a)});
  CircleEllipse::meet({59, 3, 13}, {0, 0, 1, 0, 80, 25},
                      {up(first, circle::cx), up(first, circle::r), down(second, ellipse::b)});
  // The ellipse inside, touching at both ends of its long axis.
  CircleEllipse::meet({0, 0, 10}, {0, 0, 1, 0, 5, 10}, {down(first, circle::r), up(second, ellipse::b)});
}

// Four-fold contact: the circle of curvature at a vertex, radius b^2 / a; inside at the sharp end, outside at the
// blunt.
TEST(OverlapCircleEllipse, FourFoldOsculation) {
  CircleEllipse::meet({3, 0, 1}, {0, 0, 1, 0, 4, 2},
                      {up(first, circle::r), up(first, circle::cx), down(second, ellipse::a)});
  CircleEllipse::meet({0, -6, 8}, {0, 0, 1, 0, 4, 2},
                      {down(first, circle::r), up(first, circle::cy), up(second, ellipse::b)});
}

// x^2 + y^2 - 1 + (x - 1)(3 (x - 1) + 4 y) / 5, 36 times as large: three-fold contact at (36, 0), where they also
// cross.
TEST(OverlapCircleEllipse, ThreeFoldOsculation) {
  CircleEllipse::meet({0, 0, 36}, {11, 10, 2, 1, 10, 15},
                      {up(first, circle::r), up(first, circle::cx), up(second, ellipse::a), up(second, ellipse::cy)});
  CircleEllipse::meet({0, 0, 64}, {39, 45, 3, 1, 5, 20}, {up(first, circle::r), up(second, ellipse::b)});
}

TEST(OverlapCircleEllipse, CircleWithoutSize) {
  CircleEllipse::touch(
      {-2, 19, 0}, {0, 0, 2, 1, 5, 10},
      {up(first, circle::cx), up(first, circle::cy), down(second, ellipse::a), down(second, ellipse::b)});
  CircleEllipse::pinned({5, 0, 0}, {0, 0, 1, 0, 5, 10}, {up(first, circle::cy)});
  CircleEllipse::pinned({2, 1, 0}, {0, 0, 2, 1, 3, 0}, {up(first, circle::cx), up(first, circle::cy)});
  CircleEllipse::pinned({2, 1, 0}, {2, 1, 3, 4, 0, 0}, {up(first, circle::cx), up(first, circle::cy)});
}

TEST(OverlapCircleEllipse, EllipseWithoutSize) {
  // Beside the segment (-3, -4) - (3, 4), beyond its end, and a single point.
  CircleEllipse::touch({-4, 3, 5}, {0, 0, 3, 4, 1, 0},
                       {down(first, circle::cx), up(first, circle::cy), down(first, circle::r)});
  CircleEllipse::touch(
      {8, 16, 13}, {0, 0, 4, -3, 0, 1},
      {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, ellipse::b)});
  CircleEllipse::touch({8, 16, 13}, {3, 4, 3, 4, 0, 0},
                       {up(first, circle::cx), up(first, circle::cy), down(first, circle::r)});
}

TEST(OverlapCircleEllipse, Needle) {
  CircleEllipse::touch({0x1p40 + 2, 0, 2}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                       {up(first, circle::cx), down(first, circle::r), down(second, ellipse::a)});
  CircleEllipse::touch({0, 0x1p-20 + 4, 4}, {0, 0, 1, 0, 0x1p20, 0x1p-20},
                       {up(first, circle::cy), down(first, circle::r), down(second, ellipse::b)});
  CircleEllipse::touch({0, 0x1p-39, 0x1p-40}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                       {up(first, circle::cy), down(first, circle::r), down(second, ellipse::b)});
}

TEST(OverlapCircleEllipse, Apart) {
  // The circle lies in the box round the ellipse.
  CircleEllipse::miss({4.5, 9, 0.5}, {0, 0, 1, 0, 5, 10},
                      {down(first, circle::cx), up(first, circle::r), up(second, ellipse::a)});
}

}  // namespace
