// SPDX-License-Identifier: Apache-2.0
// Arrays in step, on every instruction set: whatever the layout, the alignment and the length, the bytes are the scalar
// function's answers and the count is the number of ones.
#include <gtest/gtest.h>

#include <string>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "columns.hpp"

namespace many_test {
namespace {

using namespace batch_tests;
using properties::Workload;

class Many : public EveryCase {
 protected:
  template <class T>
  const Pairs<T>& pairs() const {
    return mixed_pairs<T>(GetParam().kind_a, GetParam().kind_b);
  }

  template <class T>
  std::size_t three_vectors_and_one() const {
    return 3 * static_cast<std::size_t>(GetParam().set->lanes(T{})) + 1;
  }

  /// One call on a stretch of the mixed pairs; each call takes up where the last one ended.
  template <class T>
  void check(Layout layout_a, Layout layout_b, std::size_t length, std::size_t offset = 0) {
    const Case& c = GetParam();
    const Stretch<T> s(pairs<T>(), begin_, length);
    begin_ += length;
    const bool one_a = one_shape(layout_a), one_b = one_shape(layout_b);
    const Expected expected = one_a || one_b ? in_step<T>(c.kind_a, s.a, one_a, c.kind_b, s.b, one_b) : s.expected;
    const Stored<T> a(c.kind_a, s.a, layout_a, offset), b(c.kind_b, s.b, layout_b, offset * 5 % 64);
    const std::string what = std::string(name(layout_a)) + " with " + name(layout_b) + ", " + std::to_string(length) +
                             " pairs at offset " + std::to_string(offset);
    expect_many(*c.set->table, a, b, expected, what, offset);
  }

  std::size_t begin_ = 0;
};

/// All pairs of layouts, and each layout with every length; with the many lengths of wide vectors each pair takes a
/// quarter of them.
TEST_P(Many, AgreesInEveryLayout) {
  in_its_scalar([this]<class T>(T) {
    const std::size_t lanes = (three_vectors_and_one<T>() - 1) / 3, step = lanes < 4 ? 1 : 4;
    std::size_t combination = 0;
    for (const Layout layout_a : all_layouts) {
      for (const Layout layout_b : all_layouts) {
        for (std::size_t n = combination++ % step; n <= three_vectors_and_one<T>(); n += step) {
          check<T>(layout_a, layout_b, n);
        }
      }
    }
  });
}

TEST_P(Many, AgreesAtEveryLength) {
  in_its_scalar([this]<class T>(T) {
    for (std::size_t n = 0; n <= three_vectors_and_one<T>(); ++n) {
      check<T>(Layout::columns, Layout::columns, n);
      check<T>(Layout::columns, Layout::single, n);
      check<T>(Layout::single, Layout::columns, n);
      check<T>(Layout::packed, Layout::packed, n);
      check<T>(Layout::single, Layout::packed, n);
    }
  });
}

TEST_P(Many, AgreesAtEveryAlignment) {
  in_its_scalar([this]<class T>(T) {
    for (std::size_t offset = 0; offset < 64; ++offset) {
      check<T>(Layout::columns, Layout::columns, three_vectors_and_one<T>(), offset);
      check<T>(Layout::packed, Layout::odd_records, three_vectors_and_one<T>(), offset);
      check<T>(Layout::packed, Layout::packed, three_vectors_and_one<T>(), offset);
    }
  });
}

/// An array is worked through in blocks, shorter ones where it must be copied: lengths about one block and two.
TEST_P(Many, AgreesAboutBlockSizes) {
  in_its_scalar([this]<class T>(T) {
    constexpr std::size_t copied = vesica::batch::copied_block_size<T>, long_block = vesica::batch::long_block_size;
    for (const std::size_t n : {copied - 1, copied, copied + 1, 2 * copied + 1, long_block, long_block + 1}) {
      check<T>(Layout::columns, Layout::columns, n);
      check<T>(Layout::columns, Layout::single, n);
      check<T>(Layout::repeated, Layout::columns, n);
      check<T>(Layout::padded, Layout::backward_columns, n);
      check<T>(Layout::backward_records, Layout::odd_records, n);
      check<T>(Layout::packed, Layout::packed, n);
      check<T>(Layout::packed, Layout::repeated, n);
      check<T>(Layout::repeated, Layout::single, n);
    }
  });
}

constexpr int pairs_of_a_workload = 400;
constexpr int pairs_about_contact_of_a_case = 4000;

/// Every workload by itself, in columns and in records: near ties, magnitudes of their own for each number, tiny, huge,
/// any axis.
TEST_P(Many, AgreesOnEveryWorkload) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    for (const Workload workload : properties::all_workloads) {
      const Pairs<T> p = pairs_of<T>(workload, c.kind_a, c.kind_b, pairs_of_a_workload * properties::repeat());
      const Stretch<T> s(p, 0, p.size());
      for (const Layout layout : {Layout::columns, Layout::packed}) {
        const Stored<T> a(c.kind_a, s.a, layout), b(c.kind_b, s.b, layout);
        expect_many(*c.set->table, a, b, s.expected, name(workload));
      }
    }
  });
}

TEST_P(Many, AgreesAboutContact) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    const int count = pairs_about_contact_of_a_case * properties::repeat();
    const Pairs<T> p = pairs_about_contact<T>(c.kind_a, c.kind_b, count);
    const Stretch<T> s(p, 0, p.size());
    const Stored<T> b(c.kind_b, s.b, Layout::packed);
    for (const Layout layout : {Layout::columns, Layout::packed}) {
      const Stored<T> a(c.kind_a, s.a, layout);
      expect_many(*c.set->table, a, b, s.expected, "about contact");
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, Many, testing::ValuesIn(all_cases()), test_name);

/// The sizes that lengths of tests are chosen about.
TEST(Blocks, HoldOneOrFourKibibytesAColumnOrAreReadInPlace) {
  EXPECT_EQ(vesica::batch::copied_block_size<float>, 256);
  EXPECT_EQ(vesica::batch::copied_block_size<double>, 128);
  EXPECT_EQ(vesica::batch::block_size<float>, 1024);
  EXPECT_EQ(vesica::batch::block_size<double>, 512);
  EXPECT_EQ(vesica::batch::long_block_size, 4096);
}

}  // namespace
}  // namespace many_test
