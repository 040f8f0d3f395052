// SPDX-License-Identifier: Apache-2.0
#include "lanes/neon.hpp"

#include "batch/unfiltered/loop.hpp"

namespace vesica::unfiltered {

constinit const Table neon = make_table("neon");

}  // namespace vesica::unfiltered
