// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using SegmentSegment = Pair<vesica_overlap_segment_segment_f64, vesica_overlap_segment_segment_f32>;

TEST(OverlapSegmentSegment, Crossing) {
  SegmentSegment::meet({-1, -1, 1, 1}, {-1, 1, 1, -1},
                       {up(first, segment::x0), up(first, segment::y1), up(second, segment::x1)});
  SegmentSegment::meet({0, 0, 5, 1}, {2, -3, 3, 9}, {up(first, segment::y0), up(second, segment::x0)});
}

// An end of one on the interior of the other, at (2, 1) in the middle of (0, 0) - (4, 2).
TEST(OverlapSegmentSegment, EndOnInterior) {
  SegmentSegment::touch({2, 1, 2, 5}, {0, 0, 4, 2},
                        {up(first, segment::y0), down(second, segment::y0), down(second, segment::y1)});
  SegmentSegment::touch({3, 1, 3, 6}, {-2, 1, 7, 1}, {up(first, segment::y0)});
}

TEST(OverlapSegmentSegment, EndOnEnd) {
  SegmentSegment::touch({0, 0, 2, 1}, {2, 1, 5, 1}, {down(first, segment::x1), up(second, segment::x0)});
  SegmentSegment::pinned({0, 0, 2, 1}, {2, 1, 5, 1}, {up(first, segment::y1)});
}

TEST(OverlapSegmentSegment, CollinearTouchingAtOneEnd) {
  SegmentSegment::touch({0, 1, 2, 1}, {2, 1, 5, 1}, {down(first, segment::x1), up(second, segment::x0)});
  // Oblique: nudged either way, the first leaves the common line and meets it at (0, 0) only.
  SegmentSegment::pinned({0, 0, 2, 1}, {2, 1, 4, 2}, {up(first, segment::x1), up(first, segment::y1)});
}

TEST(OverlapSegmentSegment, CollinearSharingAPart) {
  SegmentSegment::meet({0, 0, 4, 2}, {2, 1, 6, 3}, {up(first, segment::x0), up(first, segment::y0)});
  SegmentSegment::meet({0, 0, 4, 2}, {4, 2, 0, 0}, {up(first, segment::x0)});
  SegmentSegment::meet({0, 0, 8, 4}, {2, 1, 4, 2}, {up(second, segment::x0)});
}

TEST(OverlapSegmentSegment, CollinearApart) {
  SegmentSegment::miss({0, 0, 2, 1}, {4, 2, 6, 3}, {up(first, segment::x1), down(second, segment::x0)});
  SegmentSegment::miss({0, 0, 2, 0}, {3, 0, 6, 0}, {up(first, segment::x1), down(second, segment::y0)});
}

TEST(OverlapSegmentSegment, Parallel) {
  SegmentSegment::miss({0, 0, 4, 2}, {0, 1, 4, 3}, {up(first, segment::y0), down(second, segment::y1)});
}

// The lines cross, the segments do not.
TEST(OverlapSegmentSegment, CrossingBeyondAnEnd) {
  SegmentSegment::miss({0, 0, 4, 4}, {5, 0, 5, 9}, {up(first, segment::x1), down(second, segment::x0)});
}

// At x = 1 the long segment passes 1/N below (1, 1).
TEST(OverlapSegmentSegment, CrossProductOfOne) {
  SegmentSegment::miss({1, 1, 1, 5}, {0, 0, 9007199254740991, 9007199254740990}, {up(first, segment::y1)});
  SegmentSegment::meet({1, 1, 1, -5}, {0, 0, 9007199254740991, 9007199254740990}, {up(first, segment::y1)});
  SegmentSegment::miss({1, 1, 1, 5}, {0, 0, 16777215, 16777214}, {up(first, segment::y1)});
  SegmentSegment::meet({1, 1, 1, -5}, {0, 0, 16777215, 16777214}, {up(first, segment::y1)});
}

TEST(OverlapSegmentSegment, WithoutLength) {
  SegmentSegment::pinned({2, 1, 2, 1}, {0, 0, 4, 2}, {up(second, segment::y0), up(second, segment::x1)});
  SegmentSegment::touch({4, 1, 4, 1}, {0, 1, 4, 1}, {down(second, segment::x1)});
  SegmentSegment::miss({6, 3, 6, 3}, {0, 0, 4, 2}, {up(first, segment::x0), up(second, segment::x1)});
  SegmentSegment::meet({1, 2, 1, 2}, {1, 2, 1, 2}, {up(first, segment::x0), up(second, segment::y1)});
  SegmentSegment::miss({1, 2, 1, 2}, {1, 3, 1, 3}, {up(first, segment::x0), up(second, segment::y1)});
}

// The end (2^59, 2^-61) in the middle of a segment 2^60 long and 2^-60 high.
TEST(OverlapSegmentSegment, Needle) {
  SegmentSegment::touch({0x1p59, 0x1p-61, 0x1p59, 1}, {0, 0, 0x1p60, 0x1p-60},
                        {up(first, segment::y0), down(second, segment::y1)});
}

}  // namespace
