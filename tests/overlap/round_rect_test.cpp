// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "overlap/contact.hpp"

namespace overlap_round_rect_test {

using namespace contact;
template <class A, class B = vesica_round_rect_f64>
using With = PairOfKinds<A, B>;

// About the origin with an axis of length 5: 10 along (3, 4) and 5 across it either way, and a radius of 5. Its corners
// are at +-(6, 8) +- (-4, 3), so (2, 11) is one.
constexpr vesica_round_rect_f64 slanted{0, 0, 3, 4, 2, 1, 5};

TEST(OverlapRoundRect, Point) {
  using Points = With<vesica_point_f64>;
  Points::touch(
      {-8, 6}, slanted,
      {down(first, point::x), up(first, point::y), down(second, round_rect::r), down(second, round_rect::hy)});
  // Above the rectangle's corner, and beside it where the rectangle grown by the radius would still reach.
  Points::touch({2, 16}, slanted, {up(first, point::y), down(second, round_rect::r)});
  Points::miss({1, 18}, slanted, {up(second, round_rect::r)});
  Points::meet({1, 1}, slanted, {up(first, point::x)});
}

TEST(OverlapRoundRect, Segment) {
  using Segments = With<vesica_segment_f64>;
  Segments::touch({-11, 2, -5, 10}, slanted, {down(second, round_rect::r), down(second, round_rect::hy)});
  Segments::touch({-3, 16, 7, 16}, slanted, {down(second, round_rect::r)});
  Segments::meet({-20, 0, 20, 1}, slanted, {up(first, segment::x0)});
}

TEST(OverlapRoundRect, Circle) {
  using Circles = With<vesica_circle_f64>;
  Circles::touch({-16, 12, 10}, slanted,
                 {down(first, circle::cx), down(first, circle::r), down(second, round_rect::r)});
  Circles::touch({7, 23, 8}, slanted,
                 {up(first, circle::cx), up(first, circle::cy), down(first, circle::r), down(second, round_rect::r)});
}

TEST(OverlapRoundRect, Aabb) {
  using Boxes = With<vesica_aabb_f64>;
  Boxes::touch({-1, 16, 3, 20}, slanted, {up(first, aabb::min_y), down(second, round_rect::r)});
  Boxes::touch({-20, 6, -8, 20}, slanted,
               {down(first, aabb::max_x), up(first, aabb::min_y), down(second, round_rect::r)});
  Boxes::meet({-1, -1, 1, 1}, slanted, {up(first, aabb::min_x)});
}

TEST(OverlapRoundRect, Rect) {
  using Rects = With<vesica_rect_f64>;
  Rects::touch({-12, 9, 3, 4, 1, 1}, slanted, {down(first, rect::hy), down(second, round_rect::r)});
  Rects::touch({2, 20, 1, 0, 7, 4}, slanted, {up(first, rect::cy), down(first, rect::hy), down(second, round_rect::r)});
}

TEST(OverlapRoundRect, Ellipse) {
  using Ellipses = With<vesica_ellipse_f64>;
  // Beside a straight side, the ellipse's axes along the rectangle's.
  Ellipses::touch({-12, 9, 3, 4, 1, 1}, slanted, {down(first, ellipse::b), down(second, round_rect::r)});
  Ellipses::touch({-16, 12, 3, 4, 1, 2}, slanted, {down(first, ellipse::b), down(second, round_rect::r)});
  // A tip above the corner's arc.
  Ellipses::touch({2, 20, 1, 0, 1, 4}, slanted,
                  {up(first, ellipse::cy), down(first, ellipse::b), down(second, round_rect::r)});
  Ellipses::meet({0, 0, 1, 0, 1, 2}, slanted, {up(first, ellipse::cx)});
}

TEST(OverlapRoundRect, Capsule) {
  using Capsules = With<vesica_capsule_f64>;
  Capsules::touch({-19, 8, -13, 16, 10}, slanted, {down(first, capsule::r), down(second, round_rect::r)});
  Capsules::touch({7, 23, 20, 40, 8}, slanted,
                  {up(first, capsule::x0), down(first, capsule::r), down(second, round_rect::r)});
}

TEST(OverlapRoundRect, RoundRect) {
  using RoundRects = With<vesica_round_rect_f64>;
  RoundRects::touch({-16, 12, 3, 4, 1, 1, 5}, slanted,
                    {down(first, round_rect::r), down(first, round_rect::hy), down(second, round_rect::r)});
  RoundRects::touch({9, 23, 1, 0, 2, 0, 8}, slanted,
                    {up(first, round_rect::cy), down(first, round_rect::r), down(second, round_rect::r)});
}

TEST(OverlapRoundRect, WithoutSizes) {
  // A rectangle, a capsule, a circle and a point.
  With<vesica_point_f64>::touch({-4, 3}, {0, 0, 3, 4, 2, 1, 0}, {down(first, point::x), down(second, round_rect::hy)});
  With<vesica_point_f64>::touch({-4, 3}, {0, 0, 3, 4, 2, 0, 5}, {down(first, point::x), down(second, round_rect::r)});
  With<vesica_point_f64>::touch({-4, 3}, {0, 0, 3, 4, 0, 0, 5}, {down(first, point::x), down(second, round_rect::r)});
  With<vesica_point_f64>::pinned({3, 4}, {3, 4, 3, 4, 0, 0, 0}, {up(first, point::x), up(second, round_rect::cy)});
}

}  // namespace overlap_round_rect_test
