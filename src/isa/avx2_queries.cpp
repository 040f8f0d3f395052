// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/avx2.hpp"
// clang-format on
#include "kernels/query_loop.hpp"
// After the loop, whose functions it uses.
#include "kernels/box_kernels.hpp"

namespace vesica {

constinit const BoxKernels kernels_avx2_boxes{find_bounds<Doubles>, find_corners<Doubles>};
constinit const QueryTable kernels_avx2_queries = make_query_table();

}  // namespace vesica
