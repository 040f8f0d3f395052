// SPDX-License-Identifier: Apache-2.0
// Every shape of one array with every one of another, on every instruction set: each byte is the scalar function's
// answer, wherever rows lie, and what lies between rows is left alone.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "columns.hpp"

namespace {

using namespace batch_tests;

/// The bytes of the answers as they lie in memory, those between rows untouched.
struct Image {
  std::size_t first_row = 0;  ///< where the first row begins: at the end when rows run backwards
  std::vector<std::uint8_t> bytes;
  std::int64_t overlaps = 0;
  bool invalid = false;

  Image(std::size_t rows, std::size_t columns, std::ptrdiff_t row_stride) {
    if (rows == 0) return;
    const std::size_t reach = (rows - 1) * static_cast<std::size_t>(std::abs(row_stride));
    bytes.assign(reach + columns, untouched);
    if (row_stride < 0) first_row = reach;
  }
};

template <class T>
Image expected_image(const Pairs<T>& kinds, const Stretch<T>& s, std::size_t rows, bool one_a, bool one_b,
                     std::ptrdiff_t row_stride) {
  Image image(rows, s.b.size(), row_stride);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < s.b.size(); ++j) {
      const std::int32_t answer = scalar_answer(kinds.kind_a, s.a[one_a ? 0 : i], kinds.kind_b, s.b[one_b ? 0 : j]);
      const auto row = static_cast<std::ptrdiff_t>(image.first_row) + static_cast<std::ptrdiff_t>(i) * row_stride;
      image.bytes[static_cast<std::size_t>(row) + j] = answer == 1;
      image.overlaps += answer == 1;
      image.invalid = image.invalid || answer < 0;
    }
  }
  return image;
}

class Matrix : public EveryCase {
 protected:
  /// rows of a with all of b; `more` bytes between rows, which run backwards when asked to.
  template <class T>
  void check(Layout layout_a, std::size_t rows, Layout layout_b, std::size_t columns, std::ptrdiff_t more,
             bool backward) {
    const Case& c = GetParam();
    const Pairs<T>& pairs = mixed_pairs<T>(c.kind_a, c.kind_b);
    const std::ptrdiff_t row_stride = (static_cast<std::ptrdiff_t>(columns) + more) * (backward ? -1 : 1);
    // Pairs of the mixed data meet on the diagonal.
    const Stretch<T> s(pairs, begin_, columns), t(pairs, begin_, rows);
    begin_ += columns;
    const Stretch<T> both = merged(t, s);
    const Image image = expected_image(pairs, both, rows, one_shape(layout_a), one_shape(layout_b), row_stride);
    const Stored<T> a(c.kind_a, t.a, layout_a, begin_ % 64), b(c.kind_b, s.b, layout_b, begin_ % 61);
    Output out(image.bytes.size(), begin_ % 7);
    const vesica::batch::Tally tally =
        vesica::batch::matrix(*c.set->table, a.view(), b.view(), out.data() + image.first_row, row_stride);
    const std::string what = std::string(name(layout_a)) + " with " + name(layout_b) + ", " + std::to_string(rows) +
                             " x " + std::to_string(columns) + ", row stride " + std::to_string(row_stride);
    EXPECT_EQ(tally.overlaps, image.overlaps) << what;
    EXPECT_EQ(tally.invalid, image.invalid) << what;
    EXPECT_TRUE(out.margins_untouched()) << what;
    EXPECT_TRUE(std::equal(image.bytes.begin(), image.bytes.end(), out.data()))
        << what << ", seed " << properties::seed();
  }

 private:
  template <class T>
  static Stretch<T> merged(const Stretch<T>& rows, const Stretch<T>& columns) {
    Stretch<T> result = columns;
    result.a = rows.a;
    return result;
  }

  std::size_t begin_ = 0;
};

TEST_P(Matrix, AgreesAtEveryLength) {
  in_its_scalar([this]<class T>(T) {
    const auto most = static_cast<std::size_t>(3 * GetParam().set->lanes(T{}) + 1);
    for (std::size_t columns = 0; columns <= most; ++columns) {
      check<T>(Layout::columns, columns % 4, Layout::columns, columns, 0, false);
    }
  });
}

TEST_P(Matrix, AgreesInEveryLayoutAndRowStride) {
  in_its_scalar([this]<class T>(T) {
    const auto columns = static_cast<std::size_t>(GetParam().set->lanes(T{}) + 3);
    std::size_t combination = 0;
    for (const Layout layout_a : all_layouts) {
      for (const Layout layout_b : all_layouts) {
        const std::ptrdiff_t more = combination % 3 == 0 ? 0 : 5;
        // An array of count 1 is a single row or column.
        check<T>(layout_a, layout_a == Layout::single ? 1 : 3, layout_b, layout_b == Layout::single ? 1 : columns, more,
                 combination % 2 == 1);
        ++combination;
      }
    }
  });
}

TEST_P(Matrix, AgreesAboutBlockSizes) {
  in_its_scalar([this]<class T>(T) {
    constexpr std::size_t block = vesica::batch::block_size<T>;
    check<T>(Layout::columns, 2, Layout::columns, block - 1, 0, false);
    check<T>(Layout::packed, 2, Layout::columns, block, 1, true);
    check<T>(Layout::repeated, 2, Layout::padded, block + 1, 0, true);
    check<T>(Layout::single, 1, Layout::backward_columns, 2 * block + 1, 0, false);
    check<T>(Layout::columns, block + 1, Layout::odd_records, 2, 3, false);
  });
}

/// The stride of a single row is ignored.
TEST_P(Matrix, IgnoresTheStrideOfASingleRow) {
  in_its_scalar([this]<class T>(T) { check<T>(Layout::columns, 1, Layout::columns, 9, -9, false); });
}

INSTANTIATE_TEST_SUITE_P(Sets, Matrix, testing::ValuesIn(all_cases()), test_name);

}  // namespace
