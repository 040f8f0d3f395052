// SPDX-License-Identifier: Apache-2.0
// How long a kernel is asked that helps little. Answers are the same whoever gives them, so that only a count shows it:
// these kernels are the library's own, which count their calls and what they leave undecided.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "batch.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "columns.hpp"
#include "kernels/query_table.hpp"
#include "queries/cast.hpp"

namespace {

using namespace batch_tests;
using vesica::KernelTable;
using vesica::Kind;

constexpr int rect = static_cast<int>(Kind::rect), circle = static_cast<int>(Kind::circle);

int calls, undecided;  // since the last count_anew()

void count_anew() { calls = undecided = 0; }

/// The kernels that the counting ones replace.
template <class T>
vesica::BlockKernel<T> original;
template <class T>
vesica::BlockResult counting(const vesica::Block<T>& block) noexcept {
  const vesica::BlockResult result = original<T>(block);
  ++calls;
  undecided += result.undecided;
  return result;
}

template <class T>
auto& pairs_of(KernelTable& table) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return table.f32;
  } else {
    return table.f64;
  }
}
template <class T>
auto& checked_of(KernelTable& table) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return table.checked_f32;
  } else {
    return table.checked_f64;
  }
}

vesica::CastFilter original_filter;
void counting_filter(const vesica::CastColumns& columns, std::int32_t n, const vesica::CastBytes& out) noexcept {
  ++calls;
  original_filter(columns, n, out);
}
/// Knows nothing of any pair.
void vain_filter(const vesica::CastColumns&, std::int32_t n, const vesica::CastBytes& out) noexcept {
  ++calls;
  std::fill_n(out.missed, n, std::uint8_t{0});
  std::fill_n(out.meets, n, std::uint8_t{0});
}

template <class T>
std::vector<Numbers<T>> squares(int n, T x) {
  return std::vector<Numbers<T>>(static_cast<std::size_t>(n), {x, 0, 1, 0, T(0.5), T(0.5)});
}

template <class T>
class GivenUp : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(GivenUp, Scalars);

/// All pairs touch, which no general kernel decides: it goes on to the end of the block, and single calls decide them.
TYPED_TEST(GivenUp, NeverTheGeneralKernel) {
  using T = TypeParam;
  constexpr int n = 4096;
  const Stored<T> a(rect, squares<T>(n, 0), Layout::columns), b(rect, squares<T>(n, 1), Layout::columns);
  for (const InstructionSet& set : instruction_sets()) {
    if (!set.usable) continue;
    KernelTable table = *set.table;
    vesica::PairKernels<T>& pair = pairs_of<T>(table)[rect][rect];
    original<T> = pair.general[0];
    pair.general[0] = pair.unit[0] = counting<T>;
    count_anew();
    std::vector<std::uint8_t> out(n);
    EXPECT_EQ(vesica::batch::many(table, a.view(), b.view(), n, out.data()).overlaps, n) << set.name;
    EXPECT_EQ(calls, 1) << set.name;
    EXPECT_EQ(undecided, n) << set.name;
  }
}

/// A checked kernel is asked row after row, but no more in a block in which it left much undecided.
TYPED_TEST(GivenUp, ACheckedKernelForTheRestOfABlock) {
  using T = TypeParam;
  constexpr int rows = 64, blocks = 3, columns = blocks * vesica::batch::block_size<T>;
  const Stored<T> a(rect, squares<T>(rows, 0), Layout::columns),
      touching(rect, squares<T>(columns, 1), Layout::columns), apart(rect, squares<T>(columns, 2), Layout::columns);
  for (const InstructionSet& set : instruction_sets()) {
    KernelTable table = *set.table;
    vesica::BlockKernel<T>& kernel = checked_of<T>(table).of[rect][rect].answer;
    if (!set.usable || kernel == nullptr) continue;
    original<T> = kernel;
    kernel = counting<T>;
    std::vector<std::uint8_t> out(rows * columns);
    count_anew();
    EXPECT_EQ(vesica::batch::matrix(table, a.view(), apart.view(), out.data(), columns).overlaps, 0) << set.name;
    EXPECT_EQ(calls, rows * blocks) << set.name;
    count_anew();
    EXPECT_EQ(vesica::batch::matrix(table, a.view(), touching.view(), out.data(), columns).overlaps, rows * columns)
        << set.name;
    EXPECT_EQ(calls, blocks) << set.name;
  }
}

/// The library's kernels are others for a while.
struct Chosen {
  const KernelTable* before = vesica::chosen_kernels;
  explicit Chosen(const KernelTable& table) { vesica::chosen_kernels = &table; }
  ~Chosen() { vesica::chosen_kernels = before; }
  Chosen(const Chosen&) = delete;
  Chosen& operator=(const Chosen&) = delete;
};

/// Casts of a block that the kernels cannot decide are followed by seven blocks of single calls.
TYPED_TEST(GivenUp, KernelsOfCastsForSevenBlocks) {
  using T = TypeParam;
  constexpr int blocks = 16, n = blocks * vesica::query_block;
  const std::vector<Numbers<T>> at_rest(n, {0, 0, 1}), above(n, {0, 3, 1});
  const Stored<T> a(circle, at_rest, Layout::columns), b(circle, above, Layout::columns);
  const T vx = 1, vy = 0;
  std::vector<T> t(n);
  T* const results[5] = {t.data(), nullptr, nullptr, nullptr, nullptr};
  const auto cast = [&](const KernelTable& table, vesica::CastFilter filter) {
    vesica::CastTable casts = *table.queries->cast;
    vesica::QueryTable queries = *table.queries;
    KernelTable changed = table;
    original_filter = casts.filter;
    casts.filter = filter;
    queries.cast = &casts;
    changed.queries = &queries;
    const Chosen chosen(changed);
    count_anew();
    const vesica::batch::Velocities<T> v{&vx, &vy, 0};
    EXPECT_EQ(
        vesica::batch::cast_many<T>(a.view(), b.view(), n, v, std::numeric_limits<double>::infinity(), results).hits,
        0);
    return calls;
  };
  for (const InstructionSet& set : instruction_sets()) {
    if (!set.usable || set.table->queries->cast == nullptr) continue;
    EXPECT_EQ(cast(*set.table, counting_filter), blocks) << set.name;
    EXPECT_EQ(cast(*set.table, vain_filter), 2) << set.name << ": of the blocks 0 and 8";
  }
}

}  // namespace
