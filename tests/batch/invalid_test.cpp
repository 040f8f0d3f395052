// SPDX-License-Identifier: Apache-2.0
// An invalid element gets 0, every other element its right answer, and the tally says so: each way of being invalid,
// in each number of either shape, at each place of a vector, in the partial last one, and in a repeated shape.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "columns.hpp"

namespace invalid_test {
namespace {

using namespace batch_tests;
using properties::Role;
using properties::role;

/// Every rule of the header broken, one at a time, on an otherwise valid shape.
template <class T>
std::vector<Numbers<T>> broken(int kind, const Numbers<T>& valid) {
  using Limits = std::numeric_limits<T>;
  std::vector<Numbers<T>> result;
  const auto with = [&](int field, T number) {
    Numbers<T> shape = valid;
    shape[static_cast<std::size_t>(field)] = number;
    result.push_back(shape);
  };
  for (int k = 0; k < properties::field_count(kind); ++k) {
    for (const T number : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) with(k, number);
    if (!is_size(role(kind, k))) continue;
    for (const T number : {-Limits::denorm_min(), T(-1), -Limits::max()}) with(k, number);
  }
  if (role(kind, 2) == Role::axis) {
    result.push_back({valid[0], valid[1], 0, 0, valid[4], valid[5], valid[6]});
    result.push_back({valid[0], valid[1], T(-0.0), T(-0.0), valid[4], valid[5], valid[6]});
  }
  if (kind == VESICA_AABB) {
    with(0, std::nextafter(valid[2], Limits::infinity()));
    with(1, std::nextafter(valid[3], Limits::infinity()));
    with(2, -Limits::max());
    with(3, -Limits::max());
  }
  return result;
}

/// Valid pairs without zero boxes: an AABB's lowest corner is above -max then, so that lowering the other inverts it.
template <class T>
Pairs<T> valid_pairs(int kind_a, int kind_b) {
  return pairs_of<T>(properties::Workload::random, kind_a, kind_b, 64);
}

class Invalid : public EveryCase {
 protected:
  template <class T>
  void check(const Pairs<T>& pairs, Layout layout_a, Layout layout_b, const Expected& expected,
             const std::string& what) {
    const Stored<T> a(pairs.kind_a, pairs.a, layout_a), b(pairs.kind_b, pairs.b, layout_b);
    expect_many(*GetParam().set->table, a, b, expected, what);
  }
};

/// A stretch of `size` valid pairs, and what calls on it must give once the marked elements are broken.
template <class T>
Pairs<T> first_of(const Pairs<T>& pairs, std::size_t size) {
  const auto n = static_cast<std::ptrdiff_t>(size);
  return {pairs.kind_a,
          pairs.kind_b,
          {pairs.a.begin(), pairs.a.begin() + n},
          {pairs.b.begin(), pairs.b.begin() + n},
          {pairs.answers.begin(), pairs.answers.begin() + n}};
}

template <class T>
Expected with_invalid_at(const Pairs<T>& pairs, std::size_t place) {
  Expected expected;
  for (std::size_t i = 0; i < pairs.size(); ++i) expected.add(i == place ? VESICA_E_SHAPE : pairs.answers[i]);
  return expected;
}

/// Two vectors and a partial one, with one element broken in the first, a middle, a last and a partial lane.
TEST_P(Invalid, GetsZeroAndItsNeighboursTheirAnswers) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    const auto lanes = static_cast<std::size_t>(c.set->lanes(T{})), size = 2 * lanes + (lanes + 1) / 2;
    const Pairs<T> valid = first_of(valid_pairs<T>(c.kind_a, c.kind_b), size);
    for (const std::size_t place : {std::size_t{0}, lanes / 2, 2 * lanes - 1, 2 * lanes, size - 1}) {
      for (const bool in_b : {false, true}) {
        Pairs<T> pairs = valid;
        auto& shapes = in_b ? pairs.b : pairs.a;
        for (const Numbers<T>& shape : broken(in_b ? c.kind_b : c.kind_a, shapes[place])) {
          shapes[place] = shape;
          const std::string what = describe(c.kind_a, pairs.a[place], c.kind_b, pairs.b[place]);
          check(pairs, Layout::columns, Layout::packed, with_invalid_at(valid, place), what);
          check(pairs, Layout::packed, Layout::packed, with_invalid_at(valid, place), what);
        }
      }
    }
  });
}

/// Both shapes of a pair at once: no number of one may hide those of the other.
TEST_P(Invalid, BothShapes) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    Pairs<T> pairs = first_of(valid_pairs<T>(c.kind_a, c.kind_b), 1);
    Expected expected;
    expected.add(VESICA_E_SHAPE);
    for (const Numbers<T>& a : broken(c.kind_a, pairs.a[0])) {
      for (const Numbers<T>& b : broken(c.kind_b, pairs.b[0])) {
        const Pairs<T> both{c.kind_a, c.kind_b, {a}, {b}, {0}};
        check(both, Layout::columns, Layout::columns, expected, describe(c.kind_a, a, c.kind_b, b));
      }
    }
  });
}

/// A broken shape that repeats makes every element invalid, whichever side it is on, and never shows as a 1.
TEST_P(Invalid, RepeatedShape) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    const auto size = static_cast<std::size_t>(2 * c.set->lanes(T{}) + 1);
    const Pairs<T> valid = first_of(valid_pairs<T>(c.kind_a, c.kind_b), size);
    Expected expected;
    for (std::size_t i = 0; i < size; ++i) expected.add(VESICA_E_SHAPE);
    for (const Layout layout : {Layout::single, Layout::repeated}) {
      Pairs<T> pairs = valid;
      for (const Numbers<T>& shape : broken(c.kind_a, valid.a[0])) {
        pairs.a[0] = shape;
        check(pairs, layout, Layout::columns, expected, describe(c.kind_a, shape, c.kind_b, valid.b[0]));
      }
      pairs = valid;
      for (const Numbers<T>& shape : broken(c.kind_b, valid.b[0])) {
        pairs.b[0] = shape;
        check(pairs, Layout::columns, layout, expected, describe(c.kind_a, valid.a[0], c.kind_b, shape));
      }
    }
  });
}

/// Negative zero is no negative size, and an AABB without extent no inverted one.
TEST_P(Invalid, ZeroSizesAreValid) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    const Pairs<T> drawn = valid_pairs<T>(c.kind_a, c.kind_b);
    Pairs<T> pairs{c.kind_a, c.kind_b, {}, {}, {}};
    const auto flattened = [](int kind, Numbers<T> shape) {
      for (int k = 0; k < properties::field_count(kind); ++k) {
        if (is_size(role(kind, k))) shape[static_cast<std::size_t>(k)] = T(-0.0);
      }
      if (kind == VESICA_AABB) shape = {shape[0], shape[1], shape[0], shape[1]};
      return shape;
    };
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      pairs.add(flattened(c.kind_a, drawn.a[i]), flattened(c.kind_b, drawn.b[i]));
    }
    const Stretch<T> s(pairs, 0, pairs.size());
    ASSERT_FALSE(s.expected.invalid);
    check(pairs, Layout::columns, Layout::columns, s.expected, "zero sizes");
  });
}

/// Many invalid ones in a block, which the exact stage then works through, in a matrix and in a selection too.
TEST_P(Invalid, AmongManyInBlocks) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    Pairs<T> pairs{c.kind_a, c.kind_b, {}, {}, {}};
    const Pairs<T> valid = valid_pairs<T>(c.kind_a, c.kind_b);
    const std::vector<Numbers<T>> bad = broken(c.kind_b, valid.b[0]);
    const std::size_t size = vesica::batch::block_size<T> + 5;
    for (std::size_t i = 0; i < size; ++i) {
      const bool break_it = i % 3 == 1;
      pairs.add(valid.a[i % 64], break_it ? bad[i % bad.size()] : valid.b[i % 64]);
      EXPECT_EQ(pairs.answers[i] < 0, break_it);
    }
    const Stretch<T> s(pairs, 0, size);
    check(pairs, Layout::columns, Layout::columns, s.expected, "in step");
    check(pairs, Layout::packed, Layout::packed, s.expected, "records in step");
    const Stored<T> a(c.kind_a, pairs.a, Layout::single), b(c.kind_b, pairs.b, Layout::columns);
    const Expected expected = in_step<T>(c.kind_a, pairs.a, true, c.kind_b, pairs.b, false);
    Output out(size);
    expect_tally(vesica::batch::matrix(*c.set->table, a.view(), b.view(), out.data(), 0), expected, "matrix");
    EXPECT_EQ(first_difference(out, expected), -1);
    std::vector<std::int64_t> indices(size, -1);
    expect_tally(vesica::batch::select(*c.set->table, a.view(), b.view(), indices.data(), std::int64_t(size)), expected,
                 "select");
    for (std::size_t i = 0, found = 0; i < size; ++i) {
      if (expected.bytes[i] == 1) {
        EXPECT_EQ(indices[found++], static_cast<std::int64_t>(i));
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, Invalid, testing::ValuesIn(all_cases()), test_name);

}  // namespace
}  // namespace invalid_test
