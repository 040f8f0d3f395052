// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using EllipseEllipse = Pair<vesica_overlap_ellipse_ellipse_f64, vesica_overlap_ellipse_ellipse_f32>;

// Parallel axes and one ratio: they touch where the centre lies at 3/5 and 4/5 of the summed half lengths.
TEST(OverlapEllipseEllipse, Homothetic) {
  EllipseEllipse::touch(
      {0, 0, 1, 0, 2, 4}, {3, 8, 1, 0, 3, 6},
      {down(first, ellipse::a), down(first, ellipse::b), down(second, ellipse::a), down(second, ellipse::b),
       up(second, ellipse::cx), up(second, ellipse::cy), down(first, ellipse::cx)});
  // 3v + 8 perp(v) = (-2, 19) for v = (2, 1).
  EllipseEllipse::touch({1, 1, 2, 1, 2, 4}, {-1, 20, 2, 1, 3, 6},
                        {down(first, ellipse::a), down(first, ellipse::b), down(second, ellipse::a),
                         up(second, ellipse::cx), up(second, ellipse::cy)});
  // Circles 25 apart, each on its own axes.
  EllipseEllipse::touch({0, 0, 3, 4, 3, 3}, {-7, 24, 0, 2, 5, 5},
                        {down(first, ellipse::a), down(second, ellipse::b), down(second, ellipse::cx)});
}

// Normal (5, 12). Half lengths 80 and 25: the outline point (64, 15), support 500. Axis (2, 1), 57 and 88:
// the point (-2, 175), support sqrt((57 22)^2 + (88 19)^2) = 2090. The centres lie apart by the sum of the points.
TEST(OverlapEllipseEllipse, CommonRationalNormal) {
  EllipseEllipse::touch(
      {0, 0, 1, 0, 80, 25}, {62, 190, 2, 1, 57, 88},
      {down(first, ellipse::a), down(first, ellipse::b), down(second, ellipse::a), down(second, ellipse::b),
       up(second, ellipse::cx), up(second, ellipse::cy), down(first, ellipse::cx)});
  // The same in the frame of (3, 4).
  EllipseEllipse::touch({0, 0, 3, 4, 80, 25}, {-574, 818, 2, 11, 57, 88},
                        {down(first, ellipse::a), down(first, ellipse::b), down(second, ellipse::a),
                         down(second, ellipse::b), down(second, ellipse::cx), up(second, ellipse::cy)});
  // Parallel axes, other ratios: (320, 75) of 400 and 125, (27, 20) of 45 and 25.
  EllipseEllipse::touch({0, 0, 1, 0, 400, 125}, {347, 95, 1, 0, 45, 25},
                        {down(first, ellipse::a), down(first, ellipse::b), down(second, ellipse::a),
                         down(second, ellipse::b), up(second, ellipse::cx)});
}

TEST(OverlapEllipseEllipse, VertexOnVertex) {
  EllipseEllipse::touch({0, 0, 1, 0, 5, 10}, {8, 0, 1, 0, 3, 2},
                        {down(first, ellipse::a), down(second, ellipse::a), up(second, ellipse::cx)});
  EllipseEllipse::pinned({0, 0, 1, 0, 5, 10}, {8, 0, 0, -1, 2, 3}, {up(second, ellipse::cy), up(first, ellipse::cy)});
  EllipseEllipse::touch(
      {0, 0, 3, 4, 5, 10}, {24, 32, -4, 3, 7, 3},
      {down(first, ellipse::a), down(second, ellipse::b), up(second, ellipse::cx), up(second, ellipse::cy)});
}

TEST(OverlapEllipseEllipse, InternalTangency) {
  // Half as large about the common point (3, 8); and at one vertex.
  EllipseEllipse::meet({0, 0, 1, 0, 5, 10}, {1.5, 4, 1, 0, 2.5, 5},
                       {up(second, ellipse::a), up(second, ellipse::cx), down(first, ellipse::b)});
  EllipseEllipse::meet({0, 0, 2, 1, 5, 10}, {-1, 9.5, 2, 1, 2.5, 5}, {up(second, ellipse::a), down(first, ellipse::b)});
  EllipseEllipse::meet({0, 0, 1, 0, 5, 10}, {4, 0, 1, 0, 1, 1},
                       {up(second, ellipse::a), up(second, ellipse::cx), down(first, ellipse::a)});
  // Touching at both ends of the short axis.
  EllipseEllipse::meet({0, 0, 3, 4, 5, 10}, {0, 0, 3, 4, 5, 5}, {up(second, ellipse::a), down(first, ellipse::a)});
}

TEST(OverlapEllipseEllipse, EqualUnderOtherAxes) {
  EllipseEllipse::meet({1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6}, {up(first, ellipse::a), up(second, ellipse::cx)});
  EllipseEllipse::meet({1, 2, 3, 4, 5, 6}, {1, 2, 0x3p40, 0x4p40, 0x5p-40, 0x6p-40},
                       {up(first, ellipse::a), up(second, ellipse::cx)});
  EllipseEllipse::meet({1, 2, 3, 4, 5, 6}, {1, 2, -0x4p-40, 0x3p-40, 0x6p40, 0x5p40},
                       {up(first, ellipse::a), up(second, ellipse::cx)});
}

TEST(OverlapEllipseEllipse, OneInsideTheOther) {
  EllipseEllipse::meet({0, 0, 2, 1, 50, 90}, {1, 1, 3, 4, 1, 2}, {up(first, ellipse::ux), up(second, ellipse::a)});
  EllipseEllipse::meet({0, 0, 2, 1, 50, 90}, {0, 0, 2, 1, 5, 9}, {up(first, ellipse::ux), up(second, ellipse::a)});
  // A cross with four crossings.
  EllipseEllipse::meet({0, 0, 3, 4, 50, 1}, {0, 0, -4, 3, 50, 1}, {up(first, ellipse::a), up(second, ellipse::a)});
}

// Four-fold contact at a vertex: equal curvature 1/16, one inside the other; and 1 = 2^2 / 4 in a circle.
TEST(OverlapEllipseEllipse, FourFoldOsculation) {
  EllipseEllipse::meet({0, 0, 1, 0, 4, 8}, {3, 0, 1, 0, 1, 4},
                       {up(second, ellipse::a), up(second, ellipse::cx), up(first, ellipse::b)});
  EllipseEllipse::meet({0, 0, 3, 4, 4, 2}, {9, 12, 4, -3, 1, 1},
                       {up(second, ellipse::a), up(second, ellipse::b), up(first, ellipse::b)});
}

// Three-fold contact, where the outlines also cross. x^2 + y^2 - 1 + (x - 1)(3 (x - 1) + 4 y) / 5, 180 times as large;
// and the circle of curvature at 4/5 and 3/5 of 80 and 25, 125 times as large and twice as high.
TEST(OverlapEllipseEllipse, ThreeFoldOsculation) {
  EllipseEllipse::meet({0, 0, 3, 4, 36, 36}, {55, 50, 2, 1, 50, 75},
                       {up(first, ellipse::a), up(second, ellipse::cx), down(second, ellipse::b)});
  EllipseEllipse::meet({0, 0, 1, 0, 10000, 6250}, {4620, -12474, 1, 0, 8788, 17576},
                       {up(first, ellipse::a), up(second, ellipse::cx), down(second, ellipse::b)});
}

TEST(OverlapEllipseEllipse, Apart) {
  // The boxes round them overlap, along either one's axes.
  EllipseEllipse::miss({0, 0, 1, 0, 5, 10}, {6, 12, 1, 0, 3, 4}, {up(first, ellipse::a), up(second, ellipse::b)});
  EllipseEllipse::miss({0, 0, 2, 1, 14, 1}, {0, 6, 2, 1, 14, 1}, {up(first, ellipse::a), up(second, ellipse::b)});
}

TEST(OverlapEllipseEllipse, OneWithoutWidth) {
  // Tangent to the outline at (-2, 19), along (-7, 4); an end on the outline; and the point itself.
  EllipseEllipse::touch({0, 0, 2, 1, 5, 10}, {-2, 19, -7, 4, 3, 0},
                        {down(first, ellipse::a), down(first, ellipse::b), up(second, ellipse::cx)});
  EllipseEllipse::touch({0, 0, 2, 1, 5, 10}, {4, 31, 6, -3, 0, 2}, {down(first, ellipse::a), down(second, ellipse::b)});
  EllipseEllipse::touch({0, 0, 2, 1, 5, 10}, {-2, 19, 5, 7, 0, 0},
                        {down(first, ellipse::a), down(first, ellipse::b), up(second, ellipse::cy)});
  EllipseEllipse::pinned({0, 0, 1, 0, 5, 10}, {5, 0, 5, 7, 0, 0}, {up(second, ellipse::cy)});
  EllipseEllipse::meet({0, 0, 2, 1, 5, 10}, {1, 1, 5, 7, 0, 99}, {down(first, ellipse::a), up(second, ellipse::ux)});
  EllipseEllipse::miss({0, 0, 2, 1, 5, 10}, {-7, 24, -7, 4, 3, 0}, {up(first, ellipse::a), up(second, ellipse::a)});
}

// Both are segments or points.
TEST(OverlapEllipseEllipse, BothWithoutWidth) {
  EllipseEllipse::touch({0, 0, 3, 4, 2, 0}, {15, 20, 3, 4, 3, 0}, {down(first, ellipse::a), down(second, ellipse::a)});
  EllipseEllipse::touch({0, 0, 3, 4, 2, 0}, {-5, 10, 4, -3, 2, 0},
                        {down(second, ellipse::a), down(second, ellipse::cx)});
  EllipseEllipse::meet({0, 0, 3, 4, 2, 0}, {0, 0, 4, -3, 2, 0}, {up(first, ellipse::a), up(second, ellipse::cx)});
  EllipseEllipse::meet({0, 0, 3, 4, 2, 0}, {0, 0, 3, 4, 2, 0}, {up(first, ellipse::a), up(second, ellipse::a)});
  EllipseEllipse::miss({0, 0, 3, 4, 2, 0}, {18, 24, 3, 4, 3, 0}, {up(first, ellipse::a), up(second, ellipse::a)});
  EllipseEllipse::miss({0, 0, 3, 4, 2, 0}, {-4, 3, 3, 4, 2, 0}, {up(first, ellipse::a), up(second, ellipse::a)});
  EllipseEllipse::pinned({0, 0, 3, 4, 2, 0}, {3, 4, 1, 2, 0, 0}, {up(first, ellipse::cx), up(second, ellipse::cy)});
  EllipseEllipse::pinned({3, 4, -2, 5, 0, 0}, {3, 4, 1, 2, 0, 0}, {up(first, ellipse::cx), up(second, ellipse::cy)});
}

TEST(OverlapEllipseEllipse, Needles) {
  EllipseEllipse::touch({0, 0, 1, 0, 0x1p40, 0x1p-40}, {0x1p41, 0, 1, 0, 0x1p40, 0x1p-40},
                        {down(first, ellipse::a), down(second, ellipse::a), up(second, ellipse::cx)});
  EllipseEllipse::touch({0, 0, 1, 0, 0x1p40, 0x1p-40}, {0, 0x1p-39, 1, 0, 0x1p40, 0x1p-40},
                        {down(first, ellipse::b), down(second, ellipse::b), up(second, ellipse::cy)});
  // The tip of an upright one on the side of a level one.
  EllipseEllipse::touch({0, 0, 1, 0, 0x1p20, 0x1p-20}, {0, 0x1p20 + 0x1p-20, 0, 1, 0x1p20, 0x1p-20},
                        {down(first, ellipse::b), down(second, ellipse::a), up(second, ellipse::cy)});
  // Homothetic, at 3/5 and 4/5 of the summed half lengths.
  EllipseEllipse::touch({0, 0, 1, 0, 0x2p40, 0x2p-40}, {0x3p40, 0x4p-40, 1, 0, 0x3p40, 0x3p-40},
                        {down(first, ellipse::a), down(first, ellipse::b), down(second, ellipse::a),
                         down(second, ellipse::b), up(second, ellipse::cx), up(second, ellipse::cy)});
  EllipseEllipse::touch(
      {0, 0, 1, 0, 0x2p300, 0x2p-300}, {0x3p300, 0x4p-300, 1, 0, 0x3p300, 0x3p-300},
      {down(first, ellipse::a), down(first, ellipse::b), up(second, ellipse::cx), up(second, ellipse::cy)});
}

}  // namespace
