// SPDX-License-Identifier: Apache-2.0
/// Well-known text: POINT, LINESTRING, POLYGON, and the last two with MULTI.
#ifndef WKT_H
#define WKT_H

#include "shapes.h"

/// Two positions of a line are a segment, and a polygon that is a box along the axes is an AABB. All others have their
/// positions in `vertices`. Returns 1, or 0 with the reason in `fault`.
int parse_wkt(const char* text, struct shape* shape, struct vertices* vertices, struct fault* fault);

#endif
