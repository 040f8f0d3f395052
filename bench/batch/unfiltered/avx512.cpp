// SPDX-License-Identifier: Apache-2.0
#include "lanes/avx512.hpp"

#include "batch/unfiltered/loop.hpp"

namespace vesica::unfiltered {

constinit const Table avx512 = make_table("avx512");

}  // namespace vesica::unfiltered
