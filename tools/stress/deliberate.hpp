// SPDX-License-Identifier: Apache-2.0
/// Wrong answers put in on purpose, by which a test shows that the stress test finds and shrinks them.
#pragma once

#include <string>

#include "stress/call.hpp"

namespace stress {

/// Changes an answer of ask(), rarely.
using DeliberateFault = void (*)(Query query, Scalar scalar, const Pair& pair, const Environment& environment,
                                 Answer& answer);

/// The one in use, or null.
DeliberateFault deliberate_fault();

/// Changes what a batch of overlaps wrote, at the fault "lane_flipped": where circles touch, beyond the first vector.
bool flips_lane(Query query, const Pair& pair, std::size_t element);

/// Puts one in use; false for an unknown name.
bool use_deliberate_fault(const std::string& name);

/// Their names, separated by spaces.
std::string deliberate_fault_names();

}  // namespace stress
