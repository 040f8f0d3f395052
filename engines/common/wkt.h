// SPDX-License-Identifier: Apache-2.0
/// Well-known text: POINT, LINESTRING, POLYGON, and these with MULTI. Z and M are read over.
#ifndef WKT_H
#define WKT_H

#include "geometry.h"

/// Reads a geometry, and takes it as settle_geometry() does. Numbers follow the locale. Returns 1, or 0 with the reason
/// in `fault`.
int parse_wkt(const char* text, struct vertices* vertices, int32_t* kind, double numbers[4],
              char fault[geometry_fault_room]);

#endif
