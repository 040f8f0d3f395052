// SPDX-License-Identifier: Apache-2.0
// Queries about how the parts of two shapes meet. They have no batches.
#pragma once

#include "query.hpp"

namespace vesica::queries {

extern const Query de9im, intersection;

}  // namespace vesica::queries
