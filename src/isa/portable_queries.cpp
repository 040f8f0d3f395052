// SPDX-License-Identifier: Apache-2.0
#include "kernels/query_loop.hpp"
#include "lanes/portable.hpp"

namespace vesica {

constinit const QueryTable kernels_portable_queries = make_query_table();

}  // namespace vesica
