// SPDX-License-Identifier: Apache-2.0
// The indices of the shapes that one shape overlaps, on every instruction set: those the scalar function answers 1 for,
// ascending, as many as there is room for, and nothing of the room beyond them is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "columns.hpp"

namespace {

using namespace batch_tests;

constexpr std::int64_t unwritten = -77;

class Select : public EveryCase {
 protected:
  template <class T>
  void check(Layout layout, std::size_t length) {
    const Case& c = GetParam();
    const Pairs<T>& pairs = mixed_pairs<T>(c.kind_a, c.kind_b);
    const Stretch<T> s(pairs, begin_, length), one(pairs, begin_, 1);
    begin_ += length + 1;
    const Stored<T> a(c.kind_a, one.a, Layout::single), b(c.kind_b, s.b, layout, begin_ % 64);
    std::vector<std::int64_t> indices;
    for (std::size_t i = 0; i < length; ++i) {
      const Numbers<T>& shape = s.b[one_shape(layout) ? 0 : i];
      if (scalar_answer(c.kind_a, one.a[0], c.kind_b, shape) == 1) indices.push_back(static_cast<std::int64_t>(i));
    }
    const std::size_t found = indices.size();
    for (const std::size_t capacity : {std::size_t{0}, std::size_t{1}, found / 2, found, found + 1, found + 9}) {
      call(a, b, capacity, indices, std::string(name(layout)) + ", " + std::to_string(length));
    }
  }

 private:
  template <class T>
  void call(const Stored<T>& one, const Stored<T>& many, std::size_t capacity, const std::vector<std::int64_t>& indices,
            const std::string& what) {
    std::vector<std::int64_t> out(capacity + 3, unwritten), expected = out;
    std::copy_n(indices.begin(), std::min(capacity, indices.size()), expected.begin());
    const vesica::batch::Tally tally = vesica::batch::select(*GetParam().set->table, one.view(), many.view(),
                                                             out.data(), static_cast<std::int64_t>(capacity));
    EXPECT_EQ(tally.overlaps, static_cast<std::int64_t>(indices.size())) << what;
    EXPECT_FALSE(tally.invalid) << what;
    EXPECT_EQ(out, expected) << what << " shapes, capacity " << capacity << ", seed " << properties::seed();
  }

  std::size_t begin_ = 0;
};

TEST_P(Select, AgreesAtEveryLengthAndLayout) {
  in_its_scalar([this]<class T>(T) {
    const auto most = static_cast<std::size_t>(3 * GetParam().set->lanes(T{}) + 1);
    for (std::size_t n = 0; n <= most; ++n) {
      check<T>(Layout::columns, n);
      check<T>(all_layouts[n % (all_layouts.size() - 1)], n);
    }
    check<T>(Layout::single, 1);
  });
}

TEST_P(Select, AgreesAboutBlockSizes) {
  in_its_scalar([this]<class T>(T) {
    constexpr std::size_t block = vesica::batch::block_size<T>;
    check<T>(Layout::columns, block - 1);
    check<T>(Layout::columns, block);
    check<T>(Layout::packed, block + 1);
    check<T>(Layout::columns, 2 * block + 1);
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, Select, testing::ValuesIn(all_cases()), test_name);

}  // namespace
