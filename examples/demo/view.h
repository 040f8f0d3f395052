// SPDX-License-Identifier: Apache-2.0
/// From the plane to the pixels of a panel.
#ifndef VIEW_H
#define VIEW_H

#include <stdio.h>

#include "polygon.h"

enum { drawing = 136 };  ///< pixels

struct view {
  struct spot origin;  ///< a point of the plane
  double x, y;         ///< the pixel it is drawn at
  long double scale;   ///< pixels a unit of the plane
};

/// The view of a pair, in the middle of a square of `drawing` pixels. Returns 0, or VESICA_E_RANGE for a pair that
/// reaches out of the finite numbers.
int32_t find_view(const struct pair* pair, double left, double top, struct view* out);

/// Writes a polygon, whose corners are seen from view->origin, as one element of the given class: a dot where it would
/// be too small to see.
void write_polygon(FILE* file, const struct polygon* polygon, const struct view* view, const char* css_class);

/// Writes a shape in the same way.
void write_shape(FILE* file, const struct shape* shape, const struct view* view, const char* css_class);

#endif
