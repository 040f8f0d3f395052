// SPDX-License-Identifier: Apache-2.0
/// Nine-intersection matrices: against the oracle for straight shapes, over every workload and over all pairs of a
/// small grid; known answers; what follows from the relation, of round shapes too.
#include "oracle/de9im.hpp"

#include <gtest/gtest.h>
#include <vesica.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>
#include <vesica/de9im.hpp>

#include "oracle/oracle.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using properties::has_area;
using properties::is_curved;
using properties::Numbers;
using properties::Pair;
using properties::Scalar;

std::string de9im(Scalar scalar, const Pair& p) {
  char matrix[10] = "?????????";
  if (scalar == Scalar::f64) {
    EXPECT_EQ(vesica_de9im_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), matrix), 0);
  } else {
    const auto a = properties::narrow(p.a), b = properties::narrow(p.b);
    EXPECT_EQ(vesica_de9im_f32(p.kind_a, a.data(), p.kind_b, b.data(), matrix), 0);
  }
  return matrix;
}

std::string transposed(const std::string& m) { return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}; }
bool fits(const std::string& m, const char* pattern) { return vesica_de9im_match(m.c_str(), pattern) == 1; }

/// The relation by its definition, from the matrix.
int relation_of(const std::string& m) {
  const bool within = fits(m, "**F**F***"), contains = fits(m, "******FF*");
  if (fits(m, "FF*FF****")) return VESICA_DISJOINT;
  if (within && contains) return VESICA_EQUAL;
  const bool at_b = m[1] != 'F' || m[4] != 'F', at_a = m[3] != 'F' || m[4] != 'F';
  if (within) return at_b ? VESICA_INSIDE_TOUCH : VESICA_INSIDE;
  if (contains) return at_a ? VESICA_CONTAINS_TOUCH : VESICA_CONTAINS;
  return m[0] == 'F' ? VESICA_TOUCH : VESICA_CROSS;
}

/// The matrix of a point, from its relation to b.
char part(int kind_b, const Numbers& b, double x, double y) {
  const double point[2] = {x, y};
  switch (oracle::relation(VESICA_POINT, point, kind_b, b.data())) {
    case VESICA_INSIDE:
      return 'I';
    case VESICA_INSIDE_TOUCH:
      return 'B';
    default:
      return 'E';
  }
}

/// The row of a segment's ends with a curved shape, by the oracle.
std::string row_of_ends(const Pair& p) {
  std::string row = "FFF";
  for (const std::size_t end : {0U, 2U}) {
    const char where = part(p.kind_b, p.b, p.a[end], p.a[end + 1]);
    row[where == 'I' ? 0 : where == 'B' ? 1 : 2] = '0';
  }
  return row;
}

class De9im : public testing::TestWithParam<properties::Kinds> {
 protected:
  void check(const Pair& p) {
    SCOPED_TRACE(properties::describe(p));
    const std::string m = de9im(GetParam().scalar, p);
    EXPECT_EQ(de9im(GetParam().scalar, swapped(p)), transposed(m));
    const int relation = vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
    EXPECT_EQ(relation_of(m), relation) << m;
    ++cases_;
    shared_ += relation != VESICA_DISJOINT;
    if (!is_curved(p.kind_a, p.a) && !is_curved(p.kind_b, p.b)) {
      EXPECT_EQ(m, oracle::de9im(p.kind_a, p.a.data(), p.kind_b, p.b.data()));
    } else {
      check_curved(p, m);
    }
  }

  /// Beside the relation: dimensions, and where the ends of a stored segment are.
  void check_curved(const Pair& p, const std::string& m) {
    EXPECT_EQ(m[8], '2');
    const bool has_sides = properties::is_inflated(p.kind_b);  // stretches of which may be shared
    EXPECT_TRUE(m[4] == 'F' || m[4] == '0' || has_sides || m == "2FFF1FFF2") << m;
    const bool areas = has_area(p.kind_a, p.a) && has_area(p.kind_b, p.b);
    if (areas) {
      EXPECT_TRUE(fits(m, m[0] == 'F' ? "FF2FF1212" : "2********") || fits(m, has_sides ? "FF2F*1212" : "FF2F01212"))
          << m;
      for (const std::size_t k : {1U, 3U, 5U, 7U}) EXPECT_TRUE(m[k] == 'F' || m[k] == '1') << m;
      for (const std::size_t k : {2U, 6U}) EXPECT_TRUE(m[k] == 'F' || m[k] == '2') << m;
    }
    if (p.kind_a == VESICA_SEGMENT && (p.a[0] != p.a[2] || p.a[1] != p.a[3])) {
      const std::string ends = row_of_ends(p);
      EXPECT_EQ(m.substr(3, 3), ends) << m;
      EXPECT_EQ(m.substr(6), "212");
      EXPECT_EQ(m[2], ends[2] == '0' ? '1' : 'F') << m;
      // A chord leaves through the outline exactly where an end is outside; a tangent touches it in its own inside
      // unless an end is there.
      const bool meets = oracle::overlap(p.kind_a, p.a.data(), p.kind_b, p.b.data());
      if (m[0] == '1') {
        EXPECT_EQ(m[1], ends[2] == '0' ? '0' : 'F') << m;
      } else {
        EXPECT_TRUE(m[1] == (meets && ends[1] != '0' ? '0' : 'F') || (meets && has_sides && m[1] == '1')) << m;
      }
    }
  }

  int cases_ = 0, shared_ = 0;
};

TEST_P(De9im, EveryWorkload) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  const properties::Kinds k = GetParam();
  for (const properties::Workload workload : properties::all_workloads) {
    const bool wild = workload == properties::Workload::mixed_scale || workload == properties::Workload::axis_length ||
                      workload == properties::Workload::thin;
    properties::Stream stream(workload, k.a, k.b, k.scalar, properties::seed() + 41);
    const int count = wild ? 20 : 150;
    for (int i = 0; i < count * properties::repeat(); ++i) check(stream.next());
    if (HasFailure()) FAIL() << properties::name(workload);
  }
  EXPECT_GT(shared_, cases_ / 4);
  std::printf("%d cases, %d meet\n", cases_, shared_);
}

INSTANTIATE_TEST_SUITE_P(All, De9im, testing::ValuesIn(properties::all_pairs_of_kinds()), properties::test_name);

struct Shape {
  int kind;
  Numbers numbers;
};

/// Points, segments and boxes with corners on a grid, and rectangles along diagonals and knights' moves.
std::vector<Shape> small_shapes() {
  std::vector<Shape> shapes;
  const int n = properties::repeat().value > 1 ? 4 : 3;
  for (int i = 0; i < n * n; ++i) {
    const double x = i % n, y = i / n;
    shapes.push_back({VESICA_POINT, {x, y}});
    for (int j = 0; j < n * n; ++j) {
      const double p = j % n, q = j / n;
      shapes.push_back({VESICA_SEGMENT, {x, y, p, q}});
      if (x <= p && y <= q) shapes.push_back({VESICA_AABB, {x, y, p, q}});
    }
    for (const auto& [ux, uy] : {std::pair{1, 1}, {2, -1}, {0, 1}}) {
      for (const double hx : {0.0, 0.5, 1.0}) {
        for (const double hy : {0.0, 0.5}) {
          shapes.push_back({VESICA_RECT, {x, y, static_cast<double>(ux), static_cast<double>(uy), hx, hy}});
        }
      }
    }
  }
  return shapes;
}

/// Every pair of them against the oracle.
TEST(De9imGrid, AllPairs) {
  const std::vector<Shape> shapes = small_shapes();
  std::size_t cases = 0;
  for (std::size_t k = 0; k < shapes.size() * shapes.size(); ++k) {
    const Shape &a = shapes[k / shapes.size()], &b = shapes[k % shapes.size()];
    const Pair p{a.kind, b.kind, a.numbers, b.numbers};
    ++cases;
    ASSERT_EQ(de9im(Scalar::f64, p), oracle::de9im(a.kind, a.numbers.data(), b.kind, b.numbers.data()))
        << properties::describe(p);
  }
  std::printf("%zu pairs of %zu shapes\n", cases, shapes.size());
  EXPECT_GT(cases, 80000U);
}

TEST(De9imKnown, Literals) {
  const auto m = [](int kind_a, const Numbers& a, int kind_b, const Numbers& b) {
    return de9im(Scalar::f64, {kind_a, kind_b, a, b});
  };
  const Numbers unit{0, 0, 1, 1};
  EXPECT_EQ(m(VESICA_AABB, unit, VESICA_AABB, {1, 0, 2, 1}), "FF2F11212");
  EXPECT_EQ(m(VESICA_AABB, unit, VESICA_AABB, {1, 1, 2, 2}), "FF2F01212");
  EXPECT_EQ(m(VESICA_AABB, unit, VESICA_AABB, {0.5, 0, 2, 1}), "212111212");
  EXPECT_EQ(m(VESICA_AABB, unit, VESICA_AABB, {0.5, 0.5, 2, 2}), "212101212");
  EXPECT_EQ(m(VESICA_AABB, unit, VESICA_AABB, unit), "2FFF1FFF2");
  EXPECT_EQ(m(VESICA_AABB, unit, VESICA_RECT, {0.5, 0.5, 0, 1, 0.5, 0.5}), "2FFF1FFF2");
  EXPECT_EQ(m(VESICA_AABB, unit, VESICA_AABB, {-1, 0, 2, 1}), "2FF11F212");
  EXPECT_EQ(m(VESICA_AABB, unit, VESICA_AABB, {-1, -1, 2, 2}), "2FF1FF212");
  // The two that are INSIDE_TOUCH alike: along a side, and from a side inwards.
  EXPECT_EQ(m(VESICA_SEGMENT, {0.2, 0, 0.8, 0}, VESICA_AABB, unit), "F1FF0F212");
  EXPECT_EQ(m(VESICA_SEGMENT, {0.2, 0, 0.8, 0.5}, VESICA_AABB, unit), "1FF00F212");
  EXPECT_EQ(m(VESICA_SEGMENT, {-1, 0, 2, 0}, VESICA_AABB, unit), "F11FF0212");
  EXPECT_EQ(m(VESICA_SEGMENT, {-1, 1, 1, -1}, VESICA_AABB, unit), "F01FF0212");
  EXPECT_EQ(m(VESICA_SEGMENT, {0, 0, 2, 0}, VESICA_SEGMENT, {1, 0, 3, 0}), "1010F0102");
  EXPECT_EQ(m(VESICA_SEGMENT, {0, 0, 2, 2}, VESICA_SEGMENT, {0, 2, 2, 0}), "0F1FF0102");
  EXPECT_EQ(m(VESICA_SEGMENT, {0, 0, 2, 0}, VESICA_SEGMENT, {1, 0, 1, 3}), "F01FF0102");
  EXPECT_EQ(m(VESICA_SEGMENT, {0, 0, 2, 0}, VESICA_SEGMENT, {2, 0, 1, 3}), "FF1F00102");
  EXPECT_EQ(m(VESICA_POINT, {0, 0}, VESICA_AABB, unit), "F0FFFF212");
  EXPECT_EQ(m(VESICA_POINT, {0.5, 0.5}, VESICA_AABB, unit), "0FFFFF212");
  EXPECT_EQ(m(VESICA_POINT, {0, 0}, VESICA_SEGMENT, {0, 0, 0, 0}), "0FFFFFFF2");
  EXPECT_EQ(m(VESICA_CIRCLE, {0, 0, 1}, VESICA_CIRCLE, {2, 0, 1}), "FF2F01212");
  EXPECT_EQ(m(VESICA_CIRCLE, {0, 0, 1}, VESICA_CIRCLE, {1, 0, 2}), "2FF10F212");
  EXPECT_EQ(m(VESICA_CIRCLE, {0, 0, 1}, VESICA_AABB, {-1, -1, 1, 1}), "2FF10F212");
  EXPECT_EQ(m(VESICA_CIRCLE, {0, 0, 5}, VESICA_SEGMENT, {-3, 4, 3, 4}), "1F2F01FF2");
  EXPECT_EQ(m(VESICA_SEGMENT, {-9, 5, 9, 5}, VESICA_CIRCLE, {0, 0, 5}), "F01FF0212");
  EXPECT_EQ(m(VESICA_SEGMENT, {0, 5, 9, 5}, VESICA_CIRCLE, {0, 0, 5}), "FF1F00212");
  EXPECT_EQ(m(VESICA_ELLIPSE, {0, 0, 1, 0, 3, 0}, VESICA_SEGMENT, {-3, 0, 3, 0}), "1FFF0FFF2");
}

/// Axes at neither a right angle nor none, by more than roundings and of sizes whose products are in range. What is
/// not certain is asked exactly, which takes longer.
TEST(De9imKnown, ObliqueAxes) {
  const auto oblique = [](double scale, double wx, double wy) {
    const bool is = vesica::detail::de9im::certainly_oblique(scale, 0, wx, wy);
    EXPECT_EQ(vesica::detail::de9im::certainly_oblique(wx, wy, 0, -scale), is);
    return is;
  };
  EXPECT_TRUE(oblique(1, 1, 1) && oblique(3, 1, -0x1p-40) && oblique(3, 0x1p-40, 1));
  EXPECT_TRUE(oblique(0x1p400, 0x1p400, 0x1p390) && oblique(0x1p-400, 0x1p-400, 0x1p-410));
  EXPECT_FALSE(oblique(1, 1, 0) || oblique(1, 0, 1) || oblique(1, 1, 0x1p-60) || oblique(1, -0x1p-60, 1));
  EXPECT_FALSE(oblique(0x1p600, 0x1p600, 0x1p600) || oblique(0x1p-600, 0x1p-600, 0x1p-600));
}

TEST(De9imKnown, Errors) {
  const double a[3] = {0, 0, 1}, bad[3] = {0, 0, std::nan("")};
  char out[10] = "untouched";
  EXPECT_EQ(vesica_de9im_f64(VESICA_CIRCLE, a, VESICA_CIRCLE, bad, out), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_de9im_f64(VESICA_CIRCLE, bad, VESICA_POINT, a, out), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_de9im_f64(VESICA_CIRCLE, a, -1, a, out), VESICA_E_KIND);
  EXPECT_EQ(vesica_de9im_f64(VESICA_CIRCLE, a, -1, nullptr, out), VESICA_E_NULL);
  EXPECT_EQ(vesica_de9im_f64(VESICA_CIRCLE, a, VESICA_CIRCLE, a, nullptr), VESICA_E_NULL);
  EXPECT_STREQ(out, "untouched");
}

TEST(De9imKnown, Patterns) {
  EXPECT_EQ(vesica_de9im_match("212101212", "T*T***T**"), 1);
  EXPECT_EQ(vesica_de9im_match("2FF1FF212", "T*F**F***"), 1);
  EXPECT_EQ(vesica_de9im_match("212101212", "T*F**F***"), 0);
  EXPECT_EQ(vesica_de9im_match("FF2F01212", "FT*******"), 0);
  EXPECT_EQ(vesica_de9im_match("FF2F01212", "F***T****"), 1);
  EXPECT_EQ(vesica_de9im_match("0F1FF0102", "0********"), 1);
  EXPECT_EQ(vesica_de9im_match("1F1FF0102", "0********"), 0);
  EXPECT_EQ(vesica_de9im_match("212101212", "*********"), 1);
  EXPECT_EQ(vesica_de9im_match("T12101212", "*********"), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_de9im_match("212101212", "********"), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_de9im_match("212101212", "**********"), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_de9im_match("212101212", "t********"), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_de9im_match("", "*********"), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_de9im_match(nullptr, "*********"), VESICA_E_NULL);
  EXPECT_EQ(vesica_de9im_match("212101212", nullptr), VESICA_E_NULL);
}

}  // namespace
