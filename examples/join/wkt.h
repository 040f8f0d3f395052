// SPDX-License-Identifier: Apache-2.0
/// Well-known text, as far as its shapes are this library's.
#ifndef WKT_H
#define WKT_H

#include "scene.h"

/// POINT, LINESTRING of two positions, POLYGON of one ring that is a box. Returns 1, or 0 with the reason in `fault`.
int parse_wkt(const char* text, struct shape* shape, struct fault* fault);

#endif
