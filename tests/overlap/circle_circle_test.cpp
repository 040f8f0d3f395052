// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using CircleCircle = Pair<vesica_overlap_circle_circle_f64, vesica_overlap_circle_circle_f32>;

// Pythagorean triples: the centres are at exactly the sum of the radii.
TEST(OverlapCircleCircle, PythagoreanOffset) {
  CircleCircle::touch({0, 0, 2}, {3, 4, 3},
                      {down(first, circle::r), down(second, circle::r), up(second, circle::cx), up(second, circle::cy),
                       down(first, circle::cx)});
  CircleCircle::touch({1, 1, 12.5}, {-7, 16, 4.5},
                      {down(first, circle::r), down(second, circle::r), down(second, circle::cx)});
  CircleCircle::touch({0, 0, 3}, {8, 0, 5}, {down(first, circle::r), down(second, circle::r), up(second, circle::cx)});
}

// The sums of squares need 106 bits (48 in float), all of them significant.
TEST(OverlapCircleCircle, FullWidthTriples) {
  CircleCircle::touch({0, 0, 4496000084000000}, {5120000168000001, 7392000088000000, 4496000084000001},
                      {down(first, circle::r), down(second, circle::r), up(second, circle::cx)});
  CircleCircle::touch({0, 0, 1}, {9007199017788769, 2065919576520, 9007199254711680},
                      {down(first, circle::r), down(second, circle::r), up(second, circle::cy)});
  CircleCircle::touch({0, 0, 1}, {16760925, 737100, 16777124},
                      {down(first, circle::r), down(second, circle::r), up(second, circle::cy)});
}

// The tip of the small one is the last place of the large one.
TEST(OverlapCircleCircle, UnequalSizes) {
  CircleCircle::touch({0, 0, 0x1p52}, {0x1p52 + 1, 0, 1},
                      {down(first, circle::r), down(second, circle::r), up(second, circle::cx)});
  CircleCircle::touch({0, 0, 0x1p23}, {0, 0x1p23 + 1, 1},
                      {down(first, circle::r), down(second, circle::r), up(second, circle::cy)});
  CircleCircle::touch({0x1p400, 0, 0x1p400}, {-0x1p-400, 0, 0x1p-400},
                      {down(first, circle::r), down(second, circle::r), down(second, circle::cx)});
}

TEST(OverlapCircleCircle, InternalTangency) {
  CircleCircle::meet({0, 0, 10}, {3, 4, 5}, {up(second, circle::r), up(second, circle::cx), up(first, circle::cy)});
}

TEST(OverlapCircleCircle, ConcentricAndEqual) {
  CircleCircle::meet({3, -2, 10}, {3, -2, 5}, {up(second, circle::r), up(second, circle::cx)});
  CircleCircle::meet({3, -2, 10}, {3, -2, 10}, {up(second, circle::r), up(second, circle::cx)});
}

TEST(OverlapCircleCircle, WithoutSize) {
  CircleCircle::pinned({1, 2, 0}, {1, 2, 0}, {up(first, circle::cx), up(second, circle::cy)});
  CircleCircle::pinned({0, 0, 0}, {-0.0, -0.0, 0}, {up(first, circle::cx), up(second, circle::cy)});
  CircleCircle::touch({3, 4, 0}, {0, 0, 5}, {up(first, circle::cx), up(first, circle::cy), down(second, circle::r)});
  CircleCircle::meet({1, 2, 0}, {0, 0, 5}, {up(first, circle::cx), down(second, circle::r)});
  CircleCircle::miss({1, 2, 0}, {2, 1, 0}, {up(first, circle::cx)});
}

}  // namespace
