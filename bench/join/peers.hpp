// SPDX-License-Identifier: Apache-2.0
/// Joins and windows by other libraries' trees over boxes, and a separating axis test in plain doubles for the pairs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vesica::bench {

struct RectRecord {
  double cx, cy, ux, uy, hx, hy;
};
struct BoxRecord {
  double min_x, min_y, max_x, max_y;
};

inline BoxRecord box_of(const RectRecord& r) {
  const double ax = r.ux < 0 ? -r.ux : r.ux, ay = r.uy < 0 ? -r.uy : r.uy;
  const double ex = ax * r.hx + ay * r.hy, ey = ay * r.hx + ax * r.hy;
  return {r.cx - ex, r.cy - ey, r.cx + ex, r.cy + ey};
}

/// Do they overlap, as one would write it? Ties go either way.
bool overlap_naively(const RectRecord& a, const RectRecord& b);

/// Order of shapes along a Hilbert curve: what peers' queries are sorted by.
std::vector<std::uint32_t> hilbert_order(const std::vector<RectRecord>& shapes);

/// What a peer took and found.
struct PeerJoin {
  double build, join;  // seconds
  std::int64_t pairs;
};
struct Peer {
  std::string name;
  PeerJoin (*join)(const std::vector<RectRecord>& a, const std::vector<RectRecord>& b);
  /// Seconds for the hits of all windows by one tree over a.
  double (*windows)(const std::vector<RectRecord>& a, const std::vector<BoxRecord>& windows, std::int64_t& hits);
};

std::vector<Peer>& peers();
double seconds();

}  // namespace vesica::bench
