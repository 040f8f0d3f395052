// SPDX-License-Identifier: Apache-2.0
#include "peer.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace vesica::bench {
namespace {

constexpr std::size_t ellipse_vertices = 64;

std::size_t vertices_of(std::int32_t kind) { return kind == VESICA_ELLIPSE ? ellipse_vertices : 4; }

/// centre + s axis + t perp(axis).
Vertex vertex(const Numbers& shape, double s, double t) {
  return {shape[0] + s * shape[2] - t * shape[3], shape[1] + s * shape[3] + t * shape[2]};
}

Outline outline(std::int32_t kind, const Numbers& shape) {
  const double x = shape[4], y = shape[5];
  if (kind == VESICA_RECT)
    return {vertex(shape, -x, -y), vertex(shape, x, -y), vertex(shape, x, y), vertex(shape, -x, y)};
  Outline polygon;
  for (std::size_t i = 0; i < ellipse_vertices; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / ellipse_vertices;
    polygon.push_back(vertex(shape, x * std::cos(angle), y * std::sin(angle)));
  }
  return polygon;
}

}  // namespace

std::vector<Peer>& peers() {
  static std::vector<Peer> all;
  return all;
}

bool add_peer(std::string name, std::size_t most_vertices, std::unique_ptr<NativePairs> (*make)()) {
  peers().push_back({std::move(name), most_vertices, make});
  return true;
}

bool can_answer(const Peer& peer, const Row& row) {
  return std::string_view(row.scalar) == "f64" && row.kind_a >= VESICA_RECT && row.kind_b >= VESICA_RECT &&
         !is_exact(row.workload) && vertices_of(row.kind_b) <= peer.most_vertices;
}

PeerPairs::PeerPairs(const Peer& peer, const Row& row, const Pool& pool)
    : native_(peer.make()), size_(vertices_of(row.kind_b) > 4 ? 1024 : 4096) {
  for (std::size_t i = 0; i < size_; ++i) {
    native_->add(outline(row.kind_a, pool.a[i]), outline(row.kind_b, pool.b[i]));
    const bool truth = vesica_overlap_f64(row.kind_a, pool.a[i].data(), row.kind_b, pool.b[i].data()) == 1;
    const std::array<std::size_t, 1> index{i};
    wrong_ += (native_->hits(index) == 1) != truth;
  }
}

void PeerPairs::draw(Random& random) {
  for (std::size_t& index : drawn_) index = random.index(size_);
}

}  // namespace vesica::bench
