// SPDX-License-Identifier: Apache-2.0
#include "kernels/query_loop.hpp"
#include "lanes/sse2.hpp"

namespace vesica {

constinit const QueryTable kernels_sse2_queries = make_query_table();

}  // namespace vesica
