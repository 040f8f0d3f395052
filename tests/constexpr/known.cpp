// SPDX-License-Identifier: Apache-2.0
// The predicates in constant expressions, where a compiler refuses undefined behaviour. Every pair of kinds, touching
// and a last place apart; invalid shapes; exponents at the ends of the range.
#include <limits>
#include <vesica/bounds.hpp>
#include <vesica/construct.hpp>
#include <vesica/overlap.hpp>
#include <vesica/relation.hpp>

namespace {

using namespace vesica;

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
constexpr double after_5 = 0x1.4000000000001p2, before_5 = 0x1.3ffffffffffffp2;

/// Shapes whose only point within 5 of the origin is (3, 4).
constexpr Point<double> point{3, 4};
constexpr Segment<double> segment{3, 4, 9, 9};
constexpr Aabb<double> aabb{3, 4, 9, 9};
constexpr Rect<double> rect{6, 8, 3, 4, 1, 0.5};
constexpr Ellipse<double> ellipse{6, 8, 3, 4, 1, 0.25};
constexpr Circle<double> circle{6, 8, 5};

template <template <class> class Round, class... Numbers>
constexpr bool touches_all(Numbers... sizes) {
  const Round<double> round{0, 0, sizes...};
  return overlap(round, point) && overlap(round, segment) && overlap(round, aabb) && overlap(round, rect) &&
         overlap(round, ellipse) && overlap(round, circle) && overlap(circle, round);
}
template <template <class> class Round, class... Numbers>
constexpr bool misses_all(Numbers... sizes) {
  const Round<double> round{0, 0, sizes...};
  return !overlap(round, point) && !overlap(round, segment) && !overlap(round, aabb) && !overlap(round, rect) &&
         !overlap(round, ellipse) && !overlap(round, circle) && !overlap(circle, round);
}
static_assert(touches_all<Circle>(5.0) && touches_all<Circle>(after_5) && misses_all<Circle>(before_5));
static_assert(touches_all<Ellipse>(1.0, 0.0, 5.0, 5.0) && misses_all<Ellipse>(1.0, 0.0, before_5, before_5));
static_assert(touches_all<Ellipse>(0.0, 5.0, 1.0, 1.0));

/// A corner on a corner, and a last place apart.
constexpr Rect<double> corner{0, 0, 1, 0, 3, 4}, too_small{0, 0, 1, 0, 0x1.7ffffffffffffp1, 4};
static_assert(overlap(corner, point) && overlap(corner, segment) && overlap(corner, aabb) && overlap(corner, corner));
static_assert(!overlap(too_small, point) && !overlap(too_small, segment) && !overlap(too_small, aabb));
static_assert(overlap(aabb, Aabb<double>{0, 0, 3, 4}) && overlap(segment, Segment<double>{0, 0, 3, 4}));
static_assert(overlap(point, segment) && overlap(aabb, segment) && overlap(aabb, rect) && overlap(rect, ellipse));
static_assert(overlap(segment, rect) && overlap(segment, ellipse) && overlap(aabb, ellipse) && overlap(point, aabb));
static_assert(overlap(point, point) && !overlap(point, Point<double>{4, 3}));

static_assert(relation(Circle<double>{0, 0, 5}, Circle<double>{1, 0, 4}) == Relation::contains_touch);
static_assert(relation(Circle<double>{0, 0, 5}, circle) == Relation::touch);
static_assert(relation(Ellipse<double>{0, 0, 1, 0, 3, 2}, Ellipse<double>{0, 0, 2, 0, 1, 0.5}) == Relation::contains);
static_assert(relation(Ellipse<double>{0, 0, 1, 0, 3, 2}, Ellipse<double>{0, 0, 0, 2, 1, 1.5}) == Relation::equal);
static_assert(relation(aabb, rect) == Relation::cross && relation(segment, aabb) == Relation::inside_touch);
static_assert(relation(point, point) == Relation::equal && relation(rect, point) == Relation::contains_touch);
static_assert(contains(rect, ellipse) && !contains(ellipse, rect) && contains(circle, ellipse));

/// Exponents that are wildly unlike, and the ends of the range.
static_assert(!overlap(Ellipse<double>{0, 0, 1, 0, 0x1p-500, 1}, Ellipse<double>{1, 0, 0, 1, 1, 0x1p-500}));
static_assert(overlap(Rect<double>{0, 0, tiny, 0, huge, 1}, Point<double>{0, tiny}));
static_assert(!overlap(Circle<double>{-huge, 0, 1}, Circle<double>{huge, 0, huge}));
static_assert(overlap(Circle<double>{-huge, 0, huge}, Circle<double>{huge, 0, huge}));

/// Invalid shapes are errors in constant expressions too.
static_assert(overlap_or_error(Circle<double>{0, 0, inf}, point) == error_shape);
static_assert(overlap_or_error(Ellipse<double>{0, nan, 1, 0, 1, 1}, ellipse) == error_shape);
static_assert(relation_or_error(Rect<double>{0, 0, 0, 0, 1, 1}, ellipse) == error_shape);
static_assert(contains_or_error(circle, Circle<double>{0, 0, -1}) == error_shape);
static_assert(check(Aabb<double>{1, 0, 0, 0}) == error_inverted && check(Point<double>{inf, 0}) == error_not_finite);
static_assert(!overlap(Aabb<double>{1, 0, 0, 0}, aabb));

static_assert(overlap(Circle<float>{0, 0, 5}, Ellipse<float>{6, 8, 3, 4, 1, 0.25f}));
static_assert(relation(Circle<float>{0, 0, 0.1f}, Circle<float>{0.1f, 0, 0.1f}) == Relation::cross);

/// Boxes round outward; without one, nothing is written.
template <class T>
constexpr bool has(int error, const Aabb<T>& box, T min_x, T min_y, T max_x, T max_y) {
  return error == 0 && box.min_x == min_x && box.min_y == min_y && box.max_x == max_x && box.max_y == max_y;
}
template <class T, class Shape>
constexpr bool has_box(const Shape& shape, T min_x, T min_y, T max_x, T max_y) {
  Aabb<T> box{};
  const int error = bounds(shape, box);
  return has(error, box, min_x, min_y, max_x, max_y);
}
template <class Shape>
constexpr int error_of_box(const Shape& shape) {
  Aabb<double> box{1, 2, 3, 4};
  const int error = bounds(shape, box);
  return has(0, box, 1.0, 2.0, 3.0, 4.0) ? error : 0;
}
constexpr double root_2 = 0x1.6a09e667f3bcdp0, after_1 = 0x1.0000000000001p0;  // the former rounded up
static_assert(has_box(Ellipse<double>{0, 0, 1, 1, 1, 1}, -root_2, -root_2, root_2, root_2));
static_assert(has_box(Ellipse<float>{0, 0, 1, 1, 1, 1}, -0x1.6a09e8p0f, -0x1.6a09e8p0f, 0x1.6a09e8p0f, 0x1.6a09e8p0f));
static_assert(has_box(Ellipse<double>{0, 0, 3, 4, 1, 1}, -5.0, -5.0, 5.0, 5.0));
static_assert(has_box(Rect<double>{0, 0, 3, 4, 2, 1}, -10.0, -11.0, 10.0, 11.0));
static_assert(has_box(Circle<double>{1, 0, tiny}, 0x1.fffffffffffffp-1, -tiny, after_1, tiny));
static_assert(has_box(Segment<double>{3, -4, 1, 5}, 1.0, -4.0, 3.0, 5.0));
static_assert(error_of_box(Circle<double>{0, 0, -1}) == error_shape);
static_assert(error_of_box(Circle<double>{nan, 0, 1}) == error_shape);
static_assert(error_of_box(Circle<double>{huge, 0, huge}) == error_range);
static_assert(error_of_box(Ellipse<double>{0, 0, huge, huge, 1, 1}) == error_range);

constexpr bool makes_boxes() {
  Aabb<double> box{};
  return has(aabb_from_corners(3.0, 1.0, -2.0, 5.0, box), box, -2.0, 1.0, 3.0, 5.0) &&
         aabb_from_corners(inf, 0.0, 0.0, 0.0, box) == error_not_finite;
}
static_assert(makes_boxes());
constexpr bool makes_ellipses() {
  Ellipse<double> e{};
  return ellipse_from_radius_vector(1.0, 2.0, 3.0, 4.0, 0.5, e) == 0 && e.cx == 1 && e.uy == 4 && e.a == 1 &&
         e.b == 0.5 && ellipse_from_radius_vector(1.0, 2.0, 3.0, 4.0, -0.5, e) == error_negative_size;
}
static_assert(makes_ellipses());
constexpr bool makes_capsules() {
  Capsule<double> c{};
  return capsule_from_width(1.0, 2.0, 3.0, 4.0, 0.5, c) == 0 && c.x0 == 1 && c.y1 == 4 && c.r == 0.25 &&
         capsule_from_width(1.0, 2.0, 3.0, 4.0, 3 * tiny, c) == 0 && c.r == 2 * tiny &&
         capsule_from_width(1.0, 2.0, 3.0, 4.0, -0.5, c) == error_negative_size;
}
static_assert(makes_capsules());

}  // namespace
