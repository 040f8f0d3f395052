// SPDX-License-Identifier: Apache-2.0
// Rectangles with axes near unit length have a quicker filter, which leaves all others undecided; where it leaves more
// than a quarter of a block, the general one is run over the block. Answers must not depend on which was.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "batch/data.hpp"
#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "columns.hpp"
#include "properties/random.hpp"

namespace {

using namespace batch_tests;

std::vector<Case> rectangle_cases() {
  std::vector<Case> cases;
  for (const Case& c : all_cases()) {
    if (c.kind_a == VESICA_RECT && c.kind_b == VESICA_RECT) cases.push_back(c);
  }
  return cases;
}

/// What becomes of some rectangles of a block of unit axes.
enum class Odd {
  nothing,
  longer,      ///< the same set with an axis four times as long and sizes a quarter
  edge,        ///< an axis whose squared length is 1/2 or 2, the ends of the quick filter's range
  just_off,    ///< an axis one place beyond such an end
  enormous,    ///< an axis of 2^40
  subnormal,   ///< the smallest axis there is
  not_finite,  ///< an invalid rectangle
  negative,    ///< another
  no_axis,     ///< another
};
constexpr std::array all_odd{Odd::nothing,   Odd::longer,     Odd::edge,     Odd::just_off, Odd::enormous,
                             Odd::subnormal, Odd::not_finite, Odd::negative, Odd::no_axis};

template <class T>
Numbers<T> made_odd(Numbers<T> r, Odd odd, bool coin) {
  const T below_half = coin ? T(0.5) : T(1);  // components of an axis of squared length 1/2, or 2
  switch (odd) {
    case Odd::longer:
      return {r[0], r[1], r[2] * 4, r[3] * 4, r[4] / 4, r[5] / 4};
    case Odd::edge:
      return {r[0], r[1], below_half, -below_half, r[4], r[5]};
    case Odd::just_off:
      return {r[0], r[1], below_half, std::nextafter(below_half, coin ? T(0) : T(2)), r[4], r[5]};
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

/// Rectangles of unit axes, near ties among them, `how_many` of them odd in a random place of one of the two arrays.
template <class T>
Pairs<T> block_of_pairs(std::size_t size, std::size_t how_many, Odd odd) {
  static const Pairs<T> random = pairs_of<T>(properties::Workload::random, VESICA_RECT, VESICA_RECT, 1500);
  static const Pairs<T> touching = pairs_about_contact<T>(VESICA_RECT, VESICA_RECT, 1500);
  Pairs<T> pairs{VESICA_RECT, VESICA_RECT, {}, {}, {}};
  properties::Random draw(properties::seed() + size + how_many);
  const std::size_t every = size / std::max<std::size_t>(how_many, 1);
  for (std::size_t i = 0; i < size; ++i) {
    const Pairs<T>& from = draw.chance(0.1) ? touching : random;
    const auto at = static_cast<std::size_t>(draw.below(1500));
    Numbers<T> a = from.a[at], b = from.b[at];
    const bool here = how_many != 0 && i % every == every / 2 && i / every < how_many;
    if (here) (draw.chance(0.5) ? a : b) = made_odd(draw.chance(0.5) ? a : b, odd, draw.chance(0.5));
    pairs.add(a, b);
  }
  return pairs;
}

class UnitAxes : public EveryCase {
 protected:
  template <class T>
  void check(const Pairs<T>& pairs, Layout layout_a, Layout layout_b, const std::string& what) {
    const Stretch<T> s(pairs, 0, pairs.size());
    const Expected expected = in_step<T>(VESICA_RECT, s.a, one_shape(layout_a), VESICA_RECT, s.b, one_shape(layout_b));
    const Stored<T> a(VESICA_RECT, s.a, layout_a), b(VESICA_RECT, s.b, layout_b);
    expect_many(*GetParam().set->table, a, b, expected, what + ", " + name(layout_a) + " with " + name(layout_b));
  }
};

TEST_P(UnitAxes, AgreesWithAnyShareOfOddOnes) {
  in_its_scalar([this]<class T>(T) {
    constexpr std::size_t block = vesica::batch::block_size<T>;
    for (const Odd odd : all_odd) {
      for (const std::size_t how_many :
           {std::size_t{1}, block / 8, block / 4 - 1, block / 4, block / 4 + 1, block / 2, block}) {
        const Pairs<T> pairs = block_of_pairs<T>(block, how_many, odd);
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
    Pairs<T> pairs{VESICA_RECT, VESICA_RECT, {}, {}, {}};
    for (const Odd odd : {Odd::nothing, Odd::longer, Odd::nothing}) {
      const Pairs<T> part = block_of_pairs<T>(block, block, odd);
      for (std::size_t i = 0; i < part.size(); ++i) pairs.add(part.a[i], part.b[i]);
    }
    check<T>(pairs, Layout::columns, Layout::packed, "an odd block between two of unit axes");
  });
}

/// One rectangle, odd or not, with many, odd or not, the other way round too.
TEST_P(UnitAxes, AgreesWhenOneIsRepeated) {
  in_its_scalar([this]<class T>(T) {
    for (const Odd one : all_odd) {
      for (const Odd rest : {Odd::nothing, Odd::longer, Odd::not_finite}) {
        Pairs<T> pairs = block_of_pairs<T>(200, 40, rest);
        pairs.a[0] = made_odd(pairs.a[0], one, true);
        pairs.b[0] = made_odd(pairs.b[0], one, false);
        const std::string what = "ways " + std::to_string(int(one)) + ", " + std::to_string(int(rest));
        check<T>(pairs, Layout::single, Layout::columns, what);
        check<T>(pairs, Layout::columns, Layout::repeated, what);
      }
    }
  });
}

constexpr int rectangles_at_contact = 60000;

/// A rectangle of unit axis but for rounding, its sizes of one of a few magnitudes.
properties::Numbers unit_rectangle(properties::Scalar scalar, properties::Random& draw) {
  const double angle = draw.between(0, 6.2831853);
  const double longer = std::ldexp(draw.between(1, 2), draw.integer(-3, 0));
  const double shorter = std::ldexp(draw.between(1, 2), draw.integer(-9, 0));
  const double x = draw.between(-1, 1), y = draw.between(-1, 1);
  return properties::nearest_shape(scalar, VESICA_RECT, {x, y, std::cos(angle), std::sin(angle), longer, shorter});
}

/// Moves b across one of a's axes to where the two just touch by a computation in double; rounding and up to 16 places
/// of one number then put some of them apart and join others, all well within what the quick filter's bound must cover.
properties::Numbers brought_to_contact(properties::Scalar scalar, const properties::Numbers& a, properties::Numbers b,
                                       properties::Random& draw) {
  const double c = std::fabs(a[2] * b[2] + a[3] * b[3]), s = std::fabs(a[2] * b[3] - a[3] * b[2]);
  const double along = draw.sign() * (a[4] + b[4] * c + b[5] * s);
  const double across = draw.between(-1, 1) * (a[5] + (b[4] * s + b[5] * c) / 2);
  b[0] = a[0] + along * a[2] - across * a[3];
  b[1] = a[1] + along * a[3] + across * a[2];
  double& x = b[static_cast<std::size_t>(draw.below(6))];
  const std::int64_t place = properties::ordinal(scalar, properties::nearest(scalar, x));
  x = properties::at_ordinal(scalar, place + draw.integer(-16, 16));
  return properties::nearest_shape(scalar, VESICA_RECT, b);
}

/// Near ties of unit axes only, which the quick filter alone decides or leaves.
TEST_P(UnitAxes, AgreesAtContact) {
  in_its_scalar([this]<class T>(T) {
    properties::Random draw(properties::seed());
    Pairs<T> pairs{VESICA_RECT, VESICA_RECT, {}, {}, {}};
    while (static_cast<int>(pairs.size()) < rectangles_at_contact * properties::repeat()) {
      const properties::Numbers a = unit_rectangle(scalar_of<T>, draw);
      properties::Numbers b = unit_rectangle(scalar_of<T>, draw);
      // Easy pairs between, for a block of near ties alone would go to the general filter.
      if (pairs.size() % 5 == 0) b = brought_to_contact(scalar_of<T>, a, b, draw);
      pairs.add(to_scalar<T>(a), to_scalar<T>(b));
    }
    check<T>(pairs, Layout::columns, Layout::columns, "at contact");
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, UnitAxes, testing::ValuesIn(rectangle_cases()), test_name);

}  // namespace
