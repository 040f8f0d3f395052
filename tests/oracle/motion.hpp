// SPDX-License-Identifier: Apache-2.0
/// Contact of moving shapes, in exact integers, by other formulas than the library's.
#pragma once

namespace oracle {

/// From b's place to that after a time at a velocity, the product being exact. An infinite time leads beyond all
/// shapes. With less > 0 it ends before that, by 2^-less of the time.
struct Way {
  double vx, vy, time;
  int less = 0;
};

/// Do two valid shapes share a point at any time while b goes all of the way? Otherwise as overlap() in oracle.hpp.
bool meets(int kind_a, const double* a, int kind_b, const double* b, const Way& way);

}  // namespace oracle
