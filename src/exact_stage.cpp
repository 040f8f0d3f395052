// SPDX-License-Identifier: Apache-2.0
// The exact stage of relations and depths for every pair of forms.
#include "compiled_once.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_EXACT_STAGE(template, A, B)
VESICA_EACH_PAIR_OF_FORMS(VESICA_DEFINE)
#undef VESICA_DEFINE

}  // namespace vesica
