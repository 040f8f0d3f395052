// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using PointSegment = Pair<vesica_overlap_point_segment_f64, vesica_overlap_point_segment_f32>;

TEST(OverlapPointSegment, EndPoint) {
  PointSegment::touch({4, 0}, {0, 0, 4, 0}, {up(first, point::x), down(second, segment::x1)});
  // An oblique end: every way off it leaves the segment.
  PointSegment::pinned({4, 2}, {0, 0, 4, 2},
                       {up(first, point::x), up(first, point::y), up(second, segment::x1), up(second, segment::y1)});
}

// The middle, and a third of (6, 3) from (1, 1). Nudging an end moves the segment by part of an ulp there.
TEST(OverlapPointSegment, RationalInteriorPoint) {
  PointSegment::pinned({2, 1}, {0, 0, 4, 2},
                       {up(first, point::x), up(first, point::y), up(second, segment::x0), up(second, segment::y1)});
  PointSegment::pinned({3, 2}, {1, 1, 7, 4},
                       {up(first, point::x), up(first, point::y), up(second, segment::y0), up(second, segment::x1)});
  PointSegment::pinned({0, 3}, {-5, 3, 8, 3}, {up(first, point::y)});
}

// Along the line but past an end: the cross product is 0 and must not decide alone.
TEST(OverlapPointSegment, BeyondTheEndOnTheLine) {
  PointSegment::miss({6, 3}, {0, 0, 4, 2}, {up(first, point::x), up(first, point::y)});
  PointSegment::miss({-2, -1}, {0, 0, 4, 2}, {});
  PointSegment::miss({5, 0}, {0, 0, 4, 0}, {up(first, point::x)});
}

// (N, N - 1) x (1, 1) = 1 against products of N: off the line by 1e-16 of its length. N the largest odd integers
// of double and of float.
TEST(OverlapPointSegment, CrossProductOfOne) {
  PointSegment::miss({1, 1}, {0, 0, 9007199254740991, 9007199254740990}, {up(first, point::y), down(first, point::x)});
  PointSegment::miss({1, 1}, {0, 0, 16777215, 16777214}, {up(first, point::y), down(first, point::x)});
}

TEST(OverlapPointSegment, SegmentWithoutLength) {
  PointSegment::pinned({5, 7}, {5, 7, 5, 7}, {up(first, point::x), up(first, point::y)});
  PointSegment::miss({5, 7}, {7, 5, 7, 5}, {up(first, point::x)});
  PointSegment::pinned({0, 0}, {0, 0, -0.0, -0.0}, {up(first, point::x), up(first, point::y)});
}

// The middle of a segment 2^60 long and 2^-60 high.
TEST(OverlapPointSegment, Needle) {
  PointSegment::pinned({0x1p59, 0x1p-61}, {0, 0, 0x1p60, 0x1p-60}, {up(first, point::y), up(second, segment::y1)});
  PointSegment::pinned({0x1p499, 0x1p-501}, {0, 0, 0x1p500, 0x1p-500}, {up(first, point::y), up(second, segment::y1)});
}

}  // namespace
