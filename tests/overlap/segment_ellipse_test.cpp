// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using SegmentEllipse = Pair<vesica_overlap_segment_ellipse_f64, vesica_overlap_segment_ellipse_f32>;

// v = (2, 1), half lengths 5 and 10: the outline point 3v + 8 perp(v) = (-2, 19) has the normal (4, 7), so
// (-2, 19) -+ (7, -4) is tangent there.
TEST(OverlapSegmentEllipse, RationalTangent) {
  SegmentEllipse::touch({-9, 23, 5, 15}, {0, 0, 2, 1, 5, 10},
                        {up(first, segment::x0), up(first, segment::y0), up(first, segment::y1),
                         down(second, ellipse::a), down(second, ellipse::b), down(second, ellipse::cx)});
}

// Along u = (2, 1) the ellipse with v = (1, 2), half lengths 2 and 5, reaches to sqrt((2 u.v)^2 + (5 u x v)^2) =
// sqrt(8^2 + 15^2) = 17: the line 2x + y = 17 touches it, at (166, -43) / 17.
TEST(OverlapSegmentEllipse, SupportIsAPythagoreanTriple) {
  SegmentEllipse::touch({8, 1, 12, -7}, {0, 0, 1, 2, 2, 5},
                        {up(first, segment::x0), up(first, segment::y1), down(second, ellipse::a),
                         down(second, ellipse::b), down(second, ellipse::cy)});
}

TEST(OverlapSegmentEllipse, EndOnTheOutline) {
  SegmentEllipse::touch({-2, 19, -2, 26}, {0, 0, 2, 1, 5, 10},
                        {up(first, segment::x0), up(first, segment::y0), down(second, ellipse::a)});
  SegmentEllipse::touch({5, 0, 9, 0}, {0, 0, 1, 0, 5, 10}, {up(first, segment::x0), down(second, ellipse::a)});
}

TEST(OverlapSegmentEllipse, LineMeetsSegmentDoesNot) {
  SegmentEllipse::miss({6, 0, 9, 0}, {0, 0, 1, 0, 5, 10}, {down(first, segment::x0), up(second, ellipse::a)});
  SegmentEllipse::miss({-4, 24, -8, 48}, {0, 0, 2, 1, 5, 10}, {up(first, segment::x0), up(second, ellipse::a)});
}

TEST(OverlapSegmentEllipse, ThroughAndInside) {
  SegmentEllipse::meet({-90, 1, 90, 2}, {0, 0, 2, 1, 5, 10}, {up(first, segment::x0), down(second, ellipse::a)});
  SegmentEllipse::meet({0, 1, 1, 1}, {0, 0, 2, 1, 5, 10}, {up(first, segment::x0), up(second, ellipse::uy)});
}

// Half length 0: the ellipse is the segment (3, -6) - (-3, 6) or (-6, -3) - (6, 3).
TEST(OverlapSegmentEllipse, EllipseWithoutWidth) {
  SegmentEllipse::touch({-5, 5, -1, 7}, {0, 0, 2, 1, 0, 3}, {down(second, ellipse::b)});
  SegmentEllipse::touch({6, 3, 8, 4}, {0, 0, 2, 1, 3, 0}, {down(second, ellipse::a)});
  SegmentEllipse::touch({2, 1, 2, 5}, {0, 0, 2, 1, 3, 0}, {up(first, segment::y0), down(second, ellipse::cy)});
  SegmentEllipse::meet({0, -1, 1, 9}, {0, 0, 2, 1, 3, 0}, {up(first, segment::x0)});
  SegmentEllipse::miss({8, 4, 10, 5}, {0, 0, 2, 1, 3, 0}, {down(first, segment::x0), up(second, ellipse::a)});
}

TEST(OverlapSegmentEllipse, EllipseWithoutSize) {
  SegmentEllipse::pinned({0, 0, 4, 2}, {2, 1, 3, 4, 0, 0},
                         {up(first, segment::y0), up(first, segment::x1), up(second, ellipse::cx)});
  SegmentEllipse::miss({0, 0, 4, 2}, {6, 3, 3, 4, 0, 0}, {up(second, ellipse::cx)});
}

TEST(OverlapSegmentEllipse, SegmentWithoutLength) {
  SegmentEllipse::touch({-2, 19, -2, 19}, {0, 0, 2, 1, 5, 10},
                        {down(second, ellipse::a), down(second, ellipse::b), down(second, ellipse::cx)});
  SegmentEllipse::pinned({5, 0, 5, 0}, {0, 0, 1, 0, 5, 10}, {up(second, ellipse::cy)});
  SegmentEllipse::pinned({2, 1, 2, 1}, {0, 0, 2, 1, 3, 0}, {up(second, ellipse::cx), up(second, ellipse::cy)});
}

TEST(OverlapSegmentEllipse, Needle) {
  SegmentEllipse::touch({-5, 0x1p-40, 5, 0x1p-40}, {0, 0, 1, 0, 0x1p40, 0x1p-40},
                        {down(second, ellipse::b), down(second, ellipse::cy)});
  SegmentEllipse::touch({0x1p40, -1, 0x1p40, 1}, {0, 0, 1, 0, 0x1p40, 0x1p-40}, {down(second, ellipse::a)});
  // The tangent 3x/A + 4y/B = 5 at three and four fifths of the half lengths A = 5 2^40 and B = 5 2^-40.
  SegmentEllipse::touch(
      {-0x1p40, 0x7p-40, 0x7p40, 0x1p-40}, {0, 0, 1, 0, 0x5p40, 0x5p-40},
      {up(first, segment::y0), up(first, segment::x1), down(second, ellipse::a), down(second, ellipse::b)});
}

}  // namespace
