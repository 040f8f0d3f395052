// SPDX-License-Identifier: Apache-2.0
/// Arrays of moving pairs, and whether vesica_cast_many answers them as single calls do.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "capi/face.hpp"
#include "cast/motions.hpp"
#include "properties/generators.hpp"

namespace cast_test {

using capi_tests::Face;

template <class T>
constexpr Scalar scalar_of = sizeof(T) == 8 ? Scalar::f64 : Scalar::f32;

/// Pairs as records, and their velocities as records of two.
template <class T>
struct Arrays {
  int kind_a, kind_b;
  std::vector<properties::NumbersOf<T>> a, b;
  std::vector<std::array<T, 2>> v;
  typename Face<T>::Shapes shapes_a{}, shapes_b{};

  Arrays(properties::Workload workload, int first, int second, int n) : kind_a(first), kind_b(second) {
    properties::Stream stream(workload, kind_a, kind_b, scalar_of<T>, properties::seed() + 31);
    properties::Random random(properties::seed() + 32);
    for (int i = 0; i < n; ++i) {
      const Pair p = stream.next();
      add(p, draw_motion(p, scalar_of<T>, random));
    }
    view();
  }
  Arrays(int first, int second, const std::vector<Moving>& pairs) : kind_a(first), kind_b(second) {
    for (const Moving& m : pairs) add(m.pair, m.motion);
    view();
  }

  void add(const Pair& p, const Motion& m) {
    a.emplace_back();
    b.emplace_back();
    for (std::size_t k = 0; k < 7; ++k) {
      a.back()[k] = static_cast<T>(p.a[k]);
      b.back()[k] = static_cast<T>(p.b[k]);
    }
    v.push_back({static_cast<T>(m.vx), static_cast<T>(m.vy)});
  }
  void view() {
    const auto n = static_cast<std::int64_t>(a.size());
    Face<T>::from_records(kind_a, n, a.data(), sizeof a[0], &shapes_a);
    Face<T>::from_records(kind_b, n, b.data(), sizeof b[0], &shapes_b);
  }
  std::string describe(std::size_t i) const {
    Pair p{kind_a, kind_b, {}, {}};
    for (std::size_t k = 0; k < 7; ++k) {
      p.a[k] = static_cast<double>(a[i][k]);
      p.b[k] = static_cast<double>(b[i][k]);
    }
    return cast_test::describe(p, {static_cast<double>(v[i][0]), static_cast<double>(v[i][1]), 0});
  }
};

inline bool same_bits(const void* a, const void* b, std::size_t n) { return std::memcmp(a, b, n) == 0; }

template <class T>
void check_many(Arrays<T>& s, T end) {
  const std::size_t n = s.a.size();
  std::vector<T> columns[5];
  for (auto& column : columns) column.resize(n);
  const std::int64_t hits =
      Face<T>::cast_many(&s.shapes_a, &s.shapes_b, &s.v[0][0], &s.v[0][1], sizeof s.v[0], end, columns[0].data(),
                         columns[1].data(), columns[2].data(), columns[3].data(), columns[4].data());
  std::int64_t expected = 0, worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    typename Face<T>::Impact one{};
    const std::int32_t code =
        Face<T>::cast(s.shapes_a.kind, s.a[i].data(), s.shapes_b.kind, s.b[i].data(), s.v[i][0], s.v[i][1], end, &one);
    expected += code > 0;
    if (code < 0) {
      worst = worst == VESICA_E_SHAPE ? worst : code;
      EXPECT_TRUE(std::isnan(columns[0][i]));
      continue;
    }
    const T numbers[] = {one.t, one.x, one.y, one.nx, one.ny};
    for (std::size_t k = 0; k < 5; ++k) {
      const bool same = same_bits(&numbers[k], &columns[k][i], sizeof(T));
      EXPECT_TRUE(same || (std::isnan(numbers[k]) && std::isnan(columns[k][i])))
          << i << ' ' << k << ' ' << s.describe(i) << " end " << static_cast<double>(end);
    }
  }
  EXPECT_EQ(hits, worst != 0 ? worst : expected);
}

}  // namespace cast_test
