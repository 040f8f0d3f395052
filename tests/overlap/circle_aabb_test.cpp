// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using CircleAabb = Pair<vesica_overlap_circle_aabb_f64, vesica_overlap_circle_aabb_f32>;

TEST(OverlapCircleAabb, Edges) {
  CircleAabb::touch({6, 1, 2}, {0, 0, 4, 2},
                    {up(first, circle::cx), down(first, circle::r), down(second, aabb::max_x)});
  CircleAabb::touch({1, -3, 3}, {0, 0, 4, 2},
                    {down(first, circle::cy), down(first, circle::r), up(second, aabb::min_y)});
  // Level with the corner.
  CircleAabb::touch({6, 2, 2}, {0, 0, 4, 2},
                    {up(first, circle::cx), down(first, circle::r), down(second, aabb::max_x)});
}

// From the corner (4, 2) to the centre it is a Pythagorean triple.
TEST(OverlapCircleAabb, Corner) {
  CircleAabb::touch({7, 6, 5}, {0, 0, 4, 2},
                    {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, aabb::max_x),
                     down(second, aabb::max_y)});
  CircleAabb::touch({-8, 17, 17}, {0, 0, 4, 2},
                    {down(first, circle::cx), up(first, circle::cy), down(first, circle::r), up(second, aabb::min_x),
                     down(second, aabb::max_y)});
  CircleAabb::touch({5120000168000001, 7392000088000000, 8992000168000001}, {-7, -5, 0, 0},
                    {up(first, circle::cx), up(first, circle::cy), down(first, circle::r)});
  CircleAabb::touch({16760925, 737100, 16777125}, {-7, -5, 0, 0},
                    {up(first, circle::cx), up(first, circle::cy), down(first, circle::r)});
}

// The box round the circle reaches the corner, the circle does not.
TEST(OverlapCircleAabb, PastTheCorner) {
  CircleAabb::miss({8, 6, 4.5}, {0, 0, 4, 2}, {down(first, circle::cx), up(first, circle::r), up(second, aabb::max_x)});
}

TEST(OverlapCircleAabb, OneInsideTheOther) {
  CircleAabb::meet({2, 1, 0.5}, {0, 0, 4, 2}, {up(first, circle::cx), down(first, circle::r)});
  CircleAabb::meet({2, 1, 1}, {0, 0, 4, 2}, {up(first, circle::cy), up(first, circle::r)});
  CircleAabb::meet({2, 1, 100}, {0, 0, 4, 2}, {up(first, circle::cy), up(second, aabb::max_x)});
}

TEST(OverlapCircleAabb, CircleWithoutSize) {
  CircleAabb::touch({4, 2, 0}, {0, 0, 4, 2}, {up(first, circle::cx), up(first, circle::cy), down(second, aabb::max_x)});
  CircleAabb::pinned({3, 1, 0}, {3, 1, 3, 1}, {up(first, circle::cx), up(first, circle::cy)});
  CircleAabb::miss({5, 2, 0}, {0, 0, 4, 2}, {down(first, circle::cx)});
}

TEST(OverlapCircleAabb, BoxWithoutSize) {
  CircleAabb::touch({1, 4, 3}, {0, 1, 4, 1}, {up(first, circle::cy), down(first, circle::r)});
  CircleAabb::touch({7, 5, 5}, {0, 1, 4, 1},
                    {up(first, circle::cx), down(first, circle::r), down(second, aabb::max_x)});
  CircleAabb::touch({7, 5, 5}, {4, 1, 4, 1}, {up(first, circle::cx), down(first, circle::r)});
}

}  // namespace
