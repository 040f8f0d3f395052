// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using AabbAabb = Pair<vesica_overlap_aabb_aabb_f64, vesica_overlap_aabb_aabb_f32>;

TEST(OverlapAabbAabb, EdgeToEdge) {
  AabbAabb::touch({0, 0, 4, 2}, {4, 1, 7, 9}, {down(first, aabb::max_x), up(second, aabb::min_x)});
  AabbAabb::touch({0, 0, 4, 2}, {1, 2, 3, 5}, {down(first, aabb::max_y), up(second, aabb::min_y)});
  AabbAabb::touch({0, 0, 4, 2}, {-5, 0, 0, 2}, {up(first, aabb::min_x), down(second, aabb::max_x)});
}

TEST(OverlapAabbAabb, CornerToCorner) {
  AabbAabb::touch(
      {0, 0, 4, 2}, {4, 2, 7, 9},
      {down(first, aabb::max_x), down(first, aabb::max_y), up(second, aabb::min_x), up(second, aabb::min_y)});
  AabbAabb::touch({0, 0, 4, 2}, {-3, 2, 0, 9},
                  {up(first, aabb::min_x), down(second, aabb::max_x), up(second, aabb::min_y)});
}

// Sums and differences of the corners are not representable.
TEST(OverlapAabbAabb, UnequalMagnitudes) {
  AabbAabb::touch({-0x1p60, -1, 0x1p-60, 1}, {0x1p-60, 0, 0x1p60, 3},
                  {down(first, aabb::max_x), up(second, aabb::min_x)});
  AabbAabb::touch({-9007199254740991, 0, 1, 1}, {1, 1, 9007199254740991, 2},
                  {down(first, aabb::max_x), up(second, aabb::min_x), up(second, aabb::min_y)});
}

TEST(OverlapAabbAabb, Solid) {
  AabbAabb::meet({0, 0, 9, 9}, {2, 3, 4, 5}, {up(first, aabb::min_x), up(second, aabb::max_x)});
  AabbAabb::meet({0, 0, 9, 9}, {0, 0, 9, 9}, {up(first, aabb::min_x), up(second, aabb::max_x)});
  // A cross: no corner of either lies in the other.
  AabbAabb::meet({-5, -1, 5, 1}, {-1, -5, 1, 5}, {up(first, aabb::min_x), up(second, aabb::max_x)});
}

TEST(OverlapAabbAabb, WithoutSize) {
  AabbAabb::meet({3, 1, 3, 1}, {3, 1, 3, 1}, {});
  AabbAabb::touch({4, 1, 4, 1}, {0, 0, 4, 2}, {down(second, aabb::max_x)});
  AabbAabb::touch({0, 1, 4, 1}, {4, 1, 6, 1}, {down(first, aabb::max_x), up(second, aabb::min_x)});
  AabbAabb::touch({0, 1, 4, 1}, {2, 1, 2, 5}, {up(second, aabb::min_y)});
  AabbAabb::meet({0, 1, 4, 1}, {2, 0, 2, 5}, {up(first, aabb::min_x), up(second, aabb::min_y)});
}

TEST(OverlapAabbAabb, Apart) {
  AabbAabb::miss({0, 0, 4, 2}, {5, 0, 9, 2}, {up(first, aabb::max_x), down(second, aabb::min_x)});
  AabbAabb::miss({0, 0, 4, 2}, {0, 3, 4, 5}, {up(first, aabb::max_y), down(second, aabb::min_y)});
  AabbAabb::miss({3, 1, 3, 1}, {1, 3, 1, 3}, {});
}

}  // namespace
