// SPDX-License-Identifier: Apache-2.0
#include "index/check.hpp"

#include <cstring>

#include "index/build.hpp"
#include "index/directory.hpp"

namespace vesica::index {

namespace {

bool frame_is_sound(const Frame& frame) noexcept {
  for (int a = 0; a < 2; ++a) {
    if (frame.p[a] < least_p || frame.p[a] > greatest_p) return false;
    if (frame.k[a] < -greatest_k || frame.k[a] > greatest_k) return false;
  }
  return true;
}

/// Items are numbers of shapes, also those of lanes that hold none.
bool items_are_sound(const Block& block, std::int64_t items) noexcept {
  const Leaf* leaf = leaves_of(block);
  std::uint32_t greatest = 0;
  for (std::int32_t l = 0; l < block.leaves; ++l) {
    for (const std::uint32_t item : leaf[l].item) greatest = item > greatest ? item : greatest;
  }
  return greatest < items;
}

}  // namespace

bool header_is_sound(const void* index, std::int64_t size) noexcept {
  if (size < static_cast<std::int64_t>(sizeof(Header))) return false;
  const Header& h = *static_cast<const Header*>(index);
  if (std::memcmp(h.magic, magic, sizeof magic) != 0) return false;
  if (h.byte_order != byte_order_mark || h.version != format_version) return false;
  if (h.items < 0 || h.items > most_items || h.placed < 0 || h.placed > h.items) return false;
  if (h.blocks < 0 || h.blocks > h.placed || h.size > size || h.size < static_cast<std::int64_t>(sizeof(Header)))
    return false;
  const std::int64_t directory = directory_bytes(h.blocks);
  if (h.size % alignment != 0 || h.places != h.size - directory || h.places < static_cast<std::int64_t>(sizeof(Header)))
    return false;
  return h.tree == h.places + round_up(h.blocks * 4);
}

bool is_sound(const void* index, std::int64_t size) noexcept {
  if (!header_is_sound(index, size)) return false;
  const View view(index);
  const Header& h = view.header();
  const auto* bytes = static_cast<const unsigned char*>(index);
  const auto* places = reinterpret_cast<const std::uint32_t*>(bytes + h.places);
  std::int64_t offset = sizeof(Header), placed = 0;
  for (std::int64_t i = 0; i < h.blocks; ++i) {
    if (static_cast<std::int64_t>(places[i]) * alignment != offset) return false;
    if (h.places - offset < static_cast<std::int64_t>(sizeof(Block))) return false;
    const Block& block = view.block(i);
    if (block.count < 1 || block.count > block_items) return false;
    if (block.leaves != (block.count + leaf_items - 1) / leaf_items) return false;
    if (h.places - offset < block_bytes(block.count) || !frame_is_sound(block.frame)) return false;
    if (!items_are_sound(block, h.items)) return false;
    placed += block.count;
    offset += block_bytes(block.count);
  }
  return offset == h.places && placed == h.placed && checksum(view) == h.checksum;
}

}  // namespace vesica::index
