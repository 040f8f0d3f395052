// SPDX-License-Identifier: Apache-2.0
#include "index/directory.hpp"

#include <cstring>

#include "index/frame.hpp"

namespace vesica::index {

namespace {

void box_of(const Block& block, double (&box)[4]) noexcept {
  const std::int64_t q[4] = {block.box.min_x, block.box.min_y, block.box.max_x + 1, block.box.max_y + 1};
  for (int i = 0; i < 4; ++i) {
    const Frame& f = block.frame;
    // Exact, or infinite.
    box[i] = static_cast<double>(q[i] + f.k[i & 1]) * power_of_two(f.p[i & 1]);
  }
}

void set_child(Node& node, std::int64_t child, const double (&box)[4]) noexcept {
  node.min_x[child] = box[0];
  node.min_y[child] = box[1];
  node.max_x[child] = box[2];
  node.max_y[child] = box[3];
}

void around(const Node& node, double (&box)[4]) noexcept {
  constexpr double infinity = __builtin_inf();
  box[0] = box[1] = infinity;
  box[2] = box[3] = -infinity;
  for (int i = 0; i < node_children; ++i) {
    box[0] = node.min_x[i] < box[0] ? node.min_x[i] : box[0];
    box[1] = node.min_y[i] < box[1] ? node.min_y[i] : box[1];
    box[2] = node.max_x[i] > box[2] ? node.max_x[i] : box[2];
    box[3] = node.max_y[i] > box[3] ? node.max_y[i] : box[3];
  }
}

void write_places(unsigned char* index, const WrittenBlocks& written) noexcept {
  auto* places = reinterpret_cast<std::uint32_t*>(index + written.end);
  std::memset(places, 0, static_cast<std::size_t>(round_up(written.blocks * 4)));
  std::int64_t at_byte = sizeof(Header);
  for (std::int64_t b = 0; b < written.blocks; ++b) {
    places[b] = static_cast<std::uint32_t>(at_byte / alignment);
    at_byte += block_bytes(reinterpret_cast<const Block*>(index + at_byte)->count);
  }
}

/// Level by level; writes the bounds of everything to the header.
void write_tree(unsigned char* index, Header& header) noexcept {
  constexpr double infinity = __builtin_inf();
  const double nothing[4] = {infinity, infinity, -infinity, -infinity};
  const View view(index);
  auto* node = reinterpret_cast<Node*>(index + header.tree);
  double box[4];
  std::memcpy(header.bounds, nothing, sizeof nothing);
  const Node* below = nullptr;
  for (std::int64_t children = header.blocks; children > 0;) {
    const std::int64_t nodes = nodes_above(children);
    for (std::int64_t c = 0; c < nodes * node_children; ++c) {
      std::memcpy(box, nothing, sizeof nothing);
      if (c < children && below == nullptr) box_of(view.block(c), box);
      if (c < children && below != nullptr) around(below[c], box);
      set_child(node[c / node_children], c % node_children, box);
    }
    if (nodes == 1) {
      around(node[0], box);
      std::memcpy(header.bounds, box, sizeof box);
      break;
    }
    below = node;
    node += nodes;
    children = nodes;
  }
}

/// Sums that every 8 bytes change in a way of their own.
class Sum {
 public:
  void add(const void* data, std::int64_t bytes) noexcept {
    const auto* at = static_cast<const unsigned char*>(data);
    for (std::int64_t i = 0; i + 8 <= bytes; i += 8) {
      std::uint64_t word;
      std::memcpy(&word, at + i, 8);
      sum_ = (sum_ ^ word) * 0x9e3779b97f4a7c15u;
      sum_ ^= sum_ >> 29;
    }
  }
  std::uint64_t value() const noexcept { return sum_; }

 private:
  std::uint64_t sum_ = 0x243f6a8885a308d3u;
};

}  // namespace

void write_directory(void* index, const WrittenBlocks& written) noexcept {
  auto* bytes = static_cast<unsigned char*>(index);
  write_places(bytes, written);
  Header header{};
  std::memcpy(header.magic, magic, sizeof magic);
  header.byte_order = byte_order_mark;
  header.version = format_version;
  header.items = written.items;
  header.placed = written.placed;
  header.blocks = written.blocks;
  header.places = written.end;
  header.tree = written.end + round_up(written.blocks * 4);
  header.size = header.tree + tree_nodes(written.blocks) * static_cast<std::int64_t>(sizeof(Node));
  // A View reads the header: the tree is written through one, and the checksum is of all but itself.
  std::memcpy(index, &header, sizeof header);
  write_tree(bytes, header);
  std::memcpy(index, &header, sizeof header);
  header.checksum = checksum(View(index));
  std::memcpy(index, &header, sizeof header);
}

std::uint64_t checksum(const View& view) noexcept {
  Sum sum;
  Header header = view.header();
  header.checksum = 0;
  sum.add(&header, sizeof header);
  for (std::int64_t i = 0; i < view.blocks(); ++i) {
    const Block& block = view.block(i);
    sum.add(&block, static_cast<std::int64_t>(sizeof block) + leaf_row(block.leaves) * 8);
  }
  const auto* bytes = reinterpret_cast<const unsigned char*>(&view.header());
  sum.add(bytes + header.places, header.size - header.places);
  return sum.value();
}

}  // namespace vesica::index
