// SPDX-License-Identifier: Apache-2.0
/// Answers of the named methods. Exact ones say yes or no; approximate ones may also leave a pair undecided.
#pragma once

#include <cstdint>

namespace vesica::methods {

/// Certainly disjoint, certainly overlapping, or out of the method's depth. Errors are the negative ones of shapes.hpp.
inline constexpr std::int32_t no = 0, yes = 1, uncertain = 2;

}  // namespace vesica::methods
