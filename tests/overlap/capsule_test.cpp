// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace overlap_capsule_test {

using namespace contact;
template <class A, class B = vesica_capsule_f64>
using With = PairOfKinds<A, B>;

// From (0, 0) to (6, 8), 10 long; (-4, 3) is 5 away from it, at right angles to it.
constexpr vesica_capsule_f64 slanted{0, 0, 6, 8, 5};

TEST(OverlapCapsule, Point) {
  using Points = With<vesica_point_f64>;
  Points::touch({-1, 7}, slanted, {down(first, point::x), up(first, point::y), down(second, capsule::r)});
  Points::touch({9, 12}, slanted, {up(first, point::x), up(first, point::y), down(second, capsule::r)});
  Points::meet({3, 4}, slanted, {up(first, point::x)});
  Points::miss({-2, 8}, slanted, {up(second, capsule::r)});
}

TEST(OverlapCapsule, Segment) {
  using Segments = With<vesica_segment_f64>;
  // Parallel, beside it.
  Segments::touch({-4, 3, 2, 11}, slanted, {down(second, capsule::r)});
  // Its end beside the capsule's side, and beyond the round end.
  Segments::touch({-1, 7, -9, 7}, slanted, {down(first, segment::x0), down(second, capsule::r)});
  Segments::touch({9, 12, 9, 20}, slanted, {up(first, segment::y0), down(second, capsule::r)});
  Segments::meet({-10, 4, 10, 4}, slanted, {up(first, segment::y0)});
}

TEST(OverlapCapsule, Circle) {
  using Circles = With<vesica_circle_f64>;
  Circles::touch({-9, 13, 10}, slanted,
                 {down(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, capsule::r)});
  Circles::touch({11, 20, 8}, slanted,
                 {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, capsule::r)});
  Circles::touch({-1, 7, 0}, slanted, {down(first, circle::cx), down(second, capsule::r)});
}

TEST(OverlapCapsule, Aabb) {
  using Boxes = With<vesica_aabb_f64>;
  Boxes::touch({9, 12, 20, 20}, slanted,
               {up(first, aabb::min_x), up(first, aabb::min_y), down(second, capsule::r), down(second, capsule::x1)});
  // The box's corner beside the capsule's side; its face above the round end.
  Boxes::touch({-20, 7, -1, 9}, slanted, {down(first, aabb::max_x), up(first, aabb::min_y), down(second, capsule::r)});
  Boxes::touch({5, 13, 7, 14}, slanted, {up(first, aabb::min_y), down(second, capsule::r)});
  Boxes::meet({2, 3, 4, 5}, slanted, {up(first, aabb::min_x)});
}

TEST(OverlapCapsule, Rect) {
  using Rects = With<vesica_rect_f64>;
  // Parallel sides, 5 apart; axis (3, 4) of length 5.
  Rects::touch({-5, 10, 3, 4, 1, 1}, slanted, {down(second, capsule::r), down(first, rect::hy)});
  // A corner of the rectangle, at (9, 12) beyond the round end.
  Rects::touch({12, 16, 3, 4, 1, 0}, slanted, {up(first, rect::cx), down(first, rect::hx), down(second, capsule::r)});
}

TEST(OverlapCapsule, Ellipse) {
  using Ellipses = With<vesica_ellipse_f64>;
  // The side's normal is along an axis of the ellipse.
  Ellipses::touch({3, 4, 1, 0, 7, 3}, {-10, 0, 10, 0, 1},
                  {up(first, ellipse::cy), down(first, ellipse::b), down(second, capsule::r)});
  // The line 3x + 4y = 17 touches the ellipse with half lengths 5 and 2, and 3x + 4y = 32 is 3 away from it.
  Ellipses::touch(
      {0, 0, 1, 0, 5, 2}, {12, -1, 0, 8, 3},
      {down(first, ellipse::a), down(first, ellipse::b), down(second, capsule::r), down(first, ellipse::cx)});
  // The round end at the ellipse's tip.
  Ellipses::touch({0, 0, 1, 0, 5, 2}, {8, 0, 12, 5, 3},
                  {down(first, ellipse::a), down(second, capsule::r), up(second, capsule::x0)});
  // The ellipse is a circle of radius 10.
  Ellipses::touch({-9, 13, 3, 4, 2, 2}, slanted, {down(first, ellipse::cx), down(second, capsule::r)});
  Ellipses::meet({3, 4, 1, 0, 1, 1}, slanted, {up(first, ellipse::cx)});
  Ellipses::miss({0, 0, 1, 0, 5, 2}, {12, 0, 0, 9, 3}, {up(second, capsule::r)});
}

TEST(OverlapCapsule, Capsule) {
  using Capsules = With<vesica_capsule_f64>;
  Capsules::touch({-12, 9, -6, 17, 10}, slanted, {down(first, capsule::r), down(second, capsule::r)});
  Capsules::touch({11, 20, 30, 20, 8}, slanted,
                  {up(first, capsule::x0), up(first, capsule::y0), down(first, capsule::r), down(second, capsule::r)});
  Capsules::meet({0, 8, 6, 0, 0}, slanted, {up(first, capsule::x0)});  // cores cross
}

TEST(OverlapCapsule, WithoutSizes) {
  // A segment, a circle and a point.
  With<vesica_point_f64>::pinned({3, 4}, {0, 0, 6, 8, 0}, {up(first, point::x), up(first, point::y)});
  With<vesica_circle_f64>::touch({8, 15, 12}, {0, 0, 0, 0, 5},
                                 {up(first, circle::cx), down(first, circle::r), down(second, capsule::r)});
  With<vesica_point_f64>::pinned({3, 4}, {3, 4, 3, 4, 0}, {up(first, point::x)});
  With<vesica_ellipse_f64>::touch({0, 0, 1, 0, 5, 0}, {-2, 4, 9, 4, 4}, {down(second, capsule::r)});
}

}  // namespace overlap_capsule_test
