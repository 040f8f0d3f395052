// SPDX-License-Identifier: Apache-2.0
/// GEOS' template STR tree, by its C++ interface.
#include <geos/geom/Envelope.h>
#include <geos/index/strtree/TemplateSTRtree.h>

#include "join/peers.hpp"

namespace vesica::bench {
namespace {

using geos::geom::Envelope;
using Tree = geos::index::strtree::TemplateSTRtree<std::uint32_t>;

Envelope box(const BoxRecord& b) { return {b.min_x, b.max_x, b.min_y, b.max_y}; }

void fill(Tree& tree, const std::vector<RectRecord>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) tree.insert(box(box_of(shapes[i])), static_cast<std::uint32_t>(i));
  tree.query(Envelope(0, 0, 0, 0), [](std::uint32_t) {});  // it is built by its first query
}

PeerJoin join(const std::vector<RectRecord>& a, const std::vector<RectRecord>& b) {
  const double begin = seconds();
  Tree tree(10, b.size());
  fill(tree, b);
  const double built = seconds();
  std::int64_t pairs = 0;
  for (const std::uint32_t i : hilbert_order(a)) {
    tree.query(box(box_of(a[i])), [&](std::uint32_t j) { pairs += overlap_naively(a[i], b[j]); });
  }
  return {built - begin, seconds() - built, pairs};
}

double windows(const std::vector<RectRecord>& a, const std::vector<BoxRecord>& windows, int repeats) {
  Tree tree(10, a.size());
  fill(tree, a);
  return quickest(repeats, [&] {
    std::int64_t hits = 0;
    for (const BoxRecord& w : windows) tree.query(box(w), [&](std::uint32_t) { ++hits; });
    keep(hits);
  });
}

[[maybe_unused]] const bool listed = (peers().push_back({"GEOS", join, windows, nullptr, nullptr}), true);

}  // namespace
}  // namespace vesica::bench
