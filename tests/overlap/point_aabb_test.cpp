// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using PointAabb = Pair<vesica_overlap_point_aabb_f64, vesica_overlap_point_aabb_f32>;

TEST(OverlapPointAabb, Edges) {
  PointAabb::touch({4, 1}, {0, 0, 4, 2}, {up(first, point::x), down(second, aabb::max_x)});
  PointAabb::touch({0, 1}, {0, 0, 4, 2}, {down(first, point::x), up(second, aabb::min_x)});
  PointAabb::touch({3, 2}, {0, 0, 4, 2}, {up(first, point::y), down(second, aabb::max_y)});
  PointAabb::touch({3, 0}, {0, 0, 4, 2}, {down(first, point::y), up(second, aabb::min_y)});
}

TEST(OverlapPointAabb, Corner) {
  PointAabb::touch({4, 2}, {1, -1, 4, 2},
                   {up(first, point::x), up(first, point::y), down(second, aabb::max_x), down(second, aabb::max_y)});
}

TEST(OverlapPointAabb, BoxWithoutWidthOrHeight) {
  PointAabb::pinned({2, 1}, {0, 1, 4, 1}, {up(first, point::y)});
  PointAabb::touch({4, 1}, {0, 1, 4, 1}, {up(first, point::x), down(second, aabb::max_x)});
  PointAabb::pinned({3, 1}, {3, -1, 3, 1}, {up(first, point::x)});
  PointAabb::pinned({3, 1}, {3, 1, 3, 1}, {up(first, point::x), up(first, point::y)});
  PointAabb::pinned({0, 0}, {-0.0, 0, 0, -0.0}, {up(first, point::x), up(first, point::y)});
}

TEST(OverlapPointAabb, Solid) {
  PointAabb::meet({2, 1}, {0, 0, 4, 2}, {up(first, point::x), up(first, point::y), down(second, aabb::max_x)});
  PointAabb::miss({5, 1}, {0, 0, 4, 2}, {down(first, point::x), up(second, aabb::max_x)});
  PointAabb::miss({2, -1}, {0, 0, 4, 2}, {up(first, point::y)});
}

}  // namespace
