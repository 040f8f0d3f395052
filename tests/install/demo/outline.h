// SPDX-License-Identifier: Apache-2.0
/// Shapes as SVG elements in a panel's pixels.
#ifndef OUTLINE_H
#define OUTLINE_H

#include <stdio.h>
#include <vesica.h>

#include "scene.h"

/// Where a panel's pixels are, and the square of the plane they show.
struct view {
  double left, top, size;              ///< pixels
  double half_x, half_y, half_extent;  ///< lower left corner and side, halved: the side of a huge pair has no double
};

/// The view of a pair, in the middle of a square of `size` pixels. Returns 0, or VESICA_E_RANGE for a pair that
/// reaches out of the finite numbers.
int32_t find_view(const struct pair* pair, double left, double top, double size, struct view* out);

/// Writes a shape as one element of the given class, and a dot where it would be too small to see.
void write_shape(FILE* file, const struct shape* shape, const struct view* view, const char* css_class);

#endif
