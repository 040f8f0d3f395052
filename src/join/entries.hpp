// SPDX-License-Identifier: Apache-2.0
// The priority queue of a search for the nearest: a heap with the nearest entry first.
#pragma once

#include <cstdint>

namespace vesica::index {

/// A place to open or an item, with a lower bound of its distance: the bound in the upper 28 bits, the place or item in
/// the lower 36. So one comparison of integers puts the nearest first, and of equally near ones the lowest number.
using Entry = std::uint64_t;
inline constexpr int entry_bits = 36;
inline constexpr Entry which_mask = (Entry{1} << entry_bits) - 1;

inline Entry entry(double bound, std::uint64_t which) noexcept {
  return (__builtin_bit_cast(Entry, bound) & ~which_mask) | which;
}
inline double bound_of(Entry e) noexcept { return __builtin_bit_cast(double, e & ~which_mask); }

/// The least first.
template <int Most>
class Heap {
 public:
  bool empty() const noexcept { return count_ == 0; }
  bool full() const noexcept { return count_ == Most; }
  Entry least() const noexcept { return entry_[0]; }

  void push(Entry e) noexcept {
    int hole = count_++;
    for (int above = (hole - 1) / 2; hole > 0 && e < entry_[above]; above = (hole - 1) / 2) {
      entry_[hole] = entry_[above];
      hole = above;
    }
    entry_[hole] = e;
  }

  Entry pop() noexcept {
    const Entry top = entry_[0], last = entry_[--count_];
    int hole = 0;
    for (int child = 1; child < count_; child = 2 * hole + 1) {
      child += static_cast<int>(child + 1 < count_ && entry_[child + 1] < entry_[child]);
      if (last < entry_[child]) break;
      entry_[hole] = entry_[child];
      hole = child;
    }
    entry_[hole] = last;
    return top;
  }

 private:
  int count_ = 0;
  Entry entry_[Most];
};

}  // namespace vesica::index
