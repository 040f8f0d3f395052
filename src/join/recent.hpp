// SPDX-License-Identifier: Apache-2.0
// A cache of records that were fetched recently. A shape has candidates with several blocks, and its record is at a
// random place in the caller's memory: to fetch it again would cost as much as the first time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "index/shapes.hpp"

namespace vesica::index {

/// Direct-mapped: each key has one place, where the next record with that place replaces the last. Half a megabyte, as
/// it shares the second-level cache with the blocks that are joined.
class Recent {
 public:
  /// Two sets have keys of their own: of the second, items with the highest bit.
  static constexpr std::uint32_t of_second = std::uint32_t{1} << 31;

  /// To be called before the first use: scratch holds anything.
  void begin() noexcept { std::memset(key_, 0xff, sizeof key_); }

  /// Takes places for n items and fetches the records that are not there. Of two with the same place the later has it.
  template <std::size_t Bytes, class From>
  void fetch(From& from, const std::uint32_t* item, int n, std::uint32_t mark) noexcept {
    int missing = 0;
    for (int i = 0; i < n; ++i) {
      const std::uint32_t key = item[i] | mark, place = place_of(key);
      missing_[missing] = item[i];
      missing += static_cast<int>(key_[place] != key);
      key_[place] = key;
    }
    for (int i = 0; i < missing; ++i) {
      if (i + prefetch_distance < missing) from.prefetch(missing_[i + prefetch_distance], Bytes);
      std::memcpy(record_[place_of(missing_[i] | mark)], from.at(missing_[i]), Bytes);
    }
  }

  /// The place of a record that was fetched.
  template <class From>
  const unsigned char* at(From& from, std::uint32_t item, std::uint32_t mark) const noexcept {
    const std::uint32_t place = place_of(item | mark);
    if (__builtin_expect(static_cast<long>(key_[place] != (item | mark)), 0) != 0) return from.at(item);
    return record_[place];
  }

  static constexpr int most_at_once = 256;

 private:
  static constexpr int place_bits = 13, prefetch_distance = 20;
  static std::uint32_t place_of(std::uint32_t key) noexcept { return (key * 0x9e3779b1u) >> (32 - place_bits); }

  std::uint32_t key_[1 << place_bits];  // all bits set, which is no item's, where nothing is kept
  std::uint32_t missing_[most_at_once + 1];
  alignas(64) unsigned char record_[1 << place_bits][max_fields * sizeof(double)];
};

}  // namespace vesica::index
