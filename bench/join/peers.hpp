// SPDX-License-Identifier: Apache-2.0
/// Joins and windows by other libraries' trees over boxes, and a separating axis test in plain doubles for the pairs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace vesica::bench {

struct RectRecord {
  double cx, cy, ux, uy, hx, hy;
};
struct BoxRecord {
  double min_x, min_y, max_x, max_y;
};
struct PointRecord {
  double x, y;
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

/// The time and the hits of a peer.
struct PeerJoin {
  double build, join;  // seconds
  std::int64_t pairs;
};
struct PeerNearest {
  double seconds, sum;  // of the distances to the last of the k
};
struct Peer {
  std::string name;
  PeerJoin (*join)(const std::vector<RectRecord>& a, const std::vector<RectRecord>& b);
  /// Seconds for the hits of all windows by one tree over a, the least of several times.
  double (*windows)(const std::vector<RectRecord>& a, const std::vector<BoxRecord>& windows, int repeats);
  /// The same for the k boxes, or points, nearest to each of others, a share of these each time; none where the library
  /// has no such query.
  PeerNearest (*nearest)(const std::vector<BoxRecord>& boxes, const std::vector<PointRecord>& asked, unsigned k,
                         int repeats);
  PeerNearest (*nearest_points)(const std::vector<PointRecord>& points, const std::vector<PointRecord>& asked,
                                unsigned k, int repeats);
};

std::vector<Peer>& peers();

/// Processor time.
double seconds();

/// Uses a result, so that no compiler leaves out what made it.
void keep(std::int64_t result);

/// Seconds of the quickest of several calls.
template <class Call>
double quickest(int repeats, Call call) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const double begin = seconds();
    call();
    best = std::min(best, seconds() - begin);
  }
  return best;
}

}  // namespace vesica::bench
