// SPDX-License-Identifier: Apache-2.0
/// Well-known binary: the geometries of wkt.h as ISO and PostGIS write them. Z, M and a reference system are read over.
#ifndef WKB_H
#define WKB_H

#include "geometry.h"

/// Reads a geometry, and takes it as settle_geometry() does. Returns 1, or 0 with the reason in `fault`.
int parse_wkb(const unsigned char* bytes, int64_t count, struct vertices* vertices, int32_t* kind, double numbers[4],
              char fault[geometry_fault_room]);

#endif
