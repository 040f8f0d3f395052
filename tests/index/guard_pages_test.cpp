// SPDX-License-Identifier: Apache-2.0
/// Every buffer between two pages that may not be touched: a byte read or written outside ends the program.
#include "batch/guard_pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <limits>

#include "index/all_pairs.hpp"

namespace index_tests {
namespace {

using batch_tests::Edge;

/// Buffers of one test, all against the same edge.
class Buffers {
 public:
  explicit Buffers(Edge edge) : edge_(edge) {}
  template <class T>
  T* room(std::int64_t count) {
    const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(T);
    auto& memory = memory_.emplace_back((bytes / page + 1) * page);
    return reinterpret_cast<T*>(memory.place(bytes, edge_));
  }
  template <class T>
  T* copy(const std::vector<T>& from) {
    T* const to = room<T>(std::ssize(from));
    std::ranges::copy(from, to);
    return to;
  }
  /// Aligned to 64: up to 63 bytes are beside it, so tests choose sizes with none.
  std::byte* lines(std::int64_t bytes) {
    EXPECT_EQ(bytes % 64, 0) << "else a guard page is not next to it";
    return room<std::byte>(bytes);
  }

 private:
  static constexpr std::size_t page = 65536;
  Edge edge_;
  std::deque<batch_tests::GuardedMemory> memory_;
};

/// Sets of all kinds and their index, in guarded memory of just their size.
template <class T>
struct Guarded {
  std::vector<typename Face<T>::Shapes> sets;
  void* index;

  Guarded(Buffers& buffers, const Laid<T>& laid) {
    std::int64_t items = 0;
    for (const Records<T>& r : laid) {
      const T* const numbers = buffers.copy(r.numbers);
      const std::ptrdiff_t record = vesica_field_count(r.kind) * static_cast<std::ptrdiff_t>(sizeof(T));
      sets.emplace_back();
      EXPECT_EQ(Face<T>::from_records(r.kind, r.count(), numbers, record, &sets.back()), 0);
      items += r.count();
    }
    const std::int64_t size = vesica_index_size(items), scratch_size = (vesica_index_scratch(items) + 63) / 64 * 64;
    std::byte* const built = buffers.lines(size);
    const std::int64_t used =
        Face<T>::index_build(sets.data(), count(), built, size, buffers.lines(scratch_size), scratch_size);
    EXPECT_GT(used, 0);
    // What reads it sees no more than the bytes that a file would have.
    index = buffers.lines(used);
    std::memcpy(index, built, static_cast<std::size_t>(used));
    EXPECT_EQ(vesica_index_check(index, used), 0);
  }
  std::int32_t count() const { return static_cast<std::int32_t>(sets.size()); }
};

template <class T>
class GuardPagesTest : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(GuardPagesTest, Scalars);

TYPED_TEST(GuardPagesTest, EveryBuffer) {
  using T = TypeParam;
  for (const Edge edge : {Edge::before, Edge::after}) {
    for (const char* name : {"uniform", "two_scales", "needles", "lattice", "points"}) {
      Buffers buffers(edge);
      const Laid<T> laid_a = mixed<T>(name, 1344, 1), laid_b = mixed<T>(name, 1152, 2);
      const Guarded<T> a(buffers, laid_a), b(buffers, laid_b);
      const std::int64_t scratch_size = vesica_join_scratch(), room = 50;
      std::byte* const scratch = buffers.lines((scratch_size + 63) / 64 * 64);
      auto* const first = buffers.room<std::int64_t>(room);
      auto* const second = buffers.room<std::int64_t>(room);
      auto* const state = buffers.room<std::int64_t>(4);
      std::fill(state, state + 4, 0);
      std::vector<Pair> found;
      while (state[0] != -1) {
        const std::int64_t n =
            Face<T>::join(VESICA_JOIN_OVERLAP, a.index, a.sets.data(), a.count(), b.index, b.sets.data(), b.count(), 0,
                          1, scratch, scratch_size, first, second, room, state);
        ASSERT_GE(n, 0);
        for (std::int64_t i = 0; i < n; ++i) found.emplace_back(first[i], second[i]);
      }
      EXPECT_TRUE(sorted(found) == all_pairs<T>(laid_a, laid_b, false, overlaps<T>)) << name;

      const T* const point = buffers.copy(std::vector<T>{laid_b[0].numbers[0], laid_b[0].numbers[1]});
      typename Face<T>::Shapes one;
      ASSERT_EQ(Face<T>::from_records(VESICA_POINT, 1, point, 0, &one), 0);
      std::fill(state, state + 4, 0);
      while (state[0] != -1) {
        ASSERT_GE(Face<T>::index_select(a.index, a.sets.data(), a.count(), &one, first, 2, state), 0);
      }
      auto* const distance = buffers.room<T>(room);
      EXPECT_EQ(Face<T>::index_nearest(a.index, a.sets.data(), a.count(), &one, room,
                                       std::numeric_limits<T>::infinity(), first, distance),
                room);
      auto* const order = buffers.room<std::int64_t>(1344);
      EXPECT_EQ(vesica_index_order(a.index, order, 1344), 1344);
      EXPECT_EQ(vesica_index_bounds(a.index, buffers.room<vesica_aabb_f64>(1)), 0);
    }
  }
}

}  // namespace
}  // namespace index_tests
