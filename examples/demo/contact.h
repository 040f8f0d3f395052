// SPDX-License-Identifier: Apache-2.0
/// Where two shapes only just meet, or only just miss each other.
#ifndef CONTACT_H
#define CONTACT_H

#include "polygon.h"

struct contact {
  double size;         ///< the library's distance where the shapes are apart, and its depth where they overlap
  struct spot origin;  ///< a point there, the origin of `place` and the polygons
  struct spot place;   ///< the middle of the gap, or of the overlap
  struct spot normal;  ///< the unit direction across it, from a to b
  long double width;   ///< its width from polygon to polygon, negative where these overlap
  struct polygon a, b;
};

/// Finds the contact of a pair whose shapes overlap or not, as told. Returns 0, or a VESICA_E_ code: VESICA_E_RANGE for
/// a gap so small beside the shapes that long double cannot draw it.
int32_t find_contact(const struct pair* pair, int overlap, struct contact* out);

#endif
