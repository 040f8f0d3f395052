// SPDX-License-Identifier: Apache-2.0
#include "kernels/query_loop.hpp"
#include "lanes/avx2.hpp"

namespace vesica {

constinit const QueryTable kernels_avx2_queries = make_query_table();

}  // namespace vesica
