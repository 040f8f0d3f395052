// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using SegmentAabb = Pair<vesica_overlap_segment_aabb_f64, vesica_overlap_segment_aabb_f32>;

TEST(OverlapSegmentAabb, EndOnEdge) {
  SegmentAabb::touch({4, 1, 9, 1}, {0, 0, 4, 2}, {up(first, segment::x0), down(second, aabb::max_x)});
  SegmentAabb::touch({2, -5, 1, 0}, {0, 0, 4, 2}, {down(first, segment::y1), up(second, aabb::min_y)});
}

// Along an edge, its ends beyond the corners or not. One end alone nudged outward leaves the other in contact.
TEST(OverlapSegmentAabb, CollinearWithEdge) {
  SegmentAabb::touch({1, 2, 3, 2}, {0, 0, 4, 2}, {down(second, aabb::max_y)});
  SegmentAabb::touch({-3, 2, 7, 2}, {0, 0, 4, 2}, {down(second, aabb::max_y)});
  SegmentAabb::meet({1, 2, 3, 2}, {0, 0, 4, 2}, {up(first, segment::y0)});
}

TEST(OverlapSegmentAabb, CollinearWithEdgeTouchingTheCorner) {
  SegmentAabb::touch(
      {4, 2, 7, 2}, {0, 0, 4, 2},
      {up(first, segment::x0), up(first, segment::y0), down(second, aabb::max_x), down(second, aabb::max_y)});
  SegmentAabb::miss({5, 2, 7, 2}, {0, 0, 4, 2}, {down(first, segment::x0), up(second, aabb::max_x)});
}

// x + y = 6 passes the corner (4, 2) and no other point of the box.
TEST(OverlapSegmentAabb, ObliqueThroughCorner) {
  SegmentAabb::touch({2, 4, 6, 0}, {0, 0, 4, 2},
                     {up(first, segment::x0), up(first, segment::y0), up(first, segment::x1), up(first, segment::y1),
                      down(second, aabb::max_x), down(second, aabb::max_y)});
}

// Its bounding box meets the box, the line does not.
TEST(OverlapSegmentAabb, PastTheCorner) {
  SegmentAabb::miss({2, 5, 7, 0}, {0, 0, 4, 2}, {down(first, segment::x0), up(second, aabb::max_y)});
}

TEST(OverlapSegmentAabb, ThroughAndInside) {
  SegmentAabb::meet({-1, 1, 5, 1.5}, {0, 0, 4, 2}, {up(first, segment::x0), up(second, aabb::min_x)});
  SegmentAabb::meet({1, 1, 2, 1}, {0, 0, 4, 2}, {up(first, segment::x0)});
}

TEST(OverlapSegmentAabb, BoxWithoutSize) {
  SegmentAabb::touch({2, 1, 2, 5}, {0, 1, 4, 1}, {up(first, segment::y0)});
  SegmentAabb::touch({-3, 1, 0, 1}, {0, 1, 4, 1}, {down(first, segment::x1), up(second, aabb::min_x)});
  SegmentAabb::meet({2, 0, 3, 5}, {0, 1, 4, 1}, {up(first, segment::y0)});
  SegmentAabb::pinned({0, 0, 4, 2}, {2, 1, 2, 1},
                      {up(first, segment::x0), up(first, segment::y0), up(first, segment::y1)});
  SegmentAabb::miss({0, 0, 4, 2}, {6, 3, 6, 3}, {up(first, segment::x0)});
}

TEST(OverlapSegmentAabb, SegmentWithoutLength) {
  SegmentAabb::touch({4, 2, 4, 2}, {0, 0, 4, 2}, {down(second, aabb::max_x), down(second, aabb::max_y)});
  SegmentAabb::meet({4, 2, 4, 2}, {4, 2, 4, 2}, {up(first, segment::x0)});
  SegmentAabb::miss({4, 3, 4, 3}, {4, 2, 4, 2}, {up(first, segment::x0)});
}

}  // namespace
