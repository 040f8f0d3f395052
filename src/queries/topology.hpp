// SPDX-License-Identifier: Apache-2.0
// Queries about how the parts of two shapes meet. Their results are no numbers of a batch.
#pragma once

#include "query.hpp"

namespace vesica::queries {

extern const Query de9im, intersection;

}  // namespace vesica::queries
