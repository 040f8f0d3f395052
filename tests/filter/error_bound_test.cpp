// SPDX-License-Identifier: Apache-2.0
// |computed - exact| <= bound for every filter that estimates one polynomial, in float and in double. The truth is
// computed from the stored numbers in exact integers; the inputs are searched for the worst.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vesica/filter/box_box.hpp>
#include <vesica/filter/box_ellipse.hpp>
#include <vesica/filter/disc.hpp>
#include <vesica/filter/point_ellipse.hpp>

#include "filter/bounds.hpp"

namespace {

using namespace vesica;
using bounds::error_over_bound;
using bounds::offset;
using bounds::true_offset;
using inputs::Exponents;

template <class V>
class ErrorBound : public bounds::Bound<V, 10000> {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ErrorBound, Scalars);

constexpr auto separating_axes = [](const auto& a, const auto& b) {
  const auto axes = filter::separating_axes(filter::box(a), filter::box(b), offset(a, b));
  if (!filter::box_axis_in_range(axes.uu) || !filter::box_axis_in_range(axes.ww)) return -1.0;
  const truth::Box box_a = truth::box(a), box_b = truth::box(b);
  const truth::Vector d = true_offset(a, b);
  return std::max(error_over_bound(axes.gap_a, truth::widest_gap(box_a, box_b, d)),
                  error_over_bound(axes.gap_b, truth::widest_gap(box_b, box_a, d)));
};

// Axes 2^-25 to 2^25; sizes far below the allowance for underflow and up to overflow.
constexpr Exponents box_box{-25, 25, -90, 75};
constexpr Exponents segment_box{-25, 25, -26, 26};

TYPED_TEST(ErrorBound, SeparatingAxes) {
  this->template measure<Segment, Segment>("separating_axes segment segment", segment_box, separating_axes);
  this->template measure<Segment, Aabb>("separating_axes segment aabb", segment_box, separating_axes);
  this->template measure<Segment, Rect>("separating_axes segment rect", segment_box, separating_axes);
  this->template measure<Aabb, Rect>("separating_axes aabb rect", box_box, separating_axes);
  this->template measure<Rect, Rect>("separating_axes rect rect", box_box, separating_axes);
}

constexpr auto point_gap = [](const auto& point, const auto& b) {
  const auto box = filter::box(b);
  const auto uu = box.ux * box.ux + box.uy * box.uy;
  if (!filter::box_axis_in_range(uu)) return -1.0;
  const truth::Box none{{1, 0}, 0, 0};
  return error_over_bound(filter::point_gap(box, offset(b, point), uu),
                          truth::widest_gap(truth::box(b), none, true_offset(b, point)));
};

TYPED_TEST(ErrorBound, PointGap) {
  this->template measure<Point, Segment>("point_gap segment", segment_box, point_gap);
  this->template measure<Point, Rect>("point_gap rect", box_box, point_gap);
}

constexpr Exponents discs{0, 0, -50, 63};

TYPED_TEST(ErrorBound, BeyondReach) {
  using V = TypeParam;
  this->template measure<Point, Circle>("beyond_reach point circle", discs, [](const auto& p, const auto& c) {
    return error_over_bound(filter::beyond_reach(offset(p, c), c.r), truth::beyond_reach(true_offset(p, c), c.r));
  });
  this->template measure<Circle, Circle>("beyond_reach circle circle", discs, [](const auto& a, const auto& b) {
    const V reach = a.r + b.r;
    return error_over_bound(filter::beyond_reach(offset(a, b), reach),
                            truth::beyond_reach(true_offset(a, b), truth::Dyadic(a.r) + truth::Dyadic(b.r)));
  });
  this->template measure<Circle, Aabb>("beyond_reach circle aabb", discs, [](const auto& c, const auto& box) {
    const truth::Dyadic x(c.cx), y(c.cy);
    const truth::Vector nearest{max(max(truth::Dyadic(box.min_x) - x, x - truth::Dyadic(box.max_x)), 0),
                                max(max(truth::Dyadic(box.min_y) - y, y - truth::Dyadic(box.max_y)), 0)};
    return error_over_bound(filter::beyond_reach(filter::nearest_offset(c, box), c.r),
                            truth::beyond_reach(nearest, c.r));
  });
}

constexpr auto disc_beyond_box = [](const auto& first, const auto& second) {
  const auto measure = [](const auto& b, const auto& disc) {
    using V = decltype(disc.r + 0);
    const auto box = filter::box(b);
    const V uu = box.ux * box.ux + box.uy * box.uy;
    const auto gap = filter::disc_beyond_box(box, offset(b, disc), disc.r, uu);
    if (!filter::in_range(uu, filter::guard_power<V, -20>(), filter::guard_power<V, 20>())) return -1.0;
    if (!(gap.error <= filter::guard_power<V, 100>())) return -1.0;
    return error_over_bound(gap, truth::disc_beyond_box(truth::box(b), true_offset(b, disc), disc.r));
  };
  if constexpr (requires { first.r; }) {
    return measure(second, first);
  } else {
    return measure(first, second);
  }
};

TYPED_TEST(ErrorBound, DiscBeyondBox) {
  this->template measure<Segment, Circle>("disc_beyond_box segment", {0, 0, -11, 11}, disc_beyond_box);
  this->template measure<Circle, Rect>("disc_beyond_box rect", {-10, 9, -40, 50}, disc_beyond_box);
}

constexpr auto visible_edges = [](const auto& b, const auto& e) {
  using V = decltype(e.a + 0);
  const auto edges = filter::visible_edges(filter::box(b), e, offset(b, e));
  const auto in_range = [](V x) { return x >= filter::guard_power<V, -5>() && x <= filter::guard_power<V, 15>(); };
  if (!in_range(edges.uu) || !in_range(edges.vv) || std::min(e.a, e.b) < filter::guard_power<V, -10>()) return -1.0;
  if (!(edges.error <= filter::guard_power<V, 100>())) return -1.0;
  const auto exact = truth::visible_edges(truth::box(b), truth::ellipse(e), true_offset(b, e));
  return std::max(error_over_bound(filter::Estimate<V>{edges.misses_x, edges.error}, exact[0]),
                  error_over_bound(filter::Estimate<V>{edges.misses_y, edges.error}, exact[1]));
};

TYPED_TEST(ErrorBound, VisibleEdges) {
  this->template measure<Segment, Ellipse>("visible_edges segment ellipse", {-2, 6, -9, 7}, visible_edges);
  this->template measure<Aabb, Ellipse>("visible_edges aabb ellipse", {-2, 6, -10, 14}, visible_edges);
  this->template measure<Rect, Ellipse>("visible_edges rect ellipse", {-2, 6, -10, 14}, visible_edges);
}

constexpr auto outside_ellipse = [](const auto& point, const auto& e) {
  using V = decltype(e.a + 0);
  const V vv = e.ux * e.ux + e.uy * e.uy;
  const auto gap = filter::outside_ellipse(e, offset(e, point), vv);
  if (std::min({e.a, e.b, vv}) < filter::guard_power<V, -12>()) return -1.0;
  if (!(gap.error <= filter::guard_power<V, 100>())) return -1.0;
  return error_over_bound(gap, truth::outside_ellipse(truth::ellipse(e), true_offset(e, point)));
};

TYPED_TEST(ErrorBound, OutsideEllipse) {
  this->template measure<Point, Ellipse>("outside_ellipse", {-6, 20, -12, 25}, outside_ellipse);
}

}  // namespace
