// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>

#include "join/measure.hpp"
#include "join/rows.hpp"

namespace vesica::bench {

namespace {

void report(const std::string& name, const std::vector<RectRecord>& shapes_a, const std::vector<RectRecord>& shapes_b,
            int repeats) {
  const std::int64_t n = std::ssize(shapes_a);
  const Operand a({view(shapes_a)}), b({view(shapes_b)});
  const Times best = least(a, b, Scratch(n), repeats);
  const double each = 1e9 / (2.0 * static_cast<double>(n));
  std::printf(
      "%-16s %7.1f ns/shape: plan %.1f bin %.1f place %.1f finish %.1f rest %.1f | candidates %.1f decide %.1f (%.1f "
      "ns each) | %lld candidates %lld pairs, %.2f B/shape",
      name.c_str(), best.total() * each, best.step[0] * each, best.step[1] * each, best.step[2] * each,
      best.step[3] * each, best.step[4] * each, best.candidates * each, (best.join - best.candidates) * each,
      best.decide_each(), static_cast<long long>(best.candidate_count), static_cast<long long>(best.pairs),
      static_cast<double>(best.bytes) / static_cast<double>(n));
  for (const Peer& peer : peers()) {
    PeerJoin p = peer.join(shapes_a, shapes_b);
    for (int i = 1; i < std::min(repeats, 3); ++i) {
      const PeerJoin again = peer.join(shapes_a, shapes_b);
      p = {std::min(p.build, again.build), std::min(p.join, again.join), again.pairs};
    }
    std::printf(" | %s x%.1f (build x%.1f)", peer.name.c_str(), (p.build + p.join) / best.total(),
                2 * p.build / best.build());
  }
  std::printf(", %.1f ns/pair\n", best.total() * 1e9 / static_cast<double>(best.pairs));
}

}  // namespace

void report_join(const std::string& workload, std::int64_t n, int repeats) {
  report(workload, draw(workload, n, 1), draw(workload, n, 2), repeats);
}

void report_identical(int repeats) {
  const std::vector<RectRecord> shapes(3000, {5, 5, 0.8, 0.6, 1, 2});
  report("identical", shapes, shapes, repeats);
}

}  // namespace vesica::bench
