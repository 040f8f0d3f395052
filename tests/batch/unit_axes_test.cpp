// SPDX-License-Identifier: Apache-2.0
// Some pairs have a quicker filter for axes of unit length, which leaves others undecided, and thin ellipses; where it
// leaves more than a 32nd of a block, the general one is run over the block. Answers must not depend on which was.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "columns.hpp"
#include "properties/random.hpp"

namespace {

using namespace batch_tests;

/// The pairs that have a quicker filter.
std::vector<Case> quick_cases() {
  std::vector<Case> cases;
  for (const Case& c : all_cases()) {
    const bool boxed = c.kind_a == VESICA_RECT && (c.kind_b == VESICA_RECT || c.kind_b == VESICA_ELLIPSE);
    const bool round = (c.kind_a == VESICA_CIRCLE || c.kind_a == VESICA_ELLIPSE) && c.kind_b == VESICA_ELLIPSE;
    if (boxed || round) cases.push_back(c);
  }
  return cases;
}

/// What becomes of some shapes of a block of unit axes.
enum class Odd {
  nothing,
  longer,      ///< the same set with an axis four times as long and sizes a quarter
  edge,        ///< an axis whose squared length is 1/2 or 2, the ends of the range for two rectangles
  just_off,    ///< an axis one place beyond such an end
  nearly,      ///< an axis a few places from unit length, about the ends of the range for the others
  thin,        ///< sizes at a ratio of 16, where an ellipse begins to be thin
  thinner,     ///< sizes at a ratio of 17.5
  outsized,    ///< a size about the ends of the range for ellipses
  enormous,    ///< an axis of 2^40
  subnormal,   ///< the smallest axis there is
  not_finite,  ///< an invalid shape
  negative,    ///< another
  no_axis,     ///< another
};
constexpr std::array all_odd{Odd::nothing,    Odd::longer,   Odd::edge,     Odd::just_off, Odd::nearly,
                             Odd::thin,       Odd::thinner,  Odd::outsized, Odd::enormous, Odd::subnormal,
                             Odd::not_finite, Odd::negative, Odd::no_axis};

template <class T>
Numbers<T> made_odd(Numbers<T> r, Odd odd, properties::Random& draw) {
  const bool coin = draw.chance(0.5);
  const T below_half = coin ? T(0.5) : T(1);  // components of an axis of squared length 1/2, or 2
  switch (odd) {
    case Odd::longer:
      return {r[0], r[1], r[2] * 4, r[3] * 4, r[4] / 4, r[5] / 4};
    case Odd::edge:
      return {r[0], r[1], below_half, -below_half, r[4], r[5]};
    case Odd::just_off:
      return {r[0], r[1], below_half, std::nextafter(below_half, coin ? T(0) : T(2)), r[4], r[5]};
    case Odd::nearly: {
      T x = 1;
      for (int i = draw.below(9); i > 0; --i) x = std::nextafter(x, coin ? T(0) : T(2));
      return {r[0], r[1], x, 0, r[4], r[5]};
    }
    case Odd::thin:
      return {r[0], r[1], r[2], r[3], r[4], coin ? r[4] / 16 : r[4] * 16};
    case Odd::thinner:
      return {r[0], r[1], r[2], r[3], r[4], coin ? r[4] / T(17.5) : r[4] * T(17.5)};
    case Odd::outsized: {
      const int range = sizeof(T) == sizeof(float) ? 1 : 8, places = draw.integer(-2, 2);
      T size = std::ldexp(T(1), (coin ? 10 : -6) * range);
      for (int i = 0; i < std::abs(places); ++i) size = std::nextafter(size, places < 0 ? T(0) : 2 * size);
      return {r[0], r[1], r[2], r[3], size, size};
    }
    case Odd::enormous:
      return {r[0], r[1], r[2] * T(0x1p40), r[3] * T(0x1p40), r[4], r[5]};
    case Odd::subnormal:
      return {r[0], r[1], std::numeric_limits<T>::denorm_min(), 0, r[4], r[5]};
    case Odd::not_finite:
      r[coin ? 0 : 4] = std::numeric_limits<T>::infinity();
      return r;
    case Odd::negative:
      r[coin ? 4 : 5] = -r[coin ? 4 : 5] - std::numeric_limits<T>::denorm_min();
      return r;
    case Odd::no_axis:
      return {r[0], r[1], 0, T(-0.0), r[4], r[5]};
    default:
      return r;
  }
}

bool has_axis(int kind) { return kind == VESICA_RECT || kind == VESICA_ELLIPSE; }

/// One of the two shapes made odd, one that has an axis.
template <class T>
void make_odd(const Case& kinds, Numbers<T>& a, Numbers<T>& b, Odd odd, properties::Random& draw) {
  Numbers<T>& shape = has_axis(kinds.kind_a) && draw.chance(0.5) ? a : b;
  shape = made_odd(shape, odd, draw);
}

/// A shape of unit axis but for rounding, its sizes of one of a few magnitudes.
properties::Numbers unit_shape(int kind, properties::Scalar scalar, properties::Random& draw) {
  const double longer = std::ldexp(draw.between(1, 2), draw.integer(-3, 0));
  const double x = draw.between(-1, 1), y = draw.between(-1, 1);
  if (kind == VESICA_CIRCLE) return properties::nearest_shape(scalar, kind, {x, y, longer});
  const double angle = draw.between(0, 6.2831853);
  const double shorter = std::ldexp(draw.between(1, 2), draw.integer(kind == VESICA_ELLIPSE ? -5 : -9, 0));
  return properties::nearest_shape(scalar, kind, {x, y, std::cos(angle), std::sin(angle), longer, shorter});
}

/// Moves b straight away from a to where they just touch; rounding and up to 16 places of one number then put some of
/// them apart and join others, all well within what the quick filter's bound must cover.
properties::Numbers brought_to_contact(properties::Scalar scalar, const Case& kinds, const properties::Numbers& a,
                                       properties::Numbers b, properties::Random& draw) {
  const double angle = draw.between(0, 6.2831853), x = b[0], y = b[1];
  double near = 0, far = 16;
  for (int i = 0; i < 60; ++i) {
    const double middle = (near + far) / 2;
    b[0] = x + middle * std::cos(angle), b[1] = y + middle * std::sin(angle);
    (vesica_overlap_f64(kinds.kind_a, a.data(), kinds.kind_b, b.data()) == 1 ? near : far) = middle;
  }
  double& number = b[static_cast<std::size_t>(draw.below(6))];
  const std::int64_t place = properties::ordinal(scalar, properties::nearest(scalar, number));
  number = properties::at_ordinal(scalar, place + draw.integer(-16, 16));
  return properties::nearest_shape(scalar, kinds.kind_b, b);
}

/// Unit axes only, one in so many near a tie, which the quick filter alone decides or leaves.
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

/// Pairs of unit axes, a few near ties among them, `how_many` of them odd in a random place of one of the two arrays.
template <class T>
Pairs<T> block_of_pairs(const Case& kinds, std::size_t size, std::size_t how_many, Odd odd) {
  constexpr int count = 3000, near_tie_in = 100;
  const Pairs<T> from = unit_pairs<T>(kinds, count, near_tie_in);
  Pairs<T> pairs{kinds.kind_a, kinds.kind_b, {}, {}, {}};
  properties::Random draw(properties::seed() + size + how_many);
  const std::size_t every = size / std::max<std::size_t>(how_many, 1);
  for (std::size_t i = 0; i < size; ++i) {
    const auto at = static_cast<std::size_t>(draw.below(count));
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
    for (const Odd odd : all_odd) {
      for (const std::size_t how_many :
           {std::size_t{1}, std::size_t{9}, block / 32, block / 32 + 1, block / 4, block / 4 + 1, block}) {
        const Pairs<T> pairs = block_of_pairs<T>(GetParam(), block, how_many, odd);
        const std::string what =
            std::to_string(how_many) + " odd of " + std::to_string(block) + ", way " + std::to_string(int(odd));
        check<T>(pairs, Layout::columns, Layout::columns, what);
      }
    }
  });
}

/// The block before and the one after must not be touched by what one block is decided with.
TEST_P(UnitAxes, AgreesWhenOnlyOneBlockIsOdd) {
  in_its_scalar([this]<class T>(T) {
    constexpr std::size_t block = vesica::batch::block_size<T>;
    Pairs<T> pairs{GetParam().kind_a, GetParam().kind_b, {}, {}, {}};
    for (const Odd odd : {Odd::nothing, Odd::longer, Odd::nothing}) {
      const Pairs<T> part = block_of_pairs<T>(GetParam(), block, block, odd);
      for (std::size_t i = 0; i < part.size(); ++i) pairs.add(part.a[i], part.b[i]);
    }
    check<T>(pairs, Layout::columns, Layout::packed, "an odd block between two of unit axes");
  });
}

/// One shape, odd or not, with many, odd or not, the other way round too.
TEST_P(UnitAxes, AgreesWhenOneIsRepeated) {
  in_its_scalar([this]<class T>(T) {
    properties::Random draw(properties::seed());
    for (const Odd one : all_odd) {
      for (const Odd rest : {Odd::nothing, Odd::longer, Odd::not_finite}) {
        Pairs<T> pairs = block_of_pairs<T>(GetParam(), 200, 40, rest);
        if (has_axis(pairs.kind_a)) pairs.a[0] = made_odd(pairs.a[0], one, draw);
        pairs.b[0] = made_odd(pairs.b[0], one, draw);
        const std::string what = "ways " + std::to_string(int(one)) + ", " + std::to_string(int(rest));
        check<T>(pairs, Layout::single, Layout::columns, what);
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
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, UnitAxes, testing::ValuesIn(quick_cases()), test_name);

}  // namespace
