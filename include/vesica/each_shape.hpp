// SPDX-License-Identifier: Apache-2.0
/// The list of shapes and the list of pairs. Tables, switches and declarations that cover every shape or every pair
/// are made from these two, so that a new shape is entered here once.
#pragma once

/// Shapes that no query but overlap answers yet, and their pairs: with every shape, the new kind second. There are
/// none. tests/kinds defines one, to check that every function refuses it.
#ifndef VESICA_EACH_SHAPE_WITHOUT_FORM
#define VESICA_EACH_SHAPE_WITHOUT_FORM(X)
#define VESICA_EACH_PAIR_WITHOUT_FORM(X)
#endif

/// X(shape, Shape): every shape that has a form (form/form.hpp), by its lower-case name and its type name.
#define VESICA_EACH_SHAPE_WITH_FORM(X) \
  X(point, Point) X(segment, Segment) X(circle, Circle) X(aabb, Aabb) X(rect, Rect) X(ellipse, Ellipse)

/// Every shape that is a core with a radius (form/inflated.hpp), except the circle.
#define VESICA_EACH_SHAPE_INFLATED(X) X(capsule, Capsule) X(round_rect, RoundRect)

/// Every shape, in the order of Kind.
#define VESICA_EACH_SHAPE(X) \
  VESICA_EACH_SHAPE_WITH_FORM(X) VESICA_EACH_SHAPE_INFLATED(X) VESICA_EACH_SHAPE_WITHOUT_FORM(X)

/// X(first, First, second, Second): every pair of shapes with a form (form/form.hpp) once, the shape of the lower Kind
/// first. A pair's function, file and test carry the two lower-case names in this order.
#define VESICA_EACH_PAIR_OF_FORMS(X)    \
  X(point, Point, point, Point)         \
  X(point, Point, segment, Segment)     \
  X(point, Point, circle, Circle)       \
  X(point, Point, aabb, Aabb)           \
  X(point, Point, rect, Rect)           \
  X(point, Point, ellipse, Ellipse)     \
  X(segment, Segment, segment, Segment) \
  X(segment, Segment, circle, Circle)   \
  X(segment, Segment, aabb, Aabb)       \
  X(segment, Segment, rect, Rect)       \
  X(segment, Segment, ellipse, Ellipse) \
  X(circle, Circle, circle, Circle)     \
  X(circle, Circle, aabb, Aabb)         \
  X(circle, Circle, rect, Rect)         \
  X(circle, Circle, ellipse, Ellipse)   \
  X(aabb, Aabb, aabb, Aabb)             \
  X(aabb, Aabb, rect, Rect)             \
  X(aabb, Aabb, ellipse, Ellipse)       \
  X(rect, Rect, rect, Rect)             \
  X(rect, Rect, ellipse, Ellipse)       \
  X(ellipse, Ellipse, ellipse, Ellipse)

/// The pairs with at least one of them.
#define VESICA_EACH_PAIR_INFLATED(X)         \
  X(point, Point, capsule, Capsule)          \
  X(segment, Segment, capsule, Capsule)      \
  X(circle, Circle, capsule, Capsule)        \
  X(aabb, Aabb, capsule, Capsule)            \
  X(rect, Rect, capsule, Capsule)            \
  X(ellipse, Ellipse, capsule, Capsule)      \
  X(capsule, Capsule, capsule, Capsule)      \
  X(point, Point, round_rect, RoundRect)     \
  X(segment, Segment, round_rect, RoundRect) \
  X(circle, Circle, round_rect, RoundRect)   \
  X(aabb, Aabb, round_rect, RoundRect)       \
  X(rect, Rect, round_rect, RoundRect)       \
  X(ellipse, Ellipse, round_rect, RoundRect) \
  X(capsule, Capsule, round_rect, RoundRect) \
  X(round_rect, RoundRect, round_rect, RoundRect)

/// Every pair of shapes.
#define VESICA_EACH_PAIR(X) VESICA_EACH_PAIR_OF_FORMS(X) VESICA_EACH_PAIR_INFLATED(X) VESICA_EACH_PAIR_WITHOUT_FORM(X)
