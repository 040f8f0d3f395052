// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "methods/method.hpp"

namespace vesica::bench::methods {

/// Runs every trial on each method and keeps the outcomes.
void measure(const std::vector<Method*>& methods);

}  // namespace vesica::bench::methods
