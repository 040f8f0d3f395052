// SPDX-License-Identifier: Apache-2.0
/// How rows and peers are run under Google Benchmark.
#pragma once

namespace vesica::bench {

/// Registers <row>/vesica, <row>/textbook and <row>/<peer> for every row. Rows must be sorted, and may not move after.
void register_benchmarks();

}  // namespace vesica::bench
