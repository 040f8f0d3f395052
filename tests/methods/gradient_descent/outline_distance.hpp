// SPDX-License-Identifier: Apache-2.0
/// Distance of outlines by brute force: the tests' reference, sharing nothing with the library.
#pragma once

#include <vesica.h>

namespace outline_distance {

/// Between disjoint solid ellipses: the largest gap between parallel lines that separate them, over all directions.
double of_disjoint(const vesica_ellipse_f64& a, const vesica_ellipse_f64& b);

/// Between the outlines of one ellipse inside another: the least distance of parallel tangents on the same side, over
/// all directions. Negative when the first is not inside the second.
double of_nested(const vesica_ellipse_f64& inner, const vesica_ellipse_f64& outer);

}  // namespace outline_distance
