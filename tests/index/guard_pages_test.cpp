// SPDX-License-Identifier: Apache-2.0
/// Every buffer between two pages that may not be touched: a byte read or written outside ends the program.
#include "batch/guard_pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <vector>

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
  /// Aligned to 64, so a page is next to its end only for a multiple of it.
  std::byte* lines(std::int64_t bytes) {
    EXPECT_EQ(bytes % 64, 0) << "else a guard page is not next to it";
    return room<std::byte>(bytes);
  }

 private:
  static constexpr std::size_t page = 65536;
  Edge edge_;
  std::deque<batch_tests::GuardedMemory> memory_;
};

std::int64_t whole_lines(std::int64_t bytes) { return (bytes + 63) / 64 * 64; }

/// Sets of all kinds and their index, in guarded memory of just their size.
template <class T>
struct Guarded {
  std::vector<typename Face<T>::Shapes> sets;
  const typename Face<T>::Shapes* guarded_sets;
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
    guarded_sets = buffers.copy(sets);
    const std::int64_t size = whole_lines(vesica_index_size(items)),
                       scratch_size = whole_lines(vesica_index_scratch(items));
    std::byte* const built = buffers.lines(size);
    const std::int64_t used =
        Face<T>::index_build(guarded_sets, count(), built, size, buffers.lines(scratch_size), scratch_size);
    EXPECT_GT(used, 0);
    // Readers see only the bytes that a file would have.
    index = buffers.lines(used);
    std::memcpy(index, built, static_cast<std::size_t>(used));
    EXPECT_EQ(vesica_index_check(index, used), 0);
  }
  std::int32_t count() const { return static_cast<std::int32_t>(sets.size()); }

  /// Builds it once more, in steps of `parts` parts, which gives the same bytes.
  void build_in_steps(Buffers& buffers, std::int64_t parts) const {
    const std::int64_t items = vesica_index_count(index);
    const std::int64_t size = whole_lines(vesica_index_size(items)),
                       scratch_size = whole_lines(vesica_index_scratch(items));
    std::byte* const built = buffers.lines(size);
    std::byte* const scratch = buffers.lines(scratch_size);
    std::int64_t used = 0;
    for (std::int32_t step = 0; step <= 4; ++step) {
      const std::int64_t of_step = step == 0 || step == 4 ? 1 : parts;
      for (std::int64_t part = 0; part < of_step; ++part) {
        used = Face<T>::index_step(step, part, of_step, guarded_sets, count(), built, size, scratch, scratch_size);
      }
    }
    ASSERT_EQ(used, vesica_index_bytes(index));
    EXPECT_EQ(std::memcmp(built, index, static_cast<std::size_t>(used)), 0);
  }
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
      const std::int64_t scratch_size = whole_lines(vesica_join_scratch()), room = 50;
      std::byte* const scratch = buffers.lines(scratch_size);
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

/// n shapes of a workload, the kinds in turn; none of some where n is below 6.
template <class T>
Laid<T> some_of_each(const char* workload, std::int64_t n, std::uint64_t seed) {
  Laid<T> laid = mixed<T>(workload, (n / 6 + 1) * 6, seed);
  std::int64_t kind = 0;
  for (Records<T>& r : laid) {
    r.numbers.resize(static_cast<std::size_t>((n + 5 - kind++) / 6 * vesica_field_count(r.kind)));
  }
  return laid;
}

/// The questions of one index and of two, every output with room for the results and no more.
template <class T>
class Questions {
 public:
  Questions(Buffers& buffers, const Guarded<T>& a, const Guarded<T>& b)
      : buffers_(buffers), a_(a), b_(b), state_(buffers.room<std::int64_t>(4)) {}

  /// Asked once with room for none, then with room for all, then for a third.
  template <class Call>
  void of_pairs(const char* name, const Call& call) {
    const std::int64_t all = call(nullptr, nullptr, std::int64_t{0}, nullptr);
    ASSERT_GE(all, 0) << name;
    for (const std::int64_t room : {std::max<std::int64_t>(1, all), all / 3 + 1}) {
      auto* const first = buffers_.room<std::int64_t>(room);
      auto* const second = buffers_.room<std::int64_t>(room);
      std::int64_t found = 0;
      std::fill(state_, state_ + 4, 0);
      while (state_[0] != -1) {
        const std::int64_t written = call(first, second, room, state_);
        ASSERT_GE(written, 0) << name;
        found += written;
      }
      EXPECT_EQ(found, all) << name;
    }
  }
  template <class Call>
  void of_items(const char* name, const Call& call) {
    of_pairs(name, [&](std::int64_t* out, std::int64_t*, std::int64_t room, std::int64_t* state) {
      return call(out, room, state);
    });
  }

  void join() {
    const std::int64_t size = whole_lines(vesica_join_scratch());
    std::byte* const scratch = buffers_.lines(size);
    for (const Guarded<T>* b : {&a_, &b_}) {
      for (const auto query :
           {VESICA_JOIN_OVERLAP, VESICA_JOIN_BOUNDS, VESICA_JOIN_CONTAINS, VESICA_JOIN_INSIDE, VESICA_JOIN_INTERIORS}) {
        of_pairs("join", [&](auto first, auto second, std::int64_t room, auto state) {
          return F::join(query, a_.index, a_.guarded_sets, a_.count(), b->index, b->guarded_sets, b->count(), 0, 1,
                         scratch, size, first, second, room, state);
        });
      }
      for (const T distance : {T(0), std::numeric_limits<T>::infinity()}) {
        of_pairs("join_within", [&](auto first, auto second, std::int64_t room, auto state) {
          return F::join_within(a_.index, a_.guarded_sets, a_.count(), b->index, b->guarded_sets, b->count(), distance,
                                0, 1, first, second, room, state);
        });
      }
    }
  }

  void nearest(std::int64_t items) {
    constexpr T far = std::numeric_limits<T>::infinity();
    for (const std::int64_t k : {std::int64_t{1}, items + 1}) {
      auto* const out = buffers_.room<std::int64_t>(items * k);
      T* const distance = buffers_.room<T>(items * k);
      EXPECT_EQ(F::join_nearest(a_.guarded_sets, a_.count(), b_.index, b_.guarded_sets, b_.count(), k, far, 0, 1, out,
                                distance),
                items * std::min(k, items));
    }
    auto* const out = buffers_.room<std::int64_t>(items);
    T* const distance = buffers_.room<T>(items);
    for (const auto& one : each_alone()) {
      EXPECT_EQ(F::index_nearest(a_.index, a_.guarded_sets, a_.count(), &one, items, far, out, distance), items);
    }
    EXPECT_EQ(vesica_index_order(a_.index, out, items), items);
    EXPECT_EQ(vesica_index_bounds(a_.index, buffers_.room<vesica_aabb_f64>(1)), 0);
  }

  void one_shape(std::int64_t items) {
    for (const auto& one : each_alone()) {
      of_items("select", [&](auto out, std::int64_t room, auto state) {
        return F::index_select(a_.index, a_.guarded_sets, a_.count(), &one, out, room, state);
      });
      of_items("select by bounds", [&](auto out, std::int64_t room, auto state) {
        return F::index_select(a_.index, nullptr, 0, &one, out, room, state);
      });
      of_items("cast", [&](auto out, std::int64_t room, auto state) {
        return F::index_cast(a_.index, a_.guarded_sets, a_.count(), &one, T(0.5), T(-0.25), T(8), out, room, state);
      });
      typename F::Impact impact;
      EXPECT_LE(F::index_cast_first(a_.index, a_.guarded_sets, a_.count(), &one, T(0.5), T(-0.25), T(8), &impact),
                items);
    }
  }

 private:
  using F = Face<T>;

  /// The first shape of each set of b as an array of one.
  std::vector<typename F::Shapes> each_alone() const {
    std::vector<typename F::Shapes> alone;
    for (typename F::Shapes set : b_.sets) {
      if (set.count == 0) continue;
      set.count = 1;
      alone.push_back(set);
    }
    return alone;
  }

  Buffers& buffers_;
  const Guarded<T>& a_;
  const Guarded<T>& b_;
  std::int64_t* state_;
};

TYPED_TEST(GuardPagesTest, EveryLength) {
  using T = TypeParam;
  for (const Edge edge : {Edge::before, Edge::after}) {
    for (std::int64_t n = 0; n <= 40; ++n) {
      Buffers buffers(edge);
      const char* const workload = n % 2 == 0 ? "lattice" : "two_scales";
      const Guarded<T> a(buffers, some_of_each<T>(workload, n, 1)), b(buffers, some_of_each<T>(workload, n, 2));
      a.build_in_steps(buffers, 3);
      Questions<T> questions(buffers, a, b);
      questions.join();
      questions.nearest(n);
      questions.one_shape(n);
    }
  }
}

}  // namespace
}  // namespace index_tests
