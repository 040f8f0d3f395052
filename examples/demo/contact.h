// SPDX-License-Identifier: Apache-2.0
/// The contact: the place where two shapes only just overlap, or only just miss.
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

/// Finds the contact of a pair; `overlap` says whether its shapes overlap. Returns 0, or a VESICA_E_ code:
/// VESICA_E_RANGE if the gap is too small beside the shapes to be drawn in long double.
int32_t find_contact(const struct pair* pair, int overlap, struct contact* out);

#endif
