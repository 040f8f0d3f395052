// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/steady.hpp"
// clang-format on
#include "kernels/cast_calls.hpp"

namespace vesica {

constinit const CallTable kernels_avx512_calls = make_calls();

}  // namespace vesica
