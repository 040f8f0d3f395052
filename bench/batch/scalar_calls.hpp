// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "batch/spec.hpp"

namespace vesica::bench {

/// Nanoseconds a pair of the scalar function of the row's pair and scalar, called through the shared library on fresh
/// mixed pairs: the typed one, where there is one. Measured once a pair and scalar.
double scalar_time(const Spec& spec);

}  // namespace vesica::bench
