// SPDX-License-Identifier: Apache-2.0
#include "kernels/queries.hpp"
#include "lanes/avx512.hpp"

namespace vesica {

constinit const QueryTable kernels_avx512_queries = make_query_table();

}  // namespace vesica
