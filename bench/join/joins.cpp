// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <iterator>

#include "join/measure.hpp"
#include "join/rows.hpp"

namespace vesica::bench {

void report_join(const std::string& workload, std::int64_t n, int repeats) {
  const auto shapes_a = draw(workload, n, 1), shapes_b = draw(workload, n, 2);
  n = std::ssize(shapes_a);
  const Operand a({view(shapes_a)}), b({view(shapes_b)});
  const Times best = least(a, b, Scratch(n), repeats);
  const double each = 1e9 / (2.0 * static_cast<double>(n));
  std::printf(
      "%-16s %7.1f ns/shape, %.1f ns/pair: plan %.1f bin %.1f place %.1f finish %.1f rest %.1f | candidates %.1f decide %.1f (%.1f "
      "ns each) | %lld candidates %lld pairs, %.2f B/shape",
      workload.c_str(), best.total() * each,
      best.total() * 1e9 / static_cast<double>(std::max<std::int64_t>(1, best.pairs)), best.step[0] * each, best.step[1] * each, best.step[2] * each,
      best.step[3] * each, best.step[4] * each, best.candidates * each, (best.join - best.candidates) * each,
      best.decide_each(), static_cast<long long>(best.candidate_count), static_cast<long long>(best.pairs),
      static_cast<double>(best.bytes) / static_cast<double>(n));
  for (const Peer& peer : peers()) {
    const PeerJoin p = peer.join(shapes_a, shapes_b);
    std::printf(" | %s x%.1f (build x%.1f)", peer.name.c_str(), (p.build + p.join) / best.total(),
                2 * p.build / best.build());
  }
  std::printf("\n");
}

}  // namespace vesica::bench
