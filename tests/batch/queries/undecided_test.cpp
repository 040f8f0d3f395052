// SPDX-License-Identifier: Apache-2.0
// How many pairs the kernels of the queries of numbers leave to the scalar function. One that leaves too many is still
// right, only slow. No kernel fuses, and the pairs are drawn without a rounding that could differ: SSE2, AVX2 and
// AVX-512 leave the same number. Relation leaves none of these pairs: tests/filter/undecided_test.cpp has harder
// ones.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "batch/instruction_sets.hpp"
#include "batch/shapes.hpp"
#include "kernels/query_table.hpp"
#include "number_columns.hpp"
#include "properties/random.hpp"

namespace queries_undecided_test {
namespace {

using namespace batch_tests;
using properties::Random;

constexpr int blocks = 32, count = blocks * vesica::query_block;

/// Sizes from 1/2 to 1 or, of one in four, thinner by any power of two to 2^-20; the second shape of every other pair
/// small and near to the first one's centre.
struct Pairs {
  std::array<Numbers<double>, count> a, b;

  Pairs(int kind_a, int kind_b) : a{}, b{} {
    Random random(1);
    for (std::size_t i = 0; i < count; ++i) {
      a[i] = shape(kind_a, 1, 1, random);
      b[i] = i % 2 == 0 ? shape(kind_b, 1, 1, random) : shape(kind_b, 0.25, 0.25, random);
    }
  }

  static Numbers<double> shape(int kind, double room, double size, Random& random) {
    const double x = random.between(-room, room), y = random.between(-room, room), t = random.between(-1, 1);
    const double width = size * random.between(0.5, 1), height = size * random.between(0.5, 1);
    const double thin = random.chance(0.25) ? std::ldexp(height, -random.below(21)) : height;
    switch (kind) {
      case VESICA_POINT:
        return {x, y};
      case VESICA_CIRCLE:
        return {x, y, width};
      case VESICA_AABB:
        return {x, y, x + width, y + thin};
      default:
        return {x, y, 1 - t * t, 2 * t, width, thin};
    }
  }
};

/// A kernel's results that are NaN.
int undecided(const vesica::Query& query, const vesica::KernelTable& table, int kind_a, int kind_b) {
  static vesica::batch::NumberColumns first, second;
  const Pairs pairs(kind_a, kind_b);
  const auto view = [](int kind, const std::array<Numbers<double>, count>& shapes) {
    vesica::batch::Shapes<double> all{kind, count, sizeof shapes[0], {}};
    for (int k = 0; k < 6; ++k) all.field[k] = shapes[0].data() + k;
    return all;
  };
  int left = 0;
  for (int block = 0; block < blocks; ++block) {
    constexpr std::int32_t n = vesica::query_block;
    first.set(view(kind_a, pairs.a), block * n, n, query, table);
    second.set(view(kind_b, pairs.b), block * n, n, query, table);
    for (auto* shapes : {&first, &second}) shapes->find_areas(query);
    double known[n], results[vesica::max_results][n];
    for (std::int32_t i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(block * n + i);
      known[i] = vesica_overlap_f64(kind_a, pairs.a[at].data(), kind_b, pairs.b[at].data());
    }
    double* const columns[] = {results[0], results[1], results[2], results[3], results[4]};
    (table.queries->*query.kernels)[kind_a][kind_b]({first.operand(), second.operand(), known}, n, columns);
    for (const double x : std::span(results[0])) left += std::isnan(x);
  }
  return left;
}

struct Expected {
  const char* name;
  const vesica::Query& query;
  int kind_a, kind_b, undecided;
  int by_sse2 = undecided;  ///< which leaves some pairs to the scalar function on purpose
};
namespace q = vesica::queries;
const Expected all_expected[] = {
    {"relation", q::relation, VESICA_POINT, VESICA_RECT, 0},
    {"relation", q::relation, VESICA_POINT, VESICA_ELLIPSE, 0},
    {"relation", q::relation, VESICA_CIRCLE, VESICA_CIRCLE, 0},
    {"relation", q::relation, VESICA_CIRCLE, VESICA_RECT, 0},
    {"relation", q::relation, VESICA_CIRCLE, VESICA_ELLIPSE, 0},
    {"relation", q::relation, VESICA_AABB, VESICA_AABB, 0},
    {"relation", q::relation, VESICA_RECT, VESICA_RECT, 0},
    {"relation", q::relation, VESICA_RECT, VESICA_ELLIPSE, 0},
    {"relation", q::relation, VESICA_ELLIPSE, VESICA_ELLIPSE, 0},
    {"nearest", q::nearest, VESICA_CIRCLE, VESICA_ELLIPSE, 1220},
    {"nearest", q::nearest, VESICA_RECT, VESICA_RECT, 1003},
    {"nearest", q::nearest, VESICA_RECT, VESICA_ELLIPSE, 966},
    {"nearest", q::nearest, VESICA_ELLIPSE, VESICA_ELLIPSE, 1015},
    {"boundary_distance", q::boundary_distance, VESICA_CIRCLE, VESICA_ELLIPSE, 2464},
    {"boundary_distance", q::boundary_distance, VESICA_RECT, VESICA_RECT, 2501},
    {"boundary_distance", q::boundary_distance, VESICA_RECT, VESICA_ELLIPSE, 2315, 3254},
    {"boundary_distance", q::boundary_distance, VESICA_ELLIPSE, VESICA_ELLIPSE, 2288},
    {"depth", q::depth, VESICA_CIRCLE, VESICA_ELLIPSE, 132},
    {"depth", q::depth, VESICA_RECT, VESICA_RECT, 0},
    {"depth", q::depth, VESICA_RECT, VESICA_ELLIPSE, 262},
    {"depth", q::depth, VESICA_ELLIPSE, VESICA_ELLIPSE, 207},
    {"area", q::area, VESICA_RECT, VESICA_RECT, 875},
    {"iou", q::iou, VESICA_RECT, VESICA_RECT, 875},
};

TEST(QueryKernels, LeaveAsManyAsTheyDid) {
  for (const InstructionSet& set : instruction_sets()) {
    if (!set.usable) continue;
    for (const Expected& e : all_expected) {
      if ((set.table->queries->*e.query.kernels)[e.kind_a][e.kind_b] == nullptr) continue;  // of one lane
      EXPECT_EQ(undecided(e.query, *set.table, e.kind_a, e.kind_b),
                std::string_view(set.name) == "sse2" ? e.by_sse2 : e.undecided)
          << set.name << ' ' << e.name << ' ' << properties::kind_name(e.kind_a) << ' '
          << properties::kind_name(e.kind_b);
    }
  }
}

/// The circle about a rectangle holds it and is at most a relative 2^-47 too great, or pairs that are apart would be
/// looked at. The lengths of these axes and half sizes, up to powers of two, are whole numbers.
TEST(BoundingRadius, IsTheFarthestCornersDistanceAndLittleMore) {
  constexpr std::array<std::array<double, 3>, 4> whole{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {0, 1, 1}}};
  for (const auto& [ux, uy, axis] : whole) {
    for (const auto& [hx, hy, size] : whole) {
      for (const int of_axis : {-190, -3, 0, 190}) {
        for (const int of_size : {-190, 0, 5, 190}) {
          const double k = std::ldexp(1, of_axis), l = std::ldexp(1, of_size), truth = k * axis * l * size;
          const double radius = vesica::batch::bounding_radius(1, 2, k * ux, k * uy, l * hx, l * hy);
          EXPECT_GE(radius, truth);
          EXPECT_LE(radius, truth * (1 + 0x1p-47));
        }
      }
    }
  }
}

TEST(BoundingRadius, IsNanForInvalidOrExtremeNumbers) {
  constexpr std::array<double, 6> usual{1, 2, 3, 4, 5, 12};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto radius = [](const std::array<double, 6>& s) {
    return vesica::batch::bounding_radius(s[0], s[1], s[2], s[3], s[4], s[5]);
  };
  EXPECT_FALSE(std::isnan(radius(usual)));
  for (std::size_t k = 0; k < 6; ++k) {
    std::array<double, 6> odd = usual;
    for (const double x : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
      odd[k] = x;
      EXPECT_TRUE(std::isnan(radius(odd))) << k << ' ' << x;
    }
    if (k < 2) continue;
    for (const double x : {0x1p-210, 0x1p210}) {
      const std::size_t first = k < 4 ? 2 : 4;
      odd = usual;
      odd[first] = odd[first + 1] = 0;
      odd[k] = x;
      EXPECT_TRUE(std::isnan(radius(odd))) << k << ' ' << x;
    }
    odd = usual;
    odd[k] = -odd[k];
    EXPECT_EQ(std::isnan(radius(odd)), k > 3) << k;
  }
}

}  // namespace
}  // namespace queries_undecided_test
