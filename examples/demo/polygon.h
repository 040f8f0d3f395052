// SPDX-License-Identifier: Apache-2.0
/// Shapes as convex polygons, for drawing. Corners are in long double: insets show gaps as small as the last digit of
/// a double.
#ifndef POLYGON_H
#define POLYGON_H

#include "scene.h"

struct spot {
  long double x, y;
};

enum { polygon_capacity = 512 };

struct polygon {
  int count;
  struct spot at[polygon_capacity];  ///< counter-clockwise
};

/// The corners of a shape, relative to `origin`. A round outline gets many corners, evenly spread. With a `focus` they
/// are dense near the focus instead, so that the polygon looks round there under any magnification.
void find_polygon(const struct shape* shape, struct spot origin, const struct spot* focus, struct polygon* out);

/// Cuts a polygon to the square with |x| <= half and |y| <= half.
void clip_polygon(struct polygon* polygon, long double half);

#endif
