// SPDX-License-Identifier: Apache-2.0
/// Other libraries on the same pairs. A peer sees outlines: a rectangle as its corners, an ellipse as an inscribed
/// 64-gon. Its own shapes are built beforehand; only its test is timed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "row.hpp"

namespace vesica::bench {

struct Vertex {
  double x, y;
};

/// Counter-clockwise, the first vertex not repeated.
using Outline = std::vector<Vertex>;

/// Pairs in a peer's own types.
class NativePairs {
 public:
  virtual ~NativePairs() = default;
  virtual void add(const Outline& a, const Outline& b) = 0;
  /// How many pairs with the given indices overlap.
  virtual std::int64_t hits(std::span<const std::size_t> indices) = 0;
};

struct Peer {
  std::string name;
  std::size_t most_vertices;
  std::unique_ptr<NativePairs> (*make)();
};

/// The peers that were built in.
std::vector<Peer>& peers();
bool add_peer(std::string name, std::size_t most_vertices, std::unique_ptr<NativePairs> (*make)());

/// Rows in double of rectangles and ellipses, but not those of the exact stage, within the peer's limit of vertices.
bool can_answer(const Peer& peer, const Row& row);

/// A peer's share of a row's pool. Pairs are drawn in a fresh order for each pass, but not copied into one buffer: what
/// most peers need for a shape lies behind pointers.
class PeerPairs {
 public:
  /// Enough that a pass's cost is near the average where a peer rejects most pairs in no time and the rest slowly.
  static constexpr std::size_t tests_per_pass = 256;

  PeerPairs(const Peer& peer, const Row& row, const Pool& pool);
  void draw(Random& random);
  std::int64_t hits() { return native_->hits(drawn_); }
  /// On how many of the pairs the peer and the library differ.
  std::int64_t wrong() const { return wrong_; }
  std::int64_t size() const { return static_cast<std::int64_t>(size_); }

 private:
  std::unique_ptr<NativePairs> native_;
  std::size_t size_;
  std::array<std::size_t, tests_per_pass> drawn_{};
  std::int64_t wrong_ = 0;
};

}  // namespace vesica::bench
