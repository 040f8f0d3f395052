// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using SegmentCircle = Pair<vesica_overlap_segment_circle_f64, vesica_overlap_segment_circle_f32>;

// The line 3x + 4y = 25 is at 5 from the origin; the foot (3, 4) is the middle of (-1, 7) - (7, 1).
TEST(OverlapSegmentCircle, RationalTangent) {
  SegmentCircle::touch({-1, 7, 7, 1}, {0, 0, 5},
                       {up(first, segment::x0), up(first, segment::y0), up(first, segment::y1), down(second, circle::r),
                        down(second, circle::cx), down(second, circle::cy)});
  // 9001^2 and 4000^2: the point (p, q) = (65018001, 72008000) at 97018001, and the ends (p, q) -+ (q, -p).
  SegmentCircle::touch({-6989999, 137026001, 137026001, 6989999}, {0, 0, 97018001},
                       {up(first, segment::y0), up(first, segment::x1), down(second, circle::r)});
  SegmentCircle::touch({-4, 3, 9, 3}, {1, 1, 2}, {down(second, circle::r), down(second, circle::cy)});
}

TEST(OverlapSegmentCircle, EndOnTheRim) {
  SegmentCircle::touch({3, 4, 6, 8}, {0, 0, 5},
                       {up(first, segment::x0), up(first, segment::y0), down(second, circle::r)});
  SegmentCircle::touch({5, 0, 5, 9}, {0, 0, 5}, {up(first, segment::x0), down(second, circle::r)});
}

// The line passes through the disc, the segment ends before it.
TEST(OverlapSegmentCircle, LineMeetsSegmentDoesNot) {
  SegmentCircle::miss({6, 8, 9, 12}, {0, 0, 5}, {down(first, segment::x0), up(second, circle::r)});
  SegmentCircle::miss({-6, 0, -100, 1}, {0, 0, 5}, {up(first, segment::x0)});
}

TEST(OverlapSegmentCircle, ThroughAndInside) {
  SegmentCircle::meet({-10, 1, 10, 2}, {0, 0, 5}, {up(first, segment::x0), down(second, circle::r)});
  SegmentCircle::meet({-1, 1, 2, 2}, {0, 0, 5}, {up(first, segment::x0), down(second, circle::r)});
}

TEST(OverlapSegmentCircle, CircleWithoutSize) {
  SegmentCircle::pinned(
      {0, 0, 4, 2}, {2, 1, 0},
      {up(first, segment::y0), up(first, segment::x1), up(second, circle::cx), up(second, circle::cy)});
  SegmentCircle::touch({0, 1, 4, 1}, {4, 1, 0}, {up(second, circle::cx), down(first, segment::x1)});
  SegmentCircle::miss({0, 0, 4, 2}, {6, 3, 0}, {up(second, circle::cx)});
}

TEST(OverlapSegmentCircle, SegmentWithoutLength) {
  SegmentCircle::touch({3, 4, 3, 4}, {0, 0, 5}, {down(second, circle::r), down(second, circle::cx)});
  SegmentCircle::pinned({5, 0, 5, 0}, {0, 0, 5}, {up(second, circle::cy)});
  SegmentCircle::pinned({2, 1, 2, 1}, {2, 1, 0}, {up(second, circle::cx), up(second, circle::cy)});
}

}  // namespace
