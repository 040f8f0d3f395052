// SPDX-License-Identifier: Apache-2.0
// Areas and ratios of arrays of polygons, in lanes where they have few sides: the bits of single calls.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "polygon/questions.hpp"
#include "properties/random.hpp"

namespace polygon_area_arrays {

using polygons::Face;
using properties::Random;

/// Rings of an array, each a polygon.
template <class T>
struct Rings {
  std::vector<T> xy;
  std::vector<std::int32_t> rings{0};

  void add(const std::vector<double>& ring) {
    for (const double z : ring) xy.push_back(static_cast<T>(z));
    rings.push_back(static_cast<std::int32_t>(xy.size() / 2));
  }
  std::int64_t count() const { return static_cast<std::int64_t>(rings.size()) - 1; }
  typename Face<T>::Shapes shapes() const {
    typename Face<T>::Shapes s{};
    s.kind = VESICA_POLYGON;
    s.field[0] = xy.data();
    s.field[1] = xy.data() + 1;
    s.stride = 2 * sizeof(T);
    s.count = count();
    s.rings = rings.data();
    return s;
  }
  polygons::PolygonOf<T> operator[](std::int64_t i) const {
    const std::int32_t first = rings[static_cast<std::size_t>(i)], last = rings[static_cast<std::size_t>(i) + 1];
    return {xy.data() + 2 * first, xy.data() + 2 * first + 1, 2 * sizeof(T), nullptr, last - first};
  }
};

/// A ring about a place near the origin: convex, a star, on a lattice, without area, or closed.
inline std::vector<double> some_ring(int most, double extent, Random& random) {
  const int n = random.integer(random.chance(0.05) ? 1 : 3, most), way = random.integer(0, 5);
  const double x = random.between(0, extent), y = random.between(0, extent), turn = random.between(0, 1);
  std::vector<double> ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * (i + turn + random.between(0, 0.9)) / n;
    const double r = way == 1 ? random.between(0.3, 1) : 1;
    double px = x + r * std::cos(angle), py = y + r * std::sin(angle);
    if (way == 2) px = std::round(2 * px) / 2, py = std::round(2 * py) / 2;
    if (way == 3) py = 0.25 * px;  // no area
    ring.push_back(px);
    ring.push_back(py);
  }
  if (way == 4) ring.insert(ring.end(), {ring[0], ring[1]});
  if (random.chance(0.5)) {
    std::vector<double> reversed;
    for (std::size_t i = ring.size(); i >= 2; i -= 2) reversed.insert(reversed.end(), {ring[i - 2], ring[i - 1]});
    ring = reversed;
  }
  return ring;
}

/// Some of them scaled, moved, exchanged for the one before, or invalid.
template <class T>
Rings<T> some_rings(int count, int most, double extent, Random& random) {
  Rings<T> rings;
  std::vector<double> ring;
  for (int k = 0; k < count; ++k) {
    if (ring.empty() || !random.chance(0.1)) ring = some_ring(most, extent, random);
    std::vector<double> drawn = ring;
    const double odd = random.between(0, 1), scale = std::ldexp(1, random.integer(-120, 120));
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (odd < 0.05) drawn[i] *= scale;
      if (odd > 0.97) drawn[i] += i % 2 == 0 ? 1e15 : 0;
      if (odd > 0.95 && odd <= 0.97 && i % 2 == 0) drawn[i] *= std::ldexp(1, -100);
    }
    if (random.chance(0.03)) drawn[static_cast<std::size_t>(random.below(static_cast<int>(drawn.size())))] = NAN;
    rings.add(drawn);
  }
  return rings;
}

template <class T>
bool same(T a, T b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

/// The number that an array writes for a pair: the single call's, or NaN in place of an error.
template <class T, class Ask>
T single(const Rings<T>& a, std::int64_t i, const Rings<T>& b, std::int64_t j, Ask ask) {
  const auto p = a[i], q = b[j];
  T out = std::numeric_limits<T>::quiet_NaN();
  return ask(p, q, &out) < 0 ? std::numeric_limits<T>::quiet_NaN() : out;
}

/// Arrays in step, one against many in either order, and matrices; returns how many pairs share area.
template <class T, class Ask, class Many, class Matrix>
std::int64_t compare(const Rings<T>& a, const Rings<T>& b, Ask ask, Many many, Matrix matrix) {
  const auto m = static_cast<std::size_t>(a.count()), n = static_cast<std::size_t>(b.count());
  const auto all_a = a.shapes(), all_b = b.shapes();
  auto one_a = all_a, one_b = all_b;
  one_a.count = one_b.count = 1;
  std::vector<T> out(m * n, -2), row(n, -2), column(m, -2), step(std::min(m, n), -2);
  const std::int64_t positive = matrix(&all_a, &all_b, out.data(), static_cast<std::ptrdiff_t>(n));
  many(&one_a, &all_b, row.data());
  many(&all_a, &one_b, column.data());
  auto some_a = all_a, some_b = all_b;
  some_a.count = some_b.count = static_cast<std::int64_t>(step.size());
  many(&some_a, &some_b, step.data());
  int wrong = 0;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const T expected = single(a, static_cast<std::int64_t>(i), b, static_cast<std::int64_t>(j), ask);
      wrong += !same(out[i * n + j], expected);
      if (i == 0) wrong += !same(row[j], expected);
      if (j == 0) wrong += !same(column[i], expected);
      if (i == j) wrong += !same(step[i], expected);
    }
  }
  EXPECT_EQ(wrong, 0);
  return positive;
}

template <class T>
void compare_all(int most, double extent, std::uint64_t seed) {
  Random random(seed);
  for (int k = 0; k < 3; ++k) {
    const auto a = some_rings<T>(random.integer(1, 70), most, extent, random);
    const auto b = some_rings<T>(random.integer(60, 140), most, extent, random);
    compare(
        a, b,
        [](const auto& p, const auto& q, T* out) { return Face<T>::area(VESICA_POLYGON, &p, VESICA_POLYGON, &q, out); },
        Face<T>::area_many, Face<T>::area_matrix);
    for (std::int32_t which = 0; which <= VESICA_RATIO_COMPLETE; ++which) {
      compare(
          a, b,
          [&](const auto& p, const auto& q, T* out) {
            return Face<T>::ratio(which, VESICA_POLYGON, &p, VESICA_POLYGON, &q, out);
          },
          [&](const auto* p, const auto* q, T* out) { return Face<T>::ratio_many(which, p, q, out); },
          [&](const auto* p, const auto* q, T* out, std::ptrdiff_t stride) {
            return Face<T>::ratio_matrix(which, p, q, out, stride);
          });
    }
  }
}

TEST(PolygonAreaArrays, HaveTheBitsOfSingleCalls) {
  std::uint64_t seed = 1;
  for (const int most : {3, 4, 6, 8, 11}) {
    for (const double extent : {1.0, 4.0, 20.0}) {
      compare_all<double>(most, extent, seed++);
      compare_all<float>(most, extent, seed++);
    }
  }
}

}  // namespace polygon_area_arrays
