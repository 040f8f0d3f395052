// SPDX-License-Identifier: Apache-2.0
/// The C functions of index and join by scalar type, over vectors that own their memory.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "capi/face.hpp"
#include "index/workloads.hpp"

namespace index_tests {

using capi_tests::Face;

/// Memory aligned to 64 that is as large as it says, so that a sanitizer sees a step beyond.
struct Memory {
  explicit Memory(std::int64_t bytes)
      : size(bytes), data(std::aligned_alloc(64, static_cast<std::size_t>((bytes + 63) / 64 * 64 + 64))) {
    std::memset(data.get(), 0xA5, static_cast<std::size_t>(bytes));
  }
  void* get() const { return data.get(); }
  std::int64_t size;
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  std::unique_ptr<void, Free> data;
};

template <class T>
struct Sets {
  std::vector<typename Face<T>::Shapes> sets;
  std::int64_t items = 0;

  explicit Sets(const Laid<T>& laid) {
    for (const Records<T>& r : laid) {
      typename Face<T>::Shapes shapes;
      constexpr std::ptrdiff_t fields[] = {2, 4, 3, 4, 6, 6};
      const std::ptrdiff_t record = fields[r.kind] * static_cast<std::ptrdiff_t>(sizeof(T));
      EXPECT_EQ(Face<T>::from_records(r.kind, r.count(), r.numbers.data(), record, &shapes), 0);
      sets.push_back(shapes);
      items += r.count();
    }
  }
  const typename Face<T>::Shapes* data() const { return sets.data(); }
  std::int32_t count() const { return static_cast<std::int32_t>(sets.size()); }
};

/// Shapes and their index.
template <class T>
struct Indexed {
  Laid<T> laid;
  Sets<T> sets;
  Memory index;
  std::int64_t result;

  explicit Indexed(Laid<T> shapes) : laid(std::move(shapes)), sets(laid), index(vesica_index_size(sets.items)) {
    const Memory scratch(vesica_index_scratch(sets.items));
    result = Face<T>::index_build(sets.data(), sets.count(), index.get(), index.size, scratch.get(), scratch.size);
  }
  explicit Indexed(Records<T> records) : Indexed(Laid<T>{std::move(records)}) {}
  std::int64_t bytes() const { return vesica_index_bytes(index.get()); }
  std::vector<unsigned char> copy() const {
    const auto* begin = static_cast<const unsigned char*>(index.get());
    return {begin, begin + bytes()};
  }
};

using Pair = std::pair<std::int64_t, std::int64_t>;

/// The pairs of a part in the join's order, by calls of so much capacity.
template <class T>
std::vector<Pair> join(std::int32_t query, const Indexed<T>& a, const Indexed<T>& b, std::int64_t part = 0,
                       std::int64_t parts = 1, std::int64_t capacity = 4096) {
  const Memory scratch(vesica_join_scratch());
  std::vector<std::int64_t> out_a(static_cast<std::size_t>(capacity)), out_b(static_cast<std::size_t>(capacity));
  std::vector<Pair> pairs;
  std::int64_t state[4] = {0, 0, 0, 0};
  while (state[0] != -1) {
    const std::int64_t n =
        Face<T>::join(query, a.index.get(), a.sets.data(), a.sets.count(), b.index.get(), b.sets.data(), b.sets.count(),
                      part, parts, scratch.get(), scratch.size, out_a.data(), out_b.data(), capacity, state);
    EXPECT_GE(n, 0);
    if (n < 0) break;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) pairs.emplace_back(out_a[i], out_b[i]);
  }
  return pairs;
}

template <class T>
std::int64_t count(std::int32_t query, const Indexed<T>& a, const Indexed<T>& b, std::int64_t part = 0,
                   std::int64_t parts = 1) {
  const Memory scratch(vesica_join_scratch());
  return Face<T>::join(query, a.index.get(), a.sets.data(), a.sets.count(), b.index.get(), b.sets.data(),
                       b.sets.count(), part, parts, scratch.get(), scratch.size, nullptr, nullptr, 0, nullptr);
}

/// FNV-1a of whatever lies in memory.
inline std::uint64_t hash_bytes(const void* data, std::size_t size) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (std::size_t i = 0; i < size; ++i) h = (h ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
  return h;
}

}  // namespace index_tests
