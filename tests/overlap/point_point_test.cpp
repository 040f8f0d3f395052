// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace {

using namespace contact;
using PointPoint = Pair<vesica_overlap_point_point_f64, vesica_overlap_point_point_f32>;

TEST(OverlapPointPoint, OnlyTheSamePointMeets) {
  PointPoint::pinned({3, -4}, {3, -4},
                     {up(first, point::x), up(first, point::y), up(second, point::x), up(second, point::y)});
}

// From 0 the next number is 2^-1074 away, at every scale.
TEST(OverlapPointPoint, ZerosOfEitherSignAreOnePoint) {
  PointPoint::pinned({0, 0}, {-0.0, 0}, {up(first, point::x), up(first, point::y), up(second, point::x)});
}

TEST(OverlapPointPoint, NeedsBothCoordinates) {
  PointPoint::miss({1, 2}, {2, 1}, {up(first, point::x)});
  PointPoint::miss({1, 2}, {1, 3}, {});
  PointPoint::miss({1, 2}, {0, 2}, {});
  PointPoint::miss({1, 2}, {-1, -2}, {up(second, point::y)});
}

}  // namespace
