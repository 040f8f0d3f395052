// SPDX-License-Identifier: Apache-2.0
/// Ellipses and rectangles from round to needle, from far apart to the last place before contact: what the functions'
/// comments say of accuracy by aspect ratio and by distance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "nearest/face.hpp"
#include "nearest/reference.hpp"
#include "properties/random.hpp"

namespace aspect_test {
namespace {

using nearest_reference::Real;
using nearest_test::Answer;
using nearest_test::Numbers;
using nearest_test::Pair;
using properties::Random;
using properties::Scalar;

constexpr double u = 0x1p-53;

Numbers random_shape(int kind, double aspect, Random& random) {
  const double angle = random.between(0, 2 * std::numbers::pi), size = std::exp2(random.between(-2, 0));
  const double x = random.between(-1, 1), y = random.between(-1, 1);
  if (kind == VESICA_CIRCLE) return {x, y, size};
  Numbers n{x, y, std::cos(angle), std::sin(angle), size, size / aspect};
  if (random.chance(0.5)) std::swap(n[4], n[5]);
  return n;
}

bool overlap(const Pair& p) { return vesica_overlap_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) == 1; }

Pair moved(Pair p, double x, double y) {
  p.b[0] = p.a[0] + x;
  p.b[1] = p.a[1] + y;
  return p;
}

/// A disjoint pair: b moved away from a along a random line, from contact on by a random power of ten of its way there.
Pair disjoint_pair(int kind_a, int kind_b, double aspect, Random& random) {
  for (;;) {
    const Pair p{kind_a, kind_b, random_shape(kind_a, aspect, random), random_shape(kind_b, aspect, random)};
    const double angle = random.between(0, 2 * std::numbers::pi), x = std::cos(angle), y = std::sin(angle);
    double together = 0, apart = 8;
    for (int i = 0; i < 80; ++i) {
      const double middle = (together + apart) / 2;
      (overlap(moved(p, middle * x, middle * y)) ? together : apart) = middle;
    }
    const double way = apart * (1 + std::pow(10.0, -random.between(0, 17)));
    const Pair result = moved(p, way * x, way * y);
    if (!overlap(result)) return result;
  }
}

/// Worst errors by distance: 10^-k scale and more.
struct Table {
  std::array<double, 18> of_itself{};
  double of_scale = 0, off_outline = 0;
};

void check(const Pair& p, Table& table) {
  SCOPED_TRACE(properties::describe(p));
  const Answer r = nearest_test::nearest(Scalar::f64, p);
  ASSERT_EQ(r.code, 0);
  ASSERT_GT(r.distance, 0);
  nearest_reference::set_precision(p);
  const auto a = nearest_reference::shape(p.kind_a, p.a), b = nearest_reference::shape(p.kind_b, p.b);
  const auto exact = nearest_reference::distance(a, b, r.bx - r.ax, r.by - r.ay);
  ASSERT_TRUE(exact.proved());
  const Real scale = nearest_reference::scale(a, b), error = abs(Real(r.distance) - exact.upper);
  table.of_scale = std::max(table.of_scale, Real(error / scale).get_d() / u);
  const double itself = Real(error / exact.upper).get_d() / u, share = Real(exact.upper / scale).get_d();
  EXPECT_LE(error, Real(4 * u * scale));
  for (std::size_t k = 0; k < table.of_itself.size(); ++k) {
    if (share > std::pow(10.0, -static_cast<double>(k))) table.of_itself[k] = std::max(table.of_itself[k], itself);
  }
  for (const auto& [s, x, y] : {std::tuple{&a, r.ax, r.ay}, {&b, r.bx, r.by}}) {
    const Real rounding = u * (abs(Real(x)) + abs(Real(y)));
    const Real off = abs(nearest_reference::beyond_outline(*s, x, y, Real(rounding + u * scale))) - rounding;
    table.off_outline = std::max(table.off_outline, Real(off / scale).get_d() / u);
  }
}

void expect_accuracy(int kind_a, int kind_b, double aspect) {
  Random random(properties::seed());
  Table table;
  for (int i = 0; i < 250 * properties::repeat(); ++i) {
    check(disjoint_pair(kind_a, kind_b, aspect, random), table);
    if (testing::Test::HasFailure()) return;
  }
  std::printf("aspect %g: %.3g u of scale, outline %.3g u; of itself", aspect, table.of_scale, table.off_outline);
  for (const std::size_t k : {2U, 6U, 10U, 12U, 14U, 17U}) std::printf(", 1e-%zu: %.3g u", k, table.of_itself[k]);
  std::printf("\n");
  EXPECT_LE(table.of_scale, 4);
  EXPECT_LE(table.off_outline, 4);
  if (aspect <= 1e6) {
    EXPECT_LE(table.of_itself[10], 2);
  }
  if (aspect <= 1e3) {
    EXPECT_LE(table.of_itself[14], 2);
  }
}

class Aspect : public testing::TestWithParam<std::array<int, 2>> {};

TEST_P(Aspect, FromRoundToNeedle) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  for (const double aspect : {1.0, 1.5, 20.0, 1e3, 1e6, 1e9, 1e12, 1e15}) {
    SCOPED_TRACE(aspect);
    expect_accuracy(GetParam()[0], GetParam()[1], aspect);
    if (HasFailure()) return;
  }
}

std::string kinds_of(const testing::TestParamInfo<std::array<int, 2>>& tested) {
  return std::string(vesica_kind_name(tested.param[0])) + "_" + vesica_kind_name(tested.param[1]);
}

INSTANTIATE_TEST_SUITE_P(Nearest, Aspect,
                         testing::Values(std::array{VESICA_RECT, VESICA_RECT}, std::array{VESICA_RECT, VESICA_ELLIPSE},
                                         std::array{VESICA_CIRCLE, VESICA_ELLIPSE},
                                         std::array{VESICA_ELLIPSE, VESICA_ELLIPSE}),
                         kinds_of);

}  // namespace
}  // namespace aspect_test
