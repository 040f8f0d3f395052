// SPDX-License-Identifier: Apache-2.0
/// Signed distances are those of vesica_nearest and vesica_depth, bit for bit, alone and in arrays.
#include <gtest/gtest.h>
#include <vesica.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using properties::Pair;
using properties::Scalar;

struct Answer {
  std::int32_t code;
  double value;
};

template <class T>
bool same_bits(T a, T b) {
  if constexpr (sizeof(T) == 8)
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  else
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

Answer expected(double, int kind_a, const double* a, int kind_b, const double* b) {
  vesica_closest_points_f64 c{};
  vesica_penetration_f64 p{};
  const std::int32_t overlap = vesica_overlap_f64(kind_a, a, kind_b, b);
  const std::int32_t code =
      overlap == 0 ? vesica_nearest_f64(kind_a, a, kind_b, b, &c) : vesica_depth_f64(kind_a, a, kind_b, b, &p);
  return {code, overlap == 0 ? c.distance : p.depth == 0 ? 0 : -p.depth};
}
Answer expected(float, int kind_a, const float* a, int kind_b, const float* b) {
  vesica_closest_points_f32 c{};
  vesica_penetration_f32 p{};
  const std::int32_t overlap = vesica_overlap_f32(kind_a, a, kind_b, b);
  const std::int32_t code =
      overlap == 0 ? vesica_nearest_f32(kind_a, a, kind_b, b, &c) : vesica_depth_f32(kind_a, a, kind_b, b, &p);
  return {code, static_cast<double>(overlap == 0 ? c.distance : p.depth == 0 ? 0 : -p.depth)};
}
std::int32_t ask(int kind_a, const double* a, int kind_b, const double* b, double* out) {
  return vesica_signed_distance_f64(kind_a, a, kind_b, b, out);
}
std::int32_t ask(int kind_a, const float* a, int kind_b, const float* b, float* out) {
  return vesica_signed_distance_f32(kind_a, a, kind_b, b, out);
}
std::int64_t ask_many(const vesica_shapes_f64* a, const vesica_shapes_f64* b, double* out) {
  return vesica_signed_distance_many_f64(a, b, out);
}
std::int64_t ask_many(const vesica_shapes_f32* a, const vesica_shapes_f32* b, float* out) {
  return vesica_signed_distance_many_f32(a, b, out);
}
std::int64_t ask_matrix(const vesica_shapes_f64* a, const vesica_shapes_f64* b, double* out, std::ptrdiff_t row) {
  return vesica_signed_distance_matrix_f64(a, b, out, row);
}
std::int64_t ask_matrix(const vesica_shapes_f32* a, const vesica_shapes_f32* b, float* out, std::ptrdiff_t row) {
  return vesica_signed_distance_matrix_f32(a, b, out, row);
}

template <class T>
using Record = properties::NumbersOf<T>;
template <class T>
Record<T> record(const properties::Numbers& n) {
  if constexpr (sizeof(T) == 8)
    return n;
  else
    return properties::narrow(n);
}

vesica_shapes_f64 shapes(int kind, const std::vector<Record<double>>& r) {
  vesica_shapes_f64 s;
  vesica_shapes_from_records_f64(kind, static_cast<std::int64_t>(r.size()), r.data(), sizeof r[0], &s);
  return s;
}
vesica_shapes_f32 shapes(int kind, const std::vector<Record<float>>& r) {
  vesica_shapes_f32 s;
  vesica_shapes_from_records_f32(kind, static_cast<std::int64_t>(r.size()), r.data(), sizeof r[0], &s);
  return s;
}

template <class T>
void check(const properties::Kinds& k) {
  std::vector<Record<T>> a, b;
  std::vector<T> single;
  std::int64_t not_positive = 0;
  std::int32_t worst = 0;
  for (const properties::Workload workload : properties::all_workloads) {
    properties::Stream stream(workload, k.a, k.b, k.scalar, properties::seed() + 31);
    for (int i = 0; i < 20 * properties::repeat(); ++i) {
      const Pair p = stream.next();
      SCOPED_TRACE(properties::describe(p));
      a.push_back(record<T>(p.a));
      b.push_back(record<T>(p.b));
      T value = 7, exchanged = 7;
      const Answer right = expected(T{}, k.a, a.back().data(), k.b, b.back().data());
      const std::int32_t code = ask(k.a, a.back().data(), k.b, b.back().data(), &value);
      EXPECT_EQ(code, right.code);
      EXPECT_EQ(ask(k.b, b.back().data(), k.a, a.back().data(), &exchanged), code);
      EXPECT_TRUE(same_bits(value, exchanged));
      EXPECT_TRUE(same_bits(value, code == 0 ? static_cast<T>(right.value) : T{7}));
      worst = code < 0 ? code : worst;
      single.push_back(code == 0 ? value : std::numeric_limits<T>::quiet_NaN());
      not_positive += code == 0 && value <= 0;
    }
  }
  const auto of_a = shapes(k.a, a), of_b = shapes(k.b, b);
  const auto n = static_cast<std::size_t>(of_a.count);
  std::vector<T> out(n, 7);
  EXPECT_EQ(ask_many(&of_a, &of_b, out.data()), worst != 0 ? worst : not_positive);
  EXPECT_GT(not_positive, 0);
  for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(same_bits(out[i], single[i]) || single[i] != single[i]) << i;
  auto few = of_a;
  few.count = 3;
  std::vector<T> table(3 * n);
  ask_matrix(&few, &of_b, table.data(), of_a.count);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      T value = std::numeric_limits<T>::quiet_NaN();
      const std::int32_t code = ask(k.a, a[i].data(), k.b, b[j].data(), &value);
      EXPECT_TRUE(same_bits(table[i * n + j], value) || (code != 0 && table[i * n + j] != table[i * n + j]));
    }
  }
}

class SignedDistance : public testing::TestWithParam<properties::Kinds> {};

TEST_P(SignedDistance, IsDistanceOrDepth) {
  GetParam().scalar == Scalar::f64 ? check<double>(GetParam()) : check<float>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, SignedDistance, testing::ValuesIn(properties::all_pairs_of_kinds()),
                         properties::test_name);

TEST(SignedDistanceKnown, Literals) {
  const double a[3] = {0, 0, 1}, b[3] = {3, 0, 1}, c[3] = {2, 0, 1}, d[3] = {1.5, 0, 1}, bad[3] = {0, 0, -1};
  double out = 7;
  EXPECT_EQ(vesica_signed_distance_f64(VESICA_CIRCLE, a, VESICA_CIRCLE, b, &out), 0);
  EXPECT_EQ(out, 1);
  EXPECT_EQ(vesica_signed_distance_f64(VESICA_CIRCLE, a, VESICA_CIRCLE, c, &out), 0);
  EXPECT_TRUE(out == 0 && !std::signbit(out));
  EXPECT_EQ(vesica_signed_distance_f64(VESICA_CIRCLE, a, VESICA_CIRCLE, d, &out), 0);
  EXPECT_EQ(out, -0.5);
  EXPECT_EQ(vesica_signed_distance_f64(VESICA_CIRCLE, a, VESICA_CIRCLE, bad, &out), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_signed_distance_f64(VESICA_CIRCLE, a, VESICA_POLYLINE + 1, bad, &out), VESICA_E_KIND);
  EXPECT_EQ(vesica_signed_distance_f64(VESICA_CIRCLE, a, VESICA_CIRCLE, b, nullptr), VESICA_E_NULL);
  EXPECT_EQ(out, -0.5);
}

/// A depth that no float but 0 is near stays below 0.
TEST(SignedDistanceKnown, ATinyDepthStaysBelowZero) {
  const float a[4] = {-1, -1, 1, 1}, b[6] = {1, 0, 0x1p-120f, 0, 0x1p-100f, 1};
  float out = 7;
  EXPECT_EQ(vesica_signed_distance_f32(VESICA_AABB, a, VESICA_RECT, b, &out), 0);
  EXPECT_EQ(out, -0x1p-149f);
  const std::vector<Record<float>> boxes{{-1, -1, 1, 1}}, rects{{1, 0, 0x1p-120f, 0, 0x1p-100f, 1}};
  const auto first = shapes(VESICA_AABB, boxes), second = shapes(VESICA_RECT, rects);
  out = 7;
  EXPECT_EQ(vesica_signed_distance_many_f32(&first, &second, &out), 1);
  EXPECT_EQ(out, -0x1p-149f);
}

}  // namespace
