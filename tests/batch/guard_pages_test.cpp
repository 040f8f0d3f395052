// SPDX-License-Identifier: Apache-2.0
// No byte outside an array is read and none outside the output written, on every instruction set: every array lies
// against a page that may not be touched, before or behind it. A fault here is the failure.
#include "batch/guard_pages.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/guarded_shapes.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "columns.hpp"

namespace {

using namespace batch_tests;
using vesica::batch::Shapes;

struct Arena {
  GuardedShapes a, b;
  GuardedMemory out;
};
Arena& arena() {
  static Arena one;
  return one;
}

class GuardPages : public EveryCase {
 protected:
  template <class T>
  void many(Layout layout_a, Layout layout_b, std::size_t n, Edge edge) {
    const Case& c = GetParam();
    const Stretch<T> s(mixed_pairs<T>(c.kind_a, c.kind_b), begin_, n);
    begin_ += n;
    const bool one_a = one_shape(layout_a), one_b = one_shape(layout_b);
    const Expected expected = one_a || one_b ? in_step<T>(c.kind_a, s.a, one_a, c.kind_b, s.b, one_b) : s.expected;
    auto* out = reinterpret_cast<std::uint8_t*>(arena().out.place(n, edge));
    const auto a = arena().a.write<T>(c.kind_a, s.a, layout_a, edge);
    const auto b = arena().b.write<T>(c.kind_b, s.b, layout_b, edge);
    const auto tally = vesica::batch::many(*c.set->table, a, b, static_cast<std::int64_t>(n), out);
    expect_tally(tally, expected, std::string(name(layout_a)) + " with " + name(layout_b));
    EXPECT_TRUE(std::equal(expected.bytes.begin(), expected.bytes.end(), out));
  }

  template <class T>
  void matrix(Layout layout_a, Layout layout_b, std::size_t rows, std::size_t columns, Edge edge, bool backward) {
    const Case& c = GetParam();
    const Stretch<T> s(mixed_pairs<T>(c.kind_a, c.kind_b), begin_, columns);
    begin_ += columns;
    const std::size_t step = columns + 2, reach = (rows - 1) * step;
    auto* out = reinterpret_cast<std::uint8_t*>(arena().out.place(reach + columns, edge));
    const auto a = arena().a.write<T>(c.kind_a, std::span(s.a).first(rows), layout_a, edge);
    const auto b = arena().b.write<T>(c.kind_b, s.b, layout_b, edge);
    const auto row_stride = static_cast<std::ptrdiff_t>(step) * (backward ? -1 : 1);
    const auto tally = vesica::batch::matrix(*c.set->table, a, b, out + (backward ? reach : 0), row_stride);
    std::int64_t ones = 0;
    for (std::size_t i = 0; i < rows; ++i) ones += std::count(out + i * step, out + i * step + columns, 1);
    EXPECT_EQ(tally.overlaps, ones);
    EXPECT_FALSE(tally.invalid);
  }

  template <class T>
  void select(Layout layout, std::size_t n, Edge edge) {
    const Case& c = GetParam();
    const Stretch<T> s(mixed_pairs<T>(c.kind_a, c.kind_b), begin_, n);
    begin_ += n;
    const Expected expected = in_step<T>(c.kind_a, s.a, true, c.kind_b, s.b, false);
    const auto found = static_cast<std::size_t>(expected.overlaps);
    const auto a = arena().a.write<T>(c.kind_a, s.a, Layout::single, edge);
    const auto b = arena().b.write<T>(c.kind_b, s.b, layout, edge);
    for (const std::size_t capacity : {std::size_t{0}, found / 2, found}) {
      auto* out = reinterpret_cast<std::int64_t*>(arena().out.place(capacity * sizeof(std::int64_t), edge));
      const auto tally = vesica::batch::select(*c.set->table, a, b, out, static_cast<std::int64_t>(capacity));
      expect_tally(tally, expected, "select");
    }
  }

  std::size_t begin_ = 0;
};

TEST_P(GuardPages, AreNotTouchedByMany) {
  in_its_scalar([this]<class T>(T) {
    const auto most = static_cast<std::size_t>(3 * GetParam().set->lanes(T{}) + 1);
    for (const Edge edge : {Edge::before, Edge::after}) {
      for (std::size_t n = 0; n <= most; ++n) {
        many<T>(Layout::columns, Layout::columns, n, edge);
        many<T>(Layout::packed, Layout::backward_columns, n, edge);
        many<T>(Layout::odd_records, Layout::backward_records, n, edge);
        many<T>(Layout::packed, Layout::packed, n, edge);
        many<T>(Layout::single, Layout::packed, n, edge);
        many<T>(Layout::single, Layout::columns, n, edge);
        many<T>(Layout::columns, Layout::repeated, n, edge);
      }
      many<T>(Layout::columns, Layout::packed, vesica::batch::block_size<T> + 1, edge);
    }
  });
}

TEST_P(GuardPages, AreNotTouchedByMatrix) {
  in_its_scalar([this]<class T>(T) {
    const auto most = static_cast<std::size_t>(3 * GetParam().set->lanes(T{}) + 1);
    for (const Edge edge : {Edge::before, Edge::after}) {
      for (std::size_t n = 2; n <= most; ++n) {
        matrix<T>(Layout::columns, Layout::columns, 2, n, edge, n % 2 == 0);
        matrix<T>(Layout::odd_records, Layout::packed, 2, n, edge, n % 2 == 1);
      }
      matrix<T>(Layout::packed, Layout::columns, 3, vesica::batch::block_size<T> + 1, edge, false);
    }
  });
}

TEST_P(GuardPages, AreNotTouchedBySelect) {
  in_its_scalar([this]<class T>(T) {
    const auto most = static_cast<std::size_t>(3 * GetParam().set->lanes(T{}) + 1);
    for (const Edge edge : {Edge::before, Edge::after}) {
      for (std::size_t n = 1; n <= most; ++n) {
        select<T>(Layout::columns, n, edge);
        select<T>(Layout::backward_records, n, edge);
        select<T>(Layout::packed, n, edge);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, GuardPages, testing::ValuesIn(all_cases()), test_name);

/// Does an access to *byte end a child process?
bool faults(volatile std::byte* byte) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGSEGV, SIG_DFL);
    std::signal(SIGBUS, SIG_DFL);
    static_cast<void>(*byte);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) && (WTERMSIG(status) == SIGSEGV || WTERMSIG(status) == SIGBUS);
}

/// That the tests above can fail.
TEST(GuardedMemory, FaultsOneByteOutside) {
  GuardedMemory memory;
  std::byte* first = memory.place(7, Edge::before);
  std::byte* last = memory.place(7, Edge::after) + 6;
  EXPECT_FALSE(faults(first));
  EXPECT_FALSE(faults(last));
  EXPECT_TRUE(faults(first - 1));
  EXPECT_TRUE(faults(last + 1));
}

}  // namespace
