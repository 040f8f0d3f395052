// SPDX-License-Identifier: Apache-2.0
// Tiles of a matrix that are not computed: tiles whose boxes are apart, and no others. Arrays in spatial order have
// many, beside shapes that touch across the border of a tile, shapes larger than anything, and invalid ones.
#include "tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "properties/random.hpp"

namespace {

using namespace batch_tests;
using vesica::batch::Tiles;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A shape about (x, y) that reaches `size` to both sides: exactly along x, unless it is an ellipse or turned.
properties::Numbers shape_at(int kind, double x, double y, double size, bool turned) {
  const double c = turned ? 0.6 : 1, s = turned ? 0.8 : 0;
  switch (kind) {
    case VESICA_POINT:
      return {x + size, y};
    case VESICA_SEGMENT:
      return {x - size, y, x + size, y + (turned ? size : 0)};
    case VESICA_CIRCLE:
      return {x, y, size};
    case VESICA_AABB:
      return {x - size, y - size, x + size, y + size};
    case VESICA_CAPSULE:
      return {x - size / 2, y, x + size / 2, y + (turned ? size / 2 : 0), size / 2};
    case VESICA_ROUND_RECT:
      return {x, y, c, s, size / 2, turned ? size / 8 : size / 2, size / 2};
    default:
      return {x, y, c, s, size, turned ? size / 4 : size};
  }
}

/// Every shape at another place of a row, in order, a unit apart and reaching half a unit: neighbours touch.
template <class T>
std::vector<Numbers<T>> in_order(int kind, int count, double first, properties::Random& draw) {
  std::vector<Numbers<T>> shapes;
  for (int i = 0; i < count; ++i) {
    shapes.push_back(to_scalar<T>(shape_at(kind, first + i, draw.integer(-1, 1) / 2.0, 0.5, draw.chance(0.3))));
  }
  return shapes;
}

/// Spoils a few: far larger than the others, beyond the finite numbers, far off, or invalid.
template <class T>
void put_odd_ones(int kind, bool with_invalid, std::vector<Numbers<T>>& shapes, properties::Random& draw) {
  const double most = sizeof(T) == sizeof(float) ? 0x1.fffffep127 : 0x1.fffffffffffffp1023;
  for (int i = 0; i < 3; ++i) {
    Numbers<T>& shape = shapes[static_cast<std::size_t>(draw.below(static_cast<int>(shapes.size())))];
    switch (draw.integer(0, with_invalid ? 3 : 2)) {
      case 0:
        shape = to_scalar<T>(shape_at(kind, 0, 0, 300, draw.chance(0.5)));
        break;
      case 1:
        shape = to_scalar<T>(shape_at(kind, draw.chance(0.5) ? most : -most, 0, 1, false));
        break;
      case 2:
        if (is_size(properties::role(kind, 2))) shape[2] = static_cast<T>(most);
        if (is_size(properties::role(kind, 4))) shape[4] = static_cast<T>(most);
        break;
      default:
        shape[draw.chance(0.5) ? 0 : 1] = static_cast<T>(draw.chance(0.5) ? std::nan("") : infinity);
    }
  }
}

TEST(Surroundings, ApartToEachSide) {
  const vesica::batch::Surroundings box{0, 0, 2, 1};
  for (const double x : {-3.0, 0.0, 3.0}) {
    for (const double y : {-2.0, 0.0, 2.0}) {
      EXPECT_EQ(box.apart_from({x, y, x + 2, y + 1}), x != 0 || y != 0) << x << ' ' << y;
    }
  }
  for (const double x : {-2.0, 0.0, 2.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      EXPECT_FALSE(box.apart_from({x, y, x + 2, y + 1})) << "they touch: " << x << ' ' << y;
    }
  }
}

class TilesOfMatrix : public EveryCase {
 protected:
  template <class T>
  void check(const std::vector<Numbers<T>>& shapes_a, const std::vector<Numbers<T>>& shapes_b, Layout layout) {
    const Case& c = GetParam();
    const Stored<T> a(c.kind_a, shapes_a, Layout::columns), b(c.kind_b, shapes_b, layout);
    const std::size_t columns = shapes_b.size();
    Output out(shapes_a.size() * columns);
    const auto tally =
        vesica::batch::matrix(*c.set->table, a.view(), b.view(), out.data(), static_cast<std::ptrdiff_t>(columns));
    Expected expected;
    for (const auto& one : shapes_a) {
      for (const auto& other : shapes_b) expected.add(scalar_answer(c.kind_a, one, c.kind_b, other));
    }
    expect_tally(tally, expected, name(layout));
    EXPECT_TRUE(out.margins_untouched());
    const std::ptrdiff_t wrong = first_difference(out, expected);
    EXPECT_EQ(wrong, -1) << "row " << wrong / static_cast<std::ptrdiff_t>(columns) << ", column "
                         << wrong % static_cast<std::ptrdiff_t>(columns) << ", seed " << properties::seed();
  }
};

TEST_P(TilesOfMatrix, HaveTheAnswersOfPairs) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(properties::seed() + 36);
    for (int round = 0; round < 4; ++round) {
      const int rows = static_cast<int>(Tiles<T>::worth_boxing) + draw.integer(0, 20);
      auto a = in_order<T>(c.kind_a, rows, draw.integer(-64, 64), draw);
      auto b = in_order<T>(c.kind_b, draw.integer(1, 200), 0, draw);
      if (round > 0) put_odd_ones(c.kind_a, round > 1, a, draw);
      if (round > 0) put_odd_ones(c.kind_b, round > 2, b, draw);
      check<T>(a, b, round % 2 == 0 ? Layout::columns : Layout::packed);
    }
  });
}

/// The columns of a block that rows may meet, as a string of '#' and '.', a sign for each 64.
template <class T>
std::string met(Tiles<T>& tiles, std::int64_t row) {
  std::string signs;
  tiles.each(row, 16, [&](std::int32_t begin, std::int32_t length, bool met) {
    EXPECT_EQ(static_cast<std::size_t>(begin), 64 * signs.size());
    signs.append(static_cast<std::size_t>((length + 63) / 64), met ? '#' : '.');
  });
  return signs;
}

/// Shapes in order reach from half a unit below the first place to half a unit above the last.
TEST_P(TilesOfMatrix, AreSkippedWhereBoxesAreApart) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(1);
    auto shapes_b = in_order<T>(c.kind_b, 500, 0, draw);
    std::swap(shapes_b[70], shapes_b[333]);
    const Stored<T> a(c.kind_a, in_order<T>(c.kind_a, 160, 0, draw), Layout::columns),
        b(c.kind_b, shapes_b, Layout::columns);
    Tiles<T> tiles(*c.set->table, a.view(), b.view());
    tiles.begin(0, 500);
    EXPECT_EQ(met(tiles, 0), "#.......");
    EXPECT_EQ(met(tiles, 96), ".#...#..");
    EXPECT_EQ(met(tiles, 140), ".##..#..");
    tiles.begin(384, 116);
    EXPECT_EQ(met(tiles, 144), "..");
  });
}

/// One invalid shape among the rows or columns: its tile is computed, so that the matrix returns the error.
TEST_P(TilesOfMatrix, AreComputedWhereAShapeIsInvalid) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(1);
    auto shapes_a = in_order<T>(c.kind_a, 160, 1000, draw), shapes_b = in_order<T>(c.kind_b, 128, 0, draw);
    shapes_a[20][1] = static_cast<T>(infinity);
    shapes_b[100][0] = static_cast<T>(std::nan(""));
    const Stored<T> a(c.kind_a, shapes_a, Layout::columns), b(c.kind_b, shapes_b, Layout::columns);
    Tiles<T> tiles(*c.set->table, a.view(), b.view());
    tiles.begin(0, 128);
    EXPECT_EQ(met(tiles, 0), ".#");
    EXPECT_EQ(met(tiles, 16), "##");
  });
}

TEST_P(TilesOfMatrix, AreNotLookedForAmongFewRows) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(1);
    const Stored<T> a(c.kind_a, in_order<T>(c.kind_a, Tiles<T>::worth_boxing - 1, 1000, draw), Layout::columns),
        b(c.kind_b, in_order<T>(c.kind_b, 128, 0, draw), Layout::columns);
    Tiles<T> tiles(*c.set->table, a.view(), b.view());
    tiles.begin(0, 128);
    EXPECT_EQ(met(tiles, 0), "##");
  });
}

/// A block of columns that all rows meet: after eight tiles no more are looked at, until the next block.
TEST_P(TilesOfMatrix, AreNotLookedForInVain) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(1);
    const Stored<T> a(c.kind_a, in_order<T>(c.kind_a, 160, 0, draw), Layout::columns),
        b(c.kind_b, in_order<T>(c.kind_b, 128, 0, draw), Layout::columns);
    Tiles<T> tiles(*c.set->table, a.view(), b.view());
    tiles.begin(0, 128);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(met(tiles, 56), "##");
    EXPECT_EQ(met(tiles, 0), "##");
    tiles.begin(0, 128);
    for (int i = 0; i < 7; ++i) EXPECT_EQ(met(tiles, 56), "##");
    EXPECT_EQ(met(tiles, 0), "#.");
    EXPECT_EQ(met(tiles, 56), "##");
    EXPECT_EQ(met(tiles, 0), "#.");
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, TilesOfMatrix, testing::ValuesIn(all_cases()), test_name);

}  // namespace
