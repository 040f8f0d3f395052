// SPDX-License-Identifier: Apache-2.0
#include "lanes/avx2.hpp"

#include "batch/unfiltered/loop.hpp"

namespace vesica::unfiltered {

constinit const Table avx2 = make_table("avx2");

}  // namespace vesica::unfiltered
