// SPDX-License-Identifier: Apache-2.0
// The exact stage of overlap for every pair.
#include "compiled_once.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_EXACT_OVERLAP(template, A, B)
VESICA_EACH_PAIR(VESICA_DEFINE)
#undef VESICA_DEFINE

}  // namespace vesica
