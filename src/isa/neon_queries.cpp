// SPDX-License-Identifier: Apache-2.0
#include "kernels/query_loop.hpp"
#include "lanes/neon.hpp"

namespace vesica {

constinit const QueryTable kernels_neon_queries = make_query_table();

}  // namespace vesica
