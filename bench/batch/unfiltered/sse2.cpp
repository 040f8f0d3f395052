// SPDX-License-Identifier: Apache-2.0
#include "lanes/sse2.hpp"

#include "batch/unfiltered/loop.hpp"

namespace vesica::unfiltered {

constinit const Table sse2 = make_table("sse2");

}  // namespace vesica::unfiltered
