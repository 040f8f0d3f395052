// SPDX-License-Identifier: Apache-2.0
/// The truth the library is tested against: overlap and relation in exact integers, by other formulas than the
/// library's.
#pragma once

namespace oracle {

/// Do two valid shapes share a point? Kinds and flat numbers as in vesica.h, either order of kinds, every finite
/// double, zero sizes included. Slow (microseconds, milliseconds at extreme exponents), allocates, exact.
/// The shapes must be valid: nothing is checked.
bool overlap(int kind_a, const double* a, int kind_b, const double* b);

/// The relation of a to b, as a code of vesica.h; otherwise as overlap. Not of an ellipse with an area and a shape with
/// a core and a radius.
int relation(int kind_a, const double* a, int kind_b, const double* b);

}  // namespace oracle
