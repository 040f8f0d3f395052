// SPDX-License-Identifier: Apache-2.0
// The relations of src/isa/simd128_queries.cpp, for a module that answers nothing else.
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/simd128.hpp"
// clang-format on
#include "kernels/query_loop.hpp"

namespace vesica {

constinit const QueryTable kernels_simd128_queries = make_relation_table();

}  // namespace vesica
