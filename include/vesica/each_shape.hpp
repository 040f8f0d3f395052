// SPDX-License-Identifier: Apache-2.0
/// The list of shapes and the list of pairs. Tables, switches and declarations that cover every shape or every pair
/// are made from these two, so that a new shape is entered here once.
#pragma once

/// X(shape, Shape): every shape by its lower-case name and its type name, in the order of Kind.
#define VESICA_EACH_SHAPE(X) \
  X(point, Point) X(segment, Segment) X(circle, Circle) X(aabb, Aabb) X(rect, Rect) X(ellipse, Ellipse)

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

/// The same for every pair: those, and the pairs of shapes without a form, of which there are none yet.
#define VESICA_EACH_PAIR(X) VESICA_EACH_PAIR_OF_FORMS(X)
