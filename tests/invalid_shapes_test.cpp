// SPDX-License-Identifier: Apache-2.0
// The core's rule for invalid shapes, as vesica.hpp states it: checked forms return error_shape and leave their output
// alone; for plain forms an invalid shape has nothing in common with any other, and its distance from any other is NaN.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vesica/form/form.hpp>
#include <vesica/vesica.hpp>

namespace {

using namespace vesica;

template <class Shape>
struct Samples;
template <class T>
struct Samples<Point<T>> {
  static constexpr Point<T> valid{0, 0}, invalid{std::numeric_limits<T>::quiet_NaN(), 0};
};
template <class T>
struct Samples<Segment<T>> {
  static constexpr Segment<T> valid{-1, 0, 1, 0}, invalid{-1, 0, std::numeric_limits<T>::infinity(), 0};
};
template <class T>
struct Samples<Circle<T>> {
  static constexpr Circle<T> valid{0, 0, 1}, invalid{0, 0, -1};
};
template <class T>
struct Samples<Aabb<T>> {
  static constexpr Aabb<T> valid{-1, -1, 1, 1}, invalid{1, -1, -1, 1};
};
template <class T>
struct Samples<Rect<T>> {
  static constexpr Rect<T> valid{0, 0, 1, 0, 1, 1}, invalid{0, 0, 0, 0, 1, 1};
};
template <class T>
struct Samples<Ellipse<T>> {
  static constexpr Ellipse<T> valid{0, 0, 1, 0, 2, 1}, invalid{0, 0, 1, 0, -2, 1};
};
template <class T>
struct Samples<Capsule<T>> {
  static constexpr Capsule<T> valid{-1, 0, 1, 0, 1}, invalid{-1, 0, 1, 0, -1};
};
template <class T>
struct Samples<RoundRect<T>> {
  static constexpr RoundRect<T> valid{0, 0, 1, 0, 1, 1, 1}, invalid{0, 0, 1, 0, 1, 1, -1};
};

template <class Shape>
using ScalarOf = typename ShapeTraits<Shape>::Scalar;

/// Queries other than overlap need not answer a shape without a form.
template <class Shape>
concept HasForm = requires(const Shape& shape) {
  detail::form::of(shape);
};
template <class... Shapes>
concept EveryQueryAnswers = (HasForm<Shapes> && ...);

template <class A, class B>
void expect_overlap_to_refuse(const A& a, const B& b) {
  EXPECT_EQ(overlap_or_error(a, b), error_shape);
  EXPECT_FALSE(overlap(a, b));
  EXPECT_EQ(interiors_overlap_or_error(a, b), error_shape);
  EXPECT_FALSE(interiors_overlap(a, b));
}

template <class A, class B>
void expect_checked_forms_to_refuse(const A& a, const B& b) {
  using T = ScalarOf<A>;
  EXPECT_EQ(relation_or_error(a, b), error_shape);
  EXPECT_EQ(contains_or_error(a, b), error_shape);
  ClosestPoints<T> points{7, 7, 7, 7, 7};
  EXPECT_EQ(nearest_or_error(a, b, points), error_shape);
  EXPECT_EQ(boundary_distance_or_error(a, b, points), error_shape);
  EXPECT_EQ(points.distance, 7);
  Penetration<T> penetration{7, 7, 7};
  EXPECT_EQ(depth_or_error(a, b, penetration), error_shape);
  EXPECT_EQ(penetration.depth, 7);
  Impact<T> impact{7, 7, 7, 7, 7};
  EXPECT_EQ(cast_or_error(a, b, T(1), T(0), T(1), impact), error_shape);
  EXPECT_EQ(cast_or_error(a, b, T(0), T(0), T(1), impact), error_shape);
  const Turn<T> turn{1, 0, 2};
  T gap = 7;
  EXPECT_EQ(impact_time_or_error(a, turn, b, turn, T(1), impact, gap), error_shape);
  EXPECT_EQ(impact.t, 7);
  EXPECT_EQ(gap, 7);
  T number = 7;
  EXPECT_EQ(area_or_error(a, b, number), error_shape);
  EXPECT_EQ(iou_or_error(a, b, number), error_shape);
  EXPECT_EQ(ratio_or_error(Ratio::over_first, a, b, number), error_shape);
  EXPECT_EQ(ratio_or_error(Ratio::distance, a, b, number), error_shape);
  EXPECT_EQ(number, 7);
  EXPECT_EQ(signed_distance_or_error(a, b, number), error_shape);
  EXPECT_EQ(number, 7);
  constexpr T infinity = std::numeric_limits<T>::infinity();
  for (const T distance : {T(0), T(1), infinity, T(-1), -infinity}) {
    EXPECT_EQ(within_or_error(a, b, distance), error_shape);
  }
  NineIntersections nine{"untouch.."};
  EXPECT_EQ(de9im_or_error(a, b, nine), error_shape);
  EXPECT_STREQ(nine.at, "untouch..");
  if constexpr (detail::intersection::answers<A, B>) {
    SharedRegion<T> region{{7}};
    EXPECT_EQ(intersection_or_error(a, b, region), error_shape);
    EXPECT_EQ(region.at[0], 7);
  }
  CrossingPoints<T> crossing{};
  crossing.count = 7;
  EXPECT_EQ(crossings_or_error(a, b, crossing), error_shape);
  EXPECT_EQ(crossing.count, 7);
}

template <class A, class B>
void expect_nothing_in_common(const A& a, const B& b) {
  EXPECT_EQ(relation(a, b), Relation::disjoint);
  EXPECT_FALSE(contains(a, b));
  EXPECT_TRUE(std::isnan(nearest(a, b).distance));
  EXPECT_TRUE(std::isnan(nearest(a, b).bx));
  EXPECT_TRUE(std::isnan(boundary_distance(a, b).distance));
  EXPECT_TRUE(std::isnan(boundary_distance(a, b).ay));
  using T = ScalarOf<A>;
  EXPECT_TRUE(std::isnan(cast(a, b, T(1), T(1), T(9)).t));
  EXPECT_EQ(depth(a, b).depth, 0);
  EXPECT_EQ(depth(a, b).x, 0);
  EXPECT_EQ(area(a, b), 0);
  EXPECT_EQ(iou(a, b), 0);
  EXPECT_EQ(ratio(Ratio::generalized, a, b), 0);
  EXPECT_TRUE(std::isnan(signed_distance(a, b)));
  EXPECT_EQ(within(a, b, T(9)), Within::no);
  EXPECT_EQ(crossings(a, b).count, 0);
}

template <class A, class B>
void expect_the_rule() {
  const A &a = Samples<A>::valid, &bad_a = Samples<A>::invalid;
  const B &b = Samples<B>::valid, &bad_b = Samples<B>::invalid;
  // The same numbers would answer otherwise if they were taken for valid.
  EXPECT_TRUE(overlap(a, b));
  expect_overlap_to_refuse(bad_a, b);
  expect_overlap_to_refuse(a, bad_b);
  expect_overlap_to_refuse(bad_a, bad_b);
  expect_overlap_to_refuse(bad_b, a);
  if constexpr (EveryQueryAnswers<A, B>) {
    expect_checked_forms_to_refuse(bad_a, b);
    expect_checked_forms_to_refuse(a, bad_b);
    expect_checked_forms_to_refuse(bad_a, bad_b);
    expect_checked_forms_to_refuse(bad_b, a);
    expect_nothing_in_common(bad_a, b);
    expect_nothing_in_common(a, bad_b);
    expect_nothing_in_common(bad_a, bad_b);
    expect_nothing_in_common(bad_b, a);
  }
}

#define VESICA_TEST_PAIR(first, First, second, Second) \
  TEST(InvalidShapes, first##_##second) {              \
    expect_the_rule<First<double>, Second<double>>();  \
    expect_the_rule<First<float>, Second<float>>();    \
  }
#ifdef VESICA_TEST_EVERY_PAIR
VESICA_EACH_PAIR(VESICA_TEST_PAIR)
#else
// Every shape, and every query. All pairs are the whole core, compiled once more.
VESICA_TEST_PAIR(point, Point, segment, Segment)
VESICA_TEST_PAIR(circle, Circle, aabb, Aabb)
VESICA_TEST_PAIR(rect, Rect, ellipse, Ellipse)
VESICA_TEST_PAIR(capsule, Capsule, round_rect, RoundRect)
#endif
#undef VESICA_TEST_PAIR

template <class Shape>
void expect_measures_to_refuse(const Shape& invalid) {
  EXPECT_NE(check(invalid), 0);
  if constexpr (EveryQueryAnswers<Shape>) {
    double area = 7;
    EXPECT_EQ(shape_area_or_error(invalid, area), error_shape);
    EXPECT_EQ(area, 7);
    EXPECT_EQ(shape_area(invalid), 0);
    Aabb<double> box{7, 7, 7, 7};
    EXPECT_EQ(bounds(invalid, box), error_shape);
    EXPECT_EQ(sweep_bounds(invalid, 1.0, 1.0, 1.0, box), error_shape);
    EXPECT_EQ(box.min_x, 7);
  }
}

#define VESICA_TEST_SHAPE(name, Name) \
  TEST(InvalidShapes, name) { expect_measures_to_refuse(Samples<Name<double>>::invalid); }
VESICA_EACH_SHAPE(VESICA_TEST_SHAPE)
#undef VESICA_TEST_SHAPE

}  // namespace
