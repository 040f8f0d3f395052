// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using PointCircle = Pair<vesica_overlap_point_circle_f64, vesica_overlap_point_circle_f32>;

// Pythagorean triples: the point is at exactly r from the centre.
TEST(OverlapPointCircle, PythagoreanOffset) {
  PointCircle::touch({3, 4}, {0, 0, 5},
                     {up(first, point::x), up(first, point::y), down(second, circle::r), down(second, circle::cx)});
  PointCircle::touch({2, -1}, {10, -16, 17},
                     {down(first, point::x), up(first, point::y), down(second, circle::r), up(second, circle::cx)});
  PointCircle::touch({-20, -21}, {0, 0, 29}, {down(first, point::x), down(first, point::y), down(second, circle::r)});
}

// The sums of squares need 106 bits (48 in float), all of them significant.
TEST(OverlapPointCircle, FullWidthTriples) {
  PointCircle::touch({5120000168000001, 7392000088000000}, {0, 0, 8992000168000001},
                     {up(first, point::x), up(first, point::y), down(second, circle::r)});
  PointCircle::touch({9007199017788769, 2065919576520}, {0, 0, 9007199254711681},
                     {up(first, point::x), up(first, point::y), down(second, circle::r)});
  PointCircle::touch({16760925, 737100}, {0, 0, 16777125},
                     {up(first, point::x), up(first, point::y), down(second, circle::r)});
}

// Off the axis by as little as 2^-1074 the point is outside.
TEST(OverlapPointCircle, AxisExtreme) {
  PointCircle::touch({5, 0}, {0, 0, 5}, {up(first, point::x), down(second, circle::r)});
  PointCircle::pinned({5, 0}, {0, 0, 5}, {up(first, point::y), up(second, circle::cy)});
  PointCircle::pinned({1, -4}, {1, 3, 7}, {up(first, point::x)});
}

TEST(OverlapPointCircle, CircleWithoutSize) {
  PointCircle::pinned({2, -3}, {2, -3, 0}, {up(first, point::x), up(first, point::y), up(second, circle::cx)});
  PointCircle::miss({2, -3}, {-3, 2, 0}, {up(first, point::x)});
}

TEST(OverlapPointCircle, Solid) {
  PointCircle::meet({1, 1}, {1, 1, 2}, {up(first, point::x), down(second, circle::r)});
  PointCircle::meet({2, 2}, {1, 1, 2}, {up(first, point::x), down(second, circle::r)});
  PointCircle::miss({4, 4}, {0, 0, 5}, {down(first, point::x), up(second, circle::r)});
}

}  // namespace
