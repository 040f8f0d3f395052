// SPDX-License-Identifier: Apache-2.0
/// Memory between two pages that may not be touched: an access one byte outside ends the program.
#pragma once

#include <cstddef>

namespace batch_tests {

/// Which guard page the bytes are to lie against.
enum class Edge { before, after };

class GuardedMemory {
 public:
  /// Room for `capacity` bytes, a multiple of the size of a page.
  explicit GuardedMemory(std::size_t capacity = 64 * 1024);
  ~GuardedMemory();
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  /// `size` bytes, at most the capacity, right behind the one guard page or right in front of the other. Their content
  /// is whatever the last use left.
  std::byte* place(std::size_t size, Edge edge);

 private:
  std::size_t capacity_, page_;
  std::byte* mapping_;
};

}  // namespace batch_tests
