// SPDX-License-Identifier: Apache-2.0
/// The shortest case that still fails.
#pragma once

#include <functional>

#include "stress/query.hpp"

namespace stress {

/// Fields are set to 0 and 1, mantissas lose bits, exponents go to 0, both shapes move and scale together: whatever
/// keeps the case failing and makes its notation shorter, until nothing does or some seconds have passed.
Case shrunk(const Case& c, const std::function<bool(const Case&)>& fails);

}  // namespace stress
