// SPDX-License-Identifier: Apache-2.0
/// Shapes as convex polygons, for drawing. They are in long double, which where it is longer than double still tells
/// points apart that are a double's last digit from each other.
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

/// The corners of a shape, as seen from `origin`. A round outline gets many corners, evenly spread; or, with a `focus`,
/// dense near the point of the outline next to it, so that the polygon is round there under any magnification.
void find_polygon(const struct shape* shape, struct spot origin, const struct spot* focus, struct polygon* out);

/// Cuts a polygon to the square with |x| <= half and |y| <= half.
void clip_polygon(struct polygon* polygon, long double half);

#endif
