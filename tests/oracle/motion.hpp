// SPDX-License-Identifier: Apache-2.0
/// Contact of moving shapes, in exact integers, by other formulas than the library's.
#pragma once

namespace oracle {

/// b's place after the time high + low at a velocity, the product being exact; an infinite time leads beyond all shapes.
struct Way {
  double vx, vy, high, low;
};

/// Do two valid shapes share a point at any time while b goes all of the way? Otherwise as overlap() in oracle.hpp.
bool meets(int kind_a, const double* a, int kind_b, const double* b, const Way& way);

}  // namespace oracle
