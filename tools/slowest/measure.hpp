// SPDX-License-Identifier: Apache-2.0
/// How long a call takes.
#pragma once

#include "stress/query.hpp"

namespace slowest {

/// The least time of `calls` calls, in microseconds. Other work on the machine only adds to a time.
double microseconds(const stress::Case& c, int calls);

/// The same of a fixed piece of work that no mend changes: the square of a number of 32 limbs, 1,024 multiplications of
/// 64 bits, 0.8 to 1 us. Costs in this unit can be compared between machines.
double yardstick_microseconds();

}  // namespace slowest
