// SPDX-License-Identifier: Apache-2.0
// Rows of a matrix against a block that was checked as a whole. What such a kernel decides must be right however near
// to contact a pair is, whatever the sizes beside it; it must leave little undecided; and a matrix must have the same
// bytes where it cannot be asked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "batch/unit_shapes.hpp"
#include "capi/face.hpp"
#include "columns.hpp"
#include "environment/environments.hpp"

namespace {

using namespace batch_tests;

template <class T>
constexpr auto stride = vesica::batch::block_size<T>;

template <class T>
auto kernels_of(const Case& c) {
  return c.set->table->checked(T{}).of[c.kind_a][c.kind_b];
}

std::vector<Case> checked_cases() {
  std::vector<Case> cases;
  for (const Case& c : all_cases()) {
    const bool has = c.scalar == properties::Scalar::f32 ? kernels_of<float>(c).check_block != nullptr
                                                         : kernels_of<double>(c).check_block != nullptr;
    if (has) cases.push_back(c);
  }
  return cases;
}

/// A kernel's answers for one shape and a block.
template <class T>
struct Said {
  bool block_taken = false, row_taken = false;
  std::vector<std::uint8_t> bytes;
  std::vector<bool> known;

  int undecided() const { return static_cast<int>(std::count(known.begin(), known.end(), false)); }
};

template <class T>
Said<T> ask(const Case& c, const Numbers<T>& one, const std::vector<Numbers<T>>& many) {
  const std::size_t n = many.size();
  std::vector<T> columns(6 * n), space(6 * stride<T>);
  vesica::Block<T> block{};
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t i = 0; i < n; ++i) columns[k * n + i] = many[i][k];
    const bool in_order = c.kind_a <= c.kind_b;
    (in_order ? block.first : block.second)[k] = &one[k];
    (in_order ? block.second : block.first)[k] = columns.data() + k * n;
  }
  Said<T> said;
  std::vector<std::int32_t> list(n);
  said.bytes.assign(n, 2);
  said.known.assign(n, true);
  block.count = block.give_up = static_cast<std::int32_t>(n);
  block.out = said.bytes.data();
  block.undecided = list.data();
  const auto kernels = kernels_of<T>(c);
  said.block_taken = kernels.check_block(block, space.data(), stride<T>);
  if (!said.block_taken) return said;
  const vesica::BlockResult result = kernels.answer(block);
  said.row_taken = result.undecided != vesica::row_is_unusable;
  if (!said.row_taken) return said;
  for (int i = 0; i < result.undecided; ++i)
    said.known[static_cast<std::size_t>(list[static_cast<std::size_t>(i)])] = false;
  EXPECT_EQ(result.overlaps, std::count(said.bytes.begin(), said.bytes.end(), 1));
  return said;
}

/// Both sizes times 2^k, an ellipse's within the range that is asked for.
properties::Numbers resized(properties::Numbers shape, int k) {
  shape[4] = std::ldexp(shape[4], k);
  shape[5] = std::ldexp(shape[5], k);
  return shape;
}

/// A shape that the check takes: its axis as it is made, an ellipse no thinner than 1 : 12.
template <class T>
properties::Numbers taken_shape(int kind, int spread, properties::Random& draw) {
  properties::Numbers shape = resized(unit_shape(kind, scalar_of<T>, draw), draw.integer(-spread, spread));
  if (kind == VESICA_ELLIPSE) shape[5] = std::clamp(shape[5], shape[4] / 12, shape[4] * 12);
  return properties::nearest_shape(scalar_of<T>, kind, shape);
}

/// Shapes that touch `a`, each then moved or grown by up to 2^14 places of one number.
template <class T>
std::vector<Numbers<T>> at_contact(const Case& c, const properties::Numbers& a, int n, int spread,
                                   properties::Random& draw) {
  std::vector<Numbers<T>> many;
  for (int i = 0; i < n; ++i) {
    const properties::Numbers made = taken_shape<T>(c.kind_b, spread, draw);
    properties::Numbers b = made;
    b[0] += a[0];
    b[1] += a[1];
    b = brought_to_contact(scalar_of<T>, c, a, b, draw);
    std::copy_n(made.begin() + 2, 4, b.begin() + 2);
    double& number = b[static_cast<std::size_t>(draw.chance(0.5) ? draw.below(2) : draw.integer(4, 5))];
    const int places = 1 << draw.integer(0, draw.chance(0.5) ? 2 : 14);
    number = properties::at_ordinal(
        scalar_of<T>,
        properties::ordinal(scalar_of<T>, properties::nearest(scalar_of<T>, number)) + draw.integer(-places, places));
    many.push_back(to_scalar<T>(properties::nearest_shape(scalar_of<T>, c.kind_b, b)));
  }
  return many;
}

class Checked : public EveryCase {};

/// Every pair within 2^14 last places of contact; sizes alike, and from 1/8 to 8 times in one block; about the
/// origin and far from it. Some are decided, and rightly.
TEST_P(Checked, DecidesNoContactWrongly) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(properties::seed());
    int decided = 0, asked = 0, wrong = 0;
    for (int round = 0; round < 100 * properties::repeat(); ++round) {
      const int spread = round % 2 == 0 ? 0 : 3;
      properties::Numbers a = taken_shape<T>(c.kind_a, spread, draw);
      if (round % 4 > 1) a[0] += 1000;
      a = properties::nearest_shape(scalar_of<T>, c.kind_a, a);
      const Numbers<T> one = to_scalar<T>(a);
      const std::vector<Numbers<T>> many = at_contact<T>(c, a, 3 * c.set->lanes(T{}), spread, draw);
      const Said<T> said = ask<T>(c, one, many);
      ASSERT_TRUE(said.block_taken && said.row_taken);
      for (std::size_t i = 0; i < many.size(); ++i) {
        ++asked;
        if (!said.known[i]) continue;
        ++decided;
        if (said.bytes[i] == scalar_answer(c.kind_a, one, c.kind_b, many[i])) continue;
        if (++wrong <= 3) ADD_FAILURE() << describe(c.kind_a, one, c.kind_b, many[i]);
      }
    }
    EXPECT_EQ(wrong, 0) << "seed " << properties::seed();
    EXPECT_GT(decided, asked / 20) << "of " << asked;
  });
}

/// Places and sizes of ordinary data: the longer half size or length from `least` to `most`, aspects up to 4, centres
/// within `room` of a point.
struct Ordinary {
  const char* name;
  double least, most, room, away;
};
constexpr Ordinary ordinary[] = {{"unit scale", 0.2, 1, 1, 0},
                                 {"pixels", 4, 60, 200, 0},
                                 {"far from the origin", 10, 100, 200, 1e6},
                                 {"a small cluster", 0.05, 0.1, 0.1, 50},
                                 {"three decades", 0.02, 20, 10, 0}};

template <class T>
std::vector<Numbers<T>> shapes_of(const Ordinary& data, int kind, int n, properties::Random& draw) {
  std::vector<Numbers<T>> shapes;
  for (int i = 0; i < n; ++i) {
    const double size = data.least * std::pow(data.most / data.least, draw.unit()), angle = draw.between(0, 6.2831853);
    const double x = data.away + draw.between(-data.room, data.room),
                 y = data.away + draw.between(-data.room, data.room);
    shapes.push_back(to_scalar<T>(properties::nearest_shape(
        scalar_of<T>, kind, {x, y, std::cos(angle), std::sin(angle), size, size * draw.between(0.25, 1)})));
  }
  return shapes;
}

/// At most a thousandth in float, none in double. But a rectangle and an ellipse a thousandth of its size have a bound
/// that is too wide for float: such blocks are left to the other kernels.
TEST_P(Checked, LeavesLittleUndecided) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(1);
    for (const Ordinary& data : ordinary) {
      constexpr int rows = 64, n = stride<T>;
      const std::vector<Numbers<T>> a = shapes_of<T>(data, c.kind_a, rows, draw);
      const std::vector<Numbers<T>> b = shapes_of<T>(data, c.kind_b, n, draw);
      int undecided = 0;
      for (const Numbers<T>& one : a) {
        const Said<T> said = ask<T>(c, one, b);
        ASSERT_TRUE(said.block_taken && said.row_taken) << data.name;
        undecided += said.undecided();
      }
      const bool too_unlike = c.kind_a != c.kind_b && data.most / data.least > 100;
      EXPECT_LE(undecided, sizeof(T) == sizeof(double) ? 0 : rows * n / (too_unlike ? 32 : 1000)) << data.name;
    }
  });
}

/// A matrix, each byte against the scalar function's answer.
template <class T>
void expect_matrix(const Case& c, const std::vector<Numbers<T>>& rows, const std::vector<Numbers<T>>& columns,
                   const std::string& what) {
  const Stored<T> a(c.kind_a, rows, Layout::columns), b(c.kind_b, columns, Layout::packed);
  std::vector<std::uint8_t> out(rows.size() * columns.size(), untouched);
  const vesica::batch::Tally tally =
      vesica::batch::matrix(*c.set->table, a.view(), b.view(), out.data(), static_cast<std::ptrdiff_t>(columns.size()));
  std::int64_t overlaps = 0, unlike = 0;
  bool invalid = false;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::int32_t answer =
        scalar_answer(c.kind_a, rows[i / columns.size()], c.kind_b, columns[i % columns.size()]);
    overlaps += answer == 1;
    invalid = invalid || answer < 0;
    unlike += out[i] != (answer == 1);
  }
  EXPECT_EQ(unlike, 0) << what << ", seed " << properties::seed();
  EXPECT_EQ(tally.overlaps, overlaps) << what;
  EXPECT_EQ(tally.invalid, invalid) << what;
}

/// One odd shape, or a few, among the rows, the columns or both; and few enough contacts that the kernel is kept.
TEST_P(Checked, MatrixIsRightWithOddShapes) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(properties::seed());
    constexpr int rows = 6;
    const auto shapes = [&](int kind, int n) {
      std::vector<Numbers<T>> made;
      for (int i = 0; i < n; ++i) made.push_back(to_scalar<T>(taken_shape<T>(kind, 0, draw)));
      return made;
    };
    for (const Odd odd : all_odd) {
      for (const int n : {c.set->lanes(T{}), 3 * c.set->lanes(T{}) - 1, stride<T> / 4 + 3}) {
        std::vector<Numbers<T>> a = shapes(c.kind_a, rows), b = shapes(c.kind_b, n);
        const std::string what = "way " + std::to_string(int(odd)) + ", " + std::to_string(n) + " columns";
        Numbers<T>& row = a[static_cast<std::size_t>(draw.below(rows))];
        Numbers<T>& column = b[static_cast<std::size_t>(draw.below(n))];
        row = made_odd(row, odd, draw);
        expect_matrix<T>(c, a, b, what + ", a row");
        column = made_odd(column, odd, draw);
        expect_matrix<T>(c, a, b, what + ", a row and a column");
        row = to_scalar<T>(taken_shape<T>(c.kind_a, 0, draw));
        expect_matrix<T>(c, a, b, what + ", a column");
      }
    }
  });
}

/// Every length about one to three vectors, all at contact with the first row and none with others; as many rows as are
/// worth the check, one fewer and more.
TEST_P(Checked, MatrixIsRightAtEveryLength) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(properties::seed());
    for (int n = 1; n <= 3 * c.set->lanes(T{}) + 1; ++n) {
      std::vector<Numbers<T>> rows;
      const properties::Numbers first = taken_shape<T>(c.kind_a, 0, draw);
      const std::vector<Numbers<T>> columns = at_contact<T>(c, first, n, 1, draw);
      for (int i = 0; i < 3 + n % 4; ++i) {
        rows.push_back(to_scalar<T>(i % 4 == 0 ? first : taken_shape<T>(c.kind_a, 0, draw)));
      }
      expect_matrix<T>(c, rows, columns, std::to_string(n) + " columns at contact");
    }
  });
}

/// A block whose last shape is unlike the others: far larger, far away, tiny, or
/// too large or too far for the bound.
TEST_P(Checked, MatrixIsRightWithOneOfAnotherScale) {
  in_its_scalar([this]<class T>(T) {
    const Case& c = GetParam();
    properties::Random draw(properties::seed());
    const int range = sizeof(T) == sizeof(float) ? 1 : 8;
    for (const int exponent :
         {-140 * range, -80 * range, -20 * range, -5, 5, 9, 20, 31 * range, 33 * range, 100 * range}) {
      for (const bool far_away : {false, true}) {
        const properties::Numbers first = taken_shape<T>(c.kind_a, 0, draw);
        std::vector<Numbers<T>> rows, columns = at_contact<T>(c, first, 5 * c.set->lanes(T{}), 0, draw);
        for (int i = 0; i < 5; ++i) {
          rows.push_back(to_scalar<T>(i == 0 ? first : taken_shape<T>(c.kind_a, 0, draw)));
        }
        for (Numbers<T>* one : {&columns.back(), &rows.back()}) {
          for (const std::size_t k : {std::size_t{0}, std::size_t{4}, std::size_t{5}}) {
            if ((k == 0) == far_away) (*one)[k] = std::ldexp((*one)[k], exponent);
          }
          expect_matrix<T>(c, rows, columns, "2^" + std::to_string(exponent) + (far_away ? " away" : " times"));
        }
      }
    }
  });
}

/// Whatever the host has set, nothing is flushed and all is rounded as ever.
TEST(CheckedMatrix, IsTheSameInEveryEnvironment) {
  using capi_tests::Face;
  properties::Random draw(properties::seed());
  const Case c{&instruction_sets().back(), properties::Scalar::f64, VESICA_RECT, VESICA_RECT};
  const properties::Numbers first = taken_shape<double>(c.kind_a, 0, draw);
  std::vector<Numbers<double>> rows(8, to_scalar<double>(first)), columns = at_contact<double>(c, first, 100, 2, draw);
  for (std::size_t i = 0; i < columns.size(); i += 3) {
    // Centres and a half size that are subnormal: flushed, shapes would meet that do not.
    columns[i] = {std::ldexp(1.0 + static_cast<double>(i), -1070), 0, 1, 0, std::ldexp(1.0, -1070), 1};
  }
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    rows[i] = {-std::ldexp(20.0 * static_cast<double>(i), -1071), 0, 1, 0, std::ldexp(1.0, -1071), 1};
  }
  Face<double>::Shapes a{}, b{};
  Face<double>::from_records(c.kind_a, 8, rows.data(), sizeof rows[0], &a);
  Face<double>::from_records(c.kind_b, 100, columns.data(), sizeof columns[0], &b);
  std::vector<std::uint8_t> expected, out(rows.size() * columns.size());
  const auto row_length = static_cast<std::ptrdiff_t>(columns.size());
  for (const auto& row : rows) {
    for (const auto& column : columns) {
      expected.push_back(scalar_answer(c.kind_a, row, c.kind_b, column) == 1);
    }
  }
  for (const environment::Environment& e : environment::all_environments) {
    std::fill(out.begin(), out.end(), untouched);
    environment::ask_in(e, [&] { Face<double>::overlap_matrix(&a, &b, out.data(), row_length); });
    EXPECT_EQ(out, expected) << e.name << ", seed " << properties::seed();
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Checked);  // narrower sets have none
INSTANTIATE_TEST_SUITE_P(Sets, Checked, testing::ValuesIn(checked_cases()), test_name);

}  // namespace
