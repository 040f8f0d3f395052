// SPDX-License-Identifier: Apache-2.0
// Some pairs have a quicker filter for axes of unit length, which leaves others undecided, and thin ellipses; where it
// leaves more than a 32nd of a block, the general one is run over the block. Answers must not depend on which was.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "batch/unit_shapes.hpp"
#include "columns.hpp"

namespace {

using namespace batch_tests;

/// The pairs that have a quicker filter.
std::vector<Case> quick_cases() {
  std::vector<Case> cases;
  for (const Case& c : all_cases()) {
    const bool boxed = c.kind_a == VESICA_RECT && (c.kind_b == VESICA_RECT || c.kind_b == VESICA_ELLIPSE);
    const bool round = properties::is_round(c.kind_a) && c.kind_b == VESICA_ELLIPSE;
    if (boxed || round) cases.push_back(c);
  }
  return cases;
}

/// Unit axes only, one in `near_tie_in` near a tie, which the quick filter alone decides or leaves.
template <class T>
Pairs<T> unit_pairs(const Case& kinds, int count, int near_tie_in) {
  properties::Random draw(properties::seed());
  Pairs<T> pairs{kinds.kind_a, kinds.kind_b, {}, {}, {}};
  for (int i = 0; i < count; ++i) {
    const properties::Numbers a = unit_shape(kinds.kind_a, scalar_of<T>, draw);
    properties::Numbers b = unit_shape(kinds.kind_b, scalar_of<T>, draw);
    if (i % near_tie_in == 0) b = brought_to_contact(scalar_of<T>, kinds, a, b, draw);
    pairs.add(to_scalar<T>(a), to_scalar<T>(b));
  }
  return pairs;
}

/// Pairs drawn from those of unit axes, `how_many` of them odd in a random place of one of the two arrays.
template <class T>
Pairs<T> block_of_pairs(const Case& kinds, const Pairs<T>& from, std::size_t size, std::size_t how_many, Odd odd) {
  Pairs<T> pairs{kinds.kind_a, kinds.kind_b, {}, {}, {}};
  properties::Random draw(properties::seed() + size + how_many);
  const std::size_t every = size / std::max<std::size_t>(how_many, 1);
  for (std::size_t i = 0; i < size; ++i) {
    const auto at = static_cast<std::size_t>(draw.below(static_cast<int>(from.size())));
    Numbers<T> a = from.a[at], b = from.b[at];
    if (how_many != 0 && i % every == every / 2 && i / every < how_many) make_odd(kinds, a, b, odd, draw);
    pairs.add(a, b);
  }
  return pairs;
}

class UnitAxes : public EveryCase {
 protected:
  template <class T>
  void check(const Pairs<T>& pairs, Layout layout_a, Layout layout_b, const std::string& what) {
    const auto [kind_a, kind_b] = std::pair(GetParam().kind_a, GetParam().kind_b);
    const Stretch<T> s(pairs, 0, pairs.size());
    const Expected expected = in_step<T>(kind_a, s.a, one_shape(layout_a), kind_b, s.b, one_shape(layout_b));
    const Stored<T> a(kind_a, s.a, layout_a), b(kind_b, s.b, layout_b);
    expect_many(*GetParam().set->table, a, b, expected, what + ", " + name(layout_a) + " with " + name(layout_b));
  }
};

TEST_P(UnitAxes, AgreesWithAnyShareOfOddOnes) {
  in_its_scalar([this]<class T>(T) {
    constexpr std::size_t block = vesica::batch::block_size<T>;
    const Pairs<T> from = unit_pairs<T>(GetParam(), 3000, 100);
    for (const Odd odd : all_odd) {
      for (const std::size_t how_many :
           {std::size_t{1}, std::size_t{9}, block / 32, block / 32 + 1, block / 4, block / 4 + 1, block}) {
        const Pairs<T> pairs = block_of_pairs<T>(GetParam(), from, block, how_many, odd);
        const std::string what =
            std::to_string(how_many) + " odd of " + std::to_string(block) + ", way " + std::to_string(int(odd));
        check<T>(pairs, Layout::columns, Layout::columns, what);
        check<T>(pairs, Layout::packed, Layout::packed, what);
      }
    }
  });
}

/// The block before and the one after must not be touched by what one block is decided with.
TEST_P(UnitAxes, AgreesWhenOnlyOneBlockIsOdd) {
  in_its_scalar([this]<class T>(T) {
    constexpr std::size_t block = vesica::batch::block_size<T>;
    const Pairs<T> from = unit_pairs<T>(GetParam(), 3000, 100);
    Pairs<T> pairs{GetParam().kind_a, GetParam().kind_b, {}, {}, {}};
    for (const Odd odd : {Odd::nothing, Odd::longer, Odd::nothing}) {
      const Pairs<T> part = block_of_pairs<T>(GetParam(), from, block, block, odd);
      for (std::size_t i = 0; i < part.size(); ++i) pairs.add(part.a[i], part.b[i]);
    }
    check<T>(pairs, Layout::columns, Layout::packed, "an odd block between two of unit axes");
    check<T>(pairs, Layout::packed, Layout::packed, "an odd block between two of unit axes");
  });
}

/// One shape, odd or not, with many, odd or not, the other way round too.
TEST_P(UnitAxes, AgreesWhenOneIsRepeated) {
  in_its_scalar([this]<class T>(T) {
    const Pairs<T> from = unit_pairs<T>(GetParam(), 3000, 100);
    properties::Random draw(properties::seed());
    for (const Odd one : all_odd) {
      for (const Odd rest : {Odd::nothing, Odd::longer, Odd::not_finite}) {
        Pairs<T> pairs = block_of_pairs<T>(GetParam(), from, 200, 40, rest);
        if (has_axis(pairs.kind_a)) pairs.a[0] = made_odd(pairs.a[0], one, draw);
        pairs.b[0] = made_odd(pairs.b[0], one, draw);
        const std::string what = "ways " + std::to_string(int(one)) + ", " + std::to_string(int(rest));
        check<T>(pairs, Layout::single, Layout::columns, what);
        check<T>(pairs, Layout::single, Layout::packed, what);
        check<T>(pairs, Layout::columns, Layout::repeated, what);
      }
    }
  });
}

/// Few enough near ties that no block of them goes to the general filter.
TEST_P(UnitAxes, AgreesAtContact) {
  in_its_scalar([this]<class T>(T) {
    const Pairs<T> pairs = unit_pairs<T>(GetParam(), 100000 * properties::repeat(), 40);
    check<T>(pairs, Layout::columns, Layout::columns, "at contact");
    check<T>(pairs, Layout::packed, Layout::packed, "at contact");
    check<T>(pairs, Layout::single, Layout::packed, "at contact");
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, UnitAxes, testing::ValuesIn(quick_cases()), test_name);

}  // namespace
